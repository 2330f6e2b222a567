#![doc = include_str!("../README.md")]
#![cfg_attr(not(test), no_std)]

// Modules in the order of dependence: each one uses only those above it.
mod vector;

mod sensitivity;

mod sensors;

mod least_squares;

mod course;

mod model;

mod fit;

#[cfg(doc)]
#[doc = include_str!("../docs/partials.md")]
pub mod partials {}

pub use fit::{Drift, Fit, FitError, Fitted, Reason, Statistics, Tracked, Unobservable};
pub use least_squares::{Covariance, MOST_UNKNOWNS};
pub use model::{Estimate, FreeRatio, MOST_RATIOS, MOST_SENSORS};
pub use sensitivity::{Partials, Sensitivity, SensitivityCursor};
pub use sensors::{
    Accelerometer, AxisCamera, Gyroscope, Hint, Magnetometer, Mark, Measurement, Mounting, Noise,
    OrientationCamera, Prediction, Sensor, TipCamera,
};
