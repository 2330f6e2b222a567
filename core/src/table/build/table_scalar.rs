//! Scalar of a table that is set up: what a set-up needs besides the scalar of a tick.

use super::stored_coefficient::StoredCoefficient;
use crate::motion::Motion;
use crate::motion::period::Period;
use crate::motion::phase_equations::PhaseEquations;
use crate::scalar::{Extended, Float, Scalar};
use crate::table::evaluation::TickScalar;

/// Upper bounds on the rounding errors of a tick, whose parts are listed in [the error bound](crate::error_bound).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TickErrors {
    /// Orientation error for a body at rest, rad.
    pub(super) orientation: f64,
    /// Orientation error per rad that the body turns in half a segment.
    pub(super) per_half_segment: f64,
    /// Error of the angular velocity, divided by x' + |Λ_α' + Λ_β'|.
    pub(super) omega: f64,
    /// Further error of the angular velocity, relative to its greatest value.
    pub(super) relative_omega: f64,
}

/// Scalar of a table: `f32`, `f64`, and with the feature `fixed` `I2F30` and `I2F14`. Sealed.
pub trait TableScalar: TickScalar<Coefficient: StoredCoefficient> {
    /// Number type of the rates along the path of a set-up. `Extended` for `f64`, because a residual phase may be below 1e-16.
    #[doc(hidden)]
    type PathNumber: Float;

    /// Truncation error of a table unless another one is chosen, rad.
    const TRUNCATION: f64 = 2.0 * Self::ROUNDING;
    /// Rounding errors of a tick.
    #[doc(hidden)]
    const ERRORS: TickErrors;

    /// Nutation period, integrated in as many bits as the table needs.
    #[doc(hidden)]
    fn period(
        motion: &Motion,
        equations: &PhaseEquations<Extended>,
        pause: &mut dyn FnMut(),
    ) -> Option<Period> {
        motion.period::<1>(equations, pause)
    }
}

impl TableScalar for f64 {
    type PathNumber = Extended;

    const ERRORS: TickErrors = TickErrors {
        orientation: 24.0 * <Self as Scalar>::ROUNDING,
        per_half_segment: 0.0,
        omega: 0.0,
        relative_omega: 11.0 * <Self as Scalar>::ROUNDING,
    };

    fn period(
        motion: &Motion,
        equations: &PhaseEquations<Extended>,
        pause: &mut dyn FnMut(),
    ) -> Option<Period> {
        motion.period::<2>(equations, pause)
    }
}

/// Unit of the results in 32 bits, 2^-30.
const UNIT_Q30: f64 = 1.0 / (1_u64 << 30) as f64;
/// Error of the local coordinate, by which a and b are off.
const COORDINATE_ERROR: f64 = 2.0 / (1_u64 << 32) as f64;
/// Errors in 32 bits.
const ERRORS_Q30: TickErrors = TickErrors {
    orientation: (17.2 + 2.83 * 1.23) * UNIT_Q30,
    per_half_segment: COORDINATE_ERROR,
    omega: 44.0 * UNIT_Q30,
    relative_omega: 3.7 * <f32 as Scalar>::ROUNDING,
};

impl TableScalar for f32 {
    type PathNumber = f64;

    /// Errors with sines to 26 bits and results in `f32`.
    const ERRORS: TickErrors =
        TickErrors { orientation: (17.2 + 2.83 * 12.5) * UNIT_Q30 + f32::EPSILON as f64, ..ERRORS_Q30 };
}

#[cfg(feature = "fixed")]
impl TableScalar for fixed::types::I2F30 {
    type PathNumber = f64;

    const TRUNCATION: f64 = 4.0 * Self::ROUNDING;
    const ERRORS: TickErrors = ERRORS_Q30;
}

/// Unit of the sums in 16 bits, 2^-15.
#[cfg(feature = "fixed")]
const UNIT_Q15: f64 = 1.0 / (1_u64 << 15) as f64;

#[cfg(feature = "fixed")]
impl TableScalar for fixed::types::I2F14 {
    type PathNumber = f64;

    const ERRORS: TickErrors = TickErrors {
        orientation: 16.83 * UNIT_Q15 + 2.6e-5,
        per_half_segment: 0.5 * UNIT_Q15 + COORDINATE_ERROR,
        omega: 4.4 * UNIT_Q15,
        ..ERRORS_Q30
    };
}
