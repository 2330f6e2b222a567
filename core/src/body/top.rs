//! Symmetric top, with valid parameters, and their allowed ranges.

use super::parameters::check_positive;
use super::{ParameterError, TopParameters, check, check_finite, check_range};
use crate::scalar::{Extended, Float, Ring};

/// Support of the tip.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Support {
    /// Sliding on a frictionless horizontal plane: Springborn's toy top.
    Sliding,
    /// Held at a fixed point: the Lagrange top, the limit s → 0 of the formulas at fixed p.
    Fixed,
    /// None: a body that is thrown, floats or is in orbit.
    Free,
}

/// Symmetric top, in SI or any other consistent units. With g = 1 they are the paper's.
///
/// The product p = M s is not rounded to `f64`. A rotor momentum below 1e-60 A counts as 0.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Top {
    pub(crate) support: Support,
    pub(crate) a: Extended,
    pub(crate) c: Extended,
    pub(crate) s: Extended,
    /// Mass moment p = M s, the exact product.
    pub(crate) p: Extended,
    pub(crate) g: Extended,
    pub(crate) k: Extended,
}

impl Top {
    /// Top whose tip slides on a plane: Springborn's toy top. It needs A, C, s, and either M or p.
    ///
    /// # Errors
    /// [`ParameterError`] names the wrong parameter. The ranges are
    ///
    /// * A, s, g, and M or p: 1e-60 to 1e60
    /// * C: 0, or 1e-60 A to 2A
    /// * A/(ps): 1e-6 to 1e30
    /// * √(pg/A): 1e-9 to 1e9 per unit of time
    /// * |K|/A: at most 1e12 per unit of time
    pub fn sliding(parameters: &TopParameters) -> Result<Self, ParameterError> {
        check(
            parameters.gravity != 0.0,
            "gravity",
            "positive: without weight nothing keeps the tip on the plane, and the body is free",
        )?;
        let s = check_positive("com_height", parameters.com_height)?;
        let p = match parameters.given_mass()? {
            Some(mass) => Extended::from(mass) * s.into(),
            None => check_positive("mass_moment", parameters.mass_moment)?.into(),
        };
        let top = Self::new(Support::Sliding, parameters, s, p)?;
        check_range(
            1e-6..=1e30,
            "transverse_inertia",
            top.a_over_ps().to_f64(),
            "between 1e-6 and 1e30 times mass_moment x com_height",
        )?;
        Ok(top)
    }

    /// Top whose tip is held at a fixed point, the Lagrange top. It needs A and C, both about the *tip*, and either p, or M and
    /// s. Without gravity the top moves like a [`Top::free`].
    ///
    /// # Errors
    /// [`ParameterError`] names the wrong parameter. The ranges are
    ///
    /// * A, and p or M and s: 1e-60 to 1e60; with M, A at least M s² + C/2
    /// * C: 0, or 1e-60 A to 2A; without gravity 0, or 1e-20 A to 2A
    /// * g: 0, or 1e-60 to 1e60 with √(pg/A) 1e-9 to 1e9 per unit of time
    /// * |K|/A: at most 1e12 per unit of time
    pub fn fixed(parameters: &TopParameters) -> Result<Self, ParameterError> {
        const ROUNDING: f64 = 1e-9;
        let Some(mass) = parameters.given_mass()? else {
            check_range(
                0.0..=0.0,
                "com_height",
                parameters.com_height,
                "left out where the tip is fixed and mass_moment is given",
            )?;
            let p = check_positive("mass_moment", parameters.mass_moment)?.into();
            return Self::new(Support::Fixed, parameters, 0.0, p);
        };
        let p = Extended::from(mass) * check_positive("com_height", parameters.com_height)?.into();
        let top = Self::new(Support::Fixed, parameters, 0.0, p)?;
        let least = top.mass_moment() * parameters.com_height + 0.5 * top.axial_inertia();
        check(
            top.transverse_inertia() >= least * (1.0 - ROUNDING),
            "transverse_inertia",
            "the moment about the tip, at least mass x com_height^2 + axial_inertia / 2",
        )?;
        Ok(top)
    }

    /// Body without support. It needs A and C, both about its centre of mass; of the other parameters only K has an effect.
    ///
    /// # Errors
    /// [`ParameterError`] names the wrong parameter. A must be 1e-60 to 1e60; C 0, or 1e-20 A to 2A; |K|/A at most 1e12 per unit of
    /// time; and the others finite.
    pub fn free(parameters: &TopParameters) -> Result<Self, ParameterError> {
        check_finite("com_height", parameters.com_height)?;
        check_finite("mass", parameters.mass)?;
        check_finite("mass_moment", parameters.mass_moment)?;
        check_finite("gravity", parameters.gravity)?;
        let weightless = TopParameters { gravity: 0.0, ..*parameters };
        Self::new(Support::Free, &weightless, 0.0, Extended::ZERO)
    }

    fn new(
        support: Support,
        parameters: &TopParameters,
        s: f64,
        p: Extended,
    ) -> Result<Self, ParameterError> {
        let a = check_positive("transverse_inertia", parameters.transverse_inertia)?;
        let c = check_range(
            0.0..=2.0 * a,
            "axial_inertia",
            parameters.axial_inertia,
            "between 0 and twice transverse_inertia (no body has C > 2A)",
        )?;
        check(c == 0.0 || c >= 1e-60 * a, "axial_inertia", "0, or at least 1e-60 times transverse_inertia")?;
        let g = if parameters.gravity == 0.0 { 0.0 } else { check_positive("gravity", parameters.gravity)? };
        check(
            g > 0.0 || c == 0.0 || c >= 1e-20 * a,
            "axial_inertia",
            "0, or without gravity at least 1e-20 times transverse_inertia",
        )?;
        check(
            g == 0.0 || (1e-18..=1e18).contains(&(g * (p.to_f64() / a))),
            "gravity",
            "such that sqrt(mass_moment x gravity / transverse_inertia) is between 1e-9 and 1e9 per second (change the \
             unit of time), or a free body instead",
        )?;
        let k = check_finite("rotor_momentum", parameters.rotor_momentum)?;
        check(
            k.abs() <= 1e12 * a,
            "rotor_momentum",
            "at most 1e12 per second times transverse_inertia in magnitude",
        )?;
        let k = if k.abs() < 1e-60 * a { 0.0 } else { k };
        let [a, c, s, g, k] = [a, c, s, g, k].map(Extended::from);
        Ok(Self { support, a, c, s, p, g, k })
    }
}

impl Top {
    /// Support of the tip.
    pub fn support(&self) -> Support {
        self.support
    }

    /// Transverse moment of inertia A, kg m²: about the tip for a fixed tip, otherwise about the centre of mass.
    pub fn transverse_inertia(&self) -> f64 {
        self.a.to_f64()
    }

    /// Axial moment of inertia C, kg m².
    pub fn axial_inertia(&self) -> f64 {
        self.c.to_f64()
    }

    /// Distance s of the centre of mass from a sliding tip, m; 0 for another support.
    pub fn com_height(&self) -> f64 {
        self.s.to_f64()
    }

    /// Length in the tip curve c = 2 s αβ, m: s, or 1 for another support.
    pub fn tip_scale(&self) -> f64 {
        match self.support {
            Support::Sliding => self.com_height(),
            Support::Fixed | Support::Free => 1.0,
        }
    }

    /// Whether no torque acts.
    pub fn is_torque_free(&self) -> bool {
        self.g == Extended::ZERO
    }

    /// Mass moment p = M s, kg m; 0 for a free body.
    pub fn mass_moment(&self) -> f64 {
        self.p.to_f64()
    }

    /// Gravity g, m/s²; 0 for a free body.
    pub fn gravity(&self) -> f64 {
        self.g.to_f64()
    }

    /// Angular momentum K of the rotor inside, kg m²/s; 0 without one. n = C ⟨ω, r⟩ + K.
    pub fn rotor_momentum(&self) -> f64 {
        self.k.to_f64()
    }

    /// Branch point e₄ = √(1 + A/(ps)) (equation (3.5)), which u never reaches; `None` unless the tip slides.
    pub fn e4(&self) -> Option<f64> {
        (self.support == Support::Sliding).then(|| (Extended::ONE + self.a_over_ps()).sqrt().to_f64())
    }

    /// Quotient A/(ps) = e₄² - 1.
    pub(crate) fn a_over_ps(&self) -> Extended {
        self.a / (self.p * self.s)
    }

    /// Length D(u) = A/p + s (1 - u²), from 1 - u².
    pub(crate) fn length_d(&self, sine_squared: Extended) -> Extended {
        self.a / self.p + self.s * sine_squared
    }

    /// Unit of the energy of the axis: the weight p g, or 1 without it.
    pub(crate) fn energy_unit(&self) -> Extended {
        if self.is_torque_free() { Extended::ONE } else { self.p * self.g }
    }

    /// Factor 1/(2 A p g), by which the square of an angular momentum becomes an energy of the axis over the weight p g.
    pub(crate) fn energy_factor(&self) -> Extended {
        Extended::ONE / (self.a * self.p * self.g).doubled()
    }

    /// Half of τ = ⟨ω, r⟩ - n/A, rad/s, from the axial rate ⟨ω, r⟩.
    #[inline(never)] // stack
    pub(crate) fn half_tau(&self, spin: Extended) -> Extended {
        let Self { a, c, k, .. } = *self;
        ((a - c) / a * spin - k / a).halved()
    }

    /// Axial rate ⟨ω, r⟩ = (n - K)/C of the body, rad/s; 0 where C = 0, because n does not determine it.
    pub(crate) fn spin(&self, n: Extended) -> Extended {
        if self.c > Extended::ZERO { (n - self.k) / self.c } else { Extended::ZERO }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_mass_moment_is_exact() {
        let top = Top::sliding(&TopParameters::TOY).unwrap();
        assert!(top.p.to_f64_pair()[1] != 0.0);
        assert_eq!(top.mass_moment(), 0.05 * 0.03);
    }
}
