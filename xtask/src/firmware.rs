//! Programs of `firmware-examples/`, which are built for their chips and run under QEMU, and whose logs are compared with the expected ones.

mod emulator;

use std::path::PathBuf;
use std::process::{Command, ExitCode};
use std::{fs, path::Path};

use anyhow::{Context, Result, bail};

use crate::chip::{self, Chip};
use crate::process::{cargo, firmware_target_dir, root, run};
use crate::tools::{self, Toolchain};
use emulator::Run;

/// Program with the folder of its source, the chips that it runs on (`show` uses the first one), and its expected exit code.
pub(crate) struct Program {
    pub(crate) name: &'static str,
    /// Folder of the source in firmware-examples; a folder other than `src/bin` belongs to a package of its own.
    folder: &'static str,
    chips: &'static [&'static Chip],
    exit_code: i32,
    /// Whether the program also runs on the host, with the same log.
    on_host: bool,
}

const PROGRAM_FOLDER: &str = "src/bin";

pub(crate) const PROGRAMS: &[Program] = &[
    Program { name: "spin", folder: PROGRAM_FOLDER, chips: &[&chip::M4F], exit_code: 0, on_host: false },
    Program { name: "spin_m0", folder: PROGRAM_FOLDER, chips: &[&chip::M0], exit_code: 0, on_host: false },
    Program { name: "spin_m7", folder: PROGRAM_FOLDER, chips: &[&chip::M7], exit_code: 0, on_host: false },
    Program {
        name: "spin_riscv",
        folder: PROGRAM_FOLDER,
        chips: &[&chip::RISCV],
        exit_code: 0,
        on_host: false,
    },
    Program { name: "telemetry", folder: PROGRAM_FOLDER, chips: &[&chip::M4F], exit_code: 0, on_host: false },
    Program {
        name: "relaunch",
        folder: PROGRAM_FOLDER,
        chips: &[&chip::M4F, &chip::M0PLUS],
        exit_code: 0,
        on_host: false,
    },
    Program { name: "launch", folder: PROGRAM_FOLDER, chips: &[&chip::M4F], exit_code: 0, on_host: false },
    Program { name: "fit", folder: PROGRAM_FOLDER, chips: &[&chip::M4F], exit_code: 0, on_host: false },
    Program { name: "bits", folder: PROGRAM_FOLDER, chips: chip::ALL, exit_code: 0, on_host: true },
    Program { name: "embassy", folder: "embassy/src", chips: &[&chip::M4F], exit_code: 0, on_host: false },
    Program {
        name: "panics",
        folder: PROGRAM_FOLDER,
        chips: &[&chip::M0, &chip::RISCV],
        exit_code: 101,
        on_host: false,
    },
];

/// Programs that run on a chip with this target.
pub(crate) fn programs_of(target: &str) -> impl Iterator<Item = &'static Program> {
    PROGRAMS.iter().filter(move |program| program.chips.iter().any(|chip| chip.target == target))
}

/// Target folder for a build that must not share one.
pub(crate) fn target_dir(toolchain: Toolchain, own: &str) -> PathBuf {
    firmware_target_dir().join(toolchain.subfolder()).join(own)
}

fn find(name: &str) -> Result<&'static Program> {
    if COSTS.contains(&name) {
        bail!("{name} has no log: see its figures by `toytop budget`");
    }
    let names = || PROGRAMS.iter().map(|program| program.name).collect::<Vec<_>>().join(" ");
    PROGRAMS
        .iter()
        .find(|program| program.name == name)
        .with_context(|| format!("no program {name}; there are: {}", names()))
}

/// Prints programs and chips.
pub(crate) fn list() {
    for Program { name, chips, on_host, .. } in PROGRAMS {
        let chips: Vec<_> = chips.iter().map(|chip| chip.name).chain(on_host.then_some("host")).collect();
        println!("{name:8} {}", chips.join(" "));
    }
    println!();
    for chip in chip::ALL {
        println!("{:8} {}, {}, QEMU: {}", chip.name, chip.core, chip.target, chip.machine.join(" "));
    }
}

/// Runs a program on one chip and shows its log.
pub(crate) fn show(name: &str, chip: Option<&str>) -> Result<ExitCode> {
    let program = find(name)?;
    let chip = match chip {
        None => program.chips[0],
        Some(wanted) => program.chips.iter().find(|chip| chip.name == wanted).with_context(|| {
            let names: Vec<_> = program.chips.iter().map(|chip| chip.name).collect();
            format!("{name} runs on: {}", names.join(" "))
        })?,
    };
    ended(&run_on(program, chip, true)?)
}

/// Builds a program and prints only its path.
pub(crate) fn elf(name: &str, chip: &Chip) -> Result<()> {
    let what = if COSTS.contains(&name) {
        format!("--package toytop-cost --bin {name}")
    } else {
        find(name)?.selection()
    };
    println!("{}", build(chip, &what)?.join(name).display());
    Ok(())
}

/// Programs that `toytop budget` runs: one with a symbol for each call, one with 200 launches, and one with a fit. They have no log to
/// compare, and so are not among [`PROGRAMS`].
const COSTS: [&str; 3] = ["cost", "corpus", "fit_cost"];

/// Runs an ELF on a chip and shows its log.
pub(crate) fn qemu(chip: &str, elf: &str) -> Result<ExitCode> {
    tools::qemu()?;
    ended(&emulator::run(chip::named(chip)?, Path::new(elf), &decoder()?, true)?)
}

fn ended(run: &Run) -> Result<ExitCode> {
    eprint!("{}", run.errors);
    Ok(u8::try_from(run.exit_code).map_or(ExitCode::FAILURE, ExitCode::from))
}

/// Runs a program on its first chip, and on each chip with an expected log of its own, and writes the logs as the expected ones.
pub(crate) fn overwrite(name: &str) -> Result<()> {
    let program = find(name)?;
    let common = program.expected(program.chips[0]);
    for (number, chip) in program.chips.iter().enumerate() {
        let path = program.expected(chip);
        if number > 0 && path == common {
            continue;
        }
        let run = run_on(program, chip, true)?;
        if run.exit_code != program.exit_code {
            bail!("{}exit code {}, not {}: nothing written", run.errors, run.exit_code, program.exit_code);
        }
        fs::write(&path, &run.log)?;
        println!("written: {}", path.display());
    }
    Ok(())
}

impl Program {
    /// Arguments of cargo that select the program.
    pub(crate) fn selection(&self) -> String {
        let Self { name, folder, .. } = self;
        if *folder == PROGRAM_FOLDER { format!("--bin {name}") } else { format!("--package toytop-{name}") }
    }

    /// File with the expected log on a chip: one of its own, if the log depends on the speed of the chip, or that of all chips.
    fn expected(&self, chip: &Chip) -> PathBuf {
        let folder = root().join("firmware-examples").join(self.folder);
        let own = folder.join(format!("{}.{}.out", self.name, chip.name));
        if own.exists() { own } else { folder.join(format!("{}.out", self.name)) }
    }
}

/// Runs a program on all its chips; each log must be the expected one.
pub(crate) fn check(program: &Program) -> Result<String> {
    let Program { name, chips, exit_code, on_host, .. } = program;
    let read = |path: &Path| fs::read_to_string(path).with_context(|| format!("{}", path.display()));
    let accept = format!("after an intended change: cargo xtask firmware {name} --overwrite");
    let host_log = on_host.then(|| {
        let mut host = cargo("firmware-examples", &format!("run --quiet --release --bin {name}"));
        run(host.arg("--target-dir").arg(firmware_target_dir()))
    });
    let host_log = host_log.transpose()?;
    let mut different = Vec::new();
    for chip in *chips {
        if program.folder == PROGRAM_FOLDER {
            build(chip, &bins_on(chip))?;
        }
        let run = run_on(program, chip, false)?;
        if run.exit_code != *exit_code {
            bail!("{}: exit code {}, not {exit_code}\n{}{}", chip.name, run.exit_code, run.log, run.errors);
        }
        let expected = host_log.clone().map_or_else(|| read(&program.expected(chip)), Ok)?;
        if run.log != expected {
            let lines = difference(&expected, &run.log);
            different.push(format!("{} (-: expected, +: now)\n{lines}", chip.name));
        }
    }
    match &host_log {
        _ if different.is_empty() => {}
        Some(_) => bail!("the bits differ from those of the host: {}", different.concat()),
        None => bail!("{}{accept}", different.concat()),
    }
    if let Some(host) = &host_log {
        let path = program.expected(chips[0]);
        let expected = read(&path)?;
        if *host != expected {
            let lines = difference(&expected, host);
            bail!("host and chips agree, but not with {}:\n{lines}{accept}", path.display());
        }
    }
    let places: Vec<_> = chips.iter().map(|chip| chip.name).chain(on_host.then_some("host")).collect();
    Ok(places.join(" "))
}

/// Arguments of cargo that select all programs of the main package on a chip. One build of all uses all processor cores for linking.
fn bins_on(chip: &Chip) -> String {
    let here = |program: &&Program| {
        program.folder == PROGRAM_FOLDER && program.chips.iter().any(|other| other.name == chip.name)
    };
    PROGRAMS.iter().filter(here).map(Program::selection).collect::<Vec<_>>().join(" ")
}

/// Lines in which two logs differ.
fn difference(expected: &str, log: &str) -> String {
    let (mut old, mut new) = (expected.lines(), log.lines());
    let mut text = String::new();
    loop {
        let (old, new) = (old.next(), new.next());
        if old.is_none() && new.is_none() {
            return text;
        }
        if old != new {
            text.extend(old.map(|line| format!("- {line}\n")));
            text.extend(new.map(|line| format!("+ {line}\n")));
        }
    }
}

fn run_on(program: &Program, chip: &Chip, show: bool) -> Result<Run> {
    tools::qemu()?;
    let elf = build(chip, &program.selection())?.join(program.name);
    emulator::run(chip, &elf, &decoder()?, show)
}

/// Builds for a chip; returns the folder with the ELF.
pub(crate) fn build(chip: &Chip, what: &str) -> Result<PathBuf> {
    let (mut command, folder) = build_command(chip, what)?;
    run(&mut command)?;
    Ok(folder)
}

/// Command that builds for a chip, and the folder of the ELF.
pub(crate) fn build_command(chip: &Chip, what: &str) -> Result<(Command, PathBuf)> {
    let toolchain = tools::toolchain()?;
    // the memory map is not that of the target
    let memory = (chip.name == chip::M0PLUS.name).then_some("memory/mps2.x");
    let own = if chip.rustflags.is_empty() && memory.is_none() { "" } else { chip.name };
    let dir = target_dir(toolchain, own);
    let words = format!("build --release --target {} {what}", chip.target);
    let mut command = toolchain.cargo("firmware-examples", &words);
    command.arg("--target-dir").arg(&dir);
    command.envs(memory.map(|memory| ("MEMORY_X", memory)));
    if !chip.rustflags.is_empty() {
        let flags = std::env::var("RUSTFLAGS").unwrap_or_default();
        command.env("RUSTFLAGS", format!("{flags} {}", chip.rustflags).trim_start());
    }
    Ok((command, dir.join(chip.target).join("release")))
}

/// Path of the decoder of the log, a program of the host.
fn decoder() -> Result<PathBuf> {
    let dir = firmware_target_dir();
    let mut command = cargo("firmware-examples", "build --package toytop-firmware-decoder");
    run(command.arg("--target-dir").arg(&dir))?;
    Ok(dir.join("debug/toytop-firmware-decoder"))
}
