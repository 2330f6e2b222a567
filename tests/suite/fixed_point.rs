//! Ephemeris in fixed point: against exact values, and within its range.

use fixed::types::{I2F14, I2F30};
use toytop::scalar::{Ring, Scalar};
use toytop::{Ephemeris, EphemerisF64, EphemerisScalar, Phase, TableTooSmall, Tick};
use toytop_tests::vectors::{self, Vector};
use toytop_tests::{greater, tolerance, widened};

/// Largest orientation error over a vector's samples, near and far, and the largest quotient of error and bound.
fn worst<R: EphemerisScalar + Into<f64>, const S: usize>(vector: &Vector) -> Result<f64, TableTooSmall> {
    let tick = Tick::hertz(1000).unwrap();
    let ephemeris = Ephemeris::<R, S>::new(&vector.motion().unwrap(), tick)?;
    let bound = ephemeris.error_bound();
    let far = vector.huge_samples().into_iter().map(|(_, sample)| sample);
    Ok(vector.samples().into_iter().chain(far).fold(0.0, |worst: f64, sample| {
        let error = widened(ephemeris.at(sample.t).orientation()).distance(&sample.phi);
        let allowed = bound.after(sample.t * 1000.0);
        assert!(error <= allowed, "{}: {error:.1e} at {}, bound {allowed:.1e}", vector.name, sample.t);
        greater(worst, error)
    }))
}

fn exact() -> impl Iterator<Item = Vector> {
    vectors::all()
        .into_iter()
        .filter(|vector| vector.is_exact() && (vector.gap() == 0.0 || vector.gap() >= 1e-4))
}

#[test]
fn truth_to_a_thousand_million_periods_in_32_bits() {
    let error = exact().fold(0.0_f64, |error, vector| {
        let larger = |_| worst::<I2F30, 256>(&vector);
        greater(error, worst::<I2F30, 32>(&vector).or_else(larger).unwrap())
    });
    tolerance::EPHEMERIS_Q31.check("any time", error);
}

#[test]
fn truth_to_a_thousand_million_periods_in_16_bits() {
    let error = exact().fold(0.0_f64, |error, vector| {
        let larger = |_| worst::<I2F14, 128>(&vector);
        greater(error, worst::<I2F14, 32>(&vector).or_else(larger).unwrap())
    });
    tolerance::EPHEMERIS_Q15.check("any time", error);
}

/// Rounding error of a tick, against a table in `f64` with the same clock, over enough ticks to reach the greatest error.
#[test]
fn a_tick_in_32_bits_is_within_its_bound_of_one_in_f64() {
    let motion = vectors::named("exact_generic_pm").motion().unwrap();
    let tick = Tick::hertz(1000).unwrap();
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

/// Sine and cosine of a phase in 32 and 16 bits: errors within three units of the last place, and at least half a
/// unit.
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
    assert!(worst.iter().all(|units| (0.4..3.0).contains(units)), "{worst:?} units");
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
        let Ok(ephemeris) = Ephemeris::<I2F14, 64>::new(&motion, Tick::hertz(1000).unwrap()) else {
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

/// Sine and cosine in 16 bits are the nearest numbers, apart from the error of the 32-bit sine.
#[test]
fn sines_of_sixteen_bits_are_rounded() {
    let unit = f64::from(I2F14::DELTA);
    let phases = (0..4096).map(|i| Phase::new((f64::from(i) + 0.37) / 4096.0));
    let errors = phases.map(|phase| {
        let ((sine, cosine), (true_sine, true_cosine)) = (I2F14::sine_cosine(phase), f64::sine_cosine(phase));
        (f64::from(sine) - true_sine).abs().max((f64::from(cosine) - true_cosine).abs()) / unit
    });
    let worst = toytop_tests::worst(errors);
    assert!(worst > 0.4 && worst < 0.51, "{worst} units");
}
