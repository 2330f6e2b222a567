//! Samples of a table by tick, by time and by a cursor are compared with each other and with the stepper.

use fixed::types::{I2F14, I2F30};
use toytop::{Motion, SizedTable, Stepper, TableF32, TableF64, TableScalar, Tick};
use toytop_tests::{
    apart, check, check_all, keep, kilohertz, table_if_it_fits, tolerance, vectors, widened, worst,
};

fn generic() -> Motion {
    vectors::motion("exact_generic_pm")
}

/// Random access by tick, by time, and by a cursor give the same bits in every arithmetic, and a pose those of its quantities.
#[test]
fn every_access_gives_the_same_bits() {
    fn agree<R: TableScalar<Quantity: Into<f64>>, const S: usize>() {
        let tick = Tick::hertz(1024).unwrap();
        let table = SizedTable::<R, S>::new(&generic(), tick).unwrap();
        assert_eq!(table.capacity(), S);
        for (first, length) in [(0, 0), (-1, 1), (-500, 1001), (1 << 40, 4099)] {
            let mut cursor = table.cursor(first);
            for n in (first..).take(length) {
                let sample = table.at_tick(n);
                let next = cursor.next(&table);
                assert_eq!(next.orientation(), sample.orientation(), "tick {n} of {length}");
                assert_eq!(next.tip_angle(), sample.tip_angle(), "tick {n} of {length}");
                // the time of a tick of 1/1024 s is exact
                let timed = table.at(n as f64 / 1024.0);
                assert_eq!(timed.attitude_state(), sample.attitude_state(), "tick {n} of {length}");
                let half_scale = 2.0 / Into::<f64>::into(table.clock().twice_tip_scale);
                let tip = sample.tip().map(|part| half_scale * Into::<f64>::into(part));
                let off = (sample.tip_over_s().map(Into::into) - tip).modulus();
                let rounding = if S == 48 { R::ROUNDING } else { R::ROUNDING.max(f32::ROUNDING) };
                assert!(off <= 4.0 * rounding, "tick {n}: {off:e}");
            }
        }
    }
    agree::<f32, 25>();
    agree::<f64, 48>();
    agree::<I2F30, 256>();
    agree::<I2F14, 128>();
}

/// A cursor has the bits of random access on a long way, across t = 0.
#[test]
fn a_cursor_agrees_over_ten_million_ticks() {
    let table = TableF32::new(&generic(), kilohertz()).unwrap();
    let first = -5_000_000;
    let mut cursor = table.cursor(first);
    for n in first..first + 10_000_000 {
        let sample = cursor.next(&table);
        if n % 97 == 0 {
            let other = table.at_tick(n);
            assert_eq!(sample.attitude_state(), other.attitude_state());
            assert_eq!((sample.orientation(), sample.tip_angle()), (other.orientation(), other.tip_angle()));
        }
    }
}

#[test]
#[should_panic(expected = "a cursor belongs to the table that made it")]
#[cfg(debug_assertions)]
fn a_cursor_of_another_table_panics_in_a_debug_build() {
    let [slow, fast] =
        [1000, 2000].map(|hertz| TableF32::new(&generic(), Tick::hertz(hertz).unwrap()).unwrap());
    let _ = slow.cursor(0).next(&fast);
}

/// Whole seconds are whole ticks of 2/44100 s.
#[test]
fn a_whole_second_is_a_whole_number_of_ticks() {
    let table = TableF64::new(&generic(), Tick::ratio(44100, 2).unwrap()).unwrap();
    for n in [0, 1, -1, 7, -7, 1 << 30, -(1 << 30), 12345] {
        assert_eq!(table.at(n as f64).orientation(), table.at_tick(22050 * n).orientation());
    }
}

/// A quantity has one name and one value, whether it is asked of a sample, of its attitude state or of the stepper.
#[test]
fn samples_and_the_stepper_have_the_same_quantities() {
    macro_rules! quantities {
        ($orientation:expr, $rates:expr) => {
            [
                &[$orientation.axis(), $rates.omega(), $rates.omega_body()].concat(),
                &$orientation.quaternion()[..],
                &[$orientation.u(), $rates.udot()],
            ]
            .concat()
        };
    }
    let motion = vectors::motion("generic_AneC");
    let table = TableF64::new(&motion, kilohertz()).unwrap();
    let mut stepper = Stepper::<f64>::new(&motion);
    let mut greatest = [0.0_f64; 2];
    for n in 1..=200 {
        stepper.step(0.001);
        let sample = table.at_tick(n);
        let ours: Vec<f64> = quantities!(sample, sample);
        let off = |others: Vec<f64>| worst(ours.iter().zip(others).map(|(x, y)| (x - y).abs()));
        keep(
            &mut greatest,
            [sample.attitude_state(), stepper.attitude_state()]
                .map(|state| off(quantities!(state.orientation, state))),
        );
    }
    check_all(["attitude state", "stepper"], greatest, tolerance::READ_QUANTITIES);
}

/// The last time is that of tick 2^63.
#[test]
fn the_last_time_is_that_of_the_last_tick() {
    let table = TableF32::new(&generic(), kilohertz()).unwrap();
    assert_eq!(table.end_time(), 2_f64.powi(63) / 1000.0);
}

/// Across the border of two segments value and slope change by no more than in 2e-12 of time.
#[test]
fn motions_are_continuous_across_segments_and_turning_points() {
    let motion = generic();
    let period = motion.period_advance().unwrap().period;
    let table = TableF64::new(&motion, kilohertz()).unwrap();
    let phase = table.at(0.0).nutation_phase().to_turns();
    let mut jumps = [0.0_f64; 2];
    for segment in 0..128 {
        let border = (f64::from(segment) / 128.0 - phase) * period;
        let [before, after] = [-1e-12, 1e-12].map(|dt| table.at(border + dt).attitude_state());
        let value = before.orientation.distance(&after.orientation);
        keep(&mut jumps, [value, apart(before.omega(), after.omega())]);
    }
    check_all(["value", "slope"], jumps, tolerance::READ_ACROSS_SEGMENTS);
}

/// The state after n + m ticks is the state m ticks after that at tick n, launched again from the attitude state of a
/// sample. A sample in 16 bits can be launched from too, although its norm differs from 1.
#[test]
fn a_relaunch_goes_on_as_before() {
    let motion = generic();
    let table = TableF64::new(&motion, kilohertz()).unwrap();
    let errors = [3, 1000, -4321].into_iter().flat_map(|n| {
        let state = table.at_tick(n).state().unwrap();
        let again = TableF64::new(&Motion::launch(motion.top(), &state).unwrap(), kilohertz()).unwrap();
        [0, 1, -1, 700, 9999]
            .map(|m| again.at_tick(m).orientation().distance(&table.at_tick(n + m).orientation()))
    });
    check("n + m ticks", worst(errors), tolerance::READ_AFTER_A_RELAUNCH);
    for vector in vectors::tabulated() {
        let Some(table) = table_if_it_fits::<I2F14, 64>(&vector.motion().unwrap(), kilohertz()) else {
            continue;
        };
        for n in [0, 12_345, 1 << 40] {
            let sample = table.at_tick(n);
            let phi = sample.state().unwrap().orientation();
            let error = phi.distance(&widened(sample.orientation()));
            assert!(error < 1e-3 && (phi.norm_squared() - 1.0).abs() < 1e-7, "{}: {error:e}", vector.name);
        }
    }
}
