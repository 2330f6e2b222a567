//! Subcommands of cargo, which are installed by cargo at the first use. `cargo xtask test` does not need them.

use std::process::Command;
use std::time::Duration;

use anyhow::{Context, Result, bail};

use crate::process::{root, run_within};

/// Makes `cargo NAME` available.
pub(crate) fn provide(name: &str) -> Result<()> {
    if !is_there(name) {
        let crate_name = format!("cargo-{name}");
        eprintln!("installing {crate_name}: some minutes, once");
        show(Command::new("cargo").args(["install", "--locked", &crate_name]))
            .with_context(|| format!("install it: cargo install --locked {crate_name}"))?;
    }
    Ok(())
}

/// Whether `cargo NAME` runs.
pub(crate) fn is_there(name: &str) -> bool {
    succeeds(Command::new("cargo").args([name, "--version"]))
}

/// Whether a nightly compiler is installed; rustup does not fetch one.
pub(crate) fn nightly_is_there() -> bool {
    succeeds(Command::new("rustup").args(["run", "nightly", "rustc", "--version"]))
}

/// Whether a command succeeds within a minute.
pub(crate) fn succeeds(command: &mut Command) -> bool {
    run_within(command, Duration::from_secs(60)).is_ok_and(|ended| ended.success)
}

/// Runs a command that may take hours, with visible output.
pub(crate) fn show(command: &mut Command) -> Result<()> {
    let name = command.get_program().to_string_lossy().into_owned();
    let status = command.current_dir(root()).status().with_context(|| format!("cannot run {name}"))?;
    if !status.success() {
        bail!("{name} ended with {status}");
    }
    Ok(())
}
