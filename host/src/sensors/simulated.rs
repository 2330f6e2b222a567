//! Simulated measurements of a motion.

use super::models::{SensorKind, SensorModel, Sensors};
use crate::random::Random;
use std::f64::consts::PI;
use toytop::{Motion, Orientation};
use toytop_fit::{Measurement, Partials, Sensitivity};

/// Times of a recording.
pub struct Recording {
    /// Samples per second.
    pub sample_rate: f64,
    /// Number of samples.
    pub count: u64,
    /// Seed of the noise.
    pub seed: u64,
}

/// Largest number of samples.
pub const MAX_SAMPLES: f64 = 1e7;

impl Recording {
    /// Times of a recording of this duration, s; `None` where this is not from 1 to [`MAX_SAMPLES`] samples.
    pub fn new(sample_rate: f64, duration: f64, seed: u64) -> Option<Self> {
        let count = (sample_rate * duration).round();
        let possible = sample_rate > 0.0 && (1.0..=MAX_SAMPLES).contains(&count);
        possible.then_some(Self { sample_rate, count: count as u64, seed })
    }
}

/// Measurements of a motion; `None` if the motion has no period and the recording is too long.
pub fn simulate_measurements(
    motion: &Motion,
    sensors: &Sensors,
    recording: &Recording,
) -> Option<Vec<Measurement>> {
    let sensitivity = Sensitivity::new(motion);
    let mut cursor = sensitivity;
    let mut random = Random::new(recording.seed, 0);
    let models = &sensors.models;
    let biases: Vec<_> = models
        .iter()
        .map(|one| [0; 3].map(|_| one.sensor.noise().bias_deviation * normal(&mut random)))
        .collect();
    let mut measurements = Vec::new();
    // angles of the marks at the sample before
    let mut before: Vec<Option<f64>> = vec![None; models.len()];
    for n in 0..recording.count {
        let time = n as f64 / recording.sample_rate;
        let partials = cursor.advance_to(time + sensors.jitter * normal(&mut random))?;
        let dropped = random.uniform() < sensors.dropped;
        for (sensor, model) in models.iter().enumerate() {
            let SensorModel { kind, sensor: ideal, range, quantum, every } = model;
            let noise = ideal.noise();
            // the difference of a reading of 0 from the prediction
            let difference = |partials: &Partials| ideal.residual(partials, &[0.0; 4]).difference;
            if *kind == SensorKind::Mark {
                let ahead = |time| Some(difference(&sensitivity.at(time)?)[0]);
                let [now, ..] = difference(&partials);
                if let Some(before) = before[sensor].replace(now)
                    && let Some(passage) =
                        passage(ahead, [time - 1.0 / recording.sample_rate, time], [before, now])
                {
                    let time = passage + noise.deviation * normal(&mut random);
                    measurements.push(Measurement { time, sensor, values: [0.0; 4] });
                }
                continue;
            }
            if dropped || n % every != 0 {
                continue;
            }
            let error = [0; 3].map(|_| noise.deviation * normal(&mut random));
            let exact = if *kind == SensorKind::Orientation {
                Orientation::exp(error).compose(&partials.orientation()).quaternion()
            } else {
                let (bias, difference) = (biases[sensor], difference(&partials));
                let [x, y, z] = [0, 1, 2].map(|k| bias[k] + error[k] - difference[k]);
                [x, y, z, 0.0]
            };
            let mut values = [0.0; 4];
            for (value, exact) in values.iter_mut().zip(exact).take(kind.columns().len()) {
                let rounded = if *quantum > 0.0 { (exact / quantum).round() * quantum } else { exact };
                *value = rounded.clamp(-range, *range);
            }
            measurements.push(Measurement { time, sensor, values });
        }
    }
    measurements.sort_by(|a, b| a.time.total_cmp(&b.time).then(a.sensor.cmp(&b.sensor)));
    Some(measurements)
}

/// Time at which a mark passes, between two times at which it is ahead by the angles `before` and `after`.
fn passage(
    ahead: impl Fn(f64) -> Option<f64>,
    [mut low, mut high]: [f64; 2],
    [before, after]: [f64; 2],
) -> Option<f64> {
    // the angle jumps by a turn half a turn away from the passage
    if before.signum() == after.signum() || (before - after).abs() > PI {
        return None;
    }
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        if ahead(middle)?.signum() == before.signum() { low = middle } else { high = middle }
    }
    Some(0.5 * (low + high))
}

/// Normally distributed number of mean 0 and variance 1, by Box and Muller.
fn normal(random: &mut Random) -> f64 {
    let radius = (-2.0 * (1.0 - random.uniform()).ln()).sqrt();
    radius * (2.0 * PI * random.uniform()).cos()
}
