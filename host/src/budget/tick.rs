//! Cost of a tick on the chips, from `firmware-examples/budgets.toml` at the time of the build.

use crate::Failure;
use crate::budget::{Cost, Limits};
use crate::motion::Scalar;
use toytop_chips::{M0PLUS, M4F, M7, M33, RISCV};

const BUDGETS: &str = include_str!("../../../firmware-examples/budgets.toml");

/// Chip with the quantity that is counted on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CountedChip {
    /// Chip on which the costs are.
    pub chip: toytop_chips::Chip,
    /// Name of the column in a record.
    pub column: &'static str,
    /// Heading of the column in a table.
    pub heading: &'static str,
    /// Whether cycles are modelled; otherwise instructions are counted.
    pub cycles: bool,
}

/// Chips that `toytop budget` measures.
pub const PLOTTED: [CountedChip; 5] = [
    CountedChip { chip: M0PLUS, column: "m0plus_cycles", heading: "M0+ cycles", cycles: true },
    CountedChip { chip: M4F, column: "m4f_cycles", heading: "M4F cycles", cycles: true },
    CountedChip { chip: M7, column: "m7_instructions", heading: "M7 instr.", cycles: false },
    CountedChip { chip: M33, column: "m33_instructions", heading: "M33 instr.", cycles: false },
    CountedChip { chip: RISCV, column: "riscv_instructions", heading: "RISC-V instr.", cycles: false },
];

/// Costs of every scalar on every chip.
#[derive(Debug)]
pub struct Costs(Limits);

impl Costs {
    /// Costs of the file.
    ///
    /// # Errors
    /// [`Failure::Input`]: the file is not a file of budgets, which a test excludes.
    pub fn known() -> Result<Self, Failure> {
        Limits::parse(BUDGETS).map(Self)
    }

    /// Greatest cost of the next tick, from a cursor to α, β, u and the tip in memory; `None` where it was not measured.
    #[must_use]
    pub fn next_tick(&self, scalar: Scalar, chip: &CountedChip) -> Option<u64> {
        let cost: &Cost = self.0.of(chip.chip.name, &format!("cursor_{}", scalar.name()))?;
        if chip.cycles { cost.cycles } else { Some(cost.instructions) }
    }
}
