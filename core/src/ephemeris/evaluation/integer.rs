//! `f32` and 32-bit fixed point: sums and rotations in integers, with the same bits on every chip.
//!
//! A coefficient of x^k is stored as c·2^(31+k). The upper word of its product with x·2^31 has half the scale, which is
//! the scale of the next lower coefficient, so a step of Horner's rule is one product and one sum. No step overflows if
//! the sum of the |c_j| for j >= k is below 2^-k for all k >= 1; if a sum is larger, set-up refuses the segment. The
//! last sum, |α| <= 1, saturates, because a polynomial may exceed 1 by its error.
//!
//! Where the error of a table is 2^-31, the coefficients of the upper half of the powers are so small that 16 bits of
//! x are enough for their products, which take less than half the time on the smallest chip. Set-up verifies this for
//! every table.

use crate::complex::Complex;
use crate::ephemeris::evaluation::rates::{IntegerRates, ValuesAndSlopes, rate_in};
use crate::ephemeris::evaluation::{EphemerisScalar, EvaluationErrors, SegmentPoint, coefficient};
use crate::product::{high_product, high_product_of_less, short_product};
use crate::scalar::{RateNumber, Scalar, sine_cosine_q26};
use crate::su2::Vector;

/// Unit of the results of [`alpha_beta`], 2^-30.
const UNIT: f64 = 1.0 / (1_u64 << 30) as f64;

/// Upper bound on the error of [`alpha_beta`] as an orientation error, if the sines were exact: up to π units from
/// truncating the phases to 32 bits, 4 from the sums (up to 1 unit for each of four, from its coefficients and
/// products), 2 from the short products, and 8 from the rotations (up to 2 units for each of four results, truncated
/// in two products).
pub(crate) const ERROR: f64 = 17.2 * UNIT;

/// Upper bound on the orientation error caused by errors of sine and cosine, over their error: 2 √2.
pub(crate) const PER_SINE: f64 = 2.83;

/// Upper bound on the error with the sines of [`crate::scalar::sine_cosine_q31`], which have an error of 2.45 units
/// of 2^-31.
#[cfg(feature = "fixed")]
pub(crate) const ERROR_Q31: f64 = ERROR + PER_SINE * 1.23 * UNIT;

/// Upper bound on the rounding error of the angular velocity, without that of the coefficients, over the greater of two
/// rates: the rate of x, which multiplies the polynomials' derivatives, and the mean rate, which multiplies αβ. It is
/// twice the sum of 5 units from the derivatives (2.5 for each of four, from halves and products), 3 from the four
/// products of each part of N, and 12 from its products with both rates (two for each of two parts, truncated by up to 4
/// units).
pub(crate) const RATE_ERROR: f64 = 40.0 * UNIT;

/// Truncation error of [`SegmentPoint::short_x`], as a fraction of a pair of cells.
pub(crate) const PLACE_ROUNDING: f64 = 1.0 / (1_u64 << 32) as f64;

/// Re α, Im α, Re β and Im β in units of 2^-30, with sines in units of 2^-31.
///
/// `POLYNOMIALS_FIRST` changes the order of the operations, not their results: if true, both polynomials precede both
/// rotations on a 32-bit chip. A Cortex-M4F takes six cycles less for this order with the sines of `f32`, and four more
/// with those of fixed point.
#[inline(always)]
pub(crate) fn alpha_beta<const POLYNOMIALS_FIRST: bool>(
    terms: &[[i32; 4]],
    point: SegmentPoint,
    sine_cosine: impl Fn(u32) -> (i32, i32),
) -> [i32; 4] {
    let x = point.short_x;
    let mask = -i32::from(point.mirrored);
    let [a, b] = point.slow.map(|phase| (phase >> 32) as u32);
    let turned = |[re, im]: [i32; 2], phase| rotated([re, im ^ mask], sine_cosine(phase));
    let ([re_alpha, im_alpha], [re_beta, im_beta]) = if FOUR_AT_A_TIME {
        let [[re_alpha, im_alpha, re_beta, im_beta], _] = sums_and_slopes::<_, false>(terms, x, |four| *four);
        (turned([re_alpha, im_alpha], a), turned([re_beta, im_beta], b))
    } else if POLYNOMIALS_FIRST {
        let [[re_beta, im_beta], _] = sums_and_slopes::<_, false>(terms, x, |&[_, _, re, im]| [re, im]);
        let [[re_alpha, im_alpha], _] = sums_and_slopes::<_, false>(terms, x, |&[re, im, _, _]| [re, im]);
        let (im_alpha, im_beta) = (im_alpha ^ mask, im_beta ^ mask);
        let alpha = rotated([re_alpha, im_alpha], sine_cosine(a));
        (alpha, rotated([re_beta, im_beta], sine_cosine(b)))
    } else {
        let [beta, _] = sums_and_slopes::<_, false>(terms, x, |&[_, _, re, im]| [re, im]);
        let beta = turned(beta, b);
        let [alpha, _] = sums_and_slopes::<_, false>(terms, x, |&[re, im, _, _]| [re, im]);
        (turned(alpha, a), beta)
    };
    [re_alpha, im_alpha, re_beta, im_beta]
}

/// [`alpha_beta`], and the angular velocity Ω in the body frame.
#[inline(always)]
pub(crate) fn alpha_beta_and_rates(
    terms: &[[i32; 4]],
    point: SegmentPoint,
    level: u32,
    rates: [f32; 3],
    sine_cosine: impl Fn(u32) -> (i32, i32),
) -> ([i32; 4], IntegerRates) {
    let x = point.short_x;
    let mask = -i32::from(point.mirrored);
    let [a, b] = point.slow.map(|phase| sine_cosine((phase >> 32) as u32));
    let [[re_beta, im_beta], beta_slopes] = sums_and_slopes::<_, true>(terms, x, |&[_, _, re, im]| [re, im]);
    let [[re_alpha, im_alpha], alpha_slopes] =
        sums_and_slopes::<_, true>(terms, x, |&[re, im, _, _]| [re, im]);
    let ([re_slope_a, im_slope_a], [re_slope_b, im_slope_b]) = (alpha_slopes, beta_slopes);
    let polynomials = ValuesAndSlopes(
        [re_alpha, im_alpha, re_beta, im_beta],
        [re_slope_a, im_slope_a, re_slope_b, im_slope_b],
    );
    let ((sine_a, cosine_a), (sine_b, cosine_b)) = (a, b);
    let turn = [
        high_product(cosine_a, cosine_b) + high_product(sine_a, sine_b),
        high_product(cosine_a, sine_b) - high_product(sine_a, cosine_b),
    ];
    let [re_alpha, im_alpha] = rotated([re_alpha, im_alpha ^ mask], a);
    let [re_beta, im_beta] = rotated([re_beta, im_beta ^ mask], b);
    let rates = polynomials.integer_rates(point.mirrored, turn, level, rates);
    ([re_alpha, im_alpha, re_beta, im_beta], rates)
}

/// Whether the four polynomials are evaluated together. This suits the vector units of large processors; the smallest
/// chips have too few registers for it.
const FOUR_AT_A_TIME: bool = cfg!(target_pointer_width = "64");

/// Polynomials and, if `SLOPES`, their derivatives by Horner's rule. (A row of coefficients is borrowed because the compiler then
/// recognises a vector.)
///
/// The sums for a derivative have half the scale of those for the polynomial, because they may be twice as large: at
/// most the sum of the latter, each halved once for every product with x that follows.
#[inline(always)]
fn sums_and_slopes<const N: usize, const SLOPES: bool>(
    terms: &[[i32; 4]],
    x: i32,
    of: impl Fn(&[i32; 4]) -> [i32; N],
) -> [[i32; N]; 2] {
    let [constant, higher @ ..] = terms else { return [[0; N]; 2] };
    let (mut sums, mut slopes) = ([0; N], [0; N]);
    for (power, coefficients) in higher.iter().enumerate().map(|(below, four)| (below + 2, four)).rev() {
        let short = coefficient::is_short(power, terms.len());
        for ((sum, slope), c) in sums.iter_mut().zip(&mut slopes).zip(&of(coefficients)) {
            let product = |sum| if short { short_product(sum, x) } else { high_product_of_less(sum, x) };
            if SLOPES {
                *slope = (*sum >> 1) + product(*slope);
            }
            *sum = c + product(*sum);
        }
    }
    for ((sum, slope), c) in sums.iter_mut().zip(&mut slopes).zip(of(constant)) {
        if SLOPES {
            *slope = (*sum >> 1) + high_product_of_less(*slope, x);
        }
        *sum = c.saturating_add(high_product_of_less(*sum, x));
    }
    [sums, slopes]
}

/// Rotated number, from units of 2^-31 to units of 2^-30, which avoids overflow up to √2. (A sum is half a unit low,
/// so its bitwise complement represents its negative.)
#[inline(always)]
fn rotated([re, im]: [i32; 2], (sine, cosine): (i32, i32)) -> [i32; 2] {
    [high_product(!im, sine) + high_product(re, cosine), high_product(im, cosine) + high_product(re, sine)]
}

impl EphemerisScalar for f32 {
    type Coefficient = i32;
    type Segment = [[i32; 4]; 5];
    type Wide = Self;
    type Rate = Self;

    const TERMS: usize = 5;
    const ZERO_SEGMENT: Self::Segment = [[0; 4]; 5];
    const CODE: u32 = 32;
    const ERRORS: EvaluationErrors = EvaluationErrors {
        // Error of the integer evaluation, of the sines (25 units of 2^-31), and of the conversion to `f32` (2^-24,
        // relative).
        tick: ERROR + PER_SINE * 12.5 * UNIT + f32::EPSILON as f64,
        tick_deviation: 0.0,
        slope: 0.0,
        place: PLACE_ROUNDING,
        rate: RATE_ERROR,
        // One rounding for the constants, and up to five for the sums of products of the rotation to the fixed frame.
        relative_rate: 6.0 * Self::ROUNDING,
        operation: <Self::Rates as RateNumber>::OPERATION_ERROR,
    };

    fn coefficient(value: i64, power: usize) -> (i32, i64) {
        coefficient::nearest(value, power)
    }

    fn coefficient_error(polynomial: &[i64]) -> f32 {
        coefficient::error(polynomial)
    }

    fn number(held: i32, power: usize) -> Self {
        coefficient::number(held, power)
    }

    fn widened(self) -> Self {
        self
    }

    #[inline(always)]
    fn alpha_beta(terms: &[[i32; 4]], point: SegmentPoint) -> [Complex<Self>; 2] {
        let [re_alpha, im_alpha, re_beta, im_beta] =
            alpha_beta::<true>(terms, point, sine_cosine_q26).map(|value| value as Self * UNIT as Self);
        [Complex::new(re_alpha, im_alpha), Complex::new(re_beta, im_beta)]
    }

    #[inline(always)]
    fn alpha_beta_and_rates(
        terms: &[[i32; 4]],
        point: SegmentPoint,
        level: u32,
        rates: [Self; 3],
    ) -> ([Complex<Self>; 2], Vector<Self>, i32) {
        let (parameters, integers) = alpha_beta_and_rates(terms, point, level, rates, sine_cosine_q26);
        let [re_alpha, im_alpha, re_beta, im_beta] = parameters.map(|value| value as Self * UNIT as Self);
        let IntegerRates { omega: [x1, x2, _], exponent } = integers;
        let [.., axial] = rates;
        let omega_body = [rate_in(x1, exponent), rate_in(x2, exponent), axial];
        ([Complex::new(re_alpha, im_alpha), Complex::new(re_beta, im_beta)], omega_body, 0)
    }

    fn rate_number(self) -> Self {
        self
    }

    fn rate_in(rate: Self, _: i32) -> Self {
        rate
    }
}
