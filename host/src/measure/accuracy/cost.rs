//! What a tick costs on the chips: `firmware-examples/budgets.toml` as it was when this program was built.

use crate::Failure;
use crate::budget::{Cost, Limits};
use crate::motion::Scalar;
use toytop_chips::{M0PLUS, M4F, M7, M33, RISCV};

const BUDGETS: &str = include_str!("../../../../firmware-examples/budgets.toml");

/// A chip, and what is counted on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Chip {
    /// The chip itself.
    pub chip: toytop_chips::Chip,
    /// Of a record.
    pub column: &'static str,
    /// At the head of a table.
    pub heading: &'static str,
    /// Modelled cycles; otherwise instructions.
    pub cycles: bool,
}

/// Those that `toytop budget` measures.
pub const CHIPS: [Chip; 5] = [
    Chip { chip: M0PLUS, column: "m0plus_cycles", heading: "M0+ cycles", cycles: true },
    Chip { chip: M4F, column: "m4f_cycles", heading: "M4F cycles", cycles: true },
    Chip { chip: M7, column: "m7_instructions", heading: "M7 instr.", cycles: false },
    Chip { chip: M33, column: "m33_instructions", heading: "M33 instr.", cycles: false },
    Chip { chip: RISCV, column: "riscv_instructions", heading: "RISC-V instr.", cycles: false },
];

/// Of every scalar.
#[derive(Debug)]
pub struct Costs(Limits);

impl Costs {
    /// As the file says.
    ///
    /// # Errors
    /// [`Failure::Input`]: it is no file of budgets, which a test would tell.
    pub fn known() -> Result<Self, Failure> {
        Limits::parse(BUDGETS).map(Self)
    }

    /// At most, of the next tick: from a cursor to α, β, u and the tip in memory. `None` where it was not measured.
    #[must_use]
    pub fn next_tick(&self, scalar: Scalar, chip: &Chip) -> Option<u64> {
        let cost: &Cost = self.0.of(chip.chip.name, &format!("cursor_{}", scalar.name()))?;
        if chip.cycles { cost.cycles } else { Some(cost.instructions) }
    }
}
