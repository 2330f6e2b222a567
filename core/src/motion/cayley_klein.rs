//! α and β from the half phase χ and their slow phases.

use crate::complex::Complex;
use crate::constants::{BranchPoints, Signs};
use crate::motion::phase_equations::PhaseRates;
use crate::phase::Phase;
use crate::scalar::{Extended, Float, Real};
use crate::su2::{Orientation, OrientationRate};

/// Ellipses of α and β: each parameter is (x cos χ + i y sin χ) e^{iλ}, with its slow phase λ. For α, x² = (1+e₁)/2 and y² = (1+e₂)/2; for β,
/// x² = (1-e₁)/2 and y² = (1-e₂)/2. They make |α|² + |β|² = 1 for all phases.
///
/// Their methods take the phases as unit complex numbers: `chi` is e^{iχ}, and `slow` are e^{iλ_α} and e^{iλ_β}.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ellipses<R> {
    pub(crate) alpha: Ellipse<R>,
    pub(crate) beta: Ellipse<R>,
}

/// Ellipse x cos χ + i y sin χ in the complex plane: a Cayley-Klein parameter divided by e^{i slow phase}.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ellipse<R> {
    x: R,
    y: R,
}

impl Ellipses<f64> {
    /// Ellipses of a motion whose u is not constant.
    pub(crate) fn oscillating(e: &BranchPoints<Extended>, signs: Signs) -> Self {
        let root = |x: Extended| x.halved().sqrt().to_f64();
        let (a2, b2) = (root(e.one_plus_e2()), root(e.one_minus_e2));
        Self {
            alpha: Ellipse { x: root(e.one_plus_e1), y: signs.l_plus_n.times(a2) },
            beta: Ellipse { x: root(e.one_minus_e1()), y: signs.l_minus_n.times(b2) },
        }
    }

    /// Ellipses of a motion with constant u, from 1 + u and 1 - u.
    pub(crate) fn steady(complements: [Extended; 2]) -> Self {
        let [alpha, beta] = complements.map(|x| Ellipse { x: x.halved().sqrt().to_f64(), y: 0.0 });
        Self { alpha, beta }
    }

    pub(crate) fn cast<R: Float>(&self) -> Ellipses<R> {
        let cast = |Ellipse { x, y }| Ellipse { x: R::from_f64(x), y: R::from_f64(y) };
        Ellipses { alpha: cast(self.alpha), beta: cast(self.beta) }
    }
}

impl<R: Real> Ellipses<R> {
    pub(crate) fn windings(&self) -> [i32; 2] {
        [self.alpha.winding(), self.beta.winding()]
    }

    pub(crate) fn arguments(&self, chi: Complex<R>) -> [Phase; 2] {
        [self.alpha.argument(chi), self.beta.argument(chi)]
    }

    /// Tip angle arg αβ in (-1/2, 1/2] turn, from the slow phases.
    pub(crate) fn tip_angle(&self, chi: Complex<R>, [a, b]: [Phase; 2]) -> Phase {
        let [alpha, beta] = self.arguments(chi);
        (a + b + alpha + beta).principal()
    }

    #[inline]
    pub(crate) fn orientation(&self, chi: Complex<R>, [a, b]: [Complex<R>; 2]) -> Orientation<R> {
        Orientation { alpha: self.alpha.at(chi) * a, beta: self.beta.at(chi) * b }
    }

    /// Rate Φ', from the rates of the three phases, rad/s.
    pub(crate) fn rate(
        &self,
        chi: Complex<R>,
        [a, b]: [Complex<R>; 2],
        rates: &PhaseRates<R>,
    ) -> OrientationRate<R> {
        OrientationRate {
            alpha: self.alpha.rate(chi, [rates.nutation, rates.slow_alpha]) * a,
            beta: self.beta.rate(chi, [rates.nutation, rates.slow_beta]) * b,
        }
    }
}

impl<R: Real> Ellipse<R> {
    #[inline]
    pub(crate) fn at(&self, chi: Complex<R>) -> Complex<R> {
        Complex::new(self.x * chi.re, self.y * chi.im)
    }

    fn derivative(&self, chi: Complex<R>) -> Complex<R> {
        self.at(chi.times_i())
    }

    /// Rate of the parameter divided by e^{i slow phase}, from the rates of χ and of the slow phase.
    pub(crate) fn rate(&self, chi: Complex<R>, [nutation, slow]: [R; 2]) -> Complex<R> {
        self.derivative(chi).scaled(nutation) + self.at(chi).times_i().scaled(slow)
    }

    /// Winding number of the ellipse around 0 over 2π of χ: 1, -1, or 0 where it passes through 0.
    fn winding(&self) -> i32 {
        if self.x == R::ZERO { 0 } else { i32::from(self.y > R::ZERO) - i32::from(self.y < R::ZERO) }
    }

    /// Coefficients of e^{iχ} and e^{-iχ} in the ellipse.
    pub(crate) fn exponentials(&self) -> [R; 2] {
        [(self.x + self.y).halved(), (self.x - self.y).halved()]
    }

    /// Argument of the ellipse; where the ellipse is 0, the argument of its derivative with respect to χ.
    fn argument(&self, chi: Complex<R>) -> Phase {
        let value = self.at(chi);
        let value = if value == Complex::ZERO { self.derivative(chi) } else { value };
        Phase::from_radians(value.arg().to_f64())
    }

    /// Argument of the ellipse, continuous in χ, within a quarter turn of ±χ; 0 if the ellipse passes through 0.
    ///
    /// * `whole_chi`: χ with its whole turns
    pub(crate) fn continued_argument(&self, chi: Complex<R>, whole_chi: Phase) -> Phase {
        let sense = self.winding();
        if sense == 0 {
            return Phase::ZERO;
        }
        let y = if sense < 0 { -self.y } else { self.y };
        // arg(x cos χ + i y sin χ) - χ
        let correction =
            R::atan2((y - self.x) * chi.im * chi.re, self.x * chi.re.squared() + y * chi.im.squared());
        (whole_chi + Phase::from_radians(correction.to_f64())) * sense.into()
    }
}
