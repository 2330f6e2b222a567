//! Parameters of a top.

use super::{ParameterError, check_finite, check_range};

/// Parameters of a top, in SI or other consistent units.
///
/// Both moments of inertia are required: they default to NaN, which is refused. 0 means not given for `mass`, `mass_moment` and `com_height`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TopParameters {
    /// Transverse moment of inertia A, kg m²: about the tip for a fixed tip, otherwise about the centre of mass.
    pub transverse_inertia: f64,
    /// Axial moment of inertia C <= 2A, kg m²; 0 for a thin rod or a point at its end.
    pub axial_inertia: f64,
    /// Distance s of the centre of mass from the tip, m. For a fixed tip it gives p = M s, and A >= M s² + C/2 is checked.
    pub com_height: f64,
    /// Mass M, kg.
    pub mass: f64,
    /// Mass moment p = M s, kg m.
    pub mass_moment: f64,
    /// Gravity g, m/s², 9.80665 by default. It may be 0 for a fixed tip or a free body.
    pub gravity: f64,
    /// Angular momentum K of a rotor inside, along the axis and relative to the body, kg m²/s. M, A and C include it.
    pub rotor_momentum: f64,
}

impl Default for TopParameters {
    fn default() -> Self {
        Self {
            transverse_inertia: f64::NAN,
            axial_inertia: f64::NAN,
            com_height: 0.0,
            mass: 0.0,
            mass_moment: 0.0,
            gravity: 9.80665,
            rotor_momentum: 0.0,
        }
    }
}

pub(super) fn check_positive(parameter: &'static str, value: f64) -> Result<f64, ParameterError> {
    check_range(1e-60..=1e60, parameter, value, "positive, between 1e-60 and 1e60")
}

impl TopParameters {
    /// Parameters of a toy top of 50 g, for examples and tests.
    pub const TOY: Self = Self {
        transverse_inertia: 3.0e-5,
        axial_inertia: 2.0e-5,
        com_height: 0.03,
        mass: 0.05,
        mass_moment: 0.0,
        gravity: 9.81,
        rotor_momentum: 0.0,
    };

    /// Mass, or `None` where the mass moment is given instead.
    pub(super) fn given_mass(&self) -> Result<Option<f64>, ParameterError> {
        check_finite("mass", self.mass)?;
        check_finite("mass_moment", self.mass_moment)?;
        match (self.mass == 0.0, self.mass_moment == 0.0) {
            (false, true) => check_positive("mass", self.mass).map(Some),
            (true, false) => Ok(None),
            _ => Err(ParameterError::new("mass", "given if mass_moment is not, and left out if it is")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Support, Top};

    const TOP: TopParameters = TopParameters::TOY;

    fn refused(result: Result<Top, ParameterError>) -> Option<&'static str> {
        result.err().map(|error| error.parameter())
    }

    #[test]
    fn every_parameter_is_checked_and_named() {
        let sliding = |change: fn(&mut TopParameters)| {
            let mut parameters = TOP;
            change(&mut parameters);
            refused(Top::sliding(&parameters))
        };
        assert_eq!(sliding(|_| {}), None);
        let forgotten = TopParameters { transverse_inertia: 3e-5, ..TopParameters::default() };
        assert_eq!(refused(Top::free(&forgotten)), Some("axial_inertia"));
        assert_eq!(refused(Top::free(&TopParameters::default())), Some("transverse_inertia"));
        assert_eq!(sliding(|top| top.transverse_inertia = f64::NAN), Some("transverse_inertia"));
        assert_eq!(sliding(|top| top.axial_inertia = 6.1e-5), Some("axial_inertia"));
        assert_eq!(sliding(|top| top.axial_inertia = 6e-5), None);
        assert_eq!(sliding(|top| top.axial_inertia = -1e-9), Some("axial_inertia"));
        assert_eq!(sliding(|top| top.axial_inertia = 0.0), None);
        assert_eq!(sliding(|top| top.gravity = 0.0), Some("gravity"));
        assert_eq!(sliding(|top| top.com_height = 0.0), Some("com_height"));
        assert_eq!(sliding(|top| top.mass = -1.0), Some("mass"));
        assert_eq!(sliding(|top| top.mass = 0.0), Some("mass"));
        assert_eq!(sliding(|top| top.mass_moment = 1e-3), Some("mass"));
        assert_eq!(sliding(|top| (top.mass, top.mass_moment) = (0.0, -1.0)), Some("mass_moment"));
        assert_eq!(sliding(|top| (top.mass, top.mass_moment) = (0.0, 1.5e-3)), None);
        assert_eq!(sliding(|top| top.gravity = f64::INFINITY), Some("gravity"));
        assert_eq!(sliding(|top| top.rotor_momentum = f64::NAN), Some("rotor_momentum"));
        assert_eq!(sliding(|top| top.rotor_momentum = -3.1e7), Some("rotor_momentum"));
        assert_eq!(sliding(|top| top.rotor_momentum = -3e7), None);
        assert_eq!(
            sliding(|top| (top.transverse_inertia, top.axial_inertia) = (1e-12, 1e-12)),
            Some("transverse_inertia")
        );
        assert_eq!(sliding(|top| top.gravity = 1e17), Some("gravity"));
    }

    #[test]
    fn a_fixed_tip_takes_inertias_about_the_tip() {
        let fixed = |change: fn(&mut TopParameters)| {
            let mut parameters = TOP;
            change(&mut parameters);
            refused(Top::fixed(&parameters))
        };
        assert_eq!(
            fixed(|top| (top.mass, top.com_height, top.mass_moment) = (0.0, 0.0, -0.1)),
            Some("mass_moment")
        );
        assert_eq!(fixed(|top| (top.mass, top.mass_moment) = (0.0, 0.1)), Some("com_height"));
        assert_eq!(fixed(|top| top.mass = 0.0), Some("mass"));
        for change in [
            |top: &mut TopParameters| (top.mass, top.mass_moment, top.com_height) = (0.0, 0.1, f64::NAN),
            |top: &mut TopParameters| (top.mass, top.mass_moment) = (f64::NAN, 0.1),
            |top: &mut TopParameters| (top.mass, top.mass_moment) = (0.1, f64::NAN),
        ] {
            let mut parameters = TOP;
            change(&mut parameters);
            assert!(Top::fixed(&parameters).is_err_and(|error| error.is_not_finite()));
        }
        // 0.05 kg · (0.03 m)² = 4.5e-5 kg m²
        assert_eq!(fixed(|top| top.transverse_inertia = 5.5e-5), None);
        assert_eq!(fixed(|top| top.transverse_inertia = 5.4999e-5), Some("transverse_inertia"));
    }

    #[test]
    fn a_free_body_takes_two_inertias() {
        let body = TopParameters { com_height: 0.0, mass: 0.0, ..TOP };
        let top = Top::free(&body).unwrap();
        assert!(top.is_torque_free() && top.support() == Support::Free && top.e4().is_none());
        assert_eq!(top, Top::free(&TOP).unwrap());
        assert_eq!(refused(Top::free(&TopParameters { mass: f64::NAN, ..body })), Some("mass"));
        let weightless = TopParameters { mass_moment: 1e-3, gravity: 0.0, ..body };
        assert!(Top::fixed(&weightless).unwrap().is_torque_free());
    }
}
