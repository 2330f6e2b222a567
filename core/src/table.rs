//! Table of a motion: the motion at any tick, from short polynomials and three integer phases.
//!
//! In a tick the nutation phase (an integer) gives a cell, a segment and the local coordinate on it; four polynomials are evaluated by
//! Horner's rule; α and β are rotated by the slow phases (also integers). Every tick has the same cost, and the error grows only by the
//! rounding of the rates.

mod cell;

mod series;

/// Scalars, and the evaluation of a segment.
mod scalar;

/// Polynomials of half a period, from the equations of the motion.
mod build;

mod clock;

mod ephemeris;

mod baked;

mod sample;

mod cursor;

mod set_up;

pub use baked::{Baked, BakedError};
pub use build::SetUp;
pub use build::bound::ErrorBound;
pub use clock::{Clock, Tick};
pub use cursor::{Cursor, CursorPhases};
pub use ephemeris::{Ephemeris, EphemerisF32, EphemerisF64, EphemerisMemory, EphemerisView, ReadyEphemeris};
#[cfg(feature = "fixed")]
pub use ephemeris::{EphemerisQ15, EphemerisQ31};
pub use sample::{Pose, Sample};
pub use scalar::EphemerisScalar;
pub use set_up::SetUpError;
