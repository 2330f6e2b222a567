//! What a call costs on a chip, by emulating it: exact instructions, and from published timings the cycles that they would take.
//!
//! The firmware `cost` gives every call a symbol of its own. QEMU runs it and says which blocks of code it executes
//! (`trace`); those between a call's entry and its return are counted (`meter`). For chips whose timings are published
//! each instruction is decoded (`instruction`) and priced (`model`). Nothing here depends on a clock: the same ELF gives
//! the same figures. What a call may cost is in a file (`limits`), and on the front page (`readme`).

mod chip;
mod corpus;
mod image;
mod instruction;
mod limits;
mod meter;
mod model;
mod readme;
mod trace;

pub use chip::{CHIPS, Chip};
pub use corpus::{CorpusCost, corpus};
pub use image::Image;
pub use limits::Limits;
pub use meter::{Cost, measure};
pub use model::Model;
pub use readme::{with_front_table, with_table};
