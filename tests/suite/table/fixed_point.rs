//! Fixed point: one tick against `f64`, products, sines, and relaunches.

use fixed::types::{I2F14, I2F30};
use toytop::scalar::{Ring, Scalar};
use toytop::{Ephemeris, EphemerisF64, Phase};
use toytop_tests::vectors::{self, Vector};
use toytop_tests::{greater, kilohertz, widened};

fn exact() -> impl Iterator<Item = Vector> {
    vectors::tabulated().filter(|vector| vector.is_exact() && (vector.gap() == 0.0 || vector.gap() >= 1e-4))
}

/// Rounding error of a tick, against a table in `f64` with the same clock, over enough ticks to reach the greatest error.
#[test]
fn a_tick_in_32_bits_is_within_its_bound_of_one_in_f64() {
    let motion = vectors::motion("exact_generic_pm");
    let tick = kilohertz();
    let fixed = Ephemeris::<I2F30, 256>::new(&motion, tick).unwrap();
    let double = EphemerisF64::new(&motion, tick).unwrap();
    let worst = (0..300_000).fold(0.0, |worst: f64, n| {
        let n = 7919 * n;
        let (ours, truth) = (fixed.at_tick(n).orientation(), double.at_tick(n).orientation());
        greater(worst, widened(ours).distance(&truth))
    });
    let bound = fixed.error_bound().constant;
    assert!((0.4 * bound..bound).contains(&worst), "{worst:.2e}, bound {bound:.2e}");
}

/// Sine and cosine of a phase: errors within three units of the last place in 32 bits, and the nearest numbers in 16 bits.
#[test]
fn sine_and_cosine_of_a_phase() {
    let mut worst = [0.0_f64; 2];
    for i in 0..4096 {
        let phase = Phase::new(f64::from(i) * 0.618_033_988_75);
        let (sine, cosine) = f64::sine_cosine(phase);
        let ((s, c), (short_s, short_c)) = (I2F30::sine_cosine(phase), I2F14::sine_cosine(phase));
        let off = |a: f64, b: f64| greater((a - sine).abs(), (b - cosine).abs());
        worst[0] = greater(worst[0], off(s.into(), c.into()) * (1_u64 << 30) as f64);
        worst[1] = greater(worst[1], off(short_s.into(), short_c.into()) * (1_u64 << 14) as f64);
    }
    assert!((0.4..3.0).contains(&worst[0]) && (0.4..0.51).contains(&worst[1]), "{worst:?} units");
}

/// Products of both types are rounded down.
#[test]
fn products_of_either_size() {
    assert_eq!(I2F14::from_num(0.75).product(I2F14::from_num(-0.5)), I2F14::from_num(-0.375));
    assert_eq!(I2F30::from_num(0.75).product(I2F30::from_num(-0.5)), I2F30::from_num(-0.375));
    assert_eq!(I2F14::from_bits(3).product(I2F14::from_num(0.5)), I2F14::from_bits(1));
    // 3/8 - 1/8 and 1/4 - 3/16
    let [a, b, c, d] = [0.75, -0.25, 0.5, 0.5].map(I2F14::from_num::<f64>);
    assert_eq!(I2F14::inner([a, b], [c, d]), I2F14::from_num(0.25));
    let [a, b, c, d] = [0.5, 0.25, 0.75, 0.5].map(I2F14::from_num::<f64>);
    assert_eq!(I2F14::determinant([a, b], [c, d]), I2F14::from_num(0.0625));
    let [a, b, c, d] = [0.75, -0.25, 0.5, 0.5].map(I2F30::from_num::<f64>);
    assert_eq!(I2F30::inner([a, b], [c, d]), I2F30::from_num(0.25));
    assert_eq!(I2F30::determinant([a, b], [c, d]), I2F30::from_num(0.5));
}

/// The attitude state of a 16-bit sample can be launched from, although its norm differs from 1.
#[test]
fn a_relaunch_from_sixteen_bits() {
    for vector in exact() {
        let motion = vector.motion().unwrap();
        let Ok(ephemeris) = Ephemeris::<I2F14, 64>::new(&motion, kilohertz()) else {
            continue;
        };
        for n in [0, 12_345, 1 << 40] {
            let sample = ephemeris.at_tick(n);
            let state = sample.attitude_state().state().unwrap();
            let error = state.orientation().distance(&widened(sample.orientation()));
            assert!(
                error < 1e-3 && (state.orientation().norm_squared() - 1.0).abs() < 1e-7,
                "{}: {error:e}",
                vector.name
            );
        }
    }
}
