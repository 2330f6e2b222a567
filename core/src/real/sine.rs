//! Sine and cosine of an integer phase, by quarter turns and two short polynomials.
//!
//! With y = x² and |x| <= 1/8 turn, sin 2πx = x S(y) and cos 2πx = C(y). S and C are the Chebyshev interpolants on
//! [0, 1/64] (mpmath: `chebyfit(lambda y: sin(2*pi*sqrt(y))/sqrt(y), [0, 1/64], n)`, and the same for the cosine);
//! their own error is below 3e-9 in `f32` and 2e-21 in `f64`, so what remains is rounding.

use super::Ring;

/// What differs between the float types: conversion of the reduced phase, and the polynomials.
pub(super) trait SineKernel<const S: usize, const C: usize>: Ring + 'static {
    /// Coefficients of S, lowest power first.
    const SINE: [Self; S];
    /// Coefficients of C, lowest power first.
    const COSINE: [Self; C];
    /// upper·2^-32 + lower·2^-64; a short type may leave the lower word out (1.5e-9 rad).
    fn from_words(upper: i32, lower: u32) -> Self;
}

impl SineKernel<4, 5> for f32 {
    const SINE: [f32; 4] = [core::f32::consts::TAU, -41.341_663, 81.592_54, -75.401_61];
    const COSINE: [f32; 5] = [1.0, -19.739_208, 64.939_316, -85.442_84, 59.220_17];

    #[inline(always)]
    fn from_words(upper: i32, _lower: u32) -> f32 {
        const SCALE: f32 = 1.0 / (1_u64 << 32) as f32;
        upper as f32 * SCALE
    }
}

impl SineKernel<8, 9> for f64 {
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

    #[inline(always)]
    fn from_words(upper: i32, lower: u32) -> f64 {
        const SCALE: f64 = 1.0 / (1_u64 << 32) as f64;
        (f64::from(upper) + f64::from(lower) * SCALE) * SCALE
    }
}

/// (sin 2πx, cos 2πx) for each of N phases of x turns, given by the 64 bits of their fraction. Side by side, because the
/// polynomials are chains of dependent operations that a pipeline can only fill from one another.
#[inline(always)]
pub(super) fn sine_cosine<R: SineKernel<S, C>, const S: usize, const C: usize, const N: usize>(
    phases: [u64; N],
) -> [(R, R); N] {
    // the nearest quarter turn, and the signed rest in [-1/8, 1/8)
    let quadrants = phases.map(|phase| (phase.wrapping_add(1 << 61) >> 62) as u32);
    let mut x = [R::ZERO; N];
    for ((x, phase), quadrant) in x.iter_mut().zip(phases).zip(quadrants) {
        let rest = phase.wrapping_sub(u64::from(quadrant) << 62) as i64;
        *x = R::from_words((rest >> 32) as i32, rest as u32);
    }
    let y = x.map(R::squared);
    let sines = horner(&R::SINE, &y);
    let cosines = horner(&R::COSINE, &y);
    let mut pairs = [(R::ZERO, R::ZERO); N];
    for (i, pair) in pairs.iter_mut().enumerate() {
        if let (Some(&x), Some(&sine), Some(&cosine), Some(&quadrant)) =
            (x.get(i), sines.get(i), cosines.get(i), quadrants.get(i))
        {
            *pair = turned(x * sine, cosine, quadrant);
        }
    }
    pairs
}

/// Sine and cosine a number of quarter turns further on.
#[inline(always)]
fn turned<R: Ring>(sine: R, cosine: R, quadrant: u32) -> (R, R) {
    let (sine, cosine) = if quadrant & 1 == 0 { (sine, cosine) } else { (cosine, sine) };
    let sine = if quadrant & 2 == 0 { sine } else { -sine };
    let cosine = if (quadrant + 1) & 2 == 0 { cosine } else { -cosine };
    (sine, cosine)
}

/// One polynomial at N places.
#[inline(always)]
fn horner<R: Ring, const TERMS: usize, const N: usize>(coefficients: &[R; TERMS], y: &[R; N]) -> [R; N] {
    let mut backwards = coefficients.iter().rev();
    let mut sums = [backwards.next().copied().unwrap_or(R::ZERO); N];
    for &c in backwards {
        for (sum, &y) in sums.iter_mut().zip(y) {
            *sum = *sum * y + c;
        }
    }
    sums
}

#[cfg(test)]
mod tests {
    use crate::real::Scalar;
    use crate::turns::Turns;

    /// Largest error against libm's f64 sine over a grid that is no multiple of the segments.
    fn worst<R: Scalar + Into<f64>>() -> f64 {
        let points = 100_003;
        (0..points).fold(0.0, |worst: f64, i| {
            let turns = f64::from(i) * (3.0 / f64::from(points)) - 1.5;
            let (sine, cosine) = R::sine_cosine(Turns::new(turns).fraction());
            let angle = 2.0 * core::f64::consts::PI * (turns - turns.round());
            worst.max((sine.into() - libm::sin(angle)).abs()).max((cosine.into() - libm::cos(angle)).abs())
        })
    }

    #[test]
    fn errors_are_what_the_documentation_says() {
        let single = worst::<f32>();
        assert!((5e-8..1e-7).contains(&single), "f32: {single:e}");
        // The reference rounds its own argument: up to 4.4e-16 at π.
        let double = worst::<f64>();
        assert!((2e-16..6e-16).contains(&double), "f64: {double:e}");
    }

    #[test]
    fn zeros_are_exact_and_their_neighbourhood_relatively_exact() {
        assert_eq!(f64::sine_cosine(Turns::QUARTER.fraction()), (1.0, 0.0));
        assert_eq!(f32::sine_cosine(Turns::HALF.fraction()), (0.0, -1.0));
        let tiny = 1e-15;
        let (_, cosine) = f64::sine_cosine((Turns::QUARTER - Turns::new(tiny)).fraction());
        assert!((cosine / (2.0 * core::f64::consts::PI * tiny) - 1.0).abs() < 1e-4);
        let (sine, _) = f32::sine_cosine(Turns::new(1e-6).fraction());
        assert!((sine / 6.283_185_3e-6 - 1.0).abs() < 3e-4);
    }
}
