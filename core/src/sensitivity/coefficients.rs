//! Coefficients of the equations of motion, and their derivatives by the ratios of the top.

use crate::scalar::Float;
use crate::top::{Support, Top};

/// Coefficients of the equations of motion, or a change of them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Coefficients<F> {
    /// Ratio C/A.
    pub(crate) inertia: F,
    /// Quotient p/A, 1/m.
    pub(crate) moment: F,
    /// Length s, m; 0 for a fixed tip.
    pub(crate) height: F,
    /// Gravity g, m/s².
    pub(crate) gravity: F,
    /// Rate K/A of a rotor's momentum, rad per unit time.
    pub(crate) rotor: F,
}

impl Coefficients<f64> {
    /// Coefficients of a top.
    pub(crate) fn of(top: &Top) -> Self {
        let a = top.transverse_inertia();
        Self {
            inertia: top.axial_inertia() / a,
            moment: if top.support() == Support::Free { 0.0 } else { top.mass_moment() / a },
            height: top.com_height(),
            gravity: top.gravity(),
            rotor: top.rotor_momentum() / a,
        }
    }

    /// Derivatives by A/C, A/(ps), s and g; for a fixed tip by A/C, A/p, s and g. A free body depends on A/C only.
    pub(crate) fn derivatives(&self, support: Support) -> [Self; 4] {
        let Self { inertia: c, moment: b, height: s, .. } = *self;
        let none = Self { inertia: 0.0, moment: 0.0, height: 0.0, gravity: 0.0, rotor: 0.0 };
        let (by_ratio, by_height) = match support {
            Support::Sliding => {
                (Self { moment: -b * b * s, ..none }, Self { moment: -b / s, height: 1.0, ..none })
            }
            Support::Fixed => (Self { moment: -b * b, ..none }, none),
            Support::Free => (none, none),
        };
        [Self { inertia: -c * c, ..none }, by_ratio, by_height, Self { gravity: 1.0, ..none }]
    }

    /// Coefficients in another scalar.
    pub(super) fn cast<F: Float>(&self) -> Coefficients<F> {
        let Self { inertia, moment, height, gravity, rotor } = *self;
        let [inertia, moment, height, gravity, rotor] =
            [inertia, moment, height, gravity, rotor].map(F::from_f64);
        Coefficients { inertia, moment, height, gravity, rotor }
    }
}
