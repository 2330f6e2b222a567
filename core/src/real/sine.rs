//! Sine and cosine of an integer phase: reduction is exact, and costs a shift.
//!
//! In `f64` by quarter turns and two polynomials, relative to the result near its zeros. In `f32` and fixed point by
//! integers, from 256 points of the circle (1.25 KiB of flash), absolutely.

use super::high_product;

/// sin 2πx = x S(x²) and cos 2πx = C(x²) for |x| <= 1/8: the Chebyshev interpolants on [0, 1/64] (mpmath:
/// `chebyfit(lambda y: sin(2*pi*sqrt(y))/sqrt(y), [0, 1/64], 8)`, and the like), lowest power first; their own error is
/// below 2e-21.
const SINE: [f64; 8] = [
    core::f64::consts::TAU,
    -41.34170224039976,
    81.60524927607493,
    -76.70585975299812,
    42.05869392898878,
    -15.094640403891546,
    3.8197881201632113,
    -0.7116358090781666,
];
const COSINE: [f64; 9] = [
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

/// (sin 2πx, cos 2πx) for a phase of x turns, given by the 64 bits of its fraction. Error: below 2e-16.
pub(crate) const fn sine_cosine_f64(phase: u64) -> (f64, f64) {
    const SCALE: f64 = 1.0 / (1_u64 << 32) as f64;
    // the nearest quarter turn, and the signed rest in [-1/8, 1/8); a word at a time, each conversion exact
    let quadrant = phase.wrapping_add(1 << 61) >> 62;
    let rest = phase.wrapping_sub(quadrant << 62) as i64;
    quarter_turns(quadrant as u32, ((rest >> 32) as i32 as f64 + rest as u32 as f64 * SCALE) * SCALE)
}

/// (sin, cos) of a number of quarter turns and x turns more, |x| <= 1/8. Relative to the result near its zeros.
pub(super) const fn quarter_turns(quadrant: u32, x: f64) -> (f64, f64) {
    let y = x * x;
    let (sine, cosine) = (x * horner(&SINE, y), horner(&COSINE, y));
    match quadrant & 3 {
        0 => (sine, cosine),
        1 => (cosine, -sine),
        2 => (-sine, -cosine),
        _ => (-cosine, sine),
    }
}

const fn horner(mut coefficients: &[f64], y: f64) -> f64 {
    let mut sum = 0.0;
    while let [rest @ .., last] = coefficients {
        sum = sum * y + *last;
        coefficients = rest;
    }
    sum
}

/// Points on the circle; the nearest is within 1/512 of a turn.
const POINTS: usize = 256;

/// (2^31 - 1) sin of 0, 1/256, ... turns; a quarter turn on is the cosine.
#[allow(clippy::indexing_slicing)] // evaluated by the compiler, which would refuse an index out of range
static SINES: [i32; POINTS + POINTS / 4] = {
    let mut sines = [0; POINTS + POINTS / 4];
    let mut i = 0;
    while i < sines.len() {
        let (sine, _) = sine_cosine_f64((i as u64) << 56);
        let scaled = i32::MAX as f64 * sine;
        sines[i] = (if scaled < 0.0 { scaled - 0.5 } else { scaled + 0.5 }) as i32;
        i += 1;
    }
    sines
};

/// d = DISTANCE x for x in [-1, 1), rad.
const DISTANCE: f64 = 2.0 * core::f64::consts::PI / 512.0;
const LINEAR: i32 = (DISTANCE * (1_u64 << 37) as f64) as i32;
const CUBIC: i32 = (DISTANCE * DISTANCE * DISTANCE / 6.0 * (1_u64 << 39) as f64) as i32;
/// v = d²/2 - d⁴/24, with x⁴ replaced by the multiple of x² nearest to it on [0, 1].
const VERSINE: i32 = (DISTANCE
    * DISTANCE
    * (0.5 - DISTANCE * DISTANCE * (2.0 * core::f64::consts::SQRT_2 - 2.0) / 24.0)
    * (1_u64 << 38) as f64) as i32;

/// The constants of the crate's sines: for an evaluator in another language that shall give the same bits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SineConstants {
    /// In integers: (2^31 - 1) sin of 0, 1/256, ... 319/256 turns.
    pub points: &'static [i32],
    /// In integers, the turn from the nearest point: the coefficient of its sine, that of the cube in it, and that of its
    /// versine, scaled by 2^37, 2^39 and 2^38.
    pub turn: [i32; 3],
    /// In `f64`: sin 2πx = x S(x²) for |x| <= 1/8, lowest power first.
    pub sine: &'static [f64],
    /// In `f64`: cos 2πx = C(x²).
    pub cosine: &'static [f64],
}

/// The only ones.
pub static SINE_CONSTANTS: SineConstants =
    SineConstants { points: &SINES, turn: [LINEAR, CUBIC, VERSINE], sine: &SINE, cosine: &COSINE };

/// (sin 2πx, cos 2πx)·2^31 for a phase of x turns, given by the upper 32 bits of its fraction: in integers alone, so the
/// same bits everywhere. Error: below 2.4 units, 1.1e-9.
///
/// From the nearest of 256 points, turned by the rest: sin d = d - d³/6, cos d = 1 - v. No sum can overflow: only the
/// points on the axes are within 2^17 of the largest number, and they are exact.
#[inline(always)]
pub fn sine_cosine_q31(phase: u32) -> (i32, i32) {
    let x = (phase << 8) as i32;
    let (sine, cosine) = point(phase);
    let square = high_product(x, x);
    let versine = high_product(square, VERSINE);
    let small_sine = high_product(x, LINEAR - high_product(square, CUBIC));
    // the corrections have 35 bits after the point
    let sine_change = high_product(cosine, small_sine) - high_product(sine, versine);
    let cosine_change = high_product(sine, small_sine) + high_product(cosine, versine);
    (sine + ((sine_change + 8) >> 4), cosine - ((cosine_change + 8) >> 4))
}

/// (sin 2πx, cos 2πx)·2^30 as [`sine_cosine_q31`], by 16-bit products alone. Error: below 8e-5, nearly all of it a common
/// factor between 1 and 1 + 7.6e-5: a point is moved along its tangent. A bit less than there, because that may lead beyond 1.
#[cfg(feature = "fixed")]
#[inline(always)]
pub fn sine_cosine_q15(phase: u32) -> (i32, i32) {
    /// 2π/512 · 2^21
    const LINEAR: i32 = (2.0 * core::f64::consts::PI / 512.0 * (1 << 21) as f64) as i32;
    let (sine, cosine) = point(phase);
    let small = (((phase << 8) as i32 >> 16) * LINEAR) >> 15;
    ((sine >> 1) + (((cosine >> 16) * small) >> 6), (cosine >> 1) - (((sine >> 16) * small) >> 6))
}

/// (2^31 - 1) times sine and cosine of the nearest point.
#[inline(always)]
fn point(phase: u32) -> (i32, i32) {
    let point = (phase.wrapping_add(1 << 23) >> 24) as usize;
    let from_here = SINES.get(point..).unwrap_or(&[]);
    let sine = from_here.first().copied().unwrap_or(0);
    let cosine = from_here.get(POINTS / 4).copied().unwrap_or(0);
    (sine, cosine)
}

#[cfg(test)]
mod tests {
    use super::{sine_cosine_f64, sine_cosine_q31};
    use crate::real::Scalar;
    use crate::turns::Turns;

    /// Largest error against libm's f64 sine over a grid that is no multiple of the segments.
    fn worst<R: Scalar + Into<f64>>() -> f64 {
        let points = 100_003;
        (0..points).fold(0.0, |worst: f64, i| {
            let turns = f64::from(i) * (3.0 / f64::from(points)) - 1.5;
            let (sine, cosine) = R::sine_cosine(Turns::new(turns));
            let angle = 2.0 * core::f64::consts::PI * (turns - turns.round());
            worst.max((sine.into() - libm::sin(angle)).abs()).max((cosine.into() - libm::cos(angle)).abs())
        })
    }

    #[test]
    fn errors_are_what_the_documentation_says() {
        let single = worst::<f32>();
        assert!((2.9e-8..3.2e-8).contains(&single), "f32: {single:e}");
        let unit = 1.0 / (1_u64 << 31) as f64;
        let fixed = (0..1 << 20).fold(0.0, |worst: f64, i: u32| {
            // an odd step, so that all lower bits occur
            let phase = i.wrapping_mul(4099);
            let (sine, cosine) = sine_cosine_q31(phase);
            let (true_sine, true_cosine) = sine_cosine_f64(u64::from(phase) << 32);
            let miss = |ours: i32, truth: f64| (f64::from(ours) * unit - truth).abs();
            worst.max(miss(sine, true_sine)).max(miss(cosine, true_cosine))
        });
        assert!((1.5 * unit..2.4 * unit).contains(&fixed), "fixed: {} units", fixed / unit);
        // The reference rounds its own argument: up to 4.4e-16 at π.
        let double = worst::<f64>();
        assert!((2e-16..6e-16).contains(&double), "f64: {double:e}");
    }

    #[test]
    fn zeros_are_exact_and_their_neighbourhood_relatively_exact() {
        assert_eq!(f64::sine_cosine(Turns::QUARTER), (1.0, 0.0));
        assert_eq!(f32::sine_cosine(Turns::HALF), (0.0, -1.0));
        let tiny = 1e-15;
        let (_, cosine) = f64::sine_cosine(Turns::QUARTER - Turns::new(tiny));
        assert!((cosine / (2.0 * core::f64::consts::PI * tiny) - 1.0).abs() < 1e-4);
    }
}
