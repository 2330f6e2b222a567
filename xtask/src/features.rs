//! Builds of core with every set of its features for the smallest chip, and of the suite without its features. A feature only adds items,
//! so that each set must build.

use std::fs;

use anyhow::{Result, bail};

use crate::firmware;
use crate::process::{cargo, root, run};
use crate::tools;

const TARGET: &str = "thumbv6m-none-eabi";

/// Checks all sets, for a target without `std`.
pub(crate) fn check() -> Result<String> {
    let manifest = fs::read_to_string(root().join("core/Cargo.toml"))?;
    let features = features(&manifest);
    if features.is_empty() {
        bail!("core/Cargo.toml: no [features] found");
    }
    let msrv = msrv()?;
    let toolchain = tools::toolchain()?;
    let sets = subsets(&features);
    for set in &sets {
        let words =
            format!("check --release --lib --package toytop --target {TARGET} --features={}", set.join(","));
        let mut command = toolchain.cargo(".", &words);
        command.arg("--target-dir").arg(firmware::target_dir(toolchain, "core"));
        run(&mut command)?;
    }
    // this is the build of `mutants` and of the fuzzer
    run(&mut cargo(".", "check --package toytop-tests --no-default-features --tests"))?;
    Ok(format!("{} sets of {} on {TARGET}; Rust {msrv} or later", sets.len(), features.join(", ")))
}

/// Version of the oldest supported compiler, which each of two workspaces states once.
///
/// Clippy checks that the code is compatible with it (`incompatible_msrv`), because the compiler itself may not be installed.
fn msrv() -> Result<String> {
    let stated = |workspace: &str| -> Result<String> {
        let manifest = fs::read_to_string(root().join(workspace).join("Cargo.toml"))?;
        let line = manifest.lines().find_map(|line| line.strip_prefix("rust-version = "));
        Ok(line.unwrap_or("nothing").trim_matches('"').to_owned())
    };
    let (ours, chips) = (stated(".")?, stated("firmware-examples")?);
    if ours != chips {
        bail!("rust-version: {ours} in Cargo.toml, {chips} in firmware-examples/Cargo.toml");
    }
    Ok(ours)
}

/// Names in the table `[features]`, except `default`.
fn features(manifest: &str) -> Vec<&str> {
    let lines = manifest.lines().skip_while(|line| line.trim() != "[features]").skip(1);
    let section = lines.take_while(|line| !line.starts_with('['));
    let names = section.filter(|line| !line.starts_with('#')).filter_map(|line| line.split_once('='));
    names.map(|(name, _)| name.trim()).filter(|name| *name != "default").collect()
}

fn subsets<'a>(names: &[&'a str]) -> Vec<Vec<&'a str>> {
    let chosen = |set: usize| names.iter().enumerate().filter(move |(bit, _)| set >> bit & 1 == 1);
    (0..1 << names.len()).map(|set| chosen(set).map(|(_, name)| *name).collect()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_set_once() {
        assert_eq!(subsets(&["a", "b"]), [vec![], vec!["a"], vec!["b"], vec!["a", "b"]]);
    }

    #[test]
    fn features_are_read_from_the_manifest() {
        let manifest =
            "[package]\nx = 1\n[features]\ndefault = []\n# y\nb = [\"dep:b\"]\n\n[dependencies]\nc = 1\n";
        assert_eq!(features(manifest), ["b"]);
    }
}
