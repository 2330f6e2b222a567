//! α and β from the nutation half phase and the two slow phases: the brackets of the regularised solution.

use crate::complex::Complex;
use crate::launch::{BranchPoints, Signs};
use crate::nutation::PhaseRates;
use crate::real::{Float, Real, Scalar};
use crate::su2::{Phi, PhiRate};
use crate::turns::Turns;

/// α = (a₁ cos χ + i a₂ sin χ) e^{iA}, β = (b₁ cos χ + i b₂ sin χ) e^{iB}, with
/// a₁² = (1+e₁)/2, a₂² = (1+e₂)/2, b₁² = (1-e₁)/2, b₂² = (1-e₂)/2: so |α|² + |β|² = 1 whatever χ, A and B are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Brackets<R> {
    pub(crate) alpha: Bracket<R>,
    pub(crate) beta: Bracket<R>,
}

/// x cos χ + i y sin χ: the ellipse that a Cayley-Klein parameter runs through when its slow phase is taken off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bracket<R> {
    x: R,
    y: R,
}

/// A moment of the motion: the half phase by its sine and cosine, the slow phases by e^{iA} and e^{iB}.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Place<R> {
    pub(crate) sine: R,
    pub(crate) cosine: R,
    pub(crate) alpha: Complex<R>,
    pub(crate) beta: Complex<R>,
}

impl<R: Float> Brackets<R> {
    /// For a motion that swings between e₁ and e₂, or rises from e₁.
    pub(crate) fn swinging<F: Float>(e: &BranchPoints<F>, signs: Signs) -> Self {
        let root = |x: F| R::from_f64(x.halved().sqrt().to_f64());
        let (a1, a2) = (root(e.one_plus_e1), root(e.one_plus_e2()));
        let (b1, b2) = (root(e.one_minus_e1()), root(e.one_minus_e2));
        Self {
            alpha: Bracket { x: a1, y: signs.l_plus_n.times(a2) },
            beta: Bracket { x: b1, y: signs.l_minus_n.times(b2) },
        }
    }

    /// For u constant, where χ stays 0 and the slow phases are all.
    pub(crate) fn steady<F: Float>(one_plus_u: F, one_minus_u: F) -> Self {
        let modulus = |x: F| Bracket { x: R::from_f64(x.halved().sqrt().to_f64()), y: R::ZERO };
        Self { alpha: modulus(one_plus_u), beta: modulus(one_minus_u) }
    }
}

impl<R: Scalar> Brackets<R> {
    /// Φ at a place.
    #[inline]
    pub(crate) fn phi(&self, place: &Place<R>) -> Phi<R> {
        Phi { alpha: self.alpha.at(place) * place.alpha, beta: self.beta.at(place) * place.beta }
    }

    /// Φ' at a place, from the whole rates of χ, A and B there.
    pub(crate) fn rate(&self, place: &Place<R>, rates: &PhaseRates<R>) -> PhiRate<R> {
        let rate = |bracket: &Bracket<R>, cis: Complex<R>, turning: R| {
            (bracket.along(place).scaled(rates.nutation) + bracket.at(place).times_i().scaled(turning)) * cis
        };
        PhiRate {
            alpha: rate(&self.alpha, place.alpha, rates.alpha),
            beta: rate(&self.beta, place.beta, rates.beta),
        }
    }
}

impl<R: Scalar> Bracket<R> {
    /// The bracket.
    #[inline]
    pub(crate) fn at(&self, place: &Place<R>) -> Complex<R> {
        Complex::new(self.x * place.cosine, self.y * place.sine)
    }

    /// The factors of e^{iχ} and e^{-iχ} in it.
    pub(crate) fn exponentials(&self) -> [R; 2]
    where
        R: Float,
    {
        [(self.x + self.y).halved(), (self.x - self.y).halved()]
    }

    /// Its derivative by χ.
    pub(crate) fn along(&self, place: &Place<R>) -> Complex<R> {
        Complex::new(-(self.x * place.sine), self.y * place.cosine)
    }

    /// Whether it passes through 0, changing sign, instead of turning around it: e₁ = -1 (α) or e₂ = 1 (β).
    fn passes_through_zero(&self) -> bool {
        self.x == R::ZERO || self.y == R::ZERO
    }

    /// The sense in which it turns around 0 with growing χ: +1, -1, or 0 where it passes through 0.
    pub(crate) fn winding(&self) -> i32 {
        match self.passes_through_zero() {
            true => 0,
            false if self.x * self.y < R::ZERO => -1,
            false => 1,
        }
    }
}

impl<R: Real> Bracket<R> {
    /// Its argument at a place; where it vanishes, that of its derivative by χ.
    pub(crate) fn argument(&self, place: &Place<R>) -> Turns {
        let value = self.at(place);
        let value = if value == Complex::ZERO { self.along(place) } else { value };
        Turns::from_radians(value.arg().to_f64())
    }

    /// Its argument continued along the motion, up to a constant: ±χ and a correction within a quarter turn, which has
    /// no branch to track; constant where the bracket passes through 0 (a signed modulus takes over).
    pub(crate) fn continued_argument(&self, place: &Place<R>, chi: Turns) -> Turns {
        let sense = self.winding();
        if sense == 0 {
            return Turns::ZERO;
        }
        let y = if sense < 0 { -self.y } else { self.y };
        let (sine, cosine) = (place.sine, place.cosine);
        // arg(x cos χ + i y sin χ) - χ
        let correction =
            R::atan2((y - self.x) * sine * cosine, self.x * cosine.squared() + y * sine.squared());
        (chi + Turns::from_radians(correction.to_f64())).times(sense.into())
    }
}
