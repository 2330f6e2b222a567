//! `cargo xtask`: everything that is checked, on a machine that has rustup and nothing else.

mod c;
mod coverage;
mod deny;
mod features;
mod firmware;
mod fuzz;
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

  setup                        installs what the tests need: a line for each thing, and what was done about it
  test [--only STEP]           all tests; says in one line what is missing, and installs it as `setup` does where it can
  firmware NAME [--chip CHIP]  runs a program under QEMU and shows its log
  firmware NAME --overwrite    the same, and accepts the log as the expected one
  firmware NAME --chip CHIP --elf, firmware NAME --target TRIPLE --elf
                               builds it, `cost` too, and prints the path of the ELF, nothing else
  firmware --list              programs and chips
  nopanic [--planted]          links core against a panic handler that does not exist; --planted: shows that it bites
  c-archive --target NAME [--to FOLDER]
                               archive, header and CMake files for programs in C; NAME is that of a folder, or all
  c-archive --list             those folders, by processor core and float ABI
  c-header --overwrite         makes core/c/include/toytop.h anew
  clippy-firmware              clippy over the firmware workspace, each package for its own targets
  qemu CHIP ELF                runs an ELF and shows its log (the runner of firmware-examples/.cargo/config.toml)

  python --full                the Python package as users get it: tests, size of the wheel, figures, notebooks; some minutes

Studies, for a longer wait; each installs its cargo subcommand the first time:

  fuzz [--seconds N] [TARGET]  looks for input that breaks core or the scenario parser: N seconds (600) each
  coverage [--accept]          the lines of core that its tests run; --accept writes host/docs/coverage.md
  mutants --shard I/N [FILTER] cargo-mutants on part I of N (from 0) of core's mutants: which ones no test notices;
                               of those only whose names match FILTER, a regular expression
  mutants FILTER               all that match, such as regime.rs
  miri [--target TRIPLE]       core's unit tests in Miri, as a big-endian machine of 32 bits runs them; not x86-64
  narrow                       core's unit tests and the suite as a program of 32 bits
  features                     core with every set of its features, on the smallest chip
  deny                         licences, duplicates, sources and advisories of the dependencies";

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
        ["test", "--only", name] => return steps::test(Some(name)),
        ["firmware", "--list"] => firmware::list(),
        ["firmware", name] => return firmware::show(name, None),
        ["firmware", name, "--chip", chip] => return firmware::show(name, Some(chip)),
        ["firmware", name, "--target", target, "--elf"] => {
            firmware::elf(name, firmware::with_target(target)?)?
        }
        ["firmware", name, "--chip", chip, "--elf"] => firmware::elf(name, firmware::named(chip)?)?,
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
        ["clippy-firmware"] => lint::firmware()?,
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
