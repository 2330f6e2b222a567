//! α and β from the nutation half phase χ and the two slow phases A and B (the regularised solution).

use crate::complex::Complex;
use crate::constants::{BranchPoints, Sign, Signs};
use crate::law::PhaseRates;
use crate::phase::Phase;
use crate::scalar::{Float, Real, Scalar};
use crate::su2::{Orientation, OrientationRate};

/// Brackets of α and β: α = (a₁ cos χ + i a₂ sin χ) e^{iA}, β = (b₁ cos χ + i b₂ sin χ) e^{iB}, with a₁² = (1+e₁)/2,
/// a₂² = (1+e₂)/2, b₁² = (1-e₁)/2, b₂² = (1-e₂)/2. They make |α|² + |β|² = 1 for all χ, A and B.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Brackets<R> {
    pub(crate) alpha: Bracket<R>,
    pub(crate) beta: Bracket<R>,
}

/// Bracket x cos χ + i y sin χ of a Cayley-Klein parameter: the parameter divided by e^{i slow phase}. Its values form
/// an ellipse in the complex plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bracket<R> {
    x: R,
    y: R,
}

/// Phases of one instant as directions: sin χ and cos χ of the half phase, e^{iA} and e^{iB} of the slow phases.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PhaseDirections<R> {
    pub(crate) sine: R,
    pub(crate) cosine: R,
    pub(crate) alpha: Complex<R>,
    pub(crate) beta: Complex<R>,
}

impl Brackets<f64> {
    /// Brackets of a motion whose u oscillates between e₁ and e₂, or rises from e₁ to 1.
    pub(crate) fn swinging<F: Float>(e: &BranchPoints<F>, signs: Signs) -> Self {
        let root = |x: F| x.halved().sqrt().to_f64();
        let (a1, a2) = (root(e.one_plus_e1), root(e.one_plus_e2()));
        let (b1, b2) = (root(e.one_minus_e1()), root(e.one_minus_e2));
        Self {
            alpha: Bracket { x: a1, y: signs.l_plus_n.times(a2) },
            beta: Bracket { x: b1, y: signs.l_minus_n.times(b2) },
        }
    }

    /// Winding numbers of both brackets around 0 over 2π of χ, for a motion whose u oscillates between e₁ and e₂ or
    /// rises from e₁ to 1: each is 1 or -1, or 0 where the bracket passes through 0.
    pub(crate) fn windings<F: Float>(e: &BranchPoints<F>, signs: Signs) -> [i32; 2] {
        let winding = |least: F, sign: Sign| if least > F::ZERO { sign.factor() } else { 0 };
        [winding(e.one_plus_e1, signs.l_plus_n), winding(e.one_minus_e2, signs.l_minus_n)]
    }

    /// Brackets of a motion with constant u, whose χ is 0 and whose slow phases alone change.
    pub(crate) fn steady<F: Float>(one_plus_u: F, one_minus_u: F) -> Self {
        let modulus = |x: F| Bracket { x: x.halved().sqrt().to_f64(), y: 0.0 };
        Self { alpha: modulus(one_plus_u), beta: modulus(one_minus_u) }
    }

    /// Brackets rounded to the scalar of the tick.
    pub(crate) fn cast<R: Float>(&self) -> Brackets<R> {
        let cast = |Bracket { x, y }| Bracket { x: R::from_f64(x), y: R::from_f64(y) };
        Brackets { alpha: cast(self.alpha), beta: cast(self.beta) }
    }
}

impl<R: Scalar> Brackets<R> {
    /// Orientation Φ at these phases.
    #[inline]
    pub(crate) fn orientation(&self, directions: &PhaseDirections<R>) -> Orientation<R> {
        Orientation {
            alpha: self.alpha.at(directions) * directions.alpha,
            beta: self.beta.at(directions) * directions.beta,
        }
    }

    /// Rate Φ' at these phases, from the rates of χ, A and B, rad per unit time.
    pub(crate) fn rate(&self, directions: &PhaseDirections<R>, rates: &PhaseRates<R>) -> OrientationRate<R> {
        let rate = |bracket: &Bracket<R>, cis: Complex<R>, turning: R| {
            (bracket.along(directions).scaled(rates.nutation)
                + bracket.at(directions).times_i().scaled(turning))
                * cis
        };
        OrientationRate {
            alpha: rate(&self.alpha, directions.alpha, rates.alpha),
            beta: rate(&self.beta, directions.beta, rates.beta),
        }
    }
}

impl<R: Scalar> Bracket<R> {
    /// Value of the bracket.
    #[inline]
    pub(crate) fn at(&self, directions: &PhaseDirections<R>) -> Complex<R> {
        Complex::new(self.x * directions.cosine, self.y * directions.sine)
    }

    /// Coefficients of e^{iχ} and e^{-iχ} in the bracket.
    pub(crate) fn exponentials(&self) -> [R; 2]
    where
        R: Float,
    {
        [(self.x + self.y).halved(), (self.x - self.y).halved()]
    }

    /// Derivative of the bracket with respect to χ.
    pub(crate) fn along(&self, directions: &PhaseDirections<R>) -> Complex<R> {
        Complex::new(-(self.x * directions.sine), self.y * directions.cosine)
    }

    /// Whether the bracket passes through 0 and changes sign, instead of winding around 0: e₁ = -1 for α, e₂ = 1 for
    /// β.
    fn passes_through_zero(&self) -> bool {
        self.x == R::ZERO || self.y == R::ZERO
    }

    /// Winding number of the bracket around 0 over 2π of χ: 1 or -1, or 0 where the bracket passes through 0.
    pub(crate) fn winding(&self) -> i32 {
        match self.passes_through_zero() {
            true => 0,
            false if self.x * self.y < R::ZERO => -1,
            false => 1,
        }
    }
}

impl<R: Real> Bracket<R> {
    /// Argument of the bracket; where the bracket is 0, the argument of its derivative with respect to χ.
    pub(crate) fn argument(&self, directions: &PhaseDirections<R>) -> Phase {
        let value = self.at(directions);
        let value = if value == Complex::ZERO { self.along(directions) } else { value };
        Phase::from_radians(value.arg().to_f64())
    }

    /// Argument of the bracket as a continuous function of χ, up to a constant: ±χ plus a correction of at most a
    /// quarter turn, which needs no choice of branch. Where the bracket passes through 0, the argument is constant,
    /// because the modulus then has a sign.
    pub(crate) fn continued_argument(&self, directions: &PhaseDirections<R>, chi: Phase) -> Phase {
        let sense = self.winding();
        if sense == 0 {
            return Phase::ZERO;
        }
        let y = if sense < 0 { -self.y } else { self.y };
        let (sine, cosine) = (directions.sine, directions.cosine);
        // arg(x cos χ + i y sin χ) - χ
        let correction =
            R::atan2((y - self.x) * sine * cosine, self.x * cosine.squared() + y * sine.squared());
        (chi + Phase::from_radians(correction.to_f64())).times(sense.into())
    }
}
