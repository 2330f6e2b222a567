//! Runs of clippy on the firmware workspace with warnings as errors, for every package and its targets.

use anyhow::Result;

use crate::firmware::{self, named};
use crate::process::{cargo, run};
use crate::tools;

pub(crate) fn firmware() -> Result<()> {
    let deny = ["--", "-D", "warnings"];
    for package in ["--package toytop-firmware-decoder", "--lib --bin bits"] {
        let mut command = cargo("firmware-examples", &format!("clippy --release {package}"));
        run(command.arg("--target-dir").arg(crate::process::firmware_target_dir()).args(deny))?;
    }
    println!("clippy: firmware, host side");
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
            run(command.arg("--target-dir").arg(firmware::target_dir(toolchain, "")).args(deny))?;
        }
        println!("clippy: firmware, {target}");
    }
    Ok(())
}
