//! Time of a table, in ticks, and the three phases that depend on it.

mod tick;

mod instant;

mod phases;

pub(crate) use instant::Instant;
pub(crate) use phases::Phases;
pub(in crate::table) use phases::is_falling;
pub use tick::Tick;
