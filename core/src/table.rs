//! Table of a motion: the motion at any tick, from short polynomials and three integer phases.
//!
//! A tick takes these steps: the nutation phase (an integer) gives a cell, a segment and the local coordinate on it; four polynomials are
//! evaluated by Horner's rule; α and β are rotated by the slow phases (also integers). There is no square root, no division, no library
//! function and no loop whose length depends on data. Every tick has the same cost, and the error does not grow with the number of ticks
//! except by the rounding of the rates.

mod cell;

mod tick;

mod series;

/// Scalars, and the evaluation of a segment.
mod scalar;

/// Polynomials of half a period, from the equations of the motion.
mod build;

/// Table as it is stored: clock, cells and segments.
mod data;

/// Samples of a table.
mod read;

mod set_up;

pub use build::bound::ErrorBound;
pub use build::builder::SetUp;
pub use data::baked::{Baked, BakedError};
pub use data::clock::Clock;
pub use data::storage::{
    Ephemeris, EphemerisF32, EphemerisF64, EphemerisMemory, EphemerisStorage, EphemerisView, ReadyEphemeris,
};
#[cfg(feature = "fixed")]
pub use data::storage::{EphemerisQ15, EphemerisQ31};
pub use data::tip_clock::TipClock;
pub use read::cursor::Cursor;
pub use read::sample::{Pose, Sample};
pub use read::sampler::Sampler;
pub(crate) use read::turning_point::PHASE_TOLERANCE;
pub use read::turning_point::TurningPoint;
pub use scalar::EphemerisScalar;
pub use set_up::SetUpError;
pub use tick::Tick;
