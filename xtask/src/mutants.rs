//! `cargo xtask mutants`: plain cargo-mutants, with the files that it changes and the tests that judge.

use std::process::{Command, ExitCode};

use anyhow::{Context, Result};

use crate::process::root;
use crate::subcommand::provide;

/// Parts of core that are changed: all but the closed forms of `exact`, the elliptic functions that only they use, and `interop`.
const PARTS: [&str; 7] = ["constants", "ephemeris", "law", "mean_motion", "motion", "phase", "scalar"];

/// Core's mutants and the tests that judge them: core's unit tests and the suite, without what needs the host's crate.
///
/// cargo-mutants takes the time that a mutant may need from core's unit tests alone, which is too little for the suite: the time limit,
/// s, is stated.
const SCOPE: &str = "--package toytop --test-package toytop,toytop-tests --no-default-features \
    --features toytop/fixed,toytop/nalgebra --timeout 600";

/// Tries part I of N of the mutants, from 0, or all of them; with a filter, those whose names match the regular expression.
pub(crate) fn mutants(shard: Option<&str>, filter: Option<&str>) -> Result<ExitCode> {
    provide("mutants")?;
    let mut command = Command::new("cargo");
    command.current_dir(root()).arg("mutants").args(SCOPE.split_whitespace()).args(["--output", "target"]);
    command.args(["--file", "core/src/*.rs"]);
    for part in PARTS {
        command.args(["--file", &format!("core/src/{part}/**")]);
    }
    // every N-th mutant, which is a sample of all files
    command.args(shard.iter().flat_map(|shard| ["--sharding", "round-robin", "--shard", shard]));
    command.args(filter.iter().flat_map(|filter| ["--re", filter]));
    let status = command.args(["--", "--tests"]).status().context("cannot run cargo mutants")?;
    let code = status.code().and_then(|code| u8::try_from(code).ok());
    Ok(code.map_or(ExitCode::FAILURE, ExitCode::from))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_part_is_a_folder_of_core() {
        for part in PARTS {
            assert!(root().join("core/src").join(part).is_dir(), "core/src/{part}");
        }
    }
}
