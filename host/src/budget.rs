//! Cost of a call on an emulated chip: the exact number of instructions, and a model of their cycles from published timings.
//!
//! The firmware `cost` gives every call a symbol of its own. QEMU runs it and logs which blocks of code it executes (`trace`); the blocks
//! between the entry of a call and its return are counted (`meter`). For chips whose timings are published each instruction is decoded
//! (`instruction`) and its cycles are computed (`model`). No clock is used: the same ELF gives the same figures. The allowed costs are in
//! a file (`limits`) and in tables of pages (`readme`). The module `corpus` measures the set-up of many launches.

mod chip;
mod corpus;
mod image;
mod instruction;
mod limits;
mod meter;
mod model;
mod readme;
mod tick;
mod trace;

pub use chip::{CHIPS, Chip};
pub(crate) use corpus::{CorpusCost, corpus};
pub use image::Image;
pub use limits::Limits;
pub use meter::{Cost, measure};
pub use model::Model;
pub(crate) use readme::{with_corpus, with_corpus_in_brief};
pub use readme::{with_front_table, with_table};
pub use tick::{Costs, CountedChip, PLOTTED};
