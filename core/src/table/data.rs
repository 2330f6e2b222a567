//! Table as plain numbers: the clock, the error bounds, the cells and the segments.

pub(super) mod cell;

mod tick;

mod phases;

mod clock;

mod ephemeris;

mod baked;

pub use baked::{Baked, BakedError};
pub use clock::Clock;
pub use ephemeris::{Ephemeris, EphemerisF32, EphemerisF64, EphemerisMemory, ErrorBound, Table};
#[cfg(feature = "fixed")]
pub use ephemeris::{EphemerisQ15, EphemerisQ31};
pub(crate) use phases::Phases;
pub use tick::Tick;
