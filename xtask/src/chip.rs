//! Chips that the programs run on.

use anyhow::{Context, Result};
pub(crate) use toytop_chips::{Chip, M0, M0PLUS, M4F, M7, M33, RISCV};

/// Chips that the programs run on.
pub(crate) const ALL: &[&Chip] = &[&M4F, &M0, &M7, &M33, &RISCV];

/// Targets of all chips.
pub(crate) const TARGETS: &[&str] = &[M0.target, M4F.target, M33.target, RISCV.target];

/// First chip with a target, whose flags the build uses.
pub(crate) fn with_target(target: &str) -> Result<&'static Chip> {
    let known = || format!("no chip has the target {target}; there are: {}", TARGETS.join(" "));
    [&M0PLUS, &M4F, &M33, &RISCV].into_iter().find(|chip| chip.target == target).with_context(known)
}

/// Chip of this name.
pub(crate) fn named(name: &str) -> Result<&'static Chip> {
    let all = || ALL.iter().copied().chain([&M0PLUS]);
    let names = || all().map(|chip| chip.name).collect::<Vec<_>>().join(" ");
    all().find(|chip| chip.name == name).with_context(|| format!("no chip {name}; there are: {}", names()))
}
