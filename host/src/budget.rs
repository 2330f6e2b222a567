//! Cost of a call on an emulated chip: the exact number of instructions, and a model of their cycles from published timings.
//!
//! The firmware `cost` gives every call a symbol of its own. QEMU runs it and logs which blocks of code it executes (`trace`); the blocks
//! between the entry of a call and its return are counted (`meter`). For chips whose timings are published each instruction is decoded
//! and its cycles are computed (`model`). No clock is used: the same ELF gives the same figures. The allowed costs are in
//! a file (`limits`) and in tables of pages (`pages`). The module `corpus` measures the set-up of many launches.

mod chips;
mod corpus;
mod image;
mod limits;
mod meter;
mod model;
mod pages;
mod trace;

pub use chips::Chip;
pub(crate) use corpus::{CorpusCost, corpus};
pub use image::Image;
pub use limits::Limits;
pub use meter::{Cost, Costs, measure};
pub use model::Model;
pub(crate) use pages::OF_CORPUS;
pub use pages::{OF_LIMITS, Part};

/// Chips whose calls are measured.
pub const CHIPS: [Chip; 5] = [chips::M0PLUS, chips::M4F, chips::M7, chips::M33, chips::RISCV];
