//! Chips that toytop is tested on, and how firmware is built and emulated for them.

use std::path::{Path, PathBuf};
use std::process::{ChildStderr, ChildStdout, Command, ExitStatus, Stdio};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::Duration;
use std::{env, io, thread};

/// Processor core with its Rust target and QEMU machine.
pub struct Chip {
    /// Name on the command line and in `firmware-examples/budgets.toml`.
    pub name: &'static str,
    /// Rust's target triple.
    pub target: &'static str,
    /// Flags of the compiler.
    pub rustflags: &'static str,
    /// Memory map in `firmware-examples`, where it differs from the target's.
    pub memory: Option<&'static str>,
    /// Program of QEMU.
    pub emulator: &'static str,
    /// Arguments that choose the machine of QEMU.
    pub machine: &'static [&'static str],
    /// Published timings of the instructions.
    pub timings: Option<Timings>,
}

/// Tables of instruction timings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Timings {
    /// Cortex-M0+ with the fast multiplier.
    M0Plus,
    /// Cortex-M4 with its FPU.
    M4,
}

/// Cortex-M0, without FPU and division, with 16 KiB of RAM.
pub const M0: Chip = Chip {
    name: "m0",
    target: "thumbv6m-none-eabi",
    rustflags: "",
    memory: None,
    emulator: "qemu-system-arm",
    machine: &["-machine", "microbit"],
    timings: None,
};

/// Cortex-M0+, with the instructions of [`M0`]. QEMU does not emulate it with memory for large tables, so a Cortex-M3 replaces it, which executes
/// the same instructions.
pub const M0PLUS: Chip = Chip {
    name: "m0plus",
    memory: Some("memory/mps2.x"),
    machine: &["-machine", "mps2-an385"],
    timings: Some(Timings::M0Plus),
    ..M0
};

/// Cortex-M4F, with an FPU for `f32`, on which a multiplication and a sum are faster than a multiply-add.
pub const M4F: Chip = Chip {
    name: "m4f",
    target: "thumbv7em-none-eabihf",
    rustflags: "-C target-cpu=cortex-m4",
    memory: None,
    emulator: "qemu-system-arm",
    machine: &["-machine", "mps2-an386"],
    timings: Some(Timings::M4),
};

/// Cortex-M7, with an FPU for `f32` and `f64`.
pub const M7: Chip = Chip {
    name: "m7",
    rustflags: "-C target-cpu=cortex-m7",
    machine: &["-machine", "mps2-an500"],
    timings: None,
    ..M4F
};

/// Cortex-M33, with an FPU for `f32`.
pub const M33: Chip = Chip {
    name: "m33",
    target: "thumbv8m.main-none-eabihf",
    rustflags: "",
    memory: None,
    emulator: "qemu-system-arm",
    machine: &["-machine", "mps2-an505"],
    timings: None,
};

/// RISC-V chip without FPU.
pub const RISCV: Chip = Chip {
    name: "riscv",
    target: "riscv32imac-unknown-none-elf",
    rustflags: "",
    memory: None,
    emulator: "qemu-system-riscv32",
    machine: &["-machine", "virt", "-bios", "none"],
    timings: None,
};

/// Longest time of a run; the programs of this repository take seconds.
const LONGEST_RUN: Duration = Duration::from_secs(120);

/// Arguments of QEMU for a repeatable run: one instruction takes one virtual nanosecond, and a sleeping processor continues immediately at
/// its next interrupt.
pub const REPEATABLE: [&str; 2] = ["-icount", "shift=0,sleep=off"];

/// Target folder of the firmware: beside its sources, or below `CARGO_TARGET_DIR`.
pub fn target_dir(root: &Path) -> PathBuf {
    match env::var_os("CARGO_TARGET_DIR") {
        Some(dir) => root.join(dir).join("firmware"),
        None => root.join("firmware-examples/target"),
    }
}

impl Chip {
    /// All chips; those with the same target are neighbours.
    pub const ALL: [Self; 6] = [M0, M0PLUS, M4F, M7, M33, RISCV];

    /// Chips whose calls are measured: [`M0`] has too little memory.
    pub fn measured() -> impl Iterator<Item = &'static Self> {
        Self::ALL.iter().filter(|chip| chip.name != M0.name)
    }

    /// First measured chip of each target.
    pub fn one_per_target() -> Vec<&'static Self> {
        let mut chips: Vec<_> = Self::measured().collect();
        chips.dedup_by_key(|chip| chip.target);
        chips
    }

    /// Command that builds a program of `firmware-examples`, and the folder of its ELF. A chip with flags or a memory map has a target folder
    /// of its own.
    ///
    /// * `what`: arguments of cargo that select the program
    pub fn build(&self, root: &Path, what: &str) -> (Command, PathBuf) {
        let own = if self.rustflags.is_empty() && self.memory.is_none() { "" } else { self.name };
        let folder = target_dir(root).join(own);
        let mut cargo = Command::new("cargo");
        cargo.current_dir(root.join("firmware-examples")).arg("build").args(what.split_whitespace());
        cargo.args(["--release", "--target", self.target, "--target-dir"]).arg(&folder);
        cargo.envs(self.memory.map(|memory| ("MEMORY_X", memory)));
        if !self.rustflags.is_empty() {
            let flags = env::var("RUSTFLAGS").unwrap_or_default();
            cargo.env("RUSTFLAGS", format!("{flags} {}", self.rustflags).trim_start());
        }
        (cargo, folder.join(self.target).join("release"))
    }

    /// Command that runs an ELF to its end: no input, and the semihosting of the host. Both outputs are piped.
    fn qemu(&self, elf: &Path) -> Command {
        let mut command = Command::new(self.emulator);
        command
            .args(self.machine)
            .args(["-nographic", "-monitor", "none", "-serial", "none"])
            .args(["-semihosting-config", "enable=on,target=native"])
            .arg("-kernel")
            .arg(elf)
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        command
    }

    /// Runs an ELF, and returns how it ended and the result of `read`. The program is killed if `read` returns before both outputs end.
    ///
    /// * `arguments`: more arguments of QEMU
    /// * `read`: reads stdout and stderr
    ///
    /// # Errors
    /// There is no QEMU, or the program does not end in time.
    pub fn emulate<T>(
        &self,
        elf: &Path,
        arguments: &[&str],
        read: impl FnOnce(ChildStdout, ChildStderr) -> T,
    ) -> io::Result<(ExitStatus, T)> {
        let missing = |error: io::Error| {
            io::Error::new(error.kind(), format!("cannot run {} ({error}); install QEMU", self.emulator))
        };
        let mut qemu = self.qemu(elf).args(arguments).spawn().map_err(missing)?;
        let outputs = qemu.stdout.take().zip(qemu.stderr.take());
        let (stdout, stderr) = outputs.ok_or(io::ErrorKind::BrokenPipe)?;
        thread::scope(|scope| {
            let (reading, read_ended) = channel::<()>();
            let watcher = scope.spawn(move || {
                let late = read_ended.recv_timeout(LONGEST_RUN) == Err(RecvTimeoutError::Timeout);
                // a program that has closed its outputs is ending, which this does not change
                qemu.kill()?;
                let status = qemu.wait()?;
                let limit = LONGEST_RUN.as_secs();
                if late { Err(io::Error::other(format!("did not end within {limit} s"))) } else { Ok(status) }
            });
            let result = read(stdout, stderr);
            drop(reading);
            let status = watcher.join().unwrap_or_else(|_| Err(io::Error::other("a panic")))?;
            Ok((status, result))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_elf_and_the_machine_are_in_the_command() {
        let command = RISCV.qemu(Path::new("program.elf"));
        let words: Vec<_> = command.get_args().map(|word| word.to_string_lossy()).collect();
        assert_eq!(command.get_program(), "qemu-system-riscv32");
        assert_eq!(words[..4], ["-machine", "virt", "-bios", "none"]);
        assert_eq!(words[words.len() - 2..], ["-kernel", "program.elf"]);
    }
}
