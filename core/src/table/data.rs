//! Table as plain numbers: the clock, the error bounds, the cells and the segments.

pub(super) mod cell;

mod clock;

mod table;

mod memory;

mod baked;

pub use baked::{Baked, BakedError};
pub use cell::{MAX_SEGMENTS, MIN_SEGMENTS};
pub use clock::Clock;
pub use memory::TableMemory;
pub use table::{ErrorBound, SizedTable, Table, TableF32, TableF64};
#[cfg(feature = "fixed")]
pub use table::{TableQ15, TableQ31};
