//! Fits of consecutive blocks are compared with the true loss between them, and fits in single precision with those in double precision.

use super::simulated_sensors::{
    ACCELEROMETER, GYROSCOPE, MAGNETOMETER, SENSORS, check_errors, fitted, held, readings, refusal, release,
};
use toytop::{Motion, State};
use toytop_fit::{Fit, FreeRatio, Measurement, Sensitivity, Sensor};
use toytop_tests::{length, toy};

/// The top loses half a percent of ω between two blocks; the next block is fitted from the prediction of the first.
#[test]
fn a_loss_of_spin_between_two_blocks_is_tracked_and_reported() {
    const LOSS: f64 = 0.005;
    const SPAN: f64 = 0.3;
    let (top, state) = (toy(), release(0.35, 150.0));
    let motion = Motion::launch(&top, &state).unwrap();
    // one seed, so that the biases are those of the same sensors
    let first = readings(&top, &state, &SENSORS, 300, 21);
    let at = Sensitivity::new(&motion).at(SPAN).unwrap();
    let slower = State::new(at.orientation(), at.omega().map(|x| (1.0 - LOSS) * x)).unwrap();
    let second: Vec<_> = readings(&top, &slower, &SENSORS, 300, 21)
        .into_iter()
        .map(|measurement| Measurement { time: measurement.time + SPAN, ..measurement })
        .collect();

    let mut fit = Fit::new(&top, &SENSORS, &[]).unwrap();
    let last = fit.run(first.iter().copied()).unwrap();
    check_errors("first block", &last, &state);
    let tracked = fit.track(&last, 1.0 / 60.0, second.iter().copied()).unwrap();
    check_errors("second block", &tracked.fitted, &slower);
    let n = motion.first_integrals().n;
    let drift = tracked.drift_rates[1] / n;
    assert!((drift + LOSS / SPAN).abs() < 1e-4, "{drift}");
    let jump = length(tracked.jump);
    assert!(jump > 0.0 && jump < 0.02, "{jump}");
    for loss in [-1.0, f64::NAN, f64::INFINITY] {
        let refused = fit.track(&last, loss, second.iter().copied());
        assert_eq!(refusal(refused), "drift_deviation: must be finite and not negative", "{loss}");
    }
    let free = Fit::new(&top, &SENSORS, &[FreeRatio::GRAVITY]).unwrap();
    let one_sensor = Fit::new(&top, &SENSORS[..1], &[]).unwrap();
    let other_top = Fit::new(&held(), &SENSORS, &[]).unwrap();
    for mut other in [free, one_sensor, fit.clone().with_losses(LOSS).unwrap(), other_top] {
        let refused = other.track(&last, LOSS, second.iter().copied());
        assert_eq!(refusal(refused), "last: must be of the same top, and have the same unknowns");
    }
    let mut later = last;
    later.launch_time = 10.0;
    let late = fit.track(&later, 0.0, second.iter().copied());
    assert_eq!(refusal(late), "measurements 0: must be as late as the last launch, or later");
    let mut invalid = last;
    invalid.launch.omega = [f64::NAN; 3];
    let invalid = fit.track(&invalid, 0.0, second.iter().copied());
    assert_eq!(refusal(invalid), "last: must be a motion that reaches the first measurement");
}

#[test]
fn single_precision_finds_the_launch_of_double_precision() {
    let single: [&dyn Sensor<f32>; 3] = [&GYROSCOPE, &ACCELEROMETER, &MAGNETOMETER];
    let top = toy();
    for (tilt, spin) in [(0.35, 150.0), (0.6, 20.0)] {
        let measurements = readings(&top, &release(tilt, spin), &SENSORS, 300, 23);
        let wide = fitted(&top, &SENSORS, &[], &measurements);
        let narrow = Fit::new(&top, &single, &[]).unwrap().run(measurements.iter().copied()).unwrap();
        assert!(narrow.is_trusted(), "{tilt} {spin}: {:?}", narrow.warning);
        let deviations = wide.deviations();
        for k in 0..3 {
            let off = (narrow.launch.omega[k] - wide.launch.omega[k]) / deviations[3 + k];
            assert!(off.abs() < 0.2, "{tilt} {spin}: {off}");
        }
    }
}
