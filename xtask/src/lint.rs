//! Runs of clippy with warnings as errors.

use anyhow::Result;

use crate::chip::named;
use crate::firmware;
use crate::process::{cargo, run};
use crate::tools;

const DENY: [&str; 3] = ["--", "-D", "warnings"];

/// Runs clippy on the crates of the host's workspace.
pub(crate) fn host() -> Result<String> {
    run(cargo(".", "clippy --workspace --all-targets --all-features").args(DENY))?;
    Ok("no warnings".into())
}

/// Runs clippy on every package of the firmware workspace, for each of its targets.
pub(crate) fn firmware() -> Result<String> {
    let mut checked = vec!["host"];
    for package in ["--package toytop-firmware-decoder", "--lib --bin bits"] {
        let mut command = cargo("firmware-examples", &format!("clippy --release {package}"));
        run(command.arg("--target-dir").arg(crate::process::firmware_target_dir()).args(DENY))?;
    }
    let toolchain = tools::toolchain()?;
    // all programs on Cortex-M, and those that are not for Cortex-M only on RISC-V
    for chip in ["m4f", "riscv"] {
        let target = named(chip)?.target;
        let (bins, packages): (Vec<_>, Vec<_>) = firmware::programs_of(target)
            .map(firmware::Program::selection)
            .partition(|selection| selection.starts_with("--bin"));
        let programs = format!("--lib {}", bins.join(" "));
        let mut all = vec![programs.clone(), format!("{programs} --features rtt")];
        all.extend(packages);
        all.extend(["--package toytop-nopanic", "--package toytop-cost"].map(str::to_owned));
        if chip != "riscv" {
            all.push("--package toytop-cost --features dwt".to_owned()); // the counter exists on Arm only
        }
        for what in all {
            let words = format!("clippy --release --target {target} {what}");
            let mut command = toolchain.cargo("firmware-examples", &words);
            run(command.arg("--target-dir").arg(firmware::target_dir(toolchain, "")).args(DENY))?;
        }
        checked.push(target);
    }
    Ok(format!("no warnings: {}", checked.join(" ")))
}
