//! `cargo xtask miri`: core's unit tests in Miri, and on targets of another word size or byte order where std can be had.

use std::process::Command;

use anyhow::{Result, bail};

use crate::process::{root, run};
use crate::subcommand::{nightly_is_there, show, succeeds};

/// Core's unit tests under Miri, for a target that it emulates: the host's if none is named.
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
    command.args([
        "+nightly",
        "miri",
        "test",
        "--package",
        "toytop",
        "--lib",
        "--features",
        "fixed,nalgebra",
    ]);
    if let Some(target) = target {
        command.args(["--target", target]);
    }
    show(command.current_dir(root()))
}
