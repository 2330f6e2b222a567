//! Sines of phases of 96 bits in integers, from power series: for set-ups.
//!
//! Their error of 2^-56 is far below the roundings of a table. With sines in `f64` instead, the costliest set-up in `f32` takes 10.5 million
//! cycles of a Cortex-M4F instead of 9.9. With an FPU for `f64` the polynomials in `f64` take a third of their time, so that
//! [`Real::sine_cosine`](crate::scalar::Real::sine_cosine) uses those.

use super::rotate_quarter_turns;
use crate::integer::{Limbs, product_i32};
use crate::phase::Phase;

/// Fraction bits of [`sine_cosine_q57`].
pub(crate) const SINE_BITS: i32 = 57;

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
    first.iter().rev().fold(middle, |sum, c| c + square.times::<58>(sum))
}

/// (sin 2πx, cos 2πx) of a phase of x turns, in units of 2^-57. Error: below 2^-56.
pub(crate) fn sine_cosine_q57(phase: Phase) -> (i64, i64) {
    /// π/2 in units of 2^-57.
    const QUARTER_TURN: Limbs = Limbs::new(226375608064910089);
    let (quadrant, remainder) = phase.quadrant();
    // from units of 2^-62 turns to 2^-58 rad
    let angle = QUARTER_TURN.times::<59>((remainder.to_bits() >> 34) as i64);
    let square = Limbs::new(angle).times::<58>(angle);
    let sine = Limbs::new(angle).times::<59>(evaluate(&SINE, square));
    rotate_quarter_turns(quadrant, (sine, (evaluate(&COSINE, square) + 1) >> 1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::sine::exact_sine_cosine;
    use crate::scalar::{Extended, Float, Ring};

    #[test]
    fn sines_have_56_bits() {
        let mut worst = 0.0_f64;
        for k in 0..4000 {
            let phase = Phase::from_turns(0.000_573 * f64::from(k) - 1.1);
            let (sine, cosine) = sine_cosine_q57(phase);
            let (true_sine, true_cosine) = exact_sine_cosine(phase);
            let unit = Extended::ONE / Extended::from((1_u64 << SINE_BITS) as f64);
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
}
