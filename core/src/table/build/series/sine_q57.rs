//! Sine and cosine to 56 bits in integers.
//!
//! They take a fifth of the time of those in `f64`, with whose 53 bits a release from rest would not be an event at its tick.

use core::ops::Neg;

use super::{Limbs, scaled_product};
use crate::integer::product_i32;
use crate::phase::Phase;
use crate::scalar::power_of_two;

/// Fraction bits of [`sine_cosine_q57`].
pub(crate) const FRACTION: i32 = 57;

/// Series of sin r/r in powers of r², in units of 2^-58. The last four coefficients and their products with r² have at most 32 bits.
const SINE: ([i64; 6], [i32; 4]) = (
    [288230376151711744, -48038396025285291, 2401919801264265, -57188566696768, 794285648566, -7220778623],
    [46287042, -220414, 810, -2],
);
/// Series of cos r.
const COSINE: ([i64; 6], [i32; 4]) = (
    [
        288230376151711744,
        -144115188075855872,
        12009599006321323,
        -400319966877377,
        7148570837096,
        -79428564857,
    ],
    [601731552, -3306217, 13776, -45],
);

/// Value of a series at r² in units of 2^-58, which is below 0.62.
fn evaluate((first, last): &([i64; 6], [i32; 4]), square: i64) -> i64 {
    let word = (square >> 27) as i32;
    let times_square = |sum: i32| (product_i32(sum, word) >> 31) as i32;
    let last = last.iter().rev().fold(0, |sum, c| c + times_square(sum));
    let square = Limbs::new(square);
    let [first @ .., middle] = first;
    let middle = middle + i64::from(times_square(last));
    first.iter().rev().fold(middle, |sum, c| c + scaled_product::<58>(square, sum))
}

/// Quadrant of a phase, and the remainder: as a phase, and in units of 2^-58 as an angle r with sin r/r and cos r.
fn reduced(phase: Phase) -> (u32, Phase, [i64; 3]) {
    /// π/2 in units of 2^-57.
    const QUARTER_TURN: Limbs = Limbs::new(226375608064910089);
    let (quadrant, rest) = phase.quadrant();
    // from units of 2^-62 turns to rad in units of 2^-58
    let angle = scaled_product::<59>(QUARTER_TURN, (rest.to_bits() >> 34) as i64);
    let square = scaled_product::<58>(Limbs::new(angle), angle);
    (quadrant, rest, [angle, evaluate(&SINE, square), evaluate(&COSINE, square)])
}

/// Sine and cosine of an angle that is larger by quarter turns.
fn after_quarter_turns<T: Neg<Output = T>>(quarters: u32, sine: T, cosine: T) -> (T, T) {
    match quarters % 4 {
        0 => (sine, cosine),
        1 => (cosine, -sine),
        2 => (-sine, -cosine),
        _ => (-cosine, sine),
    }
}

/// (sin 2πx, cos 2πx) of a phase of x turns, in units of 2^-57. Error: below 2^-56.
#[inline(never)]
pub(crate) fn sine_cosine_q57(phase: Phase) -> (i64, i64) {
    let (quadrant, _, [angle, ratio, cosine]) = reduced(phase);
    after_quarter_turns(quadrant, scaled_product::<59>(Limbs::new(angle), ratio), (cosine + 1) >> 1)
}

/// (sin 2πx, cos 2πx) of a phase of x turns. Error: below 2^-51, relative to the result near its zeros.
#[inline(never)]
pub(crate) fn sine_cosine(phase: Phase) -> (f64, f64) {
    let (quadrant, rest, [_, ratio, cosine]) = reduced(phase);
    let number = |part: i64| part as f64 * power_of_two(-FRACTION - 1);
    after_quarter_turns(quadrant, rest.to_radians() * number(ratio), number(cosine))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::{Extended, Float, Ring};

    /// Sine and cosine by 40 terms of their power series.
    fn series(phase: Phase) -> (Extended, Extended) {
        let x = Extended::from(phase.principal()) * Extended::TWO_PI;
        let sum = |first: u32| {
            (0..40).rev().fold(Extended::ONE, |sum, k| {
                let n = f64::from(2 * k + first);
                Extended::ONE - x.squared() * sum / Extended::from(n * (n + 1.0))
            })
        };
        (x * sum(2), sum(1))
    }

    #[test]
    fn sines_have_56_bits() {
        let mut worst = 0.0_f64;
        for k in 0..4000 {
            let phase = Phase::from_turns(0.000_573 * f64::from(k) - 1.1);
            let (sine, cosine) = sine_cosine_q57(phase);
            let (true_sine, true_cosine) = series(phase);
            let unit = Extended::ONE / Extended::from((1_u64 << FRACTION) as f64);
            for (ours, truth) in [(sine, true_sine), (cosine, true_cosine)] {
                worst = worst.max(
                    (truth / unit
                        - Extended::from_f64_pair([ours as f64, (ours - ours as f64 as i64) as f64]))
                    .to_f64()
                    .abs(),
                );
            }
        }
        assert!(worst < 2.0 && worst > 0.4, "{worst}");
    }

    #[test]
    fn numbers_are_exact_relative_to_themselves() {
        let mut worst = 0.0_f64;
        for k in 0..4000 {
            let phase = Phase::from_turns(0.25 * f64::from(k % 4) + 0.127 * 0.99_f64.powi(k));
            let (true_sine, true_cosine) = series(phase.principal());
            let (sine, cosine) = sine_cosine(phase);
            for (ours, truth) in [(sine, true_sine), (cosine, true_cosine)] {
                worst = worst.max(((truth - ours.into()) / truth).to_f64().abs());
            }
        }
        assert!(worst < 2_f64.powi(-51) && worst > 2_f64.powi(-53), "{worst:e}");
    }
}
