//! Scalars of a table, and the evaluation of a segment: in integers for `f32` and fixed point, and in `f64`.

mod q30;

mod word;

mod float;

mod integer;

pub(crate) use float::values_and_slopes;

use crate::scalar::{Real, Ring, Scalar};
use crate::su2::{Orientation, Vector};
use core::fmt::Debug;

/// Place on a segment.
#[derive(Clone, Copy, Debug)]
pub struct SegmentPoint {
    /// Local coordinate x·2^63 with x in [-1, 1).
    pub(crate) x: i64,
    /// Local coordinate x·2^31, rounded down to a multiple of 2^level.
    pub(crate) short_x: i32,
    /// Level of the segment: base-2 logarithm of the rate of x over that at level 0.
    pub(crate) level: u32,
    /// Whether u is falling, where the tabulated values become their complex conjugates.
    pub(crate) mirrored: bool,
}

/// Upper bounds on the rounding errors of a tick.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EvaluationErrors {
    /// Orientation error, rad, besides that of `slope`.
    pub(crate) tick: f64,
    /// Orientation error over the greatest change of the orientation on half a segment.
    pub(crate) slope: f64,
    /// Error of the angular velocity, divided by x' + |A' + B'|.
    pub(crate) rate: f64,
    /// Further error of the angular velocity, relative to its greatest value.
    pub(crate) relative_rate: f64,
}

/// Scalar of an ephemeris: `f32`, `f64`, and with the feature `fixed` `I2F30` and `I2F14`. Sealed.
pub trait EphemerisScalar: Scalar + Into<f64> + 'static {
    /// Coefficient of the table.
    #[doc(hidden)]
    type Coefficient: Coefficient<Quantity = Self::Quantity>;
    /// Segment: coefficients of Re α, Im α, Re β and Im β side by side, lowest power first.
    type Segment: Copy
        + Debug
        + PartialEq
        + 'static
        + AsRef<[[Self::Coefficient; 4]]>
        + AsMut<[[Self::Coefficient; 4]]>;
    /// Type of lengths and rates: the scalar itself, or `f32` for fixed point, whose range is too small.
    type Quantity: Real;

    /// Truncation error of a table unless another one is chosen, rad.
    const TRUNCATION: f64 = 2.0 * Self::ROUNDING;
    /// Number of coefficients of a polynomial.
    const TERMS: usize;
    /// Number of 64-bit words of the wide numbers in which its rates are computed.
    #[doc(hidden)]
    const RATE_WORDS: usize = 1;
    /// Segment whose coefficients are all 0.
    #[doc(hidden)]
    const ZERO_SEGMENT: Self::Segment;
    /// Code of the scalar in table data: see `core/docs/table_format.md`.
    #[doc(hidden)]
    const CODE: u32;
    /// Rounding errors of a tick.
    #[doc(hidden)]
    const ERRORS: EvaluationErrors;

    /// Result in the scalar.
    #[doc(hidden)]
    fn rounded(number: <Self::Coefficient as Coefficient>::Number) -> Self;
}

/// Coefficient of a table, and the evaluator for it.
#[doc(hidden)]
pub trait Coefficient: Copy + Debug + PartialEq {
    /// Number of the results; rates are its multiples by a power of two.
    type Number: Ring;
    /// Type of lengths and rates.
    type Quantity: Real;

    /// Coefficient of x^power nearest to a value in units of 2^-62, and its error in these units.
    fn nearest(value: i64, power: usize) -> (Self, i64);
    /// Error that the coefficients of a polynomial cause, both in units of 2^-62; infinite where a sum could overflow.
    fn error(polynomial: &[i64]) -> f32;
    /// Value of a coefficient of x^power, exact.
    fn value(self, power: usize) -> f64;
    /// Orientation at a point of a segment.
    ///
    /// * `slow`: mean rotations of α and β, the 64 leading bits of a fraction of a turn
    fn orientation(terms: &[[Self; 4]], point: SegmentPoint, slow: [u64; 2]) -> Orientation<Self::Number>;
    /// Orientation, and the angular velocity Ω in the body frame over a power of two, with the exponent of that power.
    ///
    /// * `rates`: rates of x at level 0, of A + B, and about the axis
    fn orientation_and_rates(
        terms: &[[Self; 4]],
        point: SegmentPoint,
        slow: [u64; 2],
        rates: [Self::Quantity; 3],
    ) -> (Orientation<Self::Number>, Vector<Self::Number>, i32);
    /// Number in the type of lengths and rates.
    fn wide(number: Self::Number) -> Self::Quantity;
    /// Product with a power of two, in the type of lengths and rates.
    fn rate(number: Self::Number, exponent: i32) -> Self::Quantity;
}
