//! Sensors of a top: their predictions of a reading, and what a reading tells about a state.

// In the order of dependence.
mod sensor;

mod inertial;

mod optical;

pub use inertial::{Accelerometer, Gyroscope, Magnetometer};
pub use optical::{AxisCamera, Mark, OrientationCamera, TipCamera};
pub(crate) use sensor::Measurements;
pub use sensor::{Hint, Measurement, Mounting, Noise, Prediction, Sensor};
