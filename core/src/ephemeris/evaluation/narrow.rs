//! Fixed point of 16 bits: both factors of every product have 16 bits, which is one instruction on the smallest chip.
//!
//! A coefficient of x^k is stored as c·2^(15+k), for the reason given in [`super::integer`]. A sum has 32 bits, of
//! which the upper 16 are multiplied.

use crate::ephemeris::evaluation::SegmentPoint;
use crate::scalar::sine_cosine_q15;

/// Unit of a coefficient of x^0, 2^-15.
const UNIT: f64 = 1.0 / (1_u64 << 15) as f64;

/// Upper bound on the error of [`alpha_beta`] as an orientation error: 10 units from the sums (for each of four, 1
/// from its coefficients, 1 from truncating the lower halves of the sums, 1/2 from its last rounding), 2 √2 from
/// truncating sine and cosine, 4 from the results (four roundings to 2^-14), and at most 1.3e-5 from the common
/// factor of the sines.
pub(crate) const ERROR: f64 = 16.83 * UNIT + 2.6e-5;

/// Rounding of the local coordinate to 2^-15.
pub(crate) const SLOPE_ROUNDING: f64 = 0.5 * UNIT;

/// Margin of about thirty roundings of a coefficient.
pub(crate) const MARGIN: f64 = 1e-3;

/// Factor of the coefficients that compensates for half of the range 1 to 1 + 1.9e-5 of the sines' common factor.
const SHRINK: f64 = 1.0 - 9.4e-6;

/// Nearest coefficient of x^power.
pub(crate) fn coefficient(value: f64, power: usize) -> i16 {
    libm::floor(value * SHRINK * (1_u64 << (15 + power)) as f64 + 0.5) as i16
}

/// Value of a [`coefficient`].
pub(crate) fn number(coefficient: i16, power: usize) -> f64 {
    f64::from(coefficient) / (1_u64 << (15 + power)) as f64
}

/// Re α, Im α, Re β and Im β in units of 2^-14.
#[inline(always)]
pub(crate) fn alpha_beta(terms: &[[i16; 4]], point: SegmentPoint) -> [i16; 4] {
    let x = ((point.short_x >> 15) + 1) >> 1;
    let [constant, higher @ ..] = terms else { return [0; 4] };
    let wide = |coefficient: i16| i32::from(coefficient) << 16;
    let mut sums = [0; 4];
    let mut backwards = higher.iter().rev();
    if let Some(&highest) = backwards.next() {
        sums = highest.map(wide);
    }
    for coefficients in backwards {
        for (sum, &c) in sums.iter_mut().zip(coefficients) {
            *sum = wide(c) + (*sum >> 16) * x;
        }
    }
    for (sum, &c) in sums.iter_mut().zip(constant) {
        // plus half a unit, because the lower half of the sum is dropped next
        *sum = (wide(c) + (1 << 15)).saturating_add((*sum >> 16) * x);
    }
    let [re_alpha, im_alpha, re_beta, im_beta] = sums;
    let mask = -i32::from(point.mirrored);
    let [a, b] = point.slow.map(|phase| sine_cosine_q15((phase >> 32) as u32));
    let [re_alpha, im_alpha] = rotated([re_alpha, im_alpha ^ mask], a);
    let [re_beta, im_beta] = rotated([re_beta, im_beta ^ mask], b);
    [re_alpha, im_alpha, re_beta, im_beta]
}

/// Rotated number, from 31 fraction bits to 14.
#[inline(always)]
fn rotated(number: [i32; 2], (sine, cosine): (i32, i32)) -> [i16; 2] {
    let ([re, im], sine, cosine) = (number.map(|part| part >> 16), sine >> 15, cosine >> 15);
    [re * cosine - im * sine, re * sine + im * cosine].map(|part| ((part + (1 << 15)) >> 16) as i16)
}
