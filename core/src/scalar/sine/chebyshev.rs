//! Sines in `f64`, from polynomials: for ticks in `f64`, steppers and launches.

use super::rotate_quarter_turns;
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
/// Coefficients of C in cos 2πx = C(x²) for |x| <= 1/8, lowest power first, found in the same way as S.
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
pub(crate) fn sine_cosine_f64(phase: u64) -> (f64, f64) {
    // the nearest quarter turn, and the signed remainder in [-1/8, 1/8) turn
    let quadrant = phase.wrapping_add(1 << 61) >> 62;
    let remainder = fraction_of_word(phase.wrapping_sub(quadrant << 62) as i64);
    rotate_quarter_turns(quadrant as u32, sine_cosine_of_remainder(remainder))
}

/// (sin 2πx, cos 2πx) of a phase of x turns. The error is relative near the zeros.
pub(crate) fn sine_cosine_of_phase(phase: Phase) -> (f64, f64) {
    let (quadrant, remainder) = phase.quadrant();
    rotate_quarter_turns(quadrant, sine_cosine_of_remainder(remainder.to_turns()))
}

/// (sin x, cos x) of an angle of x rad up to 1e6. Error: below 4e-16, relative near the zeros. Those of libm take several kilobytes of flash.
pub(crate) fn sine_cosine_of_radians(x: f64) -> (f64, f64) {
    if x.abs() < core::f64::consts::FRAC_PI_4 {
        return sine_cosine_of_remainder(x * (0.5 * core::f64::consts::FRAC_1_PI));
    }
    sine_cosine_of_phase(Extended::from(x).radians_to_turns().to_phase())
}

/// (sin 2πx, cos 2πx) of |x| <= 1/8. The error is relative near the zeros.
#[inline]
pub(super) const fn sine_cosine_of_remainder(x: f64) -> (f64, f64) {
    let y = x * x;
    (x * horner(&SINE, y), horner(&COSINE, y))
}

const fn horner(mut coefficients: &[f64], y: f64) -> f64 {
    let mut sum = 0.0;
    while let [rest @ .., last] = coefficients {
        sum = sum * y + *last;
        coefficients = rest;
    }
    sum
}
