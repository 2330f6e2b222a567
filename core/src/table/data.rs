//! Table as plain numbers: the clock, the error bounds, the cells and the segments.

pub(super) mod cell;

mod tick;

mod phases;

mod clock;

mod memory;

mod baked;

pub use baked::{Baked, BakedError};
pub use clock::Clock;
pub use memory::{ErrorBound, SizedTable, Table, TableF32, TableF64, TableMemory};
#[cfg(feature = "fixed")]
pub use memory::{TableQ15, TableQ31};
pub(crate) use phases::Phases;
pub use tick::Tick;
