//! Simulated measurements of a motion.

use super::sensors::Sensors;
use crate::input::random::Random;
use std::f64::consts::PI;
use toytop::{Motion, Orientation};
use toytop_fit::{Measurement, Partials, Sensitivity};

/// Times of a recording.
pub struct Recording {
    /// Samples a second.
    pub hertz: f64,
    /// Number of samples.
    pub count: u64,
    /// Seed of the noise.
    pub seed: u64,
}

/// Largest number of samples.
pub const MOST_SAMPLES: f64 = 1e7;

impl Recording {
    /// Times of a recording of this duration, s; `None` where this is not from 1 to [`MOST_SAMPLES`] samples.
    pub fn new(hertz: f64, duration: f64, seed: u64) -> Option<Self> {
        let count = (hertz * duration).round();
        let possible = hertz > 0.0 && (1.0..=MOST_SAMPLES).contains(&count);
        possible.then_some(Self { hertz, count: count as u64, seed })
    }
}

/// Measurements of a motion; `None` where the derivatives of the motion, from which the readings follow, cannot be
/// computed at one of the times.
pub fn measurements(motion: &Motion, sensors: &Sensors, recording: &Recording) -> Option<Vec<Measurement>> {
    let sensitivity = Sensitivity::new(motion);
    let mut cursor = sensitivity.cursor();
    let mut random = Random::new(recording.seed, 0);
    let biases: Vec<[f64; 3]> =
        sensors.instruments.iter().map(|one| [0; 3].map(|_| one.noise.bias * normal(&mut random))).collect();
    let mut found = Vec::new();
    let mut marks_before: Vec<Option<f64>> = vec![None; sensors.instruments.len()];
    for n in 0..recording.count {
        let time = n as f64 / recording.hertz;
        let partials = cursor.at(time + sensors.jitter * normal(&mut random))?;
        let dropped = random.share() < sensors.dropped;
        for (sensor, instrument) in sensors.instruments.iter().enumerate() {
            if instrument.kind.name == "mark" {
                let [ahead, ..] = instrument.sensor.predict(&partials, &[0.0; 4]).difference;
                if let Some(before) = marks_before[sensor].replace(ahead)
                    && let Some(passage) = passage(
                        &sensitivity,
                        &*instrument.sensor,
                        [time - 1.0 / recording.hertz, time],
                        [before, ahead],
                    )
                {
                    let time = passage + instrument.noise.deviation * normal(&mut random);
                    found.push(Measurement { time, sensor, values: [0.0; 4] });
                }
                continue;
            }
            if dropped || n % instrument.every != 0 {
                continue;
            }
            let noise = [0; 3].map(|_| instrument.noise.deviation * normal(&mut random));
            let values = if instrument.kind.name == "orientation" {
                Orientation::exp(noise).compose(&partials.orientation_now()).quaternion()
            } else {
                reading(&*instrument.sensor, &partials, biases[sensor], noise)
            };
            let used = instrument.kind.columns.len();
            let mut coarse = values.map(|x| {
                let quantum = instrument.quantum;
                let rounded = if quantum > 0.0 { (x / quantum).round() * quantum } else { x };
                rounded.clamp(-instrument.range, instrument.range)
            });
            coarse[used..].fill(0.0);
            found.push(Measurement { time, sensor, values: coarse });
        }
    }
    found.sort_by(|a, b| a.time.total_cmp(&b.time).then(a.sensor.cmp(&b.sensor)));
    Some(found)
}

/// Reading with bias and noise. The prediction is the negative of the difference between a reading of 0 and the prediction.
fn reading(
    sensor: &dyn toytop_fit::Sensor,
    partials: &Partials,
    bias: [f64; 3],
    noise: [f64; 3],
) -> [f64; 4] {
    let [x, y, z] = sensor.predict(partials, &[0.0; 4]).difference;
    [bias[0] + noise[0] - x, bias[1] + noise[1] - y, bias[2] + noise[2] - z, 0.0]
}

/// Time at which a mark passes, between two times at which it is ahead by these angles.
fn passage(
    sensitivity: &Sensitivity,
    sensor: &dyn toytop_fit::Sensor,
    [mut low, mut high]: [f64; 2],
    [before, after]: [f64; 2],
) -> Option<f64> {
    // the angle jumps by a turn half a turn away from the passage
    if before.signum() == after.signum() || (before - after).abs() > PI {
        return None;
    }
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        let [ahead, ..] = sensor.predict(&sensitivity.at(middle)?, &[0.0; 4]).difference;
        if ahead.signum() == before.signum() { low = middle } else { high = middle }
    }
    Some(0.5 * (low + high))
}

/// Normally distributed number of mean 0 and variance 1, by Box and Muller.
fn normal(random: &mut Random) -> f64 {
    let radius = (-2.0 * (1.0 - random.share()).ln()).sqrt();
    radius * (2.0 * PI * random.share()).cos()
}
