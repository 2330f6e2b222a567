#![doc = include_str!("../README.md")]
#![cfg_attr(not(test), no_std)]

// Modules in the order of dependence: each one uses only those above it.
//
// `#[inline(never)] // stack`: the numbers of the function are on the stack only during its call.

mod vector;

mod sensitivity;

mod sensors;

mod square_root;

mod estimate;

mod model;

mod fit;

#[cfg(doc)]
#[doc = include_str!("../docs/partials.md")]
pub mod partials {}

pub use estimate::{Estimate, FreeRatio};
pub use fit::{Drift, Fit, FitWarning, Fitted, Statistics, Tracked, Unobservable};
pub use model::{MAX_RATIOS, MAX_SENSORS};
pub use sensitivity::{Partials, Sensitivity};
pub use sensors::{
    Accelerometer, AxisCamera, Gyroscope, Hint, Magnetometer, Mark, Measurement, Mounting, Noise,
    OrientationCamera, Residual, Sensor, TipCamera, Values,
};
pub use square_root::MAX_UNKNOWNS;
