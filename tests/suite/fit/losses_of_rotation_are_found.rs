//! Fitted rates of l, n and h are compared with those of tops that lose rotation within the measurements.
//!
//! The lossy motion is made of exact motions: every half millisecond, angular impulses on the body take rotation away.

use super::simulated_sensors::{
    ACCELEROMETER, GYROSCOPE, MAGNETOMETER, SENSORS, Sample, fitted, held, measured, refusal, release,
};
use nalgebra::{Matrix6, Vector6};
use toytop::su2::{cross, dot};
use toytop::{Motion, PointImpulse, State, Stepper, Top, TopParameters};
use toytop_fit::{Fit, FitWarning, Fitted, FreeRatio, Measurement, Sensitivity, Sensor};
use toytop_tests::random::Random;
use toytop_tests::{TOY, length, toy};

/// Time between two samples, s.
const STEP: f64 = 1e-3;
/// Loss of rotation in a minute.
const LOSS: f64 = 1.0 / 60.0;

fn thrown() -> State {
    release(0.35, 150.0)
}

/// State after an angular impulse: two opposite impulses on the body.
fn twisted(top: &Top, state: &State, impulse: [f64; 3]) -> State {
    if impulse == [0.0; 3] {
        return *state;
    }
    let least = (0..3).min_by(|i, j| impulse[*i].abs().total_cmp(&impulse[*j].abs())).unwrap();
    let mut other = [0.0; 3];
    other[least] = 1.0;
    let arm = cross(impulse, other);
    let arm = arm.map(|x| x / length(arm));
    let force = cross(impulse, arm);
    let place = state.orientation().inverse().adjoint(arm);
    let once = state.with_impulse(top, &PointImpulse { impulse: force, point: place }).unwrap();
    once.with_impulse(top, &PointImpulse { impulse: force.map(|x| -x), point: [0.0; 3] }).unwrap()
}

/// State after losses of rotation about the axis, across it and about the vertical have acted for a short time.
fn slowed(top: &Top, state: &State, [axial, across, vertical]: [f64; 3], time: f64) -> State {
    let (axis, omega) = (state.orientation().axis(), state.omega());
    let spin = dot(omega, axis);
    let torque = [0, 1, 2].map(|k| {
        let level = f64::from(u8::from(k == 2)) - axis[2] * axis[k];
        let w = omega[k] - spin * axis[k];
        -top.axial_inertia() * axial * spin * axis[k]
            - top.transverse_inertia() * (across * w + vertical * omega[2] * level)
    });
    twisted(top, state, torque.map(|x| x * time))
}

/// States at the times of the samples, of a top that loses rotation.
fn lossy(top: &Top, losses: [f64; 3], count: usize) -> Vec<State> {
    let mut states = vec![thrown()];
    while states.len() < count {
        let mut state = states[states.len() - 1];
        for _ in 0..2 {
            let before = slowed(top, &state, losses, STEP / 4.0);
            let mut stepper = Stepper::<f64>::new(&Motion::launch(top, &before).unwrap());
            stepper.step(STEP / 2.0);
            let later = State::new(stepper.orientation(), stepper.attitude_state().omega()).unwrap();
            state = slowed(top, &later, losses, STEP / 4.0);
        }
        states.push(state);
    }
    states
}

/// Readings at a state, from the motion alone: a body without an arm feels the acceleration of its support, g + s u''.
fn sample(top: &Top, state: &State) -> Sample {
    /// Half the time between two rates u', s.
    const HALF_STEP: f64 = 1e-5;
    let motion = Motion::launch(top, state).unwrap();
    let [before, after] = [-HALF_STEP, HALF_STEP].map(|time| {
        let mut stepper = Stepper::<f64>::new(&motion);
        stepper.step(time);
        stepper.attitude_state().udot()
    });
    let lift = top.com_height() * (after - before) / (2.0 * HALF_STEP);
    let orientation = state.orientation();
    let fixed = [state.omega(), [0.0, 0.0, top.gravity() + lift], MAGNETOMETER.field];
    let predicted = fixed
        .iter()
        .zip(SENSORS)
        .map(|(fixed, sensor)| [orientation.inverse().adjoint(*fixed), [sensor.noise().deviation; 3]]);
    Sample { orientation, predicted: predicted.collect() }
}

/// Readings at states, with noise and biases.
fn noisy(top: &Top, states: &[State], seed: u64) -> Vec<Measurement> {
    measured(states.iter().map(|state| sample(top, state)), &SENSORS, seed)
}

/// Mean rates of l, n and h.
fn drift_of(top: &Top, states: &[State]) -> [f64; 3] {
    let integrals = |state: &State| {
        let found = Motion::launch(top, state).unwrap().first_integrals();
        [found.l, found.n, found.h]
    };
    let span = STEP * (states.len() - 1) as f64;
    let (start, end) = (integrals(&states[0]), integrals(&states[states.len() - 1]));
    [0, 1, 2].map(|k| (end[k] - start[k]) / span)
}

fn with_losses(top: &Top, measurements: &[Measurement]) -> Fitted {
    let fit = Fit::new(top, &SENSORS, &[]).unwrap();
    fit.with_losses(LOSS).unwrap().run(measurements.iter().copied()).unwrap()
}

/// Square of the error of the launch in standard deviations: χ² of six degrees of freedom.
fn square(fitted: &Fitted, state: &State) -> f64 {
    let turn = state.orientation().compose(&fitted.launch.orientation.inverse());
    let [w, x, y, z] = turn.quaternion();
    // ω is compared in a frame that turns with the error of the orientation, because the error of the yaw may be large
    let (found, [a, b, c]) = (fitted.launch.omega, turn.inverse().adjoint(state.omega()));
    let [x, y, z] = [x, y, z].map(|x| 2.0 * x * w.signum());
    let error = Vector6::new(x, y, z, a - found[0], b - found[1], c - found[2]);
    let covariance = Matrix6::from_fn(|i, j| fitted.covariance(i.max(j), i.min(j)).unwrap());
    error.dot(&covariance.cholesky().unwrap().solve(&error))
}

/// Losses of all three kinds, of either sign.
///
/// The errors of the three rates are nearly equal, because most of each comes from the loss about the axis. Therefore each case gives
/// only one independent number: the mean of the first 24 squares is 1.6 to 1.8 by chance, and that of 300 others 0.99 to 1.06.
#[test]
fn losses_of_every_kind_are_found() {
    const CASES: u32 = 72;
    let mut random = Random(11);
    let mut squares = [0.0; 3];
    let mut launches = 0.0;
    for case in 0..CASES {
        let top = if case % 2 == 0 { toy() } else { held() };
        let losses = [0; 3].map(|_| LOSS * random.normal());
        let states = lossy(&top, losses, 250);
        let truth = drift_of(&top, &states);
        let found = with_losses(&top, &noisy(&top, &states, u64::from(case)));
        assert!(found.is_trusted(), "{case}: {:?} {:?}", found.warning, found.statistics);
        let drift = found.drift.unwrap();
        for k in 0..3 {
            let off = (drift.rates[k] - truth[k]) / drift.deviations()[k];
            assert!(off.abs() < 4.0, "{case} {k}: {off} {losses:?} {:?}", drift.losses);
            squares[k] += off * off / f64::from(CASES);
        }
        launches += square(&found, &states[states.len() - 1]) / f64::from(CASES);
    }
    // the mean of 72 squares of a normal number is 1 ± 0.17, that of six is 6 ± 0.41
    for mean in squares {
        assert!((0.55..1.45).contains(&mean), "{squares:?}");
    }
    assert!((4.8..7.2).contains(&launches), "{launches}");
}

/// The motion with the drift reaches back to the first sample, and explains every reading.
#[test]
fn the_motion_with_the_drift_is_that_of_the_measurements() {
    let top = toy();
    let states = lossy(&top, [LOSS, 0.5 * LOSS, 0.0], 300);
    let measurements = noisy(&top, &states, 3);
    let found = with_losses(&top, &measurements);
    let without = fitted(&top, &SENSORS, &[], &measurements);
    assert_eq!(without.warning, Some(FitWarning::Misfit), "{:?}", without.statistics);
    assert_eq!(found.launch_time, measurements[measurements.len() - 1].time);
    let sensitivity = found.sensitivity().unwrap();
    let exact = Sensitivity::new(&found.motion().unwrap());
    let apart = |sensitivity: &Sensitivity, index: usize| {
        let at = sensitivity.at(index as f64 * STEP - found.launch_time).unwrap();
        let turn = at.orientation().compose(&states[index].orientation().inverse());
        2.0 * turn.quaternion()[0].abs().min(1.0).acos()
    };
    for index in [0, 80, 150, 299] {
        assert!(apart(&sensitivity, index) < 0.02, "{index}: {}", apart(&sensitivity, index));
    }
    assert!(apart(&exact, 0) > 0.05, "{}", apart(&exact, 0));
}

/// The next block begins from the end of the last one, and fits its own drift.
#[test]
fn blocks_with_a_drift_are_tracked() {
    let top = toy();
    let states = lossy(&top, [LOSS, 0.0, 0.0], 600);
    let measurements = noisy(&top, &states, 9);
    let (first, second) = measurements.split_at(measurements.partition_point(|one| one.time < 300.0 * STEP));
    let mut fit = Fit::new(&top, &SENSORS, &[]).unwrap().with_losses(LOSS).unwrap();
    let last = fit.run(first.iter().copied()).unwrap();
    let tracked = fit.track(&last, LOSS, second.iter().copied()).unwrap();
    assert!(tracked.fitted.is_trusted(), "{:?} {:?}", tracked.fitted.warning, tracked.fitted.statistics);
    assert_eq!(tracked.fitted.launch_time, measurements[measurements.len() - 1].time);
    let truth = drift_of(&top, &states[300..]);
    let drift = tracked.fitted.drift.unwrap();
    let off = (drift.rates[1] - truth[1]) / drift.deviations()[1];
    assert!(off.abs() < 4.0, "{off}");
    assert!((tracked.drift_rates[1] / truth[1] - 1.0).abs() < 0.05, "{:?} {truth:?}", tracked.drift_rates);
    let jump = length(tracked.jump);
    assert!(jump > 0.0 && jump < 0.02, "{jump}");
    assert!(square(&tracked.fitted, &states[599]) < 25.0, "{}", square(&tracked.fitted, &states[599]));
}

#[test]
fn single_precision_finds_the_drift_of_double_precision() {
    let single: [&dyn Sensor<f32>; 3] = [&GYROSCOPE, &ACCELEROMETER, &MAGNETOMETER];
    let top = toy();
    let states = lossy(&top, [LOSS, 0.0, 0.0], 300);
    let measurements = noisy(&top, &states, 21);
    let wide = with_losses(&top, &measurements).drift.unwrap();
    let mut fit = Fit::new(&top, &single, &[]).unwrap().with_losses(LOSS).unwrap();
    let narrow = fit.run(measurements.iter().copied()).unwrap();
    assert!(narrow.is_trusted(), "{:?} {:?}", narrow.warning, narrow.statistics);
    let off = (narrow.drift.unwrap().rates[1] - wide.rates[1]) / wide.deviations()[1];
    assert!(off.abs() < 0.2, "{off}");
}

/// The axial inertia may be free with the drift, and no second ratio.
#[test]
fn one_ratio_may_be_free_with_a_drift() {
    let top = toy();
    let states = lossy(&top, [LOSS, 0.0, 0.0], 300);
    let measurements = noisy(&top, &states, 27);
    let wrong = Top::sliding(&TopParameters { axial_inertia: 2.02e-5, ..TOY }).unwrap();
    let fit = |ratios: &[FreeRatio]| Fit::new(&wrong, &SENSORS, ratios).unwrap().with_losses(LOSS);
    let found = fit(&[FreeRatio::AXIAL_INERTIA]).unwrap().run(measurements.iter().copied()).unwrap();
    assert!(found.is_trusted(), "{:?} {:?}", found.warning, found.statistics);
    let off = (found.top().unwrap().axial_inertia() / 2e-5).ln() / found.deviations()[6];
    assert!(off.abs() < 4.0, "{off}");
    let loss = found.drift.unwrap().losses[0];
    assert!((loss / LOSS - 1.0).abs() < 0.05, "{loss}");

    let two = fit(&[FreeRatio::AXIAL_INERTIA, FreeRatio::GRAVITY]);
    assert_eq!(refusal(two), "ratios: must be at most four, or one with losses");
    for deviation in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let refused = Fit::new(&top, &SENSORS, &[]).unwrap().with_losses(deviation);
        assert_eq!(refusal(refused), "deviation: must be finite and positive", "{deviation}");
    }
}
