//! Chips whose calls are measured, and models of those whose timings are published.

use super::Model;
pub use toytop_chips::Chip;
use toytop_chips::{M0PLUS, M4F, M7, M33, RISCV};

/// All chips whose calls are measured.
pub const CHIPS: [Chip; 5] = [M0PLUS, M4F, M7, M33, RISCV];

/// Model of a chip's cycles; `None` where no timings are published.
pub(super) fn model(chip: &Chip) -> Option<Model> {
    match *chip {
        M0PLUS => Some(Model::M0Plus),
        M4F => Some(Model::M4),
        _ => None,
    }
}
