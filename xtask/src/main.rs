//! `cargo xtask`: all checks of the repository, on a machine that needs only rustup.

mod c;
mod chip;
mod coverage;
mod deny;
mod features;
mod firmware;
mod fuzz;
mod host;
mod lint;
mod miri;
mod mutants;
mod narrow;
mod nopanic;
mod package;
mod page;
mod process;
mod python;
mod setup;
mod steps;
mod subcommand;
mod tools;
mod web;

use std::process::ExitCode;

use anyhow::{Result, bail};

const USAGE: &str = "\
usage: cargo xtask VERB

  setup                        installs the tools of the tests, and prints the result for each of them
  test [--only STEP]           runs all tests; names missing tools in one line, and installs them as `setup` does if it can
  ci                           runs clippy on all crates, and all tests, as .ci/run does
  firmware NAME [--chip CHIP]  runs a program under QEMU and shows its log
  firmware NAME --overwrite    runs a program and writes its log as the expected one
  firmware NAME --chip CHIP --elf, firmware NAME --target TRIPLE --elf
                               builds a program, also `cost`, and prints only the path of the ELF
  firmware --list              lists programs and chips
  nopanic [--planted]          links core with a panic handler that does not exist; --planted: shows that a panic does not link
  c-archive --target NAME [--to FOLDER]
                               writes archive, header and CMake files for programs in C; NAME is that of a folder, or all
  c-archive --list             lists these folders, by processor core and float ABI
  c-header --overwrite         writes core/c/include/toytop.h from the sources
  clippy-firmware              runs clippy on the firmware workspace, each package for its own targets
  qemu CHIP ELF                runs an ELF and shows its log (the runner of firmware-examples/.cargo/config.toml)

  python --full                tests the release build of the Python package, with size of the wheel, figures and notebooks; some minutes

Long tests; each installs its cargo subcommand the first time:

  fuzz [--seconds N] [TARGET]  searches for failures of core and the scenario parser, N seconds (600) for each target
  coverage [--accept]          measures the lines of core that its tests execute; --accept writes host/docs/coverage.md
  mutants --shard I/N [FILTER] runs cargo-mutants on part I of N (from 0) of core's mutants, and lists those that no test detects;
                               with FILTER only mutants whose names match this regular expression
  mutants FILTER               runs cargo-mutants on all mutants that match, such as regime.rs
  miri [--target TRIPLE]       runs core's unit tests in Miri, as on a big-endian machine of 32 bits; not x86-64
  narrow                       runs core's unit tests and the suite as a program of 32 bits
  features                     builds core with every set of its features, for the smallest chip
  deny                         checks licences, duplicates, sources and advisories of the dependencies";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match run(&words) {
        Ok(code) => code,
        Err(error) => {
            eprintln!("{error:#}");
            ExitCode::FAILURE
        }
    }
}

fn run(words: &[&str]) -> Result<ExitCode> {
    match words {
        ["setup"] => return setup::setup(),
        ["test"] => return steps::test(None),
        ["ci"] => return steps::ci(),
        ["test", "--only", name] => return steps::test(Some(name)),
        ["firmware", "--list"] => firmware::list(),
        ["firmware", name] => return firmware::show(name, None),
        ["firmware", name, "--chip", chip] => return firmware::show(name, Some(chip)),
        ["firmware", name, "--target", target, "--elf"] => firmware::elf(name, chip::with_target(target)?)?,
        ["firmware", name, "--chip", chip, "--elf"] => firmware::elf(name, chip::named(chip)?)?,
        ["firmware", name, "--overwrite"] => firmware::overwrite(name)?,
        ["qemu", chip, elf] => return firmware::qemu(chip, elf),
        ["nopanic"] => println!("{}", nopanic::check()?),
        ["nopanic", "--planted"] => nopanic::show_planted()?,
        ["c-archive", "--list"] => c::list(),
        ["c-archive", "--target", target] => println!("{}", c::make(target, None)?),
        ["c-archive", "--target", target, "--to", folder] => println!("{}", c::make(target, Some(folder))?),
        ["c-header", "--overwrite"] => c::overwrite_header()?,
        ["python", "--full"] => python::full()?,
        ["fuzz", rest @ ..] => fuzz_with(rest)?,
        ["coverage"] => coverage::coverage(false)?,
        ["coverage", "--accept"] => coverage::coverage(true)?,
        ["mutants", "--shard", shard] => return mutants::mutants(Some(shard), None),
        ["mutants", "--shard", shard, filter] => return mutants::mutants(Some(shard), Some(filter)),
        ["mutants", filter] => return mutants::mutants(None, Some(filter)),
        ["miri"] => miri::miri(None)?,
        ["miri", "--target", target] => miri::miri(Some(target))?,
        ["narrow"] => narrow::narrow()?,
        ["features"] => println!("{}", features::check()?),
        ["deny"] => deny::check()?,
        ["clippy-firmware"] => println!("{}", lint::firmware()?),
        ["help" | "--help" | "-h"] => println!("{USAGE}"),
        _ => bail!("{USAGE}"),
    }
    Ok(ExitCode::SUCCESS)
}

fn fuzz_with(words: &[&str]) -> Result<()> {
    let (seconds, rest) = match words {
        ["--seconds", seconds, rest @ ..] => (seconds.parse()?, rest),
        _ => (600, words),
    };
    match rest {
        [] => fuzz::fuzz(seconds, None),
        [target] => fuzz::fuzz(seconds, Some(target)),
        _ => bail!("{USAGE}"),
    }
}
