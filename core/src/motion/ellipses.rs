//! Ellipses of α and β, which give both from the half phase χ and their slow phases.

use crate::complex::Complex;
use crate::constants::{BranchPoints, Signs};
use crate::phase::Phase;
use crate::scalar::{Extended, Float, Real, Ring, numeric_struct};
use crate::su2::{AttitudeState, Orientation, OrientationRate};

/// Ellipses of α and β: each parameter is (x cos χ + i y sin χ) e^{iλ}, with its slow phase λ. For α, x² = (1+e₁)/2 and y² = (1+e₂)/2; for β,
/// x² = (1-e₁)/2 and y² = (1-e₂)/2. They make |α|² + |β|² = 1 for all phases.
///
/// In their methods `cis_chi` is e^{iχ}.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ellipses<R> {
    /// Ellipse of α.
    pub(crate) alpha: Ellipse<R>,
    /// Ellipse of β.
    pub(crate) beta: Ellipse<R>,
}

numeric_struct! {
    /// Ellipse x cos χ + i y sin χ in the complex plane: a Cayley-Klein parameter divided by e^{iλ}.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub(crate) struct Ellipse<R> {
        x,
        y,
    }
}

impl<R: Ring> Ellipses<R> {
    /// Ellipses of a motion whose u is not constant.
    pub(crate) fn oscillating(e: &BranchPoints<Extended>, signs: Signs, convert: fn(Extended) -> R) -> Self {
        let root = |x: Extended| convert(x.halved().sqrt());
        let a2 = root(e.one_plus_e2());
        let b2 = root(e.one_minus_e2);
        Self {
            alpha: Ellipse { x: root(e.one_plus_e1), y: signs.l_plus_n.times(a2) },
            beta: Ellipse { x: root(e.one_minus_e1()), y: signs.l_minus_n.times(b2) },
        }
    }
}

impl Ellipses<f64> {
    /// Ellipses of a steady motion, from 1 + u and 1 - u.
    pub(crate) fn steady(complements: [Extended; 2]) -> Self {
        let [alpha, beta] = complements.map(|x| Ellipse { x: x.halved().sqrt().to_f64(), y: 0.0 });
        Self { alpha, beta }
    }

    /// Ellipses in another type.
    pub(crate) fn map<R>(&self, convert: fn(f64) -> R) -> Ellipses<R> {
        Ellipses { alpha: self.alpha.map(convert), beta: self.beta.map(convert) }
    }
}

impl<R: Real> Ellipses<R> {
    /// Winding numbers of both ellipses around 0 over 2π of χ.
    pub(crate) fn windings(&self) -> [i32; 2] {
        [self.alpha.winding(), self.beta.winding()]
    }

    /// Arguments of both ellipses.
    pub(crate) fn arguments(&self, cis_chi: Complex<R>) -> [Phase; 2] {
        [self.alpha.argument(cis_chi), self.beta.argument(cis_chi)]
    }

    /// Tip angle arg αβ in (-1/2, 1/2] turn, from the slow phases.
    pub(crate) fn tip_angle(&self, cis_chi: Complex<R>, [alpha_phase, beta_phase]: [Phase; 2]) -> Phase {
        let [alpha, beta] = self.arguments(cis_chi);
        (alpha_phase + beta_phase + alpha + beta).principal()
    }

    /// Orientation Φ, from e^{iλ_α} and e^{iλ_β}.
    #[inline]
    pub(crate) fn orientation(
        &self,
        cis_chi: Complex<R>,
        [cis_alpha, cis_beta]: [Complex<R>; 2],
    ) -> Orientation<R> {
        Orientation { alpha: self.alpha.at(cis_chi) * cis_alpha, beta: self.beta.at(cis_chi) * cis_beta }
    }

    /// Orientation and its rate, from the slow phases and the rates of χ, λ_α and λ_β, rad/s.
    pub(crate) fn attitude_state(
        &self,
        cis_chi: Complex<R>,
        slow_phases: [Phase; 2],
        [chi, lambda_alpha, lambda_beta]: [R; 3],
    ) -> AttitudeState<R> {
        let cis_lambda @ [cis_alpha, cis_beta] = slow_phases.map(Complex::cis);
        let rate = OrientationRate {
            alpha: self.alpha.rate(cis_chi, [chi, lambda_alpha]) * cis_alpha,
            beta: self.beta.rate(cis_chi, [chi, lambda_beta]) * cis_beta,
        };
        AttitudeState { orientation: self.orientation(cis_chi, cis_lambda), rate }
    }
}

impl<R: Ring> Ellipse<R> {
    #[inline]
    fn at(&self, cis_chi: Complex<R>) -> Complex<R> {
        Complex::new(self.x * cis_chi.re, self.y * cis_chi.im)
    }

    fn derivative(&self, cis_chi: Complex<R>) -> Complex<R> {
        self.at(cis_chi.times_i())
    }

    /// Rate of the parameter divided by e^{iλ}, from the rates of χ and λ.
    fn rate(&self, cis_chi: Complex<R>, [chi, lambda]: [R; 2]) -> Complex<R> {
        self.derivative(cis_chi).scaled(chi) + self.at(cis_chi).times_i().scaled(lambda)
    }
}

impl<F: Float> Ellipse<F> {
    /// Number r e^{iλ} with r > 0 and the λ of a parameter z, by least squares from z and its rate. The rates of χ and λ are given.
    pub(crate) fn slow_phase(
        &self,
        cis_chi: Complex<F>,
        rates @ [chi, lambda]: [F; 2],
        [z, z_rate]: [Complex<F>; 2],
    ) -> Complex<F> {
        let time_squared = F::ONE / (chi.squared() + lambda.squared());
        z * self.at(cis_chi).conj() + (z_rate * self.rate(cis_chi, rates).conj()).scaled(time_squared)
    }

    /// Coefficients of e^{iχ} and e^{-iχ} in the ellipse.
    pub(crate) fn exponentials(&self) -> [F; 2] {
        [(self.x + self.y).halved(), (self.x - self.y).halved()]
    }
}

impl<R: Real> Ellipse<R> {
    /// Winding number of the ellipse around 0 over 2π of χ: 1, -1, or 0 where it passes through 0.
    fn winding(&self) -> i32 {
        if self.x == R::ZERO { 0 } else { i32::from(self.y > R::ZERO) - i32::from(self.y < R::ZERO) }
    }

    /// Argument of the ellipse; where the ellipse is 0, the argument of its derivative with respect to χ.
    fn argument(&self, cis_chi: Complex<R>) -> Phase {
        let value = self.at(cis_chi);
        let value = if value == Complex::ZERO { self.derivative(cis_chi) } else { value };
        Phase::from_radians(value.arg().to_f64())
    }

    /// Argument of the ellipse, continuous in χ, within a quarter turn of ±χ; 0 if the ellipse passes through 0.
    ///
    /// * `chi`: χ with its whole turns
    pub(crate) fn continued_argument(&self, cis_chi: Complex<R>, chi: Phase) -> Phase {
        let sense = self.winding();
        if sense == 0 {
            return Phase::ZERO;
        }
        let y = if sense < 0 { -self.y } else { self.y };
        let Complex { re: cosine, im: sine } = cis_chi;
        // arg(x cos χ + i y sin χ) - χ
        let correction =
            R::atan2((y - self.x) * sine * cosine, self.x * cosine.squared() + y * sine.squared());
        (chi + Phase::from_radians(correction.to_f64())) * sense.into()
    }
}
