//! Launches fitted to readings that leave a rotation open, or that other launches fit almost as well, are compared with the true ones.

use super::simulated_sensors::{ACCELEROMETER, GYROSCOPE, MAGNETOMETER, held, mounting, simulated};
use toytop::su2::dot;
use toytop::{Orientation, Release, State, Top, TopParameters};
use toytop_fit::{Accelerometer, Fitted, Mounting, Sensor};
use toytop_tests::{TOY, toy};

/// Angle between the fitted and the true orientation, without the rotation about the vertical if that is undetermined.
fn error(fitted: &Fitted, state: &State) -> f64 {
    let turn = state.orientation().compose(&fitted.launch.orientation.inverse());
    let [w, _, _, z] = turn.quaternion();
    let yaw = if fitted.unobservable.yaw { -2.0 * z.atan2(w) } else { 0.0 };
    let [w, ..] = Orientation::exp([0.0, 0.0, yaw]).compose(&turn).quaternion();
    2.0 * w.abs().min(1.0).acos()
}

fn thrown(case: u32, tilt: f64, spin: f64) -> State {
    let release = Release {
        tilt,
        azimuth: f64::from(case) * 2.4 - 3.0,
        roll: f64::from(case) * 1.7 - 2.0,
        spin: if case.is_multiple_of(2) { spin } else { -spin },
        precession: f64::from(case % 5) - 2.0,
        nutation: f64::from(case % 3) - 1.0,
    };
    State::from_release(&release).unwrap()
}

/// Launch found by a telephone at the centre of mass of a held top.
fn by_telephone(top: &Top, state: &State, count: u32, seed: u64) -> Fitted {
    let place = Mounting { place: [0.0, 0.0, 0.03], ..mounting() };
    let accelerometer = Accelerometer { mounting: place, ..ACCELEROMETER };
    simulated(top, state, &[&GYROSCOPE, &accelerometer, &MAGNETOMETER], count, seed)
}

/// Only the magnetometer tells a direction at once, and only at every tenth sample.
#[test]
fn a_held_top_beyond_the_range_of_the_gyroscope_is_found() {
    let top = held();
    for count in [300, 1000] {
        let mut found = 0;
        for case in 0..24 {
            let state = thrown(case, 0.1 + 0.03 * f64::from(case), 40.0 + 4.7 * f64::from(case));
            let fit = by_telephone(&top, &state, count, u64::from(case));
            assert!(!fit.is_trusted() || error(&fit, &state) < 0.1, "{case}: {}", error(&fit, &state));
            found += u32::from(fit.is_trusted());
        }
        assert!(found >= 23, "{count}: {found}");
    }
}

/// At the centre of mass of a free body an accelerometer reads its noise and bias, which have no direction. The magnetometer alone tells
/// the rate about the axis.
#[test]
fn an_accelerometer_of_a_free_body_tells_no_direction() {
    let body = Top::free(&TopParameters { transverse_inertia: 7.5e-5, ..TOY }).unwrap();
    for case in 0..24 {
        let state = thrown(case, 0.1 + 0.03 * f64::from(case), 40.0 + 4.7 * f64::from(case));
        let sensors: [&dyn Sensor; 3] = [&GYROSCOPE, &ACCELEROMETER, &MAGNETOMETER];
        let fit = simulated(&body, &state, &sensors, 300, u64::from(case));
        assert!(fit.is_trusted(), "{case}: {:?} {:?}", fit.warning, fit.statistics);
        // the rotation about the field is open
        assert_eq!(fit.unobservable.count, 1, "{case}: {:?}", fit.unobservable);
        let axis = fit.launch.orientation.axis();
        let off = dot(fit.launch.omega, axis) - dot(state.omega(), state.orientation().axis());
        let along = |i: usize, j: usize| axis[i] * axis[j] * fit.covariance(3 + i, 3 + j).unwrap();
        let variance: f64 = (0..3).flat_map(|i| (0..3).map(move |j| (i, j))).map(|(i, j)| along(i, j)).sum();
        assert!(off.abs() < 4.0 * variance.sqrt() && off.abs() < 0.5, "{case}: {off}, {variance}");
    }
}

/// Such throws have launches with another yaw that only the magnetometer contradicts.
#[test]
fn no_launch_is_believed_that_the_magnetometer_contradicts() {
    let top = held();
    for case in 0..80 {
        let state = thrown(case, 0.05 + 0.01 * f64::from(case), 1.0 + 0.36 * f64::from(case));
        let fit = by_telephone(&top, &state, 300, u64::from(case));
        assert!(fit.is_trusted(), "{case}: {:?} {:?}", fit.warning, fit.statistics);
        assert!(error(&fit, &state) < 0.1, "{case}: {}", error(&fit, &state));
        assert!(fit.statistics.largest < 8.0 && fit.statistics.outliers < 40, "{:?}", fit.statistics);
    }
}

/// The force of the plane is vertical, and shows the tilt and how the body turns about its axis.
#[test]
fn an_accelerometer_alone_tells_all_but_the_yaw() {
    for case in 0..48 {
        let state = thrown(case, 0.1 + 0.015 * f64::from(case), 5.0 + 4.7 * f64::from(case));
        let fit = simulated(&toy(), &state, &[&ACCELEROMETER], 300, u64::from(case));
        assert!(fit.is_trusted(), "{case}: {:?} {:?}", fit.warning, fit.statistics);
        assert!(fit.unobservable.yaw && fit.unobservable.count == 1, "{case}: {:?}", fit.unobservable);
        assert!(error(&fit, &state) < 0.1, "{case}: {}", error(&fit, &state));
    }
}

/// Rates alone tell the tilt by the torque of gravity, and leave the yaw open.
#[test]
fn a_gyroscope_alone_tells_all_but_the_yaw() {
    let sensors: [&dyn Sensor; 1] = [&GYROSCOPE];
    for case in 0..40 {
        let (top, fastest) = if case % 4 == 0 { (toy(), 30.0) } else { (held(), 28.0) };
        let tilt = (5.0 + 55.0 * f64::from(case) / 39.0).to_radians();
        let state = thrown(case, tilt, 6.0 + (fastest - 6.0) * f64::from(case * 7 % 40) / 39.0);
        let fit = simulated(&top, &state, &sensors, 300, u64::from(case));
        assert!(fit.is_trusted(), "{case}: {:?} {:?}", fit.warning, fit.statistics);
        assert!(fit.unobservable.yaw && fit.unobservable.count == 1, "{case}: {:?}", fit.unobservable);
        assert!(error(&fit, &state) < 0.1, "{case}: {}", error(&fit, &state));
    }
}
