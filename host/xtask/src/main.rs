//! `cargo xtask`: all checks of the repository, on a machine that needs only rustup.

mod c;
mod checks;
mod firmware;
mod process;
mod python;
mod size;
mod steps;
mod tools;

use std::process::ExitCode;

use anyhow::{Result, bail};

const USAGE: &str = "\
usage: cargo xtask VERB

  test [--all] [--only STEP]   runs the checks before every change, or every test, or one step; with --all on every chip, and the release
                               build of the Python package. Installs missing tools by rustup, apt-get or cargo. A step whose tools cannot
                               be installed fails
  test --list                  lists the steps
  size                         prints the tokens of Rust by room, and fails where one is above its cap
  firmware NAME [--chip CHIP]  runs a program under QEMU and shows its log
  firmware NAME --accept       runs a program and writes its log as the expected one
  firmware --list              lists programs and chips
  nopanic --planted            shows that a panic does not link
  c-archive --target NAME [--to FOLDER]
                               writes archive, header and CMake files for programs in C; NAME is that of a folder, or all
  c-archive --list             lists these folders, by processor core and float ABI
  qemu CHIP ELF                runs an ELF and shows its log (the runner of firmware-examples/.cargo/config.toml)";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    run(&words).unwrap_or_else(|error| {
        eprintln!("{error:#}");
        ExitCode::FAILURE
    })
}

fn run(words: &[&str]) -> Result<ExitCode> {
    match words {
        ["test"] => return steps::run(false, None),
        ["test", "--all"] => return steps::run(true, None),
        ["test", "--only", name] => return steps::run(false, Some(name)),
        ["test", "--all", "--only", name] => return steps::run(true, Some(name)),
        ["test", "--list"] => steps::list(),
        ["size"] => print!("{}", size::check()?),
        ["firmware", "--list"] => firmware::list(),
        ["firmware", name] => return firmware::show(name, None),
        ["firmware", name, "--chip", chip] => return firmware::show(name, Some(chip)),
        ["firmware", name, "--accept"] => firmware::accept(name)?,
        ["qemu", chip, elf] => return firmware::qemu(chip, elf),
        ["nopanic", "--planted"] => println!("{}", firmware::planted()?),
        ["c-archive", "--list"] => c::list(),
        ["c-archive", "--target", target] => println!("{}", c::make(target, None)?),
        ["c-archive", "--target", target, "--to", folder] => println!("{}", c::make(target, Some(folder))?),
        ["help" | "--help" | "-h"] => println!("{USAGE}"),
        _ => bail!("{USAGE}"),
    }
    Ok(ExitCode::SUCCESS)
}
