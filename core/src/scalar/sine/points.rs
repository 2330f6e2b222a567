//! Sines of phases of 32 bits in integers, from 512 points of the circle (2.6 KB of flash): for the ticks of a table.

use super::chebyshev::sine_cosine_of_remainder;
use crate::integer::{high_product, product_32x16};

/// Number of points on the circle.
const POINTS: usize = 512;

/// Table of 2^31 sin(k/512 turn), limited to 2^31 - 1. The entries a quarter turn later are the cosines.
#[allow(clippy::indexing_slicing)] // in a constant, an index out of range does not compile
pub static SINES: [i32; POINTS + POINTS / 4] = {
    let mut sines = [0; POINTS + POINTS / 4];
    let mut i = 0;
    while i < sines.len() {
        let quarter = (i + POINTS / 8) / (POINTS / 4);
        let remainder = (i as f64 - (quarter * (POINTS / 4)) as f64) / POINTS as f64;
        let (sine, cosine) = sine_cosine_of_remainder(remainder);
        let sine = match quarter % 4 {
            0 => sine,
            1 => cosine,
            2 => -sine,
            _ => -cosine,
        };
        let scaled = (1_u64 << 31) as f64 * sine;
        let nearest = (if scaled < 0.0 { scaled - 0.5 } else { scaled + 0.5 }) as i32;
        sines[i] = if nearest == i32::MIN { -i32::MAX } else { nearest };
        i += 1;
    }
    sines
};

/// Largest distance of a phase from its nearest point, rad: d/DISTANCE is in [-1, 1).
const DISTANCE: f64 = 2.0 * core::f64::consts::PI / 1024.0;
/// Coefficient of d, times 2^38.
pub const LINEAR: i32 = (DISTANCE * (1_u64 << 38) as f64) as i32;
/// Coefficient of the cubic term d³/6, times 2^32.
pub const CUBIC: i32 = (DISTANCE * DISTANCE * DISTANCE / 6.0 * (1_u64 << 32) as f64 + 0.5) as i32;
/// Coefficient of the versine d²/2, times 2^30. The next term, d⁴/24, is an eighth of a unit.
pub const VERSINE: i32 = (DISTANCE * DISTANCE / 2.0 * (1_u64 << 30) as f64 + 0.5) as i32;
/// Coefficient of d (1 - d²/8), times 2^33. It replaces d - d³/6 where 26 bits are enough.
pub const SMALL_SINE: i32 = (DISTANCE * (1.0 - DISTANCE * DISTANCE / 8.0) * (1_u64 << 33) as f64) as i32;

/// (sin 2πx, cos 2πx)·2^31 of the 32 leading bits of a phase. Error: below 2.45 units, 1.2e-9.
///
/// The nearest point is rotated by the remaining angle d, with sin d = d - d³/6 and cos d = 1 - d²/2. No sum overflows.
#[inline(always)]
pub(crate) fn sine_cosine_q31(phase: u32) -> (i32, i32) {
    let x = (phase << 9) as i32;
    let (sine, cosine) = point(phase);
    let square = high_product(x, x);
    // 37 fraction bits, and 44
    let small_sine = high_product(x, LINEAR - (((square >> 16) * CUBIC) >> 8));
    let versine = high_product(square, VERSINE << 16);
    // the corrections have 36 fraction bits
    let sine_change = high_product(small_sine, cosine) - (product_32x16(versine, sine) >> 7);
    let cosine_change = high_product(small_sine, sine) + (product_32x16(versine, cosine) >> 7);
    (sine + ((sine_change + 16) >> 5), cosine - ((cosine_change + 16) >> 5))
}

/// [`sine_cosine_q31`] for conversion to `f32`. Error: below 25 units, 1.2e-8.
#[inline(always)]
pub(crate) fn short_sine_cosine_q31(phase: u32) -> (i32, i32) {
    let (sine, cosine) = point(phase);
    // 32 fraction bits
    let small_sine = high_product((phase << 9) as i32, SMALL_SINE);
    let versine = high_product(small_sine, small_sine >> 1);
    (
        sine - high_product(sine, versine) + high_product(cosine, small_sine),
        cosine - high_product(cosine, versine) - high_product(sine, small_sine),
    )
}

/// (sin 2πx, cos 2πx)·2^30, by 16-bit products only. Error: below 2.2e-5. A point is moved along its tangent, so that results may exceed 1.
#[cfg(feature = "fixed")]
#[inline(always)]
pub(crate) fn coarse_sine_cosine_q30(phase: u32) -> (i32, i32) {
    /// Coefficient of d, times 2^22.
    const LINEAR: i32 = (DISTANCE * (1 << 22) as f64) as i32;
    let (sine, cosine) = point(phase);
    let small = (((phase << 9) as i32 >> 16) * LINEAR) >> 15;
    ((sine >> 1) + (((cosine >> 16) * small) >> 7), (cosine >> 1) - (((sine >> 16) * small) >> 7))
}

/// 2^31 times sine and cosine of the nearest point.
#[inline(always)]
fn point(phase: u32) -> (i32, i32) {
    let point = (phase.wrapping_add(1 << 22) >> 23) as usize;
    let from_here = SINES.get(point..).unwrap_or(&[]);
    let sine = from_here.first().copied().unwrap_or(0);
    let cosine = from_here.get(POINTS / 4).copied().unwrap_or(0);
    (sine, cosine)
}
