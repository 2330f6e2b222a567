//! The chips, and the machines that stand for them. Memory maps: firmware-examples/memory/.

use anyhow::{Context, Result};

/// A processor core with its Rust target and QEMU machine.
pub(crate) struct Chip {
    pub(crate) name: &'static str,
    pub(crate) core: &'static str,
    pub(crate) target: &'static str,
    /// Of the compiler; a chip that has some has a target folder of its own.
    pub(crate) rustflags: &'static str,
    pub(crate) emulator: &'static str,
    pub(crate) machine: &'static str,
}

/// No FPU, no division, 16 KiB of RAM.
pub(crate) const M0: Chip = Chip {
    name: "m0",
    core: "Cortex-M0",
    target: "thumbv6m-none-eabi",
    rustflags: "",
    emulator: "qemu-system-arm",
    machine: "microbit",
};

/// The same instructions. QEMU has none of it: a Cortex-M3, which has them too, and room for large tables.
pub(crate) const M0PLUS: Chip = Chip {
    name: "m0plus",
    core: "Cortex-M0+",
    target: "thumbv6m-none-eabi",
    rustflags: "",
    emulator: "qemu-system-arm",
    machine: "mps2-an385",
};

/// An FPU for f32, on which a multiplication and a sum are faster than a multiply-add.
pub(crate) const M4F: Chip = Chip {
    name: "m4f",
    core: "Cortex-M4F",
    target: "thumbv7em-none-eabihf",
    rustflags: "-C target-cpu=cortex-m4",
    emulator: "qemu-system-arm",
    machine: "mps2-an386",
};

/// An FPU for f32 and f64. Its ELF hangs on an M4F, without a word.
pub(crate) const M7: Chip = Chip {
    name: "m7",
    core: "Cortex-M7",
    target: "thumbv7em-none-eabihf",
    rustflags: "-C target-cpu=cortex-m7",
    emulator: "qemu-system-arm",
    machine: "mps2-an500",
};

/// Armv8-M, an FPU for f32.
pub(crate) const M33: Chip = Chip {
    name: "m33",
    core: "Cortex-M33",
    target: "thumbv8m.main-none-eabihf",
    rustflags: "",
    emulator: "qemu-system-arm",
    machine: "mps2-an505",
};

/// No FPU.
pub(crate) const RISCV: Chip = Chip {
    name: "riscv",
    core: "RISC-V RV32IMAC",
    target: "riscv32imac-unknown-none-elf",
    rustflags: "",
    emulator: "qemu-system-riscv32",
    machine: "virt -bios none",
};

/// What the programs run on.
pub(crate) const ALL: &[&Chip] = &[&M4F, &M0, &M7, &M33, &RISCV];

/// The targets of all chips.
pub(crate) const TARGETS: &[&str] = &[M0.target, M4F.target, M33.target, RISCV.target];

impl Chip {
    /// The first chip with a target: a target has flags, too.
    pub(crate) fn with_target(target: &str) -> Result<&'static Self> {
        let known = || format!("no chip has the target {target}; there are: {}", TARGETS.join(" "));
        [&M0PLUS, &M4F, &M33, &RISCV].into_iter().find(|chip| chip.target == target).with_context(known)
    }

    pub(crate) fn named(name: &str) -> Result<&'static Self> {
        let all = || ALL.iter().copied().chain([&M0PLUS]);
        let names = || all().map(|chip| chip.name).collect::<Vec<_>>().join(" ");
        all()
            .find(|chip| chip.name == name)
            .with_context(|| format!("no chip {name}; there are: {}", names()))
    }
}
