//! Ephemeris: consistency with itself and with the stepper. The module `truth` compares it with exact values.

mod truth;

use toytop::{
    Complex, Ephemeris, EphemerisF32, EphemerisF64, EphemerisScalar, EphemerisView, Motion, Orientation,
    Regime, Stepper, TableTooSmall, Tick,
};
use toytop_tests::{greater, tolerance, vectors, widened};

fn kilohertz() -> Tick {
    Tick::hertz(1000).unwrap()
}

fn generic() -> Motion {
    vectors::named("exact_generic_pm").motion().unwrap()
}

/// Cursor, random access and access by time (at whole numbers of ticks) give the same bits.
#[test]
fn cursor_and_random_access_and_time_agree_to_the_bit() {
    let ephemeris = EphemerisF32::new(&generic(), kilohertz()).unwrap();
    let first = -5_000_000;
    let mut cursor = ephemeris.cursor(first);
    let mut sum = 0.0_f64;
    for n in first..first + 10_000_000 {
        let sample = cursor.next(&ephemeris);
        if n % 97 == 0 {
            assert_eq!(sample.orientation(), ephemeris.at_tick(n).orientation());
        }
        sum += f64::from(sample.orientation().alpha.re);
    }
    assert_eq!(
        cursor.next(&ephemeris).attitude_state(),
        ephemeris.at_tick(first + 10_000_000).attitude_state()
    );
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
    // the phases of an aperiodic motion do not wrap and are not sums of increments
    let aperiodic = vectors::named("exact_aperiodic").motion().unwrap();
    check::<f64, 1024>(&aperiodic);
    check::<f32, 128>(&aperiodic);
}

/// The orientation at (n + 1/3) ticks lies between those at n and n + 1.
#[test]
fn times_between_ticks() {
    let ephemeris = EphemerisF64::new(&generic(), Tick::hertz(100_000).unwrap()).unwrap();
    for n in [0_i64, 77, -1, -12345, 1 << 33] {
        let (before, after) = (ephemeris.at_tick(n).orientation(), ephemeris.at_tick(n + 1).orientation());
        let between = ephemeris.at((n as f64 + 0.25) / 100_000.0).orientation();
        let mix = |a: Complex<f64>, b: Complex<f64>| a.scaled(0.75) + b.scaled(0.25);
        let expected =
            Orientation { alpha: mix(before.alpha, after.alpha), beta: mix(before.beta, after.beta) };
        let error = between.distance(&expected);
        assert!(error < 1e-9 + 1e-16 * n.abs() as f64, "{n}: {error:e}");
    }
    assert_eq!(ephemeris.at(f64::NAN).orientation(), ephemeris.at_tick(0).orientation());
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

#[test]
fn turning_points_are_where_u_turns() {
    let ephemeris = EphemerisF64::new(&generic(), kilohertz()).unwrap();
    let e = generic().branch_points();
    let mut n = -20_000_i64;
    for _ in 0..12 {
        let next = ephemeris.next_turning_point(n).unwrap();
        assert!(next.tick >= n);
        let u = [next.tick - 1, next.tick].map(|tick| ephemeris.at_tick(tick).orientation().u());
        let udot = [next.tick - 1, next.tick].map(|tick| ephemeris.at_tick(tick).attitude_state().udot());
        assert!(udot[0] * udot[1] <= 0.0, "u' changes sign within the tick before {}", next.tick);
        let end = if next.upper { e.e2 } else { e.e1 };
        assert!((u[0] - end).abs() < 1e-6 && next.upper == (udot[0] > 0.0));
        n = next.tick + 1;
    }
    assert!(ephemeris.next_turning_point(i64::MIN).is_some());
    let slow = EphemerisF64::new(&generic(), Tick::ratio(1, 10).unwrap()).unwrap();
    assert_eq!(slow.next_turning_point(0), None, "a tick of two periods");
    let rising = vectors::named("exact_aperiodic").motion().unwrap();
    let rising = Ephemeris::<f64, 1024>::new(&rising, Tick::hertz(10).unwrap()).unwrap();
    let lowest = rising.next_turning_point(-3000).unwrap();
    assert!(!lowest.upper && Some(lowest) == rising.next_turning_point(lowest.tick));
    assert_eq!(rising.next_turning_point(lowest.tick + 1), None);
    let steady = vectors::named("regular_precession").motion().unwrap();
    assert!(EphemerisF64::new(&steady, kilohertz()).unwrap().next_turning_point(0).is_none());
    // an amplitude of 5e-17 is the rounding of a state: a regular precession, whose u has no turning points
    let almost = Motion::from_branch_points(
        vectors::named("generic_AneC").motion().unwrap().top(),
        [0.0, 5e-17, 3.0],
        toytop::Signs::default(),
        &toytop::Start::default(),
    );
    let almost = almost.unwrap();
    assert!(almost.regime().is_regular_precession());
    assert_eq!(EphemerisF64::new(&almost, kilohertz()).unwrap().next_turning_point(0), None);
}

/// A top released from rest starts at its upper turning point, and the first turning point of a motion that starts at either is tick 0.
#[test]
fn a_start_at_a_turning_point_is_at_tick_0() {
    let top = *vectors::named("si_toytop_150").motion().unwrap().top();
    for (tilt, spin) in [(0.35, 150.0), (1.1, 60.0), (2.0, 300.0), (0.01, 20.0)] {
        let release = toytop::Release { tilt, spin, ..toytop::Release::default() };
        let motion = Motion::launch(&top, &toytop::State::release(&release).unwrap()).unwrap();
        let ephemeris = Ephemeris::<f64, 512>::new(&motion, kilohertz()).unwrap();
        let first = ephemeris.next_turning_point(0).unwrap();
        assert!(first.upper && first.tick == 0, "{tilt} {spin}: {first:?}");
        let next = ephemeris.next_turning_point(1).unwrap();
        assert!(!next.upper && next.tick > 1, "{tilt} {spin}: {next:?}");
    }
    let motion = generic();
    for (theta, upper) in [(0.0, false), (std::f64::consts::PI, true)] {
        let start = toytop::Start { theta, ..toytop::Start::default() };
        let e = motion.branch_points();
        let motion = Motion::from_branch_points(motion.top(), [e.e1, e.e2, e.e3], motion.signs(), &start);
        let ephemeris = EphemerisF64::new(&motion.unwrap(), kilohertz()).unwrap();
        let first = ephemeris.next_turning_point(0).unwrap();
        assert!(first.tick == 0 && first.upper == upper, "{theta}: {first:?}");
    }
}

/// An aperiodic motion at any tick: it rises to the vertical and stays there; in f32 and f64 against the stepper.
#[test]
fn aperiodic_at_any_tick() {
    let motion = vectors::named("exact_aperiodic").motion().unwrap();
    assert_eq!(motion.regime(), Regime::Aperiodic);
    let ephemeris = Ephemeris::<f64, 1024>::new(&motion, kilohertz()).unwrap();
    let single = Ephemeris::<f32, 128>::new(&motion, kilohertz()).unwrap();
    let (mut worst, mut worst_single) = (0.0_f64, 0.0_f64);
    for direction in [1, -1] {
        let mut stepper = Stepper::<f64>::new(&motion);
        for n in 1..60_000 {
            stepper.step(0.001 * f64::from(direction));
            if n % 250 == 0 {
                let truth = stepper.orientation();
                let tick = i64::from(n * direction);
                worst = greater(worst, ephemeris.at_tick(tick).orientation().distance(&truth));
                worst_single =
                    greater(worst_single, widened(single.at_tick(tick).orientation()).distance(&truth));
            }
        }
    }
    tolerance::APERIODIC_STEPPER.check("f64", worst);
    tolerance::EPHEMERIS_F32.check("f32", worst_single);
    for n in [1_000_000_000, -1_000_000_000] {
        assert_eq!(ephemeris.at(n as f64).orientation(), ephemeris.at_tick(n * 1000).orientation());
    }
    for n in [1 << 40, -(1 << 40), i64::MAX, i64::MIN] {
        let phi = ephemeris.at_tick(n).orientation();
        assert!(
            (phi.u() - 1.0).abs() < 1e-14 && (phi.norm_squared() - 1.0).abs() < 1e-14,
            "{n}: {}",
            phi.u()
        );
    }
}

/// A table that is too small is refused, and a table of the size that is needed is large enough.
#[test]
fn a_table_too_small_is_refused() {
    let motion = vectors::named("exact_near_separatrix_straddle").motion().unwrap();
    let error = Ephemeris::<f32, 16>::new(&motion, kilohertz()).unwrap_err();
    let truncation = 2.0 * f64::from(f32::EPSILON);
    assert_eq!(error, TableTooSmall { truncation, segments: 16 });
    assert_eq!(EphemerisView::<f32>::segments_needed(&motion, truncation), Some(26));
    assert!(Ephemeris::<f32, 25>::new(&motion, kilohertz()).is_err());
    Ephemeris::<f32, 26>::new(&motion, kilohertz()).unwrap();
    // the table is also large enough if a larger error is allowed
    Ephemeris::<f32, 16>::within(&motion, kilohertz(), 1e-4).unwrap();
}

#[test]
fn every_phase_wraps_and_nothing_overflows() {
    for vector in vectors::all().into_iter().filter(|vector| vector.gap() == 0.0 || vector.gap() > 1e-3) {
        let motion = vector.motion().unwrap();
        let ephemeris = Ephemeris::<f32, 256>::new(&motion, Tick::ratio(1, 1000).unwrap()).unwrap();
        for n in [i64::MIN, i64::MIN + 1, -1, 0, 1, i64::MAX - 1, i64::MAX] {
            let attitude = ephemeris.at_tick(n).attitude_state();
            assert!((attitude.orientation.norm_squared() - 1.0).abs() < 1e-6, "{} tick {n}", vector.name);
        }
        assert!(ephemeris.at(1e300).orientation().norm_squared().is_finite());
    }
}
