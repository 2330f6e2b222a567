//! Check that core has no panic path, by a panic handler that cannot be linked.
//!
//! The check is for release builds, without overflow checks.

use std::time::Duration;

use anyhow::{Result, bail};

use crate::chip::{TARGETS, named};
use crate::firmware::{build, build_command};
use crate::process::run_within;

const PACKAGE: &str = "--package toytop-nopanic";
/// Message of the linker about a panic path.
const REFUSAL: &str = "your program contains at least one panicking branch";

/// Links for all targets, and checks that the linker refuses a program with a deliberate panic.
pub(crate) fn check() -> Result<String> {
    for chip in ["m0", "m4f", "m33", "riscv"] {
        build(named(chip)?, PACKAGE)?;
    }
    if !planted()?.contains(REFUSAL) {
        bail!("a deliberate panic was not detected");
    }
    Ok(format!("{} targets link, a deliberate panic does not", TARGETS.len()))
}

/// Prints the message of the linker about a deliberate panic.
pub(crate) fn show_planted() -> Result<()> {
    let output = planted()?;
    println!("{}", output.trim_end());
    if output.contains(REFUSAL) { Ok(()) } else { bail!("a deliberate panic was not detected") }
}

fn planted() -> Result<String> {
    let (mut command, _) =
        build_command(named("m4f")?, &format!("{PACKAGE} --bin planted --features planted"))?;
    let ended = run_within(&mut command, Duration::from_secs(600))?;
    if ended.success {
        bail!("a deliberate panic was linked");
    }
    Ok(ended.output)
}
