//! The chips, the machines that stand for them, and what is known of their timing.

use super::Model;

/// A processor core with its Rust target and QEMU machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Chip {
    /// On the command line and in `budgets.toml`; also what `cargo xtask firmware --chip` calls it.
    pub name: &'static str,
    /// For reading.
    pub core: &'static str,
    /// QEMU's program.
    pub emulator: &'static str,
    /// Arguments that choose QEMU's machine.
    pub machine: &'static [&'static str],
    /// Cycles, where timings are published.
    pub model: Option<Model>,
}

/// All of them.
pub const CHIPS: [Chip; 5] = [
    Chip {
        name: "m0plus",
        core: "Cortex-M0+",
        emulator: "qemu-system-arm",
        // a Cortex-M3, whose instructions include all of the M0+'s: QEMU has no M0+ with room for the tables
        machine: &["-machine", "mps2-an385"],
        model: Some(Model::M0Plus),
    },
    Chip {
        name: "m4f",
        core: "Cortex-M4F",
        emulator: "qemu-system-arm",
        machine: &["-machine", "mps2-an386"],
        model: Some(Model::M4),
    },
    Chip {
        name: "m7",
        core: "Cortex-M7",
        emulator: "qemu-system-arm",
        machine: &["-machine", "mps2-an500"],
        model: None,
    },
    Chip {
        name: "m33",
        core: "Cortex-M33",
        emulator: "qemu-system-arm",
        machine: &["-machine", "mps2-an505"],
        model: None,
    },
    Chip {
        name: "riscv",
        core: "RV32IMAC",
        emulator: "qemu-system-riscv32",
        machine: &["-machine", "virt", "-bios", "none"],
        model: None,
    },
];
