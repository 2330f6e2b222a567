//! Evaluation of a segment: the coefficients of a scalar, and α and β from them.

mod rates;

mod coefficient;

mod float;

mod integer;

#[cfg(feature = "fixed")]
mod narrow;

#[cfg(feature = "fixed")]
mod fixed_point;

#[cfg(feature = "micromath")]
mod micromath;

#[cfg(feature = "micromath")]
pub use micromath::Micromath;
pub(crate) use rates::ValuesAndSlopes;

use crate::complex::Complex;
use crate::scalar::{Real, Ring, Scalar};
use crate::su2::Vector;
use core::fmt::Debug;

/// Local coordinate on a segment, and the mean rotations of α and β there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[doc(hidden)]
pub struct SegmentPoint {
    /// Local coordinate on the segment: x·2^63 with x in [-1, 1).
    pub x: i64,
    /// Local coordinate times 2^31, rounded down to a multiple of 2^-35 of half a period.
    pub short_x: i32,
    /// Whether u is falling. Apart from their mean rotation, α and β are then the complex conjugates of the tabulated
    /// values.
    pub mirrored: bool,
    /// Mean rotations of α and β: the 64 leading bits of a fraction of a turn.
    pub slow: [u64; 2],
}

/// Errors that the evaluation of a tick may have. They are values, so that the error bounds are compiled once for all scalars.
#[derive(Clone, Copy, Debug, PartialEq)]
#[doc(hidden)]
pub struct EvaluationErrors {
    /// Upper bound on the rounding error of a tick, as an orientation error in rad, without the errors that the next
    /// fields describe.
    pub tick: f64,
    /// Standard deviation of the random rounding error of a tick in floating point, as an orientation error in rad.
    pub tick_deviation: f64,
    /// Upper bound on a further rounding error of a tick, over the greatest change of the orientation on half a
    /// segment.
    pub slope: f64,
    /// Upper bound on the truncation of the local coordinate in a tick, as a fraction of a pair of cells.
    pub place: f64,
    /// Upper bound on the rounding error of the angular velocity, over the greatest of the rates that multiply the
    /// polynomials and their derivatives.
    pub rate: f64,
    /// Upper bound on a further rounding error of the angular velocity, relative to its greatest value.
    pub relative_rate: f64,
    /// Upper bound on the relative error of an operation in the numbers of the mean rates.
    pub operation: f64,
}

/// Scalar of an ephemeris: `f32`, `f64`, and with the feature `fixed` `I2F30` and `I2F14`. Sealed.
///
/// `f64` is evaluated in floating point. `f32` and fixed point are evaluated in 32-bit integers. The error is then a
/// quarter of that of `f32` arithmetic, and the evaluation is as fast as with a floating-point unit and several times
/// as fast as with emulated `f32`.
pub trait EphemerisScalar: Scalar {
    /// Type of a coefficient in the table.
    type Coefficient: Copy + Debug + PartialEq;
    /// Segment type: coefficients of Re α, Im α, Re β and Im β side by side, lowest power first.
    type Segment: Copy + Debug + PartialEq + AsRef<[[Self::Coefficient; 4]]> + AsMut<[[Self::Coefficient; 4]]>;
    /// Type of lengths and rates: the scalar itself, or `f32` for fixed point, whose range is too small for them.
    type Wide: Real;
    /// Type of rates as multiples of a power of two: the scalar itself, or `I2F30` for fixed point.
    #[doc(hidden)]
    type Rate: Ring;

    /// Number of coefficients of a polynomial, its degree plus one.
    const TERMS: usize;
    /// Segment whose coefficients are all 0.
    #[doc(hidden)]
    const ZERO_SEGMENT: Self::Segment;
    /// Code of the scalar in table data: see `core/docs/table_format.md`.
    #[doc(hidden)]
    const CODE: u32;
    /// Errors of the evaluation.
    #[doc(hidden)]
    const ERRORS: EvaluationErrors;

    /// Coefficient of x^power nearest to a value in units of 2^-62, and its error in these units.
    #[doc(hidden)]
    fn coefficient(value: i64, power: usize) -> (Self::Coefficient, i64);
    /// Error of a polynomial, given in units of 2^-62, that its coefficients cause; infinite where a sum could overflow,
    /// and 0 in floating point.
    #[doc(hidden)]
    fn coefficient_error(polynomial: &[i64]) -> f32;
    /// Value of a coefficient of x^power.
    #[doc(hidden)]
    fn number(coefficient: Self::Coefficient, power: usize) -> Self::Wide;
    /// Value in the wide type.
    #[doc(hidden)]
    fn widened(self) -> Self::Wide;
    /// α and β at a point of a segment.
    #[doc(hidden)]
    fn alpha_beta(terms: &[[Self::Coefficient; 4]], point: SegmentPoint) -> [Complex<Self>; 2];
    /// α and β at a point of a segment of 2^-`level` pairs of cells, the angular velocity Ω in the body frame as multiples of a
    /// power of two, and the exponent of that power for [`EphemerisScalar::rate_in`].
    ///
    /// * `rates`: rates of x on a segment of a whole pair of cells, of A + B, and about the axis
    #[doc(hidden)]
    fn alpha_beta_and_rates(
        terms: &[[Self::Coefficient; 4]],
        point: SegmentPoint,
        level: u32,
        rates: [Self::Wide; 3],
    ) -> ([Complex<Self>; 2], Vector<Self::Rate>, i32);
    /// Value in the type of the rates.
    #[doc(hidden)]
    fn rate_number(self) -> Self::Rate;
    /// Rate from its multiple of the power of two with this exponent.
    #[doc(hidden)]
    fn rate_in(rate: Self::Rate, exponent: i32) -> Self::Wide;
}
