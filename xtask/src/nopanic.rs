//! Core's set-up and stepper, linked with a panic handler that cannot be linked: no panic path is left.
//!
//! For release builds, where overflow checks are off.

use std::time::Duration;

use anyhow::{Result, bail};

use crate::firmware::{TARGETS, build, build_command, named};
use crate::process::run_within;

const PACKAGE: &str = "--package toytop-nopanic";
/// What the linker says then.
const REFUSAL: &str = "your program contains at least one panicking branch";

/// Links for all targets, and sees the linker refuse a program in which a panic was planted.
pub(crate) fn check() -> Result<String> {
    for chip in ["m0", "m4f", "m33", "riscv"] {
        build(named(chip)?, PACKAGE)?;
    }
    if !planted()?.contains(REFUSAL) {
        bail!("a planted panic went unnoticed");
    }
    Ok(format!("{} targets link, a planted panic does not", TARGETS.len()))
}

/// Shows what the linker says to a planted panic.
pub(crate) fn show_planted() -> Result<()> {
    let output = planted()?;
    println!("{}", output.trim_end());
    if output.contains(REFUSAL) { Ok(()) } else { bail!("a planted panic went unnoticed") }
}

fn planted() -> Result<String> {
    let (mut command, _) = build_command(named("m4f")?, &format!("{PACKAGE} --features planted"))?;
    let ended = run_within(&mut command, Duration::from_secs(600))?;
    if ended.success {
        bail!("a planted panic was linked");
    }
    Ok(ended.output)
}
