//! Symmetric top, with valid parameters.

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
/// Its numbers are those that were given; they are not rounded to `f64`.
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
    #[doc(hidden)]
    pub fn a_over_ps(&self) -> Extended {
        self.a / (self.p * self.s)
    }

    /// Length D(u) = A/p + s (1 - u²), from 1 - u².
    #[doc(hidden)]
    pub fn d(&self, sine_squared: Extended) -> Extended {
        self.a / self.p + self.s * sine_squared
    }

    /// Unit of the energy of the axis: the weight p g, or 1 without it.
    pub(crate) fn weight_or_one(&self) -> Extended {
        if self.is_torque_free() { Extended::ONE } else { self.p * self.g }
    }

    /// Factor κ = 1/(2 A p g), which makes κ l² dimensionless.
    pub(crate) fn kappa(&self) -> Extended {
        Extended::ONE / (self.a * self.p * self.g).doubled()
    }

    /// Axial rate ⟨ω, r⟩ = (n - K)/C of the body, rad/s; 0 where C = 0, because n does not determine it.
    pub(crate) fn spin(&self, n: Extended) -> Extended {
        if self.c > Extended::ZERO { (n - self.k) / self.c } else { Extended::ZERO }
    }

    /// Unrounded A, C, s, p, g and K.
    #[doc(hidden)]
    pub fn parts(&self) -> [Extended; 6] {
        [self.a, self.c, self.s, self.p, self.g, self.k]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::TopParameters;

    #[test]
    fn the_mass_moment_is_exact() {
        let top = Top::sliding(&TopParameters::TOY).unwrap();
        assert!(top.p.to_parts()[1] != 0.0);
        assert_eq!(top.mass_moment(), 0.05 * 0.03);
    }
}
