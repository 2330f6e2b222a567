//! Launches fitted to simulated sensors are compared with the true ones, and launches that the readings do not determine are not trusted.

use super::simulated_sensors::{
    GYROSCOPE, SENSORS, check_errors, errors, fitted, held, readings, release, simulated,
};
use toytop::{Orientation, Release, State, Top, TopParameters};
use toytop_fit::{
    AxisCamera, Fit, FitWarning, FreeRatio, Gyroscope, Mark, Measurement, Noise, OrientationCamera, Sensor,
    TipCamera, Unobservable,
};
use toytop_tests::{TOY, toy};

#[test]
fn a_launch_is_found_beyond_the_range_of_the_gyroscope_and_within() {
    for (name, top) in [("sliding", toy()), ("held", held())] {
        for (seed, (tilt, spin)) in
            [(0.35, 150.0), (0.1, -220.0), (0.8, 60.0), (0.6, 20.0)].into_iter().enumerate()
        {
            let state = release(tilt, spin);
            let found = simulated(&top, &state, &SENSORS, 300, 7 + seed as u64);
            check_errors(&format!("{name} {tilt} {spin}"), &found, &state);
            assert_eq!(found.unobservable.count, 0, "{name} {tilt} {spin}");
        }
    }
}

/// One pass over all measurements may be enough: its launch, its error bars and its sum of squares are those of more passes.
#[test]
fn one_pass_has_the_error_bars_of_more_passes() {
    // ω₂ is about 0, so that the effect of an error of the yaw on ω₁ depends on the launch
    let top = toy();
    let state = State::from_release(&Release { tilt: 0.35, spin: 150.0, ..Release::default() }).unwrap();
    for seed in 0..8 {
        let measurements = readings(&top, &state, &SENSORS, 1000, 31 + seed);
        let found = fitted(&top, &SENSORS, &[], &measurements);
        let mut fit = Fit::new(&top, &SENSORS, &[]).unwrap();
        let again = fit.run_from(found.launch, measurements.iter().copied()).unwrap();
        assert!(found.is_trusted() && again.is_trusted(), "{seed}: {:?} {:?}", found.warning, again.warning);
        for k in 0..6 {
            let ratio = found.deviations()[k] / again.deviations()[k];
            assert!((ratio - 1.0).abs() < 0.1, "{seed}: unknown {k}: {ratio}");
        }
        for (k, off) in errors(&again, &found.state().unwrap()).into_iter().enumerate() {
            assert!(off.abs() < 0.1, "{seed}: omega {k}: {off}");
        }
        let off = found.statistics.chi_squared - again.statistics.chi_squared;
        assert!(off.abs() < 10.0, "{seed}: {off}");
    }
}

/// The yaw is undetermined without a magnetometer, and the tilt, which does not depend on it, is determined. A camera of the axis leaves the
/// roll open.
#[test]
fn what_the_sensors_leave_open_is_reported() {
    let (top, state) = (toy(), release(0.35, 150.0));
    let camera = AxisCamera { deviation: 1e-3 };
    for (sensors, open) in [(&SENSORS[..2], [true, false]), (&[&camera as &dyn Sensor], [false, true])] {
        let found = simulated(&top, &state, sensors, 500, 5);
        assert!(found.is_trusted(), "{:?} {:?}", found.warning, found.statistics);
        let Unobservable { yaw, roll, spin, count } = found.unobservable;
        assert!([yaw, roll] == open && !spin && count == 1, "{:?}", found.unobservable);
        let [ours, truth] = [found.launch.orientation, state.orientation()].map(|phi| phi.u().acos());
        assert!((ours - truth).abs() < 2e-3, "{ours} {truth}");
    }
}

/// If the spin of an upright top is beyond the range of the gyroscope, only a magnetometer determines it.
#[test]
fn the_spin_of_an_upright_top_is_not_believed_without_a_magnetometer() {
    for (name, top) in [("sliding", toy()), ("held", held())] {
        for (seed, spin) in [-115.0, 180.0, 45.0].into_iter().enumerate() {
            let state = State::from_release(&Release { spin, ..Release::default() }).unwrap();
            let [without, with] =
                [2, 3].map(|count| simulated(&top, &state, &SENSORS[..count], 300, 17 + seed as u64));
            assert_eq!(
                without.warning,
                Some(FitWarning::SpinUnknown),
                "{name} {spin}: {:?}",
                without.statistics
            );
            check_errors(&format!("{name} {spin}"), &with, &state);
        }
    }
}

/// A camera below the plane sees the tip, which leaves the roll open, and a mark on the body tells it.
#[test]
fn a_camera_of_the_tip_and_a_mark_tell_the_launch() {
    let camera = TipCamera { deviation: 3e-5 };
    let top = toy();
    let release =
        Release { tilt: 0.35, azimuth: 0.4, spin: 150.0, precession: 2.0, nutation: 0.5, roll: 0.0 };
    // the search begins with an arbitrary roll, and precise marks are then far from their predictions
    for (roll, deviation) in
        [-2.2, -0.7, 0.7, 2.2].into_iter().flat_map(|roll| [1e-5, 1e-4].map(|deviation| (roll, deviation)))
    {
        let mark = Mark { deviation, place: [0.01, 0.002, 0.0] };
        let state = State::from_release(&Release { roll, ..release }).unwrap();
        for (sensors, open) in [(&[&camera as &dyn Sensor] as &[&dyn Sensor], 1), (&[&camera, &mark], 0)] {
            let found = simulated(&top, &state, sensors, 500, 8);
            check_errors("tip", &found, &state);
            let Unobservable { roll, count, .. } = found.unobservable;
            assert_eq!((roll, count), (open == 1, open), "{:?}", found.unobservable);
            if open == 0 {
                // Φ and -Φ are 4 rad apart
                let distance = found.launch.orientation.distance(&state.orientation());
                let error = distance.min((16.0 - distance * distance).sqrt());
                assert!(error < 1e-2 && error > 1e-5, "{error:e}");
            }
        }
    }
}

#[test]
fn a_camera_of_the_orientation_tells_the_axial_inertia() {
    let camera = OrientationCamera { deviation: 2e-3 };
    let sensors: [&dyn Sensor; 1] = [&camera];
    let state = release(0.35, 150.0);
    // a top on the plane and a thrown body
    for make in [Top::sliding, Top::free] {
        let (top, wrong) = (make(&TOY), make(&TopParameters { axial_inertia: 2.06e-5, ..TOY }));
        let (top, wrong) = (top.unwrap(), wrong.unwrap());
        let measurements = readings(&top, &state, &sensors, 500, 5);
        // 3 % wrong
        let strict = fitted(&wrong, &sensors, &[], &measurements);
        assert_eq!(strict.warning, Some(FitWarning::Misfit), "{:?}", strict.statistics);
        let found = fitted(&wrong, &sensors, &[FreeRatio::AXIAL_INERTIA], &measurements);
        check_errors("orientation", &found, &state);
        let inertia = found.top().unwrap().axial_inertia();
        let deviation = found.deviations()[6];
        assert!(((inertia / 2e-5).ln() / deviation).abs() < 4.0 && deviation < 1e-3, "{inertia} {deviation}");
    }
}

#[test]
fn outliers_do_not_move_the_launch() {
    let camera = OrientationCamera { deviation: 2e-3 };
    let sensors: [&dyn Sensor; 1] = [&camera];
    let (top, state) = (toy(), release(0.35, 150.0));
    let mut measurements = readings(&top, &state, &sensors, 500, 9);
    for measurement in measurements.iter_mut().skip(40).step_by(50) {
        measurement.values = [0.5, -0.5, 0.5, 0.5];
    }
    let found = fitted(&top, &sensors, &[], &measurements);
    check_errors("outliers", &found, &state);
    assert!((9..40).contains(&found.statistics.outliers), "{:?}", found.statistics);
}

#[test]
fn rates_in_degrees_are_recognised() {
    let (top, state) = (toy(), release(0.6, 20.0));
    let mut measurements = readings(&top, &state, &SENSORS, 200, 11);
    for measurement in measurements.iter_mut().filter(|measurement| measurement.sensor == 0) {
        measurement.values = measurement.values.map(f64::to_degrees);
    }
    let found = fitted(&top, &SENSORS, &[], &measurements);
    assert_eq!(found.warning, Some(FitWarning::RatesInDegrees), "{:?}", found.statistics);
}

/// Rates of a disc whose nutation decays, fitted without losses. They fit neither as rad/s nor as degrees per second, but as degrees they are
/// small numbers, and therefore have small residuals.
#[test]
fn a_decaying_nutation_is_not_a_wrong_unit() {
    let disc = TopParameters { transverse_inertia: 1.0, axial_inertia: 1.94, ..TOY };
    let top = Top::free(&disc).unwrap();
    let state = State::new(Orientation::IDENTITY, [3.9, 0.0, 32.0]).unwrap();
    let gyroscope = Gyroscope { noise: Noise { deviation: 0.1, bias_deviation: 0.3 }, ..GYROSCOPE };
    let sensors: [&dyn Sensor; 2] = [&gyroscope, &OrientationCamera { deviation: 1e-3 }];
    // every tenth rate, and the first orientation
    let mut measurements: Vec<_> = readings(&top, &state, &sensors, 640, 5).into_iter().step_by(20).collect();
    measurements.insert(1, readings(&top, &state, &sensors, 1, 5)[1]);
    let guess = Top::free(&TopParameters { axial_inertia: 1.9, ..disc }).unwrap();
    for damping in [0.5, 1.0, 2.0] {
        let mut damped = measurements.clone();
        for Measurement { time, values, .. } in damped.iter_mut().filter(|one| one.sensor == 0) {
            values[..2].iter_mut().for_each(|rate| *rate *= (-damping * *time).exp());
        }
        let found = fitted(&guess, &sensors, &[FreeRatio::AXIAL_INERTIA], &damped);
        assert_eq!(found.warning, Some(FitWarning::Misfit), "{damping}: {:?}", found.statistics);
    }
}
