//! Motion by the core: its propagators at given times, and quantities of a motion.
//!
//! | module | contents |
//! |---|---|
//! | [`propagate`] | stepper at given times |
//! | [`ephemeris`] | ephemeris in the smallest table that fits |
//! | [`tip_angle`] | tip angle of an ephemeris, continued from t = 0 |
//! | [`invariants`] | l, n, h from orientation and angular velocity, without the core's formulas |
//! | [`cast`] | complex numbers and orientations of any scalar as `f64` |
//! | [`Scalar`] | scalar types of the core |
//! | [`physical_limits`] | motions of the equations that a top on a table cannot perform |

pub mod cast;
pub mod ephemeris;
pub mod invariants;
pub mod physical_limits;
pub mod propagate;
mod scalar;
pub mod tip_angle;

pub use scalar::Scalar;

/// Greater of two errors; infinite where the second is no number.
pub fn greater(a: f64, b: f64) -> f64 {
    if b.is_nan() { f64::INFINITY } else { a.max(b) }
}
