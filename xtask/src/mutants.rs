//! `cargo xtask mutants`: cargo-mutants with the files that it changes and the tests that it runs.

use std::process::{Command, ExitCode};

use anyhow::{Context, Result};

use crate::process::root;
use crate::subcommand::provide;

/// Folders of core that are changed: all except the closed forms of `exact`, the elliptic functions that only they use, and `interop`.
const PARTS: [&str; 7] = ["constants", "ephemeris", "law", "mean_motion", "motion", "phase", "scalar"];

/// Arguments that select core's mutants, and core's unit tests and the suite without the host's crate as their tests.
///
/// The time limit, s, is stated, because cargo-mutants would take it from core's unit tests alone, which is too short for the suite.
const SCOPE: &str = "--package toytop --test-package toytop,toytop-tests --no-default-features \
    --features toytop/fixed,toytop/nalgebra --timeout 600";

/// Runs part I of N of the mutants, from 0, or all of them; with a filter, those whose names match the regular expression.
pub(crate) fn mutants(shard: Option<&str>, filter: Option<&str>) -> Result<ExitCode> {
    provide("mutants")?;
    let mut command = Command::new("cargo");
    command.current_dir(root()).arg("mutants").args(SCOPE.split_whitespace()).args(["--output", "target"]);
    command.args(["--file", "core/src/*.rs"]);
    for part in PARTS {
        command.args(["--file", &format!("core/src/{part}/**")]);
    }
    // a part contains every N-th mutant, and so mutants of all files
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
