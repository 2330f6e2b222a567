//! The top: A, C, s, p and the gravity it spins in.

use crate::error::{LaunchError, finite, require};
use crate::real::{DoubleDouble, Float, Ring};

/// How heavy the top is: exactly one of two ways to say it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Heaviness {
    /// Its mass M in kg; the moment is then p = M s.
    Mass(f64),
    /// The paper's p = M s in kg m.
    MassMoment(f64),
}

/// What holds the tip.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Support {
    /// A frictionless horizontal plane, on which the tip slides: Springborn's toy top.
    Sliding,
    /// A fixed point: the Lagrange top, the limit s → 0 of the formulas at fixed p.
    Fixed,
}

/// A symmetric top, validated. Copy it, share it: it never changes.
///
/// Any consistent units will do; those named are SI. With g = 1 they are the paper's.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Top {
    support: Support,
    a: f64,
    c: f64,
    s: f64,
    p: DoubleDouble,
    g: f64,
}

/// With this range, and those of A/(ps), A/p and √(pg/A), nothing overflows or underflows in `f32` either.
const ALLOWED: &str = "between 1e-12 and 1e12";

fn magnitude(parameter: &'static str, value: f64) -> Result<f64, LaunchError> {
    finite(parameter, value)?;
    require(value > 0.0, parameter, "positive, between 1e-12 and 1e12")?;
    require((1e-12..=1e12).contains(&value), parameter, ALLOWED)?;
    Ok(value)
}

impl Top {
    /// A top whose tip slides on a plane.
    ///
    /// * `transverse_inertia`: A, about an axis through the centre of mass across the symmetry axis, kg m²
    /// * `axial_inertia`: C <= 2A, about the symmetry axis, kg m²
    /// * `com_height`: s, distance of the centre of mass from the tip, m
    /// * `gravity`: g, m/s²
    ///
    /// # Errors
    /// Names the parameter that is not finite, not between 1e-12 and 1e12, or (C) above 2A or below 1e-6 A; `A/(ps)`, the square of a
    /// radius of gyration over s, must be between 1e-6 and 1e12, A/p between 1e-12 and 1e12 m, and √(pg/A), the rate at
    /// which the top falls, between 1e-9 and 1e9 per second.
    pub fn sliding(
        transverse_inertia: f64,
        axial_inertia: f64,
        com_height: f64,
        heaviness: Heaviness,
        gravity: f64,
    ) -> Result<Self, LaunchError> {
        let s = magnitude("com_height", com_height)?;
        let p = match heaviness {
            Heaviness::Mass(mass) => DoubleDouble::product(magnitude("mass", mass)?, s),
            Heaviness::MassMoment(moment) => magnitude("mass_moment", moment)?.into(),
        };
        let top = Self::new(Support::Sliding, transverse_inertia, axial_inertia, s, p, gravity)?;
        let spread = top.a / (top.p.hi() * s);
        require(
            (1e-6..=1e12).contains(&spread),
            "transverse_inertia",
            "between 1e-6 and 1e12 times mass_moment x com_height",
        )?;
        Ok(top)
    }

    /// A top whose tip is held in a fixed point: both inertias are then about the *tip*, and only the product
    /// p = M s (kg m) of mass and height enters.
    ///
    /// # Errors
    /// As [`Top::sliding`].
    pub fn fixed(
        transverse_inertia: f64,
        axial_inertia: f64,
        mass_moment: f64,
        gravity: f64,
    ) -> Result<Self, LaunchError> {
        let p = magnitude("mass_moment", mass_moment)?.into();
        Self::new(Support::Fixed, transverse_inertia, axial_inertia, 0.0, p, gravity)
    }

    /// As [`Top::fixed`], from the mass (kg) and the height of the centre of mass above the tip (m).
    ///
    /// # Errors
    /// As [`Top::sliding`]; and A below M s² + C/2, which no body has about its tip: most likely it is about the centre of mass.
    pub fn fixed_with_mass(
        transverse_inertia: f64,
        axial_inertia: f64,
        com_height: f64,
        mass: f64,
        gravity: f64,
    ) -> Result<Self, LaunchError> {
        /// Room for what the numbers are rounded to.
        const ROOM: f64 = 1e-9;
        let p = DoubleDouble::product(magnitude("mass", mass)?, magnitude("com_height", com_height)?);
        let top = Self::new(Support::Fixed, transverse_inertia, axial_inertia, 0.0, p, gravity)?;
        let least = p.hi() * com_height + 0.5 * top.c;
        require(
            top.a >= least * (1.0 - ROOM),
            "transverse_inertia",
            "about the tip, at least mass x com_height^2 + axial_inertia / 2",
        )?;
        Ok(top)
    }

    fn new(support: Support, a: f64, c: f64, s: f64, p: DoubleDouble, g: f64) -> Result<Self, LaunchError> {
        let a = magnitude("transverse_inertia", a)?;
        let c = magnitude("axial_inertia", c)?;
        require(c <= 2.0 * a, "axial_inertia", "at most twice transverse_inertia (no body has C > 2A)")?;
        require(c >= 1e-6 * a, "axial_inertia", "at least 1e-6 times transverse_inertia")?;
        let g = magnitude("gravity", g)?;
        let length = a / p.hi();
        require(
            (1e-12..=1e12).contains(&length),
            "transverse_inertia",
            "between 1e-12 and 1e12 m times the mass moment",
        )?;
        let rate_squared = g / length;
        require(
            (1e-18..=1e18).contains(&rate_squared),
            "gravity",
            "such that sqrt(mass_moment x gravity / transverse_inertia) is between 1e-9 and 1e9 per second",
        )?;
        Ok(Self { support, a, c, s, p, g })
    }

    /// What holds the tip.
    #[must_use]
    pub fn support(&self) -> Support {
        self.support
    }

    /// A, the transverse moment of inertia, kg m² (sliding: about the centre of mass; fixed: about the tip).
    #[must_use]
    pub fn a(&self) -> f64 {
        self.a
    }

    /// C, the axial moment of inertia, kg m².
    #[must_use]
    pub fn c(&self) -> f64 {
        self.c
    }

    /// s, the distance of the centre of mass from the sliding tip, m; 0 for a fixed tip, where the paper's formulas are
    /// read in the limit s → 0 at fixed p.
    #[must_use]
    pub fn s(&self) -> f64 {
        self.s
    }

    /// The length that scales the tip curve c = 2 s αβ: s, and 1 for a fixed tip (where 2αβ is a direction).
    #[must_use]
    pub fn tip_scale(&self) -> f64 {
        match self.support {
            Support::Sliding => self.s,
            Support::Fixed => 1.0,
        }
    }

    /// p = M s, kg m.
    #[must_use]
    pub fn p(&self) -> f64 {
        self.p.hi()
    }

    /// g, m/s². The paper has g = 1.
    #[must_use]
    pub fn g(&self) -> f64 {
        self.g
    }

    /// e₄ = √(1 + A/(ps)), the branch point that no motion reaches; `None` (infinite) for a fixed tip.
    #[must_use]
    pub fn e4(&self) -> Option<f64> {
        (self.s > 0.0).then(|| {
            let quantities = Quantities::<DoubleDouble>::of(self);
            (DoubleDouble::ONE + quantities.a / (quantities.p * quantities.s)).sqrt().to_f64()
        })
    }
}

/// The paper's quantities in the number type that a set-up stage computes in.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Quantities<F> {
    pub(crate) a: F,
    pub(crate) c: F,
    pub(crate) s: F,
    pub(crate) p: F,
    pub(crate) g: F,
}

impl<F: Float> Quantities<F> {
    pub(crate) fn of(top: &Top) -> Self {
        let p = F::from_f64(top.p.hi()) + F::from_f64(top.p.lo());
        Self { a: F::from_f64(top.a), c: F::from_f64(top.c), s: F::from_f64(top.s), p, g: F::from_f64(top.g) }
    }

    /// κ = 1/(2 A p g): κ l² has the dimension of u³.
    pub(crate) fn kappa(&self) -> F {
        F::ONE / (self.a * self.p * self.g).doubled()
    }

    /// τ = (1/C - 1/A) n.
    pub(crate) fn tau(&self, n: F) -> F {
        (self.a - self.c) / (self.a * self.c) * n
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_parameter_is_checked_and_named() {
        let mass = Heaviness::Mass(0.05);
        let parameter = |result: Result<Top, LaunchError>| result.err().map(|error| error.parameter());
        assert_eq!(parameter(Top::sliding(3e-5, 2e-5, 0.03, mass, 9.81)), None);
        assert_eq!(parameter(Top::sliding(f64::NAN, 2e-5, 0.03, mass, 9.81)), Some("transverse_inertia"));
        assert_eq!(parameter(Top::sliding(3e-5, 6.1e-5, 0.03, mass, 9.81)), Some("axial_inertia"));
        assert_eq!(parameter(Top::sliding(3e-5, 6e-5, 0.03, mass, 9.81)), None);
        assert_eq!(parameter(Top::sliding(3e-5, 2e-5, 0.0, mass, 9.81)), Some("com_height"));
        assert_eq!(parameter(Top::sliding(3e-5, 2e-5, 0.03, Heaviness::Mass(-1.0), 9.81)), Some("mass"));
        assert_eq!(
            parameter(Top::sliding(3e-5, 2e-5, 0.03, Heaviness::MassMoment(0.0), 9.81)),
            Some("mass_moment")
        );
        assert_eq!(parameter(Top::sliding(3e-5, 2e-5, 0.03, mass, f64::INFINITY)), Some("gravity"));
        assert_eq!(parameter(Top::sliding(1e-11, 1e-11, 0.03, mass, 9.81)), Some("transverse_inertia"));
        assert_eq!(parameter(Top::fixed(3e-5, 2e-5, -0.1, 9.81)), Some("mass_moment"));
        assert_eq!(parameter(Top::fixed_with_mass(3e-5, 2e-5, 0.03, 0.0, 9.81)), Some("mass"));
        // 0.05 kg x (0.03 m)^2 = 4.5e-5 kg m^2
        assert_eq!(parameter(Top::fixed_with_mass(5.5e-5, 2e-5, 0.03, 0.05, 9.81)), None);
        assert_eq!(
            parameter(Top::fixed_with_mass(5.4999e-5, 2e-5, 0.03, 0.05, 9.81)),
            Some("transverse_inertia")
        );
    }

    #[test]
    fn the_mass_moment_is_exact() {
        let top = Top::sliding(3e-5, 2e-5, 0.03, Heaviness::Mass(0.05), 9.81).unwrap();
        assert!(top.p.lo() != 0.0);
        assert_eq!(top.p(), 0.05 * 0.03);
        let p = Quantities::<DoubleDouble>::of(&top).p;
        assert_eq!((p.hi(), p.lo()), (top.p.hi(), top.p.lo()));
    }
}
