//! Chips that the programs run on; `toytop budget` describes them.

use anyhow::{Context, Result};
#[allow(unreachable_pub)]
#[path = "../../src/budget/chips.rs"]
mod chips;

pub(crate) use chips::{Chip, M0, M0PLUS, M4F, M7, M33, RISCV, target_dir};

/// All chips.
pub(crate) const ALL: &[&Chip] = &[&M4F, &M0, &M7, &M33, &RISCV, &M0PLUS];

/// Chip of this name.
pub(crate) fn named(name: &str) -> Result<&'static Chip> {
    let names = || ALL.iter().map(|chip| chip.name).collect::<Vec<_>>().join(" ");
    let found = ALL.iter().copied().find(|chip| chip.name == name);
    found.with_context(|| format!("no chip {name}; there are: {}", names()))
}
