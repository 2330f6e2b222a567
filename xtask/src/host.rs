//! Build of the host's crates for tests, which all steps share.

use std::path::PathBuf;
use std::process::Command;

use anyhow::Result;

use crate::process::{cargo, run, target_dir};
use crate::web;

/// Command that tests all crates, with the program's feature `parquet`.
pub(crate) fn tests(words: &str) -> Command {
    web::with_core(cargo(".", &format!("test --workspace --features toytop-host/parquet {words}")))
}

/// Path of the program `toytop` of this build.
pub(crate) fn program() -> Result<PathBuf> {
    run(&mut tests("--test cli --no-run"))?;
    Ok(target_dir().join("debug/toytop"))
}
