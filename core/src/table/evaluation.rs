//! Evaluation of a segment: four polynomials by Horner's rule and two rotations.
//!
//! `f32` and fixed point are evaluated in integers, with the same bits on every chip. With α = a e^{iΛ_α} and β = b e^{iΛ_β}, where a and b
//! are tabulated, the angular velocity Ω = Φ⁻¹Φ' in the body frame has the transverse part
//!
//! ```text
//! Ω₁ + iΩ₂ = -2i N,    N = ᾱβ' - βᾱ' = x' (ᾱ db/dx e^{iΛ_β} - β (da/dx e^{iΛ_α})*) + i (Λ_α' + Λ_β') ᾱβ
//! ```
//!
//! Where u falls, a, b and their derivatives become their complex conjugates, and x' is negative. The axial part Ω₃ = (n - K)/C is constant. Ω is
//! computed in floating point: rates can be of any size.
//!
//! | scalar | coefficient | accumulator of Horner's rule | component of α and β |
//! |---|---|---|---|
//! | `f32`, `I2F30` (q31) | `i32` | `i32` | `Q30` |
//! | `I2F14` (q15) | `i16` | `i32` | `Q14` |
//! | `f64` | `f64` | `f64` | `f64` |

pub(super) mod range;

mod i32;

mod f32;

#[cfg(feature = "fixed")]
mod i16;

mod f64;

use crate::complex::Complex;
use crate::scalar::{Float, Real, Ring, sealed::Sealed};
use crate::su2::{Orientation, Vector};
use core::fmt::Debug;
use core::ops::Neg;

/// Fraction bits of the polynomials from which the coefficients are rounded.
pub(super) const TABLE_BITS: u32 = 62;
/// Unit of these polynomials, 2^-62.
pub(super) const TABLE_UNIT: f64 = 1.0 / (1_u64 << TABLE_BITS) as f64;

/// Point of a segment.
#[derive(Clone, Copy, Debug)]
pub struct SegmentPoint {
    /// Local coordinate x·2^63 with x in [-1, 1).
    pub(crate) x_q63: i64,
    /// Local coordinate x·2^31, rounded down to a multiple of 2^halvings.
    pub(crate) x_q31: i32,
    /// Length of the segment: 2^-halvings of an eighth of half a period.
    pub(crate) halvings: u32,
    /// Whether u is falling, where the tabulated values become their complex conjugates.
    pub(crate) is_falling: bool,
}

/// Upper bounds on the rounding errors of a tick, whose parts are listed in [the error bound](crate::error_bound).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TickErrors {
    /// Orientation error for a body at rest, rad.
    pub(super) orientation: f64,
    /// Orientation error per rad that the body turns in half a segment.
    pub(super) coordinate: f64,
    /// Error of the angular velocity, divided by x' + |Λ_α' + Λ_β'|.
    pub(super) omega: f64,
    /// Further error of the angular velocity, relative to its greatest value.
    pub(super) relative_omega: f64,
}

/// Scalar of a table. Sealed.
///
/// | scalar | table for the top of [the first page](crate) | error bound, rad | for |
/// |---|---|--:|---|
/// | `f32` | `TableF32`, 2.2 KB | 1.8e-7 | chips with an FPU or without one |
/// | `f64` | `TableF64`, 17 KB | 7.4e-15 | PCs, and chips with an FPU for `f64` |
/// | `fixed::types::I2F30` (q31) | `TableQ31`, 2.3 KB | 1.9e-8 | the smallest error without an FPU for `f64` |
/// | `fixed::types::I2F14` (q15) | `TableQ15`, 0.6 KB | 5.5e-4 | the fastest tick of a chip without an FPU |
///
/// The last two need the feature `fixed`.
pub trait TableScalar: Sealed + Copy + Debug + PartialEq + Neg<Output = Self> + Into<f64> + 'static {
    /// Coefficient of the table.
    #[doc(hidden)]
    type Coefficient: Coefficient;
    /// Segment: coefficients of Re a, Im a, Re b and Im b side by side, lowest power first.
    type Segment: Copy
        + Debug
        + PartialEq
        + AsRef<[[Self::Coefficient; 4]]>
        + AsMut<[[Self::Coefficient; 4]]>
        + 'static;
    /// Type of lengths and rates: the scalar itself, or `f32` for fixed point, whose range is too small.
    type Quantity: Real;
    /// Number type of the rates in a set-up, of 64 bits, or of 128 for `f64`.
    #[doc(hidden)]
    type SetUpFloat: Float;

    /// Half a unit in the last place of 1.
    const ROUNDING: f64;
    /// Code of the scalar in [the table format](crate::table_format).
    const CODE: u32;
    /// Number of coefficients of a polynomial.
    const TERMS: usize;
    /// Segment whose coefficients are all 0.
    const ZERO_SEGMENT: Self::Segment;
    /// Truncation error of a table unless another one is chosen, rad.
    const TRUNCATION: f64 = 2.0 * Self::ROUNDING;
    /// Rounding errors of a tick.
    #[doc(hidden)]
    const ERRORS: TickErrors;

    /// Nearest value of the scalar.
    #[doc(hidden)]
    fn from_component(number: ComponentOf<Self>) -> Self;
    /// Length or rate of a number.
    #[doc(hidden)]
    fn to_quantity(number: ComponentOf<Self>) -> Self::Quantity;

    /// Sine and cosine of a phase, given by its 64 leading bits.
    #[doc(hidden)]
    fn sine_cosine(phase: u64) -> [AccumulatorOf<Self>; 2];

    /// Complex number of the table, rotated for the angular velocity by the angle with this sine and cosine.
    #[doc(hidden)]
    #[inline(always)]
    fn rotated_quantity(
        number: [AccumulatorOf<Self>; 2],
        is_falling: bool,
        sine_cosine: [AccumulatorOf<Self>; 2],
    ) -> Complex<Self::Quantity> {
        Self::Coefficient::rotated(number, is_falling, sine_cosine).map(Self::to_quantity)
    }
}

/// Number type of the parts of α and β in a tick of a scalar.
pub(crate) type ComponentOf<R> = <<R as TableScalar>::Coefficient as Coefficient>::Component;

/// Number type of the sums of Horner's rule of a scalar.
type AccumulatorOf<R> = <<R as TableScalar>::Coefficient as Coefficient>::Accumulator;

/// Coefficient of a table, and the operations that depend on its word: rounding in a set-up, evaluation in a tick.
pub trait Coefficient: Copy + Debug + PartialEq {
    /// Number type of the sums of Horner's rule and of the local coordinate: `i32`, and `f64` in `f64`.
    type Accumulator: Coefficient<Accumulator = Self::Accumulator> + Default + Into<f64>;
    /// Number type of the parts of α and β in a tick.
    type Component: Ring;
    // Set-up: rounding.

    /// Coefficient of x^power nearest to a value in units of 2^-62; beyond the range, one that is not safe.
    fn nearest(value: i64, power: usize) -> Self;
    /// Whether no sum of Horner's rule can overflow with the coefficients of a segment.
    fn are_safe(segment: &[[Self; 4]]) -> bool;

    // Tick: polynomials.

    /// Coefficient in the scale of the sums.
    fn to_sum(self) -> Self::Accumulator;
    /// Local coordinate.
    fn coordinate(point: SegmentPoint) -> Self::Accumulator;
    /// Step of Horner's rule, `self` + `sum` x.
    fn step(self, sum: Self::Accumulator, x: Self::Accumulator) -> Self::Accumulator;
    /// Last step, to the value of a polynomial with this constant.
    #[inline(always)]
    fn last_step(self, sum: Self::Accumulator, x: Self::Accumulator) -> Self::Accumulator {
        self.step(sum, x)
    }
    /// Step of Horner's rule for the derivative, `sum` + `slope` x, with the sum of the polynomial before its step.
    fn slope_step(
        sum: Self::Accumulator,
        slope: Self::Accumulator,
        x: Self::Accumulator,
    ) -> Self::Accumulator;

    // Tick: rotation and angular velocity.

    /// Complex number of the table, rotated by the angle with this sine and cosine.
    fn rotated(
        number: [Self::Accumulator; 2],
        is_falling: bool,
        sine_cosine: [Self::Accumulator; 2],
    ) -> Complex<Self::Component>;
}

/// Orientation at a point of a segment, from the 64 leading bits of the mean phases.
#[inline(always)]
pub(crate) fn orientation<R: TableScalar>(
    rows: &[[R::Coefficient; 4]],
    point: SegmentPoint,
    [a, b]: [u64; 2],
) -> Orientation<ComponentOf<R>> {
    let [[re_a, im_a, re_b, im_b], _] = polynomials::<R::Coefficient, false>(rows, point);
    // each sine where it is needed: the smallest chips have few registers
    let alpha = R::Coefficient::rotated([re_a, im_a], point.is_falling, R::sine_cosine(a));
    let beta = R::Coefficient::rotated([re_b, im_b], point.is_falling, R::sine_cosine(b));
    Orientation { alpha, beta }
}

/// Orientation and Ω, from the 64 leading bits of the mean phases.
///
/// * `rates`: rates of x on an eighth of half a period, of Λ_α + Λ_β, and about the axis
#[inline(always)]
pub(crate) fn orientation_and_omega_body<R: TableScalar>(
    rows: &[[R::Coefficient; 4]],
    point: SegmentPoint,
    mean_phases: [u64; 2],
    [x, mean, spin]: [R::Quantity; 3],
) -> (Orientation<ComponentOf<R>>, Vector<R::Quantity>) {
    let [a, b] = mean_phases.map(R::sine_cosine);
    let [[re_a, im_a, re_b, im_b], [re_slope_a, im_slope_a, re_slope_b, im_slope_b]] =
        polynomials::<R::Coefficient, true>(rows, point);
    let falling = point.is_falling;
    let orientation = Orientation {
        alpha: R::Coefficient::rotated([re_a, im_a], falling, a),
        beta: R::Coefficient::rotated([re_b, im_b], falling, b),
    };
    let alpha = R::rotated_quantity([re_a, im_a], falling, a);
    let beta = R::rotated_quantity([re_b, im_b], falling, b);
    let alpha_slope = R::rotated_quantity([re_slope_a, im_slope_a], falling, a);
    let beta_slope = R::rotated_quantity([re_slope_b, im_slope_b], falling, b);
    // towards u = e₂ while u rises, and back while it falls
    let x = if point.is_falling { -x } else { x } * R::Quantity::from_f64((1_u32 << point.halvings) as f64);
    let change = (alpha.conj() * beta_slope - beta * alpha_slope.conj()).scaled(x);
    let n = change + (alpha.conj() * beta).times_i().scaled(mean);
    (orientation, [n.im.doubled(), -n.re.doubled(), spin])
}

/// a and b, and their derivatives, before the rotation, to 32 bits also for 16-bit coefficients: in units of 2^-31, and of 1 in `f64`.
pub(crate) fn tabulated_a_b<R: TableScalar>(
    rows: &[[R::Coefficient; 4]],
    point: SegmentPoint,
) -> [[Complex<f64>; 2]; 2] {
    let x = <R::Coefficient as Coefficient>::Accumulator::coordinate(point);
    horner::<_, _, 4, true>(rows, x, |four| four.map(Coefficient::to_sum))
        .map(|four| complex_pair(four.map(Into::into)))
}

/// a and b before the rotation at the centre of a segment, which are its constants, in the scale of [`tabulated_a_b`].
pub(crate) fn a_b_at_centre<C: Coefficient>(constants: [C; 4]) -> [Complex<f64>; 2] {
    complex_pair(constants.map(|constant| constant.to_sum().into()))
}

fn complex_pair<Q>([re_a, im_a, re_b, im_b]: [Q; 4]) -> [Complex<Q>; 2] {
    [Complex::new(re_a, im_a), Complex::new(re_b, im_b)]
}

/// Polynomials and, if `SLOPES`, their derivatives.
#[inline(always)]
fn polynomials<C: Coefficient, const SLOPES: bool>(
    rows: &[[C; 4]],
    point: SegmentPoint,
) -> [[C::Accumulator; 4]; 2] {
    let x = C::coordinate(point);
    // four for vector units, two for the few registers of the smallest chips
    if cfg!(target_pointer_width = "64") || size_of::<C>() == 8 {
        return horner::<C, C, 4, SLOPES>(rows, x, |four| *four);
    }
    let [[re_b, im_b], [re_slope_b, im_slope_b]] =
        horner::<C, C, 2, SLOPES>(rows, x, |&[_, _, re, im]| [re, im]);
    let [[re_a, im_a], [re_slope_a, im_slope_a]] =
        horner::<C, C, 2, SLOPES>(rows, x, |&[re, im, _, _]| [re, im]);
    [[re_a, im_a, re_b, im_b], [re_slope_a, im_slope_a, re_slope_b, im_slope_b]]
}

/// Polynomials and, if `SLOPES`, their derivatives by Horner's rule in `D`. A borrowed row lets the compiler recognise a vector.
#[inline(always)]
fn horner<C, D: Coefficient, const N: usize, const SLOPES: bool>(
    rows: &[[C; 4]],
    x: D::Accumulator,
    part: impl Fn(&[C; 4]) -> [D; N],
) -> [[D::Accumulator; N]; 2] {
    let mut sums = [Default::default(); N];
    let mut slopes = [Default::default(); N];
    let [constant, higher @ ..] = rows else { return [sums, slopes] };
    for coefficients in higher.iter().rev() {
        for ((sum, slope), c) in sums.iter_mut().zip(&mut slopes).zip(&part(coefficients)) {
            if SLOPES {
                *slope = D::slope_step(*sum, *slope, x);
            }
            *sum = c.step(*sum, x);
        }
    }
    for ((sum, slope), c) in sums.iter_mut().zip(&mut slopes).zip(part(constant)) {
        if SLOPES {
            *slope = D::slope_step(*sum, *slope, x);
        }
        *sum = c.last_step(*sum, x);
    }
    [sums, slopes]
}
