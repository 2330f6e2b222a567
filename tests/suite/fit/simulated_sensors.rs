//! Simulated sensors, and the launches fitted to their readings: these functions serve the other files of the folder.

use toytop::{Motion, Orientation, ParameterError, Release, State, Top, TopParameters};
use toytop_fit::{
    Accelerometer, Fit, Fitted, FreeRatio, Gyroscope, Hint, Magnetometer, Measurement, Mounting, Noise,
    Residual, Sensitivity, Sensor,
};
use toytop_tests::TOY;
use toytop_tests::random::Random;

pub(crate) fn held() -> Top {
    Top::fixed(&TopParameters { transverse_inertia: 7.5e-5, ..TOY }).unwrap()
}

pub(crate) fn release(tilt: f64, spin: f64) -> State {
    State::from_release(&Release { tilt, azimuth: 0.4, roll: -0.7, spin, precession: 2.0, nutation: 0.5 })
        .unwrap()
}

pub(crate) const GYROSCOPE: Gyroscope =
    Gyroscope { noise: Noise { deviation: 2e-3, bias_deviation: 0.0175 }, mounting: mounting(), range: 34.9 };
pub(crate) const ACCELEROMETER: Accelerometer = Accelerometer {
    noise: Noise { deviation: 0.02, bias_deviation: 0.2 },
    mounting: mounting(),
    range: 160.0,
};
pub(crate) const MAGNETOMETER: Magnetometer = Magnetometer {
    noise: Noise { deviation: 0.6, bias_deviation: 0.0 },
    mounting: mounting(),
    field: [20.0, 0.0, -43.0],
};

/// Sensors of a telephone.
pub(crate) const SENSORS: [&dyn Sensor; 3] = [&GYROSCOPE, &ACCELEROMETER, &MAGNETOMETER];

pub(crate) const fn mounting() -> Mounting {
    Mounting { rotation: Orientation::IDENTITY, place: [0.0; 3] }
}

/// Readings at 1 kHz of a motion that starts in a state.
pub(crate) fn readings(
    top: &Top,
    state: &State,
    sensors: &[&dyn Sensor],
    count: u32,
    seed: u64,
) -> Vec<Measurement> {
    let mut sensitivity = Sensitivity::new(&Motion::launch(top, state).unwrap());
    let at = |n: u32| {
        let partials = sensitivity.advance_to(f64::from(n) * 1e-3).unwrap();
        let predicted = sensors.iter().map(|sensor| {
            let Residual { difference, deviation, .. } = sensor.residual(&partials, &[0.0; 4]);
            [difference.map(|x| -x), deviation]
        });
        Sample { orientation: partials.orientation(), predicted: predicted.collect() }
    };
    measured((0..count).map(at), sensors, seed)
}

/// Orientation, and the readings of the sensors without noise, with their standard deviations.
pub(crate) struct Sample {
    pub(crate) orientation: Orientation<f64>,
    pub(crate) predicted: Vec<[[f64; 3]; 2]>,
}

/// Readings at 1 kHz with noise and biases; those of a camera get the noise in the fixed frame. The third sensor is the magnetometer, which
/// is read at every tenth sample.
pub(crate) fn measured(
    samples: impl Iterator<Item = Sample>,
    sensors: &[&dyn Sensor],
    seed: u64,
) -> Vec<Measurement> {
    let mut random = Random(seed);
    let biases: Vec<[f64; 3]> = sensors
        .iter()
        .map(|sensor| [0; 3].map(|_| random.normal() * sensor.noise().bias_deviation))
        .collect();
    let mut found = Vec::new();
    for (n, Sample { orientation, predicted }) in (0_u32..).zip(samples) {
        for (sensor, one) in
            sensors.iter().enumerate().filter(|(sensor, _)| *sensor < 2 || n.is_multiple_of(10))
        {
            let [predicted, deviation] = predicted[sensor];
            // a component that does not exist has an infinite deviation
            let noise = deviation
                .map(|deviation| if deviation.is_finite() { random.normal() * deviation } else { 0.0 });
            let camera = matches!(one.hint(&[1.0, 0.0, 0.0, 0.0]), Hint::Orientation(_));
            let values = if camera {
                Orientation::exp(noise).compose(&orientation).quaternion()
            } else {
                let [x, y, z] = [0, 1, 2].map(|k| biases[sensor][k] + noise[k] + predicted[k]);
                let range = if sensor == 0 { GYROSCOPE.range } else { f64::INFINITY };
                [x, y, z, 0.0].map(|x| x.clamp(-range, range))
            };
            found.push(Measurement { time: f64::from(n) * 1e-3, sensor, values });
        }
    }
    found
}

pub(crate) fn fitted(
    top: &Top,
    sensors: &[&dyn Sensor],
    ratios: &[FreeRatio],
    measurements: &[Measurement],
) -> Fitted {
    Fit::new(top, sensors, ratios).unwrap().run(measurements.iter().copied()).unwrap()
}

/// Launch found from the readings of a motion that starts in a state.
pub(crate) fn simulated(top: &Top, state: &State, sensors: &[&dyn Sensor], count: u32, seed: u64) -> Fitted {
    fitted(top, sensors, &[], &readings(top, state, sensors, count, seed))
}

/// Text of a refusal.
pub(crate) fn refusal<T>(result: Result<T, ParameterError>) -> String {
    result.err().unwrap().to_string()
}

/// Errors in standard deviations of ω, turned back by the error of the orientation.
pub(crate) fn errors(fitted: &Fitted, state: &State) -> [f64; 3] {
    let deviations = fitted.deviations();
    let turn = state.orientation().compose(&fitted.launch.orientation.inverse());
    let omega = turn.inverse().adjoint(state.omega());
    [0, 1, 2].map(|k| (fitted.launch.omega[k] - omega[k]) / deviations[3 + k])
}

pub(crate) fn check_errors(name: &str, fitted: &Fitted, state: &State) {
    assert!(fitted.is_trusted(), "{name}: {:?} {:?}", fitted.warning, fitted.statistics);
    for error in errors(fitted, state) {
        assert!(error.abs() < 4.5, "{name}: {:?}", errors(fitted, state));
    }
}
