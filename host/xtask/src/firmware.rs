//! Programs of `firmware-examples/`, which are built for their chips and run under QEMU, and whose logs are compared with the expected ones.

use std::fs;
use std::io::read_to_string;
use std::path::{Path, PathBuf};
use std::process::{ChildStderr, ChildStdout, Command, ExitCode};
use std::time::Duration;

use anyhow::{Context, Result, bail};
use toytop_chips::chip::{self, Chip, REPEATABLE};

use crate::process::{cargo, firmware_target_dir, locked, named, root, run, run_within};
use crate::tools::{self, QEMU};

/// Program of firmware-examples with the folder of its source and its chips, of which the first is the default.
struct Program {
    name: &'static str,
    folder: &'static str,
    chips: &'static [&'static Chip],
}

const fn program(name: &'static str, chips: &'static [&'static Chip]) -> Program {
    Program { name, folder: MAIN, chips }
}

/// Folder of the programs of the main package; each other folder is a package of its own.
const MAIN: &str = "src/bin";

const PROGRAMS: &[Program] = &[
    program("spin", &[&chip::M4F]),
    program("spin_m0", &[&chip::M0]),
    program("spin_m7", &[&chip::M7]),
    program("spin_riscv", &[&chip::RISCV]),
    program("telemetry", &[&chip::M4F]),
    program("relaunch", &[&chip::M4F, &chip::M0PLUS]),
    program("launch", &[&chip::M4F]),
    program("fit", &[&chip::M4F]),
    program(BITS, &[&chip::M4F, &chip::M0, &chip::M7, &chip::M33, &chip::RISCV]),
    Program { name: "embassy", folder: "embassy/src", chips: &[&chip::M4F] },
    Program { name: "rtic", folder: "rtic/src", chips: &[&chip::M4F] },
    program(PANICS, &[&chip::M0, &chip::RISCV]),
];

fn chip_named(name: &str) -> Result<&'static Chip> {
    named("chip", name, Chip::ALL.iter(), |chip| chip.name)
}

/// Program that also runs on the host, with the same log.
const BITS: &str = "bits";
/// Program that ends with a panic.
const PANICS: &str = "panics";

/// Result of a run.
struct Run {
    /// Decoded log.
    log: String,
    /// Other text, such as the message of a panic or an error of QEMU.
    errors: String,
    exit_code: i32,
}

impl Program {
    fn named(name: &str) -> Result<&'static Self> {
        named("program", name, PROGRAMS.iter(), |program| program.name)
    }

    /// Arguments of cargo that select the program.
    fn selection(&self) -> String {
        let Self { name, folder, .. } = self;
        if *folder == MAIN { format!("--bin {name}") } else { format!("--package toytop-{name}") }
    }

    /// File with the expected log on a chip: one of its own, if the log depends on the speed of the chip, or the common file.
    fn expected(&self, chip: &Chip) -> PathBuf {
        let folder = root().join("firmware-examples").join(self.folder);
        let own = folder.join(format!("{}.{}.out", self.name, chip.name));
        if own.exists() { own } else { folder.join(format!("{}.out", self.name)) }
    }

    /// Result of a run, which must have the program's exit code.
    fn run(&self, chip: &Chip) -> Result<Run> {
        let run = emulate(chip, &build(chip, &self.selection())?.join(self.name))?;
        let expected = if self.name == PANICS { 101 } else { 0 };
        if run.exit_code != expected {
            bail!("{}: exit code {}, not {expected}\n{}{}", chip.name, run.exit_code, run.log, run.errors);
        }
        Ok(run)
    }

    /// Runs the program on all its chips; each log must be the expected one.
    fn check(&self) -> Result<()> {
        let read = |path: PathBuf| fs::read_to_string(&path).with_context(|| format!("{}", path.display()));
        let mut logs = Vec::new();
        if self.name == BITS {
            let mut host = cargo("firmware-examples", "run --quiet --release --bin bits");
            let log = run(host.arg("--target-dir").arg(firmware_target_dir()))?;
            logs.push(("host", log, read(self.expected(self.chips[0]))?));
        }
        for chip in self.chips {
            logs.push((chip.name, self.run(chip)?.log, read(self.expected(chip))?));
        }
        let differences: String =
            logs.iter().map(|(place, log, expected)| difference(place, expected, log)).collect();
        if !differences.is_empty() {
            bail!(
                "(-: expected, +: now)\n{differences}after an intended change: cargo xtask firmware {} --accept",
                self.name
            );
        }
        Ok(())
    }
}

/// Checks the bits on all chips and on the host.
pub(crate) fn bits() -> Result<String> {
    Program::named(BITS)?.check()?;
    Ok("equal on every chip and on the host".into())
}

/// Checks all programs but the one of the bits.
pub(crate) fn programs() -> Result<String> {
    let others: Vec<_> = PROGRAMS.iter().filter(|program| program.name != BITS).collect();
    let failures: Vec<_> = others
        .iter()
        .filter_map(|program| program.check().err().map(|error| format!("{}: {error:#}", program.name)))
        .collect();
    if !failures.is_empty() {
        bail!("{}", failures.join("\n"));
    }
    Ok(others.iter().map(|program| program.name).collect::<Vec<_>>().join(" "))
}

/// Arguments of cargo that select all programs of the main package on a chip.
pub(crate) fn all_on(chip: &Chip) -> String {
    let is_built = |program: &&Program| {
        program.folder == MAIN && program.chips.iter().any(|other| other.name == chip.name)
    };
    PROGRAMS.iter().filter(is_built).map(Program::selection).collect::<Vec<_>>().join(" ")
}

/// Lines in which two logs differ.
fn difference(place: &str, expected: &str, log: &str) -> String {
    let (mut old, mut new) = (expected.lines(), log.lines());
    let mut text = String::new();
    loop {
        match (old.next(), new.next()) {
            (None, None) => return text,
            (old, new) if old != new => {
                text.extend(old.map(|line| format!("{place} - {line}\n")));
                text.extend(new.map(|line| format!("{place} + {line}\n")));
            }
            _ => {}
        }
    }
}

/// Prints programs and chips.
pub(crate) fn list() {
    for Program { name, chips, .. } in PROGRAMS {
        let chips: Vec<_> = chips.iter().map(|chip| chip.name).collect();
        println!("{name:12} {}", chips.join(" "));
    }
    println!();
    for chip in Chip::ALL {
        println!("{:8} {}, QEMU: {}", chip.name, chip.target, chip.machine.join(" "));
    }
}

/// Runs a program on one chip and shows its log.
pub(crate) fn show(name: &str, chip: Option<&str>) -> Result<ExitCode> {
    let program = Program::named(name)?;
    let chip = chip.map_or(Ok(program.chips[0]), chip_named)?;
    shown(chip, &build(chip, &program.selection())?.join(name))
}

/// Runs an ELF on a chip and shows its log.
pub(crate) fn qemu(chip: &str, elf: &str) -> Result<ExitCode> {
    shown(chip_named(chip)?, Path::new(elf))
}

fn shown(chip: &Chip, elf: &Path) -> Result<ExitCode> {
    let Run { log, errors, exit_code } = emulate(chip, elf)?;
    print!("{log}");
    eprint!("{errors}");
    Ok(u8::try_from(exit_code).map_or(ExitCode::FAILURE, ExitCode::from))
}

/// Runs a program on its chips, and writes the logs as the expected ones.
pub(crate) fn accept(name: &str) -> Result<()> {
    let program = Program::named(name)?;
    // the first chip last, because chips without a file of their own have its log
    for chip in program.chips.iter().rev() {
        let path = program.expected(chip);
        fs::write(&path, program.run(chip)?.log)?;
        println!("written: {}", path.display());
    }
    Ok(())
}

/// Links core for the two chips whose cycles have a model with a panic handler that does not exist, and checks that the linker refuses a
/// deliberate panic.
pub(crate) fn no_panic() -> Result<String> {
    link_without_panic(&[&chip::M0PLUS, &chip::M4F])
}

/// Links core likewise for every target.
pub(crate) fn no_panic_on_all() -> Result<String> {
    link_without_panic(&Chip::one_per_target())
}

fn link_without_panic(chips: &[&Chip]) -> Result<String> {
    for chip in chips {
        build(chip, "--package toytop-nopanic")?;
    }
    planted()?;
    Ok(format!("{} targets link, a deliberate panic does not", chips.len()))
}

/// Message of the linker about a deliberate panic.
pub(crate) fn planted() -> Result<String> {
    let (mut command, _) =
        build_command(&chip::M4F, "--package toytop-nopanic --bin planted --features planted")?;
    let ended = run_within(&mut command, Duration::from_secs(600))?;
    if ended.success || !ended.output.contains("your program contains at least one panicking branch") {
        bail!("{}\na deliberate panic was not detected", ended.output);
    }
    Ok(ended.output)
}

/// Builds for a chip; returns the folder with the ELF.
fn build(chip: &Chip, what: &str) -> Result<PathBuf> {
    let (mut command, folder) = build_command(chip, what)?;
    run(&mut command)?;
    Ok(folder)
}

/// Command that builds for a chip, and the folder of the ELF.
fn build_command(chip: &Chip, what: &str) -> Result<(Command, PathBuf)> {
    tools::CHIPS.provide()?;
    let (mut command, folder) = chip.build(&root(), what);
    command.args(locked());
    Ok((command, folder))
}

/// Result of the run of an ELF.
fn emulate(chip: &Chip, elf: &Path) -> Result<Run> {
    QEMU.provide()?;
    let mut build = cargo("firmware-examples", "build --package toytop-firmware-decoder");
    run(build.arg("--target-dir").arg(firmware_target_dir()))?;
    let decoder = firmware_target_dir().join("debug/toytop-firmware-decoder");
    let read = |stdout: ChildStdout, stderr: ChildStderr| {
        (run(Command::new(decoder).arg(elf).stdin(stdout)), read_to_string(stderr))
    };
    let (status, (log, errors)) = chip.emulate(elf, &REPEATABLE, read).context(chip.name)?;
    let errors = errors?;
    let log = log.with_context(|| format!("{}: {errors}", chip.name))?;
    let exit_code = status.code().context("QEMU was killed")?;
    Ok(Run { log, errors, exit_code })
}
