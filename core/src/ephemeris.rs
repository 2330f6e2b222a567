//! Ephemeris: the motion at any tick, from a table of short polynomials and three integer phases.
//!
//! The evaluation of a tick takes these steps: the nutation phase (an integer) gives a cell, a segment and the local
//! coordinate on it; four polynomials are evaluated by Horner's rule; α and β are rotated by the slow phases (also
//! integers). There is no square root, no division, no library function and no loop whose length depends on data.
//! Every tick has the same cost, and the error does not grow with the number of ticks except by the rounding of the
//! rates.

// Set-up: from a motion to a table.
mod cell;

mod tick;

mod mean_rates;

mod polynomial;

mod chebyshev;

mod seek;

mod span;

mod speeds;

mod segment_errors;

mod larger_error;

mod longer_segments;

mod tabulated;

mod segment_estimate;

mod half_period;

mod tabulate;

mod steady;

mod evaluation;

mod error_bound;

mod rate_error;

mod table;

// Data of an ephemeris, and their evaluation.
mod clock;

mod storage;

mod clock_change;

mod tip_angle;

mod sample;

mod set_up;

mod batch;

mod cursor;

mod sampler;

mod turning_point;

mod crc32;

mod baked;

pub use baked::{Baked, BakedError, TableData};
pub use clock::{Clock, TipClock};
pub use cursor::{Cursor, Samples};
pub use error_bound::ErrorBound;
#[cfg(feature = "micromath")]
pub use evaluation::Micromath;
pub use evaluation::{EphemerisScalar, SegmentPoint};
pub use sample::Sample;
pub use sampler::Sampler;
pub use set_up::SetUp;
pub use storage::{Ephemeris, EphemerisF32, EphemerisF64, EphemerisStorage, EphemerisView};
#[cfg(feature = "fixed")]
pub use storage::{EphemerisQ15, EphemerisQ31};
pub use table::TableTooSmall;
pub use tick::Tick;
pub(crate) use turning_point::AT_THE_POINT;
pub use turning_point::TurningPoint;
