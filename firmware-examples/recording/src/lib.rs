//! Recording of three sensors on a top, and the numbers of their data sheets. A recording of your own replaces it.

#![no_std]

mod registers;

use toytop::Orientation;
use toytop_fit::{Accelerometer, Gyroscope, Magnetometer, Measurement, Mounting, Noise};

/// Samples a second.
pub const SAMPLE_RATE: u32 = 1000;
/// Time between two samples, s.
const SAMPLE_TIME: f64 = 1.0 / SAMPLE_RATE as f64;
/// Range of the gyroscope, rad/s: 2000 degrees per second.
const GYROSCOPE_RANGE: f64 = 34.906_585_039_886_59;
/// Range of the accelerometer, m/s^2: 16 g.
const ACCELEROMETER_RANGE: f64 = 157.0;
/// Units of the registers: rad/s, m/s^2 and microtesla.
const GYROSCOPE_UNIT: f32 = (GYROSCOPE_RANGE / 32768.0) as f32;
const ACCELEROMETER_UNIT: f32 = (ACCELEROMETER_RANGE / 32768.0) as f32;
const MAGNETIC_UNIT: f32 = 0.15;
/// Number of samples for each reading of the magnetometer.
const EVERY: usize = 10;
/// Mounting at the centre of mass, along the axes of the body.
const MOUNTING: Mounting = Mounting { rotation: Orientation::IDENTITY, place: [0.0; 3] };

pub const GYROSCOPE: Gyroscope = Gyroscope {
    noise: Noise { deviation: 0.002, bias_deviation: 0.0175 },
    mounting: MOUNTING,
    range: 0.999 * GYROSCOPE_RANGE,
};
pub const ACCELEROMETER: Accelerometer = Accelerometer {
    noise: Noise { deviation: 0.022, bias_deviation: 0.2 },
    mounting: MOUNTING,
    range: 0.999 * ACCELEROMETER_RANGE,
};
pub const MAGNETOMETER: Magnetometer = Magnetometer {
    noise: Noise { deviation: 0.6, bias_deviation: 0.0 },
    mounting: MOUNTING,
    field: [20.0, 0.0, -43.0],
};

/// Measurements of the gyroscope (0), the accelerometer (1) and the magnetometer (2), in SI units and microtesla.
///
/// The iterator is a counter with a time, because a fit keeps copies of it on the stack. The first passes of a fit skip most
/// measurements without reading them.
pub fn measurements() -> impl Iterator<Item = Measurement> + Clone {
    let mut time = 0.0;
    (0..3 * registers::INERTIAL.len()).filter_map(move |place| {
        let (n, sensor) = (place / 3, place % 3);
        if sensor == 0 {
            time = time_of(n);
        }
        let (gyroscope, accelerometer) = registers::INERTIAL.get(n)?.split_at(3);
        let (reading, unit) = match sensor {
            0 => (gyroscope, GYROSCOPE_UNIT),
            1 => (accelerometer, ACCELEROMETER_UNIT),
            _ if n % EVERY == 0 => (registers::MAGNETIC.get(n / EVERY)?.as_slice(), MAGNETIC_UNIT),
            _ => return None,
        };
        // a product in f32 keeps the digits of a register, and is an instruction of a Cortex-M4F
        let mut values = [0.0; 4];
        for (value, register) in values.iter_mut().zip(reading) {
            *value = f64::from(f32::from(*register) * unit);
        }
        Some(Measurement { time, sensor, values })
    })
}

/// Time of a sample, s.
#[inline(never)] // the compiler would compute it where it is not needed
fn time_of(sample: usize) -> f64 {
    sample as f64 * SAMPLE_TIME
}
