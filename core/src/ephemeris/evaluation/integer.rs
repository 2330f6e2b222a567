//! `f32` and 32-bit fixed point: sums and rotations in integers, with the same bits on every chip.
//!
//! A coefficient of x^k is stored as c·2^(31+k). The upper word of its product with x·2^31 has half the scale, which
//! is the scale of the next lower coefficient, so a step of Horner's rule is one product and one sum. No step
//! overflows if the sum of the |c_j| for j >= k is below 2^-k for all k >= 1; set-up counts an excess as an error of
//! the table. The last sum, |α| <= 1, saturates, because a polynomial may exceed 1 by its error.
//!
//! The coefficients of the upper half of the powers are so small, where the error of a table is 2^-31, that 16 bits
//! of x are enough for them, which takes less than half the time on the smallest chip. Set-up verifies this for every
//! table.

use crate::complex::Complex;
use crate::ephemeris::evaluation::rates::{IntegerRates, ValuesAndSlopes, rate_in};
use crate::ephemeris::evaluation::{EphemerisScalar, SegmentPoint};
use crate::law::series;
use crate::product::{high_product, high_product_of_less, short_product};
use crate::scalar::{Scalar, sine_cosine_q26};
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

/// Upper bound on the rounding error of the angular velocity, without that of the coefficients, over the rate of x, with
/// which the polynomials' derivatives are multiplied, or over the mean rate, with which αβ is: twice the sum of 5 units
/// from the derivatives (2.5 for each of four, from halves and products), 3 from the four products of each part of N,
/// and 12 from its products with both rates (two for each of two parts, truncated by up to 4 units).
pub(crate) const RATE_ERROR: f64 = 40.0 * UNIT;

/// Truncation of [`SegmentPoint::short_x`].
pub(crate) const PLACE_ROUNDING: f64 = 1.0 / (1_u64 << 32) as f64;

/// Error of a polynomial from short products that set-up accepts without counting it as an error of the table.
const SHORT_ERROR: f64 = 0.5 * UNIT;

/// Least sum that could overflow, with a margin of 2^-15 plus some thousand roundings of a coefficient.
pub(crate) const OVERFLOW: i64 = overflow_limit(3.2e-5);

/// Fraction bits of the values that coefficients are made from.
pub(crate) const TABLE_BITS: u32 = 62;

/// Coefficient of x^power nearest to a value, with its error in the units of the value, plus half a unit to compensate for the product that is rounded down and added. The
/// constant coefficient has no such half unit: [`alpha_beta`] can mirror a last sum that is half a unit low without a
/// carry.
pub(crate) fn coefficient(value: i64, power: usize) -> (i32, i64) {
    let dropped = TABLE_BITS - 31 - power as u32;
    let nearest =
        if power == 0 { (value >> (dropped - 1)).saturating_add(1) >> 1 } else { (value >> dropped) + 1 };
    let held = nearest.clamp(i32::MIN.into(), i32::MAX.into());
    (held as i32, (held << dropped).saturating_sub(value))
}

/// Value of a [`coefficient`].
pub(crate) fn number(coefficient: i32, power: usize) -> f64 {
    f64::from(coefficient) / (1_u64 << (31 + power)) as f64
}

/// Whether 16 bits of x are enough for a sum that is multiplied by this power of x.
#[inline(always)]
const fn is_short(power: usize, terms: usize) -> bool {
    2 * power > terms
}

/// Amount by which a polynomial's error from short products can exceed [`SHORT_ERROR`]; x is truncated by up to
/// 2^-15.
pub(crate) fn short_product_error(polynomial: &[i64]) -> f64 {
    let (mut sum, mut sums) = (0, 0);
    for (power, value) in polynomial.iter().enumerate().rev() {
        // a sum of 136 values needs eight bits more than i64 has; rounded up
        sum += (value.unsigned_abs() >> 8) + 1;
        if is_short(power, polynomial.len()) {
            sums += sum;
        }
    }
    let error = sums as f64 * (256.0 / 32768.0 * series::UNIT);
    if error > SHORT_ERROR { error - SHORT_ERROR } else { 0.0 }
}

/// Least sum that could overflow, for a margin: 1 less the margin, in units of 2^-62.
pub(crate) const fn overflow_limit(margin: f64) -> i64 {
    ((1.0 - margin) * (1_i64 << TABLE_BITS) as f64) as i64
}

/// Infinite where a sum of the polynomial could overflow, with a margin for the rounding of the coefficients, because
/// the error after an overflow is unbounded; otherwise 0.
pub(crate) fn overflow(polynomial: &[i64], limit: i64) -> f64 {
    let mut sum = 0_i64;
    for (power, value) in polynomial.iter().enumerate().skip(1).rev() {
        sum = sum.saturating_add(value.saturating_abs());
        if sum > limit >> power {
            return f64::INFINITY;
        }
    }
    0.0
}

/// Re α, Im α, Re β and Im β in units of 2^-30, with sines in units of 2^-31.
#[inline(always)]
pub(crate) fn alpha_beta(
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
/// most the sum of the latter, each halved as often as products with x follow.
#[inline(always)]
fn sums_and_slopes<const N: usize, const SLOPES: bool>(
    terms: &[[i32; 4]],
    x: i32,
    of: impl Fn(&[i32; 4]) -> [i32; N],
) -> [[i32; N]; 2] {
    let [constant, higher @ ..] = terms else { return [[0; N]; 2] };
    let (mut sums, mut slopes) = ([0; N], [0; N]);
    for (power, coefficients) in higher.iter().enumerate().map(|(below, four)| (below + 2, four)).rev() {
        let short = is_short(power, terms.len());
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
    [high_product(re, cosine) + high_product(!im, sine), high_product(re, sine) + high_product(im, cosine)]
}

impl EphemerisScalar for f32 {
    type Coefficient = i32;
    type Segment = [[i32; 4]; 5];
    type Wide = Self;
    type Rate = Self;

    const TERMS: usize = 5;
    const ZERO_SEGMENT: Self::Segment = [[0; 4]; 5];
    const CODE: u32 = 32;
    /// Error of the integer evaluation, of the sines (25 units of 2^-31), and of the conversion to `f32` (2^-24,
    /// relative).
    const TICK_ERROR: f64 = ERROR + PER_SINE * 12.5 * UNIT + f32::EPSILON as f64;
    const TICK_DEVIATION: f64 = 0.0;
    const SLOPE_ROUNDING: f64 = 0.0;
    const PLACE_ROUNDING: f64 = PLACE_ROUNDING;
    const RATE_ERROR: f64 = RATE_ERROR;
    /// One rounding for the constants, and up to five for the sums of products of the rotation to the fixed frame.
    const RATE_ROUNDING: f64 = 6.0 * Self::ROUNDING;

    fn coefficient(value: i64, power: usize) -> (i32, i64) {
        coefficient(value, power)
    }

    fn coefficient_error(polynomial: &[i64]) -> f64 {
        overflow(polynomial, OVERFLOW) + short_product_error(polynomial)
    }

    fn number(held: i32, power: usize) -> Self {
        number(held, power) as Self
    }

    fn widened(self) -> Self {
        self
    }

    #[inline(always)]
    fn alpha_beta(terms: &[[i32; 4]], point: SegmentPoint) -> [Complex<Self>; 2] {
        let [re_alpha, im_alpha, re_beta, im_beta] =
            alpha_beta(terms, point, sine_cosine_q26).map(|value| value as Self * UNIT as Self);
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

#[cfg(test)]
mod tests {
    use super::*;

    /// With six terms the products with the fourth and the fifth power are short, and the sum of the lower one
    /// contains both.
    #[test]
    fn what_short_products_lose() {
        let near =
            |found: f64, expected: f64| assert!((found - expected).abs() < 1e-14, "{found:e} {expected:e}");
        near(short_product_error(&polynomial([0.9, 0.9, 0.9, 0.9, -0.3, 0.5])), 1.3 / 32768.0 - SHORT_ERROR);
        near(short_product_error(&polynomial([1.0, 0.5, 0.25, 0.1, 0.0, 1e-9])), 0.0);
        // in range, but the short products are not accurate enough
        let steep = polynomial([0.0, 0.0, 0.0, 0.0, 0.02, 0.01]);
        near(<f32 as EphemerisScalar>::coefficient_error(&steep), 0.04 / 32768.0 - SHORT_ERROR);
    }

    #[test]
    fn sums_stay_below_their_powers_by_a_margin() {
        let limit = overflow_limit(1e-3);
        assert_eq!(overflow(&polynomial([0.9, 0.4994, 0.0]), limit), 0.0);
        assert_eq!(overflow(&polynomial([0.9, 0.4996, 0.0]), limit), f64::INFINITY);
        assert_eq!(overflow(&polynomial([0.9, 0.2, -0.2499, 0.0]), limit), f64::INFINITY);
    }

    #[test]
    fn a_coefficient_knows_its_error() {
        for power in 0..16 {
            for value in [0.2, -0.2, 1e-9, 0.0].map(|value| value * 0.5_f64.powi(power)) {
                let [value] = polynomial([value]);
                let (held, error) = coefficient(value, power as usize);
                let truth = number(held, power as usize) - value as f64 * 2_f64.powi(-62);
                assert!((error as f64 * 2_f64.powi(-62) - truth).abs() < 1e-16, "{power} {value}");
                assert!(truth.abs() <= 2_f64.powi(-31 - power));
            }
        }
        assert_eq!(coefficient(i64::MAX, 1).0, i32::MAX);
    }

    fn polynomial<const N: usize>(values: [f64; N]) -> [i64; N] {
        values.map(|value| (value * 2_f64.powi(62)) as i64)
    }
}
