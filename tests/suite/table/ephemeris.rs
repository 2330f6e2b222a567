//! Ephemeris: consistency with itself and with the stepper. The module `truth` compares it with exact values.

use toytop::{
    Ephemeris, EphemerisF32, EphemerisF64, EphemerisScalar, EphemerisView, Motion, Orientation, SetUpError,
    Tick,
};
use toytop_tests::{greater, kilohertz, tolerance, vectors};

fn generic() -> Motion {
    vectors::motion("exact_generic_pm")
}

/// Cursor, random access and access by time (at whole numbers of ticks) give the same bits.
#[test]
fn cursor_and_random_access_and_time_agree_to_the_bit() {
    let ephemeris = EphemerisF32::new(&generic(), kilohertz()).unwrap();
    let first = -5_000_000;
    let mut cursor = ephemeris.cursor(first);
    let mut sum = 0.0_f64;
    for n in first..first + 10_000_000 {
        let sample = cursor.next();
        if n % 97 == 0 {
            let other = ephemeris.at_tick(n);
            assert_eq!((sample.orientation(), sample.tip_angle()), (other.orientation(), other.tip_angle()));
        }
        sum += f64::from(sample.orientation().alpha.re);
    }
    assert_eq!(cursor.next().attitude_state(), ephemeris.at_tick(first + 10_000_000).attitude_state());
    assert!(sum.is_finite());
    let half_hertz = EphemerisF64::new(&generic(), Tick::ratio(44100, 2).unwrap()).unwrap();
    for n in [0, 1, -1, 22050, -7 * 22050, 1 << 40, -(1 << 40), 12345 * 22050] {
        let whole_seconds = n % 22050 == 0;
        if whole_seconds {
            assert_eq!(half_hertz.at((n / 22050) as f64).orientation(), half_hertz.at_tick(n).orientation());
        }
        let binary = EphemerisF64::new(&generic(), Tick::hertz(1024).unwrap()).unwrap();
        assert_eq!(binary.at(n as f64 / 1024.0).orientation(), binary.at_tick(n).orientation());
    }
}

/// A batch gives the same bits as its ticks one by one, in every arithmetic.
#[test]
fn a_batch_agrees_with_random_access_to_the_bit() {
    fn check<R: EphemerisScalar, const S: usize>(motion: &Motion) {
        let ephemeris = Ephemeris::<R, S>::new(motion, kilohertz()).unwrap();
        for (first, length) in [(0, 0), (-1, 1), (-500, 1001), (1 << 40, 4099)] {
            let mut batch = vec![Orientation::<R>::IDENTITY; length];
            ephemeris.fill(first, &mut batch);
            for (n, phi) in (first..).zip(batch) {
                assert_eq!(phi, ephemeris.at_tick(n).orientation(), "tick {n} of {length} from {first}");
            }
        }
    }
    check::<f32, 25>(&generic());
    check::<f64, 48>(&generic());
    check::<fixed::types::I2F30, 256>(&generic());
    check::<fixed::types::I2F14, 128>(&generic());
}

/// The motion is its own mirror image about a turning point, apart from the rotation by the slow phases; across the
/// border of two segments value and slope are continuous.
#[test]
fn continuity_across_segments_and_turning_points() {
    let motion = generic();
    let period = motion.period_advance().unwrap().period;
    let ephemeris = EphemerisF64::new(&motion, kilohertz()).unwrap();
    let phase = ephemeris.at(0.0).nutation_phase().to_f64();
    let (mut value, mut slope) = (0.0_f64, 0.0_f64);
    for segment in 0..128 {
        // time of the border
        let border = (f64::from(segment) / 128.0 - phase) * period;
        let [before, after] = [-1e-12, 1e-12].map(|dt| ephemeris.at(border + dt).attitude_state());
        value = greater(value, before.orientation.distance(&after.orientation));
        for (x, y) in before.omega().iter().zip(after.omega()) {
            slope = greater(slope, (x - y).abs());
        }
    }
    tolerance::CONTINUITY.check("value", value);
    tolerance::CONTINUITY_OF_RATES.check("slope", slope);
}

/// The state after n + m ticks is the state m ticks after that at tick n, launched again from the attitude state of a
/// sample.
#[test]
fn a_relaunch_goes_on_as_before() {
    let motion = generic();
    let ephemeris = EphemerisF64::new(&motion, kilohertz()).unwrap();
    let mut worst = 0.0_f64;
    for n in [3, 1000, -4321] {
        let state = ephemeris.at_tick(n).attitude_state().state().unwrap();
        let again = EphemerisF64::new(&Motion::launch(motion.top(), &state).unwrap(), kilohertz()).unwrap();
        for m in [0, 1, -1, 700, 9999] {
            worst = greater(
                worst,
                again.at_tick(m).orientation().distance(&ephemeris.at_tick(n + m).orientation()),
            );
        }
    }
    tolerance::RELAUNCH.check("n + m ticks", worst);
}

/// A table that is too small is refused, and a table of the size that is needed is large enough.
#[test]
fn a_table_too_small_is_refused() {
    let motion = vectors::motion("exact_near_separatrix_straddle");
    let error = Ephemeris::<f32, 16>::new(&motion, kilohertz()).unwrap_err();
    let truncation = f64::from(f32::EPSILON);
    assert_eq!(error, SetUpError::TooSmall { truncation, segments: 16 });
    assert_eq!(EphemerisView::<f32>::segments_needed(&motion, truncation), Some(27));
    assert!(Ephemeris::<f32, 26>::new(&motion, kilohertz()).is_err());
    Ephemeris::<f32, 27>::new(&motion, kilohertz()).unwrap();
    // the table is also large enough if a larger error is allowed
    Ephemeris::<f32, 16>::within(&motion, kilohertz(), 1e-4).unwrap();
}

#[test]
fn every_phase_wraps_and_nothing_overflows() {
    for vector in vectors::tabulated().filter(|vector| vector.gap() == 0.0 || vector.gap() > 1e-3) {
        let motion = vector.motion().unwrap();
        let ephemeris = Ephemeris::<f32, 256>::new(&motion, Tick::ratio(1, 1000).unwrap()).unwrap();
        for n in [i64::MIN, i64::MIN + 1, -1, 0, 1, i64::MAX - 1, i64::MAX] {
            let attitude = ephemeris.at_tick(n).attitude_state();
            assert!((attitude.orientation.norm_squared() - 1.0).abs() < 1e-6, "{} tick {n}", vector.name);
        }
        assert!(ephemeris.at(1e300).orientation().norm_squared().is_finite());
    }
}
