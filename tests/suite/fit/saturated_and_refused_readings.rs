//! Fits of readings beyond a range, and of a rod, are compared with the true launch, and invalid measurements are refused.

use super::simulated_sensors::{
    ACCELEROMETER, GYROSCOPE, MAGNETOMETER, SENSORS, check_errors, fitted, readings, refusal, release,
    simulated,
};
use toytop::{Motion, Orientation, ParameterError, State, Top, TopParameters};
use toytop_fit::{
    AxisCamera, Fit, FitWarning, Fitted, FreeRatio, Gyroscope, Hint, Magnetometer, Mark, Measurement,
    Mounting, Noise, Sensitivity, Sensor,
};
use toytop_tests::{TOY, toy};

/// The spin exceeds the range of two axes of a gyroscope that is turned by 45 degrees. Along the axis of the top they have opposite signs,
/// and neither is a measurement of the spin.
#[test]
fn saturated_axes_of_a_turned_gyroscope_are_not_believed() {
    let half_turn = core::f64::consts::PI / 8.0;
    let rotation = Orientation::from_quaternion([half_turn.cos(), 0.0, half_turn.sin(), 0.0]);
    let gyroscope = Gyroscope { mounting: Mounting { rotation, place: [0.0; 3] }, ..GYROSCOPE };
    let sensors: [&dyn Sensor; 3] = [&gyroscope, &ACCELEROMETER, &MAGNETOMETER];
    let (top, state) = (toy(), release(0.35, 250.0));
    check_errors("turned", &simulated(&top, &state, &sensors, 300, 5), &state);
}

/// A thin rod has C = 0, and its ratio A/C is infinite: no result may depend on it.
#[test]
fn the_launch_of_a_thin_rod_has_error_bars() {
    let top = Top::fixed(&TopParameters { transverse_inertia: 4.5e-5, axial_inertia: 0.0, ..TOY }).unwrap();
    let state = release(2.1, -1.2);
    let measurements = readings(&top, &state, &SENSORS, 300, 3);
    let partials = Sensitivity::new(&Motion::launch(&top, &state).unwrap()).at(0.2).unwrap();
    let gravity = [FreeRatio::new([0.0, 0.0, 0.0, 0.01])];
    for ratios in [&[][..], &gravity] {
        let found = fitted(&top, &SENSORS, ratios, &measurements);
        check_errors("rod", &found, &state);
        let covariance = found.orientation_covariance(&partials);
        let deviation = (covariance[0][0] + covariance[1][1] + covariance[2][2]).sqrt();
        assert!((1e-5..0.1).contains(&deviation), "{deviation:e}");
    }
}

/// A vector of length 0 has no direction, and a mark on the vertical no azimuth.
#[test]
fn readings_without_a_direction_have_no_effect() {
    let no_field = Magnetometer { field: [0.0; 3], ..MAGNETOMETER };
    let sensors: [(&dyn Sensor, _); 2] = [(&AxisCamera { deviation: 1e-3 }, [0.0; 4]), (&no_field, [1.0; 4])];
    for (sensor, values) in sensors {
        assert_eq!(sensor.hint(&values), Hint::None);
    }
    let upright = State::new(Orientation::IDENTITY, [0.0, 0.0, 150.0]).unwrap();
    let partials = Sensitivity::new(&Motion::launch(&toy(), &upright).unwrap()).at(0.0).unwrap();
    let mark: &dyn Sensor = &Mark { deviation: 1e-5, place: [0.0, 0.0, 0.01] };
    assert_eq!(mark.residual(&partials, &[0.0; 4]).deviation, [f64::INFINITY; 3]);
}

/// A run that ends without a launch has nothing of the run before it.
#[test]
fn a_run_begins_without_the_results_of_the_last_one() {
    let top = toy();
    let good = readings(&top, &release(0.35, 150.0), &SENSORS, 60, 13);
    let mut fit = Fit::new(&top, &SENSORS, &[]).unwrap();
    let mut run = |count: usize| fit.run(good.iter().copied().take(count)).unwrap();
    let [fresh, _, again] = [1, good.len(), 1].map(&mut run);
    assert_eq!(again.statistics, fresh.statistics);
    assert_eq!(again.unobservable, fresh.unobservable);
    assert_eq!(again.deviations(), fresh.deviations());
}

#[test]
fn bad_measurements_are_refused_or_not_believed() {
    let top = toy();
    let good = readings(&top, &release(0.35, 150.0), &SENSORS, 60, 13);
    let run = |measurements: &[Measurement]| {
        Fit::new(&top, &SENSORS, &[]).unwrap().run(measurements.iter().copied())
    };
    assert_eq!(refusal(run(&[])), "measurements: must be at least one");
    let changed = |change: fn(&mut Vec<Measurement>)| {
        let mut measurements = good.clone();
        change(&mut measurements);
        run(&measurements)
    };
    let refused = |change, expected: &str| assert_eq!(refusal(changed(change)), expected);
    refused(|all| all[5].values[1] = f64::NAN, "measurements 5: must be finite");
    refused(|all| all[6].time = f64::INFINITY, "measurements 6: must be finite");
    refused(|all| all[8].time = 0.0, "measurements 8: must be as late as the one before, or later");
    refused(|all| all[9].sensor = 3, "measurements 9: must be of a sensor in the list");
    // the readings of one instant do not determine the rate about the axis
    let reason = |found: Result<Fitted, ParameterError>| found.unwrap().warning;
    assert!(reason(changed(|all| all.truncate(1))).is_some());
    assert!(reason(changed(|all| all.truncate(3))).is_some());
    // all readings are at the end of the range
    let all = changed(|all| {
        all.retain(|measurement| measurement.sensor == 0);
        all.iter_mut().for_each(|measurement| measurement.values = [34.9, -34.9, 34.9, 0.0]);
    });
    assert!(reason(all).is_some());
    // a top that is held by hand
    let mut still = good.clone();
    let first: Vec<_> = still[..3].to_vec();
    for measurement in &mut still {
        measurement.values = first[measurement.sensor].values;
        if measurement.sensor == 0 {
            measurement.values = [0.0; 4];
        }
    }
    let long: Vec<_> = (0..10)
        .flat_map(|k| still.iter().map(move |m| Measurement { time: m.time + 0.06 * f64::from(k), ..*m }))
        .collect();
    assert_eq!(reason(run(&long)), Some(FitWarning::AtRest));
}

#[test]
fn a_sensor_without_positive_noise_is_refused() {
    let refused = [(0.0, 0.0), (f64::NAN, 0.0), (f64::INFINITY, 0.0), (1.0, -1.0), (1.0, f64::NAN)];
    for (deviation, bias_deviation) in refused {
        let gyroscope = Gyroscope { noise: Noise { deviation, bias_deviation }, ..GYROSCOPE };
        let sensors: [&dyn Sensor; 2] = [&ACCELEROMETER, &gyroscope];
        let refused = refusal(Fit::new(&toy(), &sensors, &[]));
        assert_eq!(refused, "sensors 1: must be one with positive noise, and a bias that is not negative");
    }
}

#[test]
fn a_ratio_without_a_direction_or_with_a_wrong_deviation_is_refused() {
    let FreeRatio { direction, .. } = FreeRatio::GRAVITY;
    let deviations = [0.0, -1.0, f64::NAN].map(|deviation| FreeRatio { direction, deviation });
    let directions = [0.0, f64::NAN, f64::INFINITY].map(|x| FreeRatio::new([0.0, x, 0.0, 0.0]));
    for wrong in deviations.into_iter().chain(directions) {
        let refused = refusal(Fit::new(&toy(), &SENSORS, &[FreeRatio::GRAVITY, wrong]));
        let expected = "ratios 1: must be one with a finite direction other than 0, and a positive deviation";
        assert_eq!(refused, expected, "{wrong:?}");
    }
}

#[test]
fn a_limit_of_residuals_below_their_deviation_is_refused() {
    for residual in [0.9, -1.0, f64::NAN] {
        let refused = refusal(Fit::new(&toy(), &SENSORS, &[]).unwrap().with_huber(residual));
        assert_eq!(refused, "residual: must be a number from 1, or infinite", "{residual}");
    }
    assert!(Fit::new(&toy(), &SENSORS, &[]).unwrap().with_huber(f64::INFINITY).is_ok());
}
