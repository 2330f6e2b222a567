//! 16-bit fixed point: both factors of every product have 16 bits, so that a product is one instruction on the
//! smallest chip.
//!
//! A coefficient of x^k is stored as c·2^(15+k), for the reason given in [`super::integer`]. A sum has 32 bits, of
//! which the upper 16 are multiplied.

use crate::ephemeris::evaluation::SegmentPoint;
use crate::ephemeris::evaluation::coefficient::{TABLE_BITS, overflow_limit};
use crate::ephemeris::evaluation::rates::{IntegerRates, ValuesAndSlopes};
use crate::scalar::sine_cosine_q15;

/// Unit of a coefficient of x^0, 2^-15.
const UNIT: f64 = 1.0 / (1_u64 << 15) as f64;

/// Upper bound on the error of [`alpha_beta`] as an orientation error: 10 units from the sums (for each of four, 1
/// from its coefficients, 1 from truncating the lower halves of the sums, 1/2 from its last rounding), 2 √2 from
/// truncating sine and cosine, 4 from the results (four roundings to 2^-14), and at most 1.3e-5 from the common
/// factor of the sines.
pub(crate) const ERROR: f64 = 16.83 * UNIT + 2.6e-5;

/// Upper bound on the rounding error of the angular velocity, without that of the coefficients, over the greater of
/// the rate of x and the mean rate: twice the error of N, which is 1 unit from the derivatives (half a unit for each
/// of four, from the truncated sum) and 2^-12 of a unit from the products.
pub(crate) const RATE_ERROR: f64 = 2.001 * UNIT;

/// Rounding of the local coordinate to 2^-15.
pub(crate) const SLOPE_ROUNDING: f64 = 0.5 * UNIT;

/// Least sum that could overflow, with a margin of about thirty roundings of a coefficient.
pub(crate) const OVERFLOW: i64 = overflow_limit(1e-3);

/// Factor of the coefficients, in units of 2^-30, that compensates for half of the range 1 to 1 + 1.9e-5 of the sines'
/// common factor: 1 - 9.4e-6.
const SHRINK: i64 = (1 << 30) - 10093;

/// Coefficient of x^power nearest to a value in units of 2^-62, and its error in these units.
pub(crate) fn coefficient(value: i64, power: usize) -> (i16, i64) {
    let dropped = TABLE_BITS - 15 - power as u32;
    // 2^-30 of the value's unit is far below the rounding
    let shrunk = (value >> 30) * SHRINK;
    let held = ((shrunk >> (dropped - 1)).saturating_add(1) >> 1).clamp(i16::MIN.into(), i16::MAX.into());
    (held as i16, (held << dropped).saturating_sub(value))
}

/// Value of a [`coefficient`].
pub(crate) fn number(coefficient: i16, power: usize) -> f32 {
    f32::from(coefficient) / (1_u32 << (15 + power)) as f32
}

/// Re α, Im α, Re β and Im β in units of 2^-14.
#[inline(always)]
pub(crate) fn alpha_beta(terms: &[[i16; 4]], point: SegmentPoint) -> [i16; 4] {
    let ValuesAndSlopes(values, _) = values_and_slopes(terms, point.short_x);
    turned(values, point.mirrored, point.slow.map(sine_cosine))
}

/// [`alpha_beta`], and the angular velocity Ω in the body frame.
#[inline(always)]
pub(crate) fn alpha_beta_and_rates(
    terms: &[[i16; 4]],
    point: SegmentPoint,
    level: u32,
    rates: [f32; 3],
) -> ([i16; 4], IntegerRates) {
    let polynomials = values_and_slopes(terms, point.short_x);
    let [a, b] = point.slow.map(sine_cosine);
    let parameters = turned(polynomials.0, point.mirrored, [a, b]);
    let ((sine_a, cosine_a), (sine_b, cosine_b)) = (a, b);
    let turn = [cosine_a * cosine_b + sine_a * sine_b, cosine_a * sine_b - sine_a * cosine_b];
    (parameters, polynomials.integer_rates(point.mirrored, turn, level, rates))
}

/// Polynomials and their derivatives at x·2^31, in units of 2^-31.
#[inline(always)]
fn values_and_slopes(terms: &[[i16; 4]], x: i32) -> ValuesAndSlopes<i32> {
    let x = ((x >> 15) + 1) >> 1;
    let [constant, higher @ ..] = terms else { return ValuesAndSlopes([0; 4], [0; 4]) };
    let wide = |coefficient: i16| i32::from(coefficient) << 16;
    let (mut sums, mut slopes) = ([0; 4], [0; 4]);
    let mut backwards = higher.iter().rev();
    if let Some(&highest) = backwards.next() {
        sums = highest.map(wide);
    }
    for coefficients in backwards {
        for ((sum, slope), &c) in sums.iter_mut().zip(&mut slopes).zip(coefficients) {
            *slope = (*sum >> 1) + (*slope >> 16) * x;
            *sum = wide(c) + (*sum >> 16) * x;
        }
    }
    for ((sum, slope), &c) in sums.iter_mut().zip(&mut slopes).zip(constant) {
        *slope = (*sum >> 1) + (*slope >> 16) * x;
        // plus half a unit, because the lower half of the sum is dropped next
        *sum = (wide(c) + (1 << 15)).saturating_add((*sum >> 16) * x);
    }
    ValuesAndSlopes(sums, slopes)
}

/// Sine and cosine of a phase with 15 fraction bits.
#[inline(always)]
fn sine_cosine(phase: u64) -> (i32, i32) {
    let (sine, cosine) = sine_cosine_q15((phase >> 32) as u32);
    (sine >> 15, cosine >> 15)
}

/// Parameters turned by their slow phases.
#[inline(always)]
fn turned([re_a, im_a, re_b, im_b]: [i32; 4], mirrored: bool, [a, b]: [(i32, i32); 2]) -> [i16; 4] {
    let mask = -i32::from(mirrored);
    let [re_alpha, im_alpha] = rotated([re_a, im_a ^ mask], a);
    let [re_beta, im_beta] = rotated([re_b, im_b ^ mask], b);
    [re_alpha, im_alpha, re_beta, im_beta]
}

/// Rotated number, from 31 fraction bits to 14.
#[inline(always)]
fn rotated(number: [i32; 2], (sine, cosine): (i32, i32)) -> [i16; 2] {
    let [re, im] = number.map(|part| part >> 16);
    [re * cosine - im * sine, re * sine + im * cosine].map(|part| ((part + (1 << 15)) >> 16) as i16)
}
