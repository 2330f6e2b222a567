//! `cargo xtask mutants --shard I/N`: does a test notice when a line of core's stages is wrong? By cargo-mutants.

use std::process::Command;

use anyhow::{Result, bail};

use crate::process::root;
use crate::subcommand::{provide, show};

/// The stages: what runs once per throw, what runs every tick, and the law between them.
const FILES: [&str; 4] =
    ["core/src/launch/**", "core/src/tick/**", "core/src/nutation/**", "core/src/nutation.rs"];

/// The I-th of N parts of all mutants, each judged by core's unit tests and the suite without the host's crate. A mutant takes
/// about as long as these tests take to build and run: minutes, so all of them take days.
pub(crate) fn mutants(shard: &str) -> Result<()> {
    let numbers = shard.split_once('/').map(|(part, of)| (part.parse::<u32>(), of.parse::<u32>()));
    if !matches!(numbers, Some((Ok(part), Ok(of))) if part < of) {
        bail!("--shard: must be I/N with I < N, such as 0/64, not {shard}");
    }
    provide("mutants")?;
    let mut command = Command::new("cargo");
    command.args(["mutants", "--package", "toytop", "--test-package", "toytop,toytop-tests"]);
    // without the host's crate a build is a third; every N-th mutant is a sample of all files
    command.args(["--no-default-features", "--sharding", "round-robin", "--shard", shard]);
    command.args(FILES.iter().flat_map(|file| ["--file", file]));
    command.arg("--output").arg(root().join("target/mutants"));
    command.args(["--", "--lib", "--test", "suite"]);
    show(&mut command)
}
