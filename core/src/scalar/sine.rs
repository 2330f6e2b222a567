//! Sines and cosines of phases and of angles.
//!
//! | function | argument | result |
//! |---|---|---|
//! | `sine_cosine_q31`; `short_sine_cosine_q31`, error 1.2e-8; `coarse_sine_cosine_q30`, error 2.2e-5 | phase of 32 bits | integers, from points of the circle |
//! | `sine_cosine_f64` | phase of 64 bits | `f64`, from polynomials |
//! | `sine_cosine_of_phase`, `of_radians` | phase of 96 bits, angle | `f64`, relatively exact, from the same polynomials |
//! | `sine_cosine_q57` | phase of 96 bits | integers, from power series |
//! | `exact_sine_cosine`, `sine_cosine_series` | phase of 96 bits, angle up to π/4 | wide numbers, relatively exact |
//!
//! `host` writes the constants into tables for C.

mod chebyshev;

mod points;

mod q57;

mod series;

use core::ops::Neg;

pub use chebyshev::{COSINE, SINE};
pub(crate) use chebyshev::{fraction_of_word, sine_cosine_f64, sine_cosine_of_phase, sine_cosine_of_radians};
#[cfg(feature = "fixed")]
pub(crate) use points::coarse_sine_cosine_q30;
pub use points::{CUBIC, LINEAR, SINES, SMALL_SINE, VERSINE};
pub(crate) use points::{short_sine_cosine_q31, sine_cosine_q31};
pub(crate) use q57::{SINE_BITS, sine_cosine_q57};
pub use series::{exact_sine_cosine, sine_cosine_series};

/// Sine and cosine of an angle that is larger by quarter turns.
#[inline(always)]
pub fn rotate_quarter_turns<T: Neg<Output = T>>(quarters: u32, (sine, cosine): (T, T)) -> (T, T) {
    let (sine, cosine) = if quarters & 1 == 0 { (sine, cosine) } else { (cosine, -sine) };
    if quarters & 2 == 0 { (sine, cosine) } else { (-sine, -cosine) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::phase::Phase;
    use crate::scalar::{Extended, Float, Real};

    /// Largest error over a grid that is not a multiple of the table's spacing.
    fn worst<R: Real + Into<f64>>() -> f64 {
        let points = if cfg!(miri) { 203 } else { 20_011 };
        (0..points).fold(0.0, |worst: f64, i| {
            let phase = Phase::from_turns(f64::from(i) * (3.0 / f64::from(points)) - 1.5);
            let ((sine, cosine), truth) = (R::sine_cosine(phase), exact_sine_cosine(phase));
            let error = |ours: R, truth: Extended| (truth - ours.into().into()).to_f64().abs();
            worst.max(error(sine, truth.0)).max(error(cosine, truth.1))
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
        let (long, short) = (units(sine_cosine_q31), units(short_sine_cosine_q31));
        assert!((1.5..2.4).contains(&long), "q31: {long} units");
        assert!((20.0..25.0).contains(&short), "short: {short} units");
        let double = worst::<f64>();
        assert!((1e-16..2e-16).contains(&double), "f64: {double:e}");
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
