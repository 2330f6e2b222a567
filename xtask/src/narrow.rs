//! `cargo xtask narrow`: core's unit tests and the suite as a program of 32 bits, which an x86-64 machine can execute.

use std::process::Command;

use anyhow::{Result, bail};

use crate::process::run;
use crate::subcommand::{show, succeeds};

const TARGET: &str = "i686-unknown-linux-gnu";

/// Runs the tests, without those that need the host's crate.
pub(crate) fn narrow() -> Result<()> {
    run(Command::new("rustup").args(["target", "add", TARGET]))?;
    if !succeeds(Command::new("sh").args(["-c", "echo 'int main;' | cc -m32 -xc - -o /dev/null"])) {
        bail!("needs the 32-bit libraries of C: apt-get install gcc-multilib");
    }
    let mut command = Command::new("cargo");
    command.args(["test", "--target", TARGET, "--package", "toytop", "--package", "toytop-tests"]);
    command.args(["--no-default-features", "--features", "toytop/fixed", "--lib", "--test", "suite"]);
    show(&mut command)
}
