//! Coefficients of the equations of motion, and their derivatives with respect to the ratios and the losses.

use crate::vector::cast;
use toytop::scalar::Float;
use toytop::{ParameterError, Support, Top, TopParameters};

/// Number of ratios: A/C, A/(ps), s and g.
pub(crate) const RATIOS: usize = 4;
/// Number of losses.
pub(crate) const LOSS_COUNT: usize = 3;

/// Coefficients of the equations of motion. A change of them has the same type.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Coefficients<F = f64> {
    /// Ratio C/A.
    pub(crate) c_over_a: F,
    /// Ratio p/A, 1/m.
    pub(crate) p_over_a: F,
    /// Length s, m; 0 for a fixed tip.
    pub(crate) s: F,
    /// Gravity g, m/s².
    pub(crate) g: F,
    /// Ratio K/A, rad per unit time.
    pub(crate) k_over_a: F,
    /// Losses x₁, x₂ and x₃ about the axis, across it and about the vertical, per unit time.
    pub(crate) losses: [F; LOSS_COUNT],
}

impl<F: Float> Coefficients<F> {
    /// Rate n/A = (C/A) S + K/A of the gyroscopic torque.
    pub(crate) fn n_over_a(&self, spin: F) -> F {
        self.c_over_a * spin + self.k_over_a
    }

    /// Whether there are losses, or changes of them.
    pub(crate) fn has_losses(&self) -> bool {
        self.losses != [F::ZERO; LOSS_COUNT]
    }
}

impl Coefficients {
    /// Coefficients of a top without losses.
    pub(crate) fn new(top: &Top) -> Self {
        let a = top.transverse_inertia();
        Self {
            c_over_a: top.axial_inertia() / a,
            p_over_a: if top.support() == Support::Free { 0.0 } else { top.mass_moment() / a },
            s: top.com_height(),
            g: top.gravity(),
            k_over_a: top.rotor_momentum() / a,
            ..Self::default()
        }
    }

    /// Coefficients in the scalar of a computation.
    pub(crate) fn cast<F: Float>(&self) -> Coefficients<F> {
        let Self { c_over_a, p_over_a, s, g, k_over_a, losses } = *self;
        let [c_over_a, p_over_a, s, g, k_over_a] = cast([c_over_a, p_over_a, s, g, k_over_a]);
        Coefficients { c_over_a, p_over_a, s, g, k_over_a, losses: cast(losses) }
    }

    /// Top with these coefficients, and with the A, the rotor and the support of a given one.
    pub(crate) fn top(&self, given: &Top) -> Result<Top, ParameterError> {
        let a = given.transverse_inertia();
        let make = match given.support() {
            Support::Sliding => Top::sliding,
            Support::Fixed => Top::fixed,
            Support::Free => Top::free,
        };
        make(&TopParameters {
            transverse_inertia: a,
            axial_inertia: a * self.c_over_a,
            mass_moment: a * self.p_over_a,
            com_height: self.s,
            gravity: self.g,
            rotor_momentum: given.rotor_momentum(),
            ..TopParameters::default()
        })
    }

    /// Coefficients whose C/A, p/A, s and g are multiplied by factors.
    pub(crate) fn times(self, [c_over_a, p_over_a, s, g]: [f64; 4]) -> Self {
        Self {
            c_over_a: self.c_over_a * c_over_a,
            p_over_a: self.p_over_a * p_over_a,
            s: self.s * s,
            g: self.g * g,
            ..self
        }
    }

    /// Ratios A/C, A/(ps), s and g; A/p in the second place for a fixed tip.
    pub(crate) fn ratios(&self, support: Support) -> [f64; RATIOS] {
        let ps_over_a = if support == Support::Sliding { self.p_over_a * self.s } else { self.p_over_a };
        [1.0 / self.c_over_a, 1.0 / ps_over_a, self.s, self.g]
    }

    /// Derivatives with respect to A/C, A/(ps), s and g; for a fixed tip, to A/C, A/p, s and g. A free body depends on A/C only.
    pub(crate) fn by_ratios(&self, support: Support) -> [Self; RATIOS] {
        let Self { c_over_a, p_over_a, s, .. } = *self;
        let zero = Self::default();
        let (by_length, by_s) = match support {
            Support::Sliding => (-p_over_a * p_over_a * s, Self { p_over_a: -p_over_a / s, s: 1.0, ..zero }),
            Support::Fixed => (-p_over_a * p_over_a, zero),
            Support::Free => (0.0, zero),
        };
        [
            Self { c_over_a: -c_over_a * c_over_a, ..zero },
            Self { p_over_a: by_length, ..zero },
            by_s,
            Self { g: 1.0, ..zero },
        ]
    }
}

/// Derivatives of the logarithms of C/A, p/A, s and g, along a direction in the logarithms of the ratios.
pub(crate) fn log_derivatives(support: Support, [a_over_c, a_over_ps, s, g]: [f64; RATIOS]) -> [f64; 4] {
    let a_over_p = if support == Support::Sliding { a_over_ps + s } else { a_over_ps };
    [-a_over_c, -a_over_p, s, g]
}
