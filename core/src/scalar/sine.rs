//! Sines and cosines of phases and of angles.
//!
//! | function | argument | result |
//! |---|---|---|
//! | `sine_cosine_of_phase` | phase of 96 bits | `f64`, relatively exact |
//! | `sine_cosine_of_radians` | angle | `f64`, relatively exact |
//! | `sine_cosine_f64` | phase of 64 bits | `f64` |
//! | `sine_cosine_q31`, `q26`, `q15` | phase of 32 bits | integers, from 512 points of the circle (2.5 KiB of flash) |
//!
//! `host` writes the constants into tables for C. A set-up has sines of 57 bits of its own, and `Orientation::exp`, whose angle may be of any
//! size, libm's.

use crate::integer::{high_product, product_32x16, product_32x16_by_constant};
use crate::phase::Phase;
use crate::scalar::Extended;

/// Coefficients of S in sin 2πx = x S(x²) for |x| <= 1/8, lowest power first: the Chebyshev interpolant on [0, 1/64]
/// (mpmath: `chebyfit(lambda y: sin(2*pi*sqrt(y))/sqrt(y), [0, 1/64], 8)`). Truncation error: below 2e-21.
pub const SINE: [f64; 8] = [
    core::f64::consts::TAU,
    -41.34170224039976,
    81.60524927607493,
    -76.70585975299812,
    42.05869392898878,
    -15.094640403891546,
    3.8197881201632113,
    -0.7116358090781666,
];
/// Coefficients of C in cos 2πx = C(x²) for |x| <= 1/8, lowest power first, found as those of S.
pub const COSINE: [f64; 9] = [
    1.0,
    -19.739208802178716,
    64.9393940226683,
    -85.45681720669354,
    60.244641371818105,
    -26.426256772545436,
    7.9035351947629575,
    -1.7143161879285278,
    0.27945867147528963,
];

/// Integer over 2^64, rounded once, by two conversions of 32 bits.
#[inline(always)]
pub(crate) const fn fraction_of_word(word: i64) -> f64 {
    const SCALE: f64 = 1.0 / (1_u64 << 32) as f64;
    ((word >> 32) as i32 as f64 + word as u32 as f64 * SCALE) * SCALE
}

/// (sin 2πx, cos 2πx) of the 64 leading bits of a phase. Error: below 2e-16.
pub(crate) const fn sine_cosine_f64(phase: u64) -> (f64, f64) {
    // the nearest quarter turn, and the signed remainder in [-1/8, 1/8) turn
    let quadrant = phase.wrapping_add(1 << 61) >> 62;
    quarter_turns(quadrant as u32, fraction_of_word(phase.wrapping_sub(quadrant << 62) as i64))
}

/// (sin 2πx, cos 2πx) of a phase of x turns. The error is relative near the zeros.
pub(super) fn sine_cosine_of_phase(phase: Phase) -> (f64, f64) {
    let (quadrant, remainder) = phase.quadrant();
    quarter_turns(quadrant, remainder.to_turns())
}

/// (sin x, cos x) of an angle of x rad up to 1e6. Error: below 4e-16, relative near the zeros. Those of libm take several kilobytes of flash.
pub(crate) fn sine_cosine_of_radians(x: f64) -> (f64, f64) {
    if x.abs() < core::f64::consts::FRAC_PI_4 {
        return quarter_turns(0, x * (0.5 * core::f64::consts::FRAC_1_PI));
    }
    sine_cosine_of_phase(Extended::from(x).in_turns().to_phase())
}

/// (sin, cos) of `quadrant` quarter turns plus x turns, |x| <= 1/8. The error is relative near the zeros.
#[inline]
const fn quarter_turns(quadrant: u32, x: f64) -> (f64, f64) {
    let y = x * x;
    let (sine, cosine) = (x * horner(&SINE, y), horner(&COSINE, y));
    let (sine, cosine) = if quadrant & 1 == 0 { (sine, cosine) } else { (cosine, -sine) };
    if quadrant & 2 == 0 { (sine, cosine) } else { (-sine, -cosine) }
}

const fn horner(mut coefficients: &[f64], y: f64) -> f64 {
    let mut sum = 0.0;
    while let [rest @ .., last] = coefficients {
        sum = sum * y + *last;
        coefficients = rest;
    }
    sum
}

/// Number of points on the circle.
const POINTS: usize = 512;

/// Table of 2^31 sin(k/512 turn), limited to 2^31 - 1. The entries a quarter turn later are the cosines.
#[allow(clippy::indexing_slicing)] // in a constant, an index out of range does not compile
pub static SINES: [i32; POINTS + POINTS / 4] = {
    let mut sines = [0; POINTS + POINTS / 4];
    let mut i = 0;
    while i < sines.len() {
        let (sine, _) = sine_cosine_f64((i as u64) << 55);
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
pub const SECANT: i32 = (DISTANCE * (1.0 - DISTANCE * DISTANCE / 8.0) * (1_u64 << 33) as f64) as i32;

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
    let versine = product_32x16_by_constant(square, VERSINE << 16);
    // the corrections have 36 fraction bits
    let sine_change = high_product(small_sine, cosine) - (product_32x16(versine, sine) >> 7);
    let cosine_change = high_product(small_sine, sine) + (product_32x16(versine, cosine) >> 7);
    (sine + ((sine_change + 16) >> 5), cosine - ((cosine_change + 16) >> 5))
}

/// [`sine_cosine_q31`] for conversion to `f32`. Error: below 25 units, 1.2e-8.
#[inline(always)]
pub(crate) fn sine_cosine_q26(phase: u32) -> (i32, i32) {
    let (sine, cosine) = point(phase);
    // 32 fraction bits
    let small_sine = high_product((phase << 9) as i32, SECANT);
    let versine = high_product(small_sine, small_sine >> 1);
    (
        sine - high_product(sine, versine) + high_product(cosine, small_sine),
        cosine - high_product(cosine, versine) - high_product(sine, small_sine),
    )
}

/// (sin 2πx, cos 2πx)·2^30 as [`sine_cosine_q31`], by 16-bit products only. Error: below 2.2e-5. A point is moved along its tangent, so that
/// results may exceed 1.
#[cfg(feature = "fixed")]
#[inline(always)]
pub(crate) fn sine_cosine_q15(phase: u32) -> (i32, i32) {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::Scalar;

    /// Largest error against libm's f64 sine over a grid that is not a multiple of the table's spacing.
    fn worst<R: Scalar + Into<f64>>() -> f64 {
        let points = if cfg!(miri) { 2003 } else { 100_003 };
        (0..points).fold(0.0, |worst: f64, i| {
            let turns = f64::from(i) * (3.0 / f64::from(points)) - 1.5;
            let (sine, cosine) = R::sine_cosine(Phase::from_turns(turns));
            let angle = 2.0 * core::f64::consts::PI * (turns - turns.round());
            worst.max((sine.into() - libm::sin(angle)).abs()).max((cosine.into() - libm::cos(angle)).abs())
        })
    }

    #[test]
    fn errors_are_what_the_documentation_says() {
        let single = worst::<f32>();
        assert!((2.9e-8..3.2e-8).contains(&single), "f32: {single:e}");
        let unit = 1.0 / (1_u64 << 31) as f64;
        let units = |of: fn(u32) -> (i32, i32)| {
            (0..if cfg!(miri) { 1 << 13 } else { 1 << 20 }).fold(0.0, |worst: f64, i: u32| {
                // an odd step, so that all lower bits occur and any number of steps covers the whole turn
                let phase = i.wrapping_mul(0x9e37_79b1);
                let ((sine, cosine), truth) = (of(phase), sine_cosine_f64(u64::from(phase) << 32));
                let miss = |ours: i32, truth: f64| (f64::from(ours) - truth / unit).abs();
                worst.max(miss(sine, truth.0)).max(miss(cosine, truth.1))
            })
        };
        let (long, short) = (units(sine_cosine_q31), units(sine_cosine_q26));
        assert!((1.5..2.4).contains(&long), "q31: {long} units");
        assert!((20.0..25.0).contains(&short), "q26: {short} units");
        // The reference rounds its own argument, by up to 4.4e-16 at π.
        let double = worst::<f64>();
        assert!((2e-16..6e-16).contains(&double), "f64: {double:e}");
    }

    #[test]
    fn zeros_are_exact_and_their_neighbourhood_relatively_exact() {
        assert_eq!(f64::sine_cosine(Phase::QUARTER), (1.0, 0.0));
        assert_eq!(f32::sine_cosine(Phase::HALF), (0.0, -1.0));
        let tiny = 1e-15;
        let (_, cosine) = f64::sine_cosine(Phase::QUARTER - Phase::from_turns(tiny));
        assert!((cosine / (2.0 * core::f64::consts::PI * tiny) - 1.0).abs() < 1e-4);
    }

    /// The error is relative to the result also near the zeros, and for the largest angles.
    #[test]
    fn sines_of_radians_are_those_of_libm() {
        let mut worst = 0.0_f64;
        for k in 1..if cfg!(miri) { 100 } else { 20_000 } {
            let x = 1e6 * libm::exp(-0.002_77 * f64::from(k)) * if k % 2 == 0 { 1.0 } else { -1.0 };
            let (sine, cosine) = sine_cosine_of_radians(x);
            let (true_sine, true_cosine) = libm::sincos(x);
            worst = worst.max((sine / true_sine - 1.0).abs()).max((cosine / true_cosine - 1.0).abs());
        }
        assert!(worst < 4e-16 && worst > 2e-16, "{worst:e}");
        assert_eq!(sine_cosine_of_radians(0.0), (0.0, 1.0));
        assert_eq!(sine_cosine_of_radians(core::f64::consts::PI).1, -1.0);
    }
}
