//! `cargo xtask miri`: core's unit tests in Miri, on a big-endian machine of 32 bits.

use std::process::Command;

use anyhow::{Result, bail};

use crate::process::{root, run};
use crate::subcommand::{nightly_is_there, show, succeeds};

/// Target with 32 bits in big-endian order. Miri refuses assembly, which libm uses for the square root on x86-64 but not on this target.
const TARGET: &str = "powerpc-unknown-linux-gnu";

/// Runs core's unit tests in Miri, for a target that it emulates.
pub(crate) fn miri(target: Option<&str>) -> Result<()> {
    if !nightly_is_there() {
        bail!("Miri needs a nightly compiler: rustup toolchain install nightly");
    }
    let there = || succeeds(Command::new("cargo").args(["+nightly", "miri", "--version"]));
    if !there() {
        let _ = run(Command::new("rustup").args(["+nightly", "component", "add", "miri", "rust-src"]));
    }
    if !there() {
        bail!("no Miri here, and rustup cannot fetch it: rustup +nightly component add miri rust-src");
    }
    let mut command = Command::new("cargo");
    command.args(["+nightly", "miri", "test", "--package", "toytop", "--lib", "--features", "fixed"]);
    command.args(["--target", target.unwrap_or(TARGET)]);
    show(command.current_dir(root()))
}
