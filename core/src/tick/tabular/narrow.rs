//! Fixed point of 16 bits: every product is of two 16-bit numbers, one instruction on the smallest chip.
//!
//! A coefficient of x^k is held as c·2^(15+k), for the reason given in [`super::integer`]; a sum keeps 32 bits, of which the
//! upper 16 are multiplied.

use super::Place;
use crate::real::sine_cosine_q15;

/// Error of [`alpha_beta`], as an orientation error: the coefficients and the sums round off a unit of 2^-15 or two, the
/// results half a unit of 2^-14, the sines leave half their greatest stretch. (On 400 random motions up to 3.1e-4.)
pub(super) const ERROR: f64 = 3.3e-4;

/// Some thirty roundings of a coefficient.
pub(super) const MARGIN: f64 = 1e-3;

/// The sines stretch by 1 to 1 + 1.9e-5: the coefficients meet them half-way.
const SHRINK: f64 = 1.0 - 9.4e-6;

/// The nearest coefficient of x^power.
pub(super) fn coefficient(value: f64, power: usize) -> i16 {
    libm::floor(value * SHRINK * (1_u64 << (15 + power)) as f64 + 0.5) as i16
}

/// What [`coefficient`] holds.
pub(super) fn number(coefficient: i16, power: usize) -> f64 {
    f64::from(coefficient) / (1_u64 << (15 + power)) as f64
}

/// Re α, Im α, Re β and Im β in units of 2^-14.
#[inline(always)]
pub(super) fn alpha_beta(terms: &[[i16; 4]], place: Place) -> [i16; 4] {
    let x = ((place.short_x >> 15) + 1) >> 1;
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
        // half a unit more, because the lower half of the sum is dropped next
        *sum = (wide(c) + (1 << 15)).saturating_add((*sum >> 16) * x);
    }
    let [re_alpha, im_alpha, re_beta, im_beta] = sums;
    let mask = -i32::from(place.mirrored);
    let [a, b] = place.slow.map(|phase| sine_cosine_q15((phase >> 32) as u32));
    let [re_alpha, im_alpha] = rotated([re_alpha, im_alpha ^ mask], a);
    let [re_beta, im_beta] = rotated([re_beta, im_beta ^ mask], b);
    [re_alpha, im_alpha, re_beta, im_beta]
}

/// From 31 bits after the point to 14.
#[inline(always)]
fn rotated(number: [i32; 2], (sine, cosine): (i32, i32)) -> [i16; 2] {
    let ([re, im], sine, cosine) = (number.map(|part| part >> 16), sine >> 15, cosine >> 15);
    [re * cosine - im * sine, re * sine + im * cosine].map(|part| ((part + (1 << 15)) >> 16) as i16)
}
