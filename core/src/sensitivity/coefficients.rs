//! Coefficients of the equations of motion, and their derivatives with respect to the ratios of the top.

use crate::scalar::Float;
use crate::top::{Support, Top};

/// Number of losses.
pub(crate) const LOSSES: usize = 3;

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
    /// Losses of rotation about the axis, across it, and about the vertical, per unit time. They are 0 in the exact motion.
    pub(crate) losses: [F; LOSSES],
}

impl Coefficients<f64> {
    /// Zero change.
    pub(super) const NONE: Self =
        Self { inertia: 0.0, moment: 0.0, height: 0.0, gravity: 0.0, rotor: 0.0, losses: [0.0; LOSSES] };

    /// Coefficients of a top.
    pub(crate) fn of(top: &Top) -> Self {
        let a = top.transverse_inertia();
        Self {
            inertia: top.axial_inertia() / a,
            moment: if top.support() == Support::Free { 0.0 } else { top.mass_moment() / a },
            height: top.com_height(),
            gravity: top.gravity(),
            rotor: top.rotor_momentum() / a,
            losses: [0.0; LOSSES],
        }
    }

    /// Derivatives with respect to A/C, A/(ps), s and g; for a fixed tip, to A/C, A/p, s and g. A free body depends on
    /// A/C only.
    pub(crate) fn derivatives(&self, support: Support) -> [Self; 4] {
        let Self { inertia: c, moment: b, height: s, .. } = *self;
        let none = Self::NONE;
        let (by_ratio, by_height) = match support {
            Support::Sliding => {
                (Self { moment: -b * b * s, ..none }, Self { moment: -b / s, height: 1.0, ..none })
            }
            Support::Fixed => (Self { moment: -b * b, ..none }, none),
            Support::Free => (none, none),
        };
        [Self { inertia: -c * c, ..none }, by_ratio, by_height, Self { gravity: 1.0, ..none }]
    }

    /// Derivatives with respect to the losses.
    pub(crate) fn by_losses() -> [Self; LOSSES] {
        let mut changes = [Self::NONE; LOSSES];
        for (index, change) in changes.iter_mut().enumerate() {
            if let Some(slot) = change.losses.get_mut(index) {
                *slot = 1.0;
            }
        }
        changes
    }

    /// Linear combination of changes with these factors.
    pub(crate) fn combined(changes: &[Self; 4], shares: &[f64; 4]) -> Self {
        let mut sum = Self::NONE;
        for (change, share) in changes.iter().zip(shares) {
            sum.inertia += share * change.inertia;
            sum.moment += share * change.moment;
            sum.height += share * change.height;
            sum.gravity += share * change.gravity;
        }
        sum
    }

    /// Coefficients in another scalar.
    pub(super) fn cast<F: Float>(&self) -> Coefficients<F> {
        let Self { inertia, moment, height, gravity, rotor, losses } = *self;
        let [inertia, moment, height, gravity, rotor] =
            [inertia, moment, height, gravity, rotor].map(F::from_f64);
        Coefficients { inertia, moment, height, gravity, rotor, losses: losses.map(F::from_f64) }
    }
}
