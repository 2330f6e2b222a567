//! A copy of the project with mutants woven in, and the programs of its tests.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, bail};
use serde_json::Value;

use super::weave::{Chosen, at_line, weave};
use crate::process::{root, run, run_within};

/// Everything of mutants, below the repository's root.
pub(super) const FOLDER: &str = "target/mutants";
const LIB: &str = "core/src/lib.rs";

/// Without the host's crate, which takes longer to compile than all of this.
const BUILD: &str = "test --no-run --message-format json --package toytop --package toytop-tests \
    --no-default-features --lib --test suite --target-dir ../build";

/// What compiles: programs, and the folder that each runs in.
pub(super) struct Built {
    pub(super) programs: Vec<(PathBuf, PathBuf)>,
    /// Mutants that do not compile.
    pub(super) unviable: BTreeSet<u32>,
}

/// Weaves the mutants in; one that the compiler refuses is left out, until it refuses none.
pub(super) fn build(mutants: &[Chosen]) -> Result<Built> {
    let copy = root().join(FOLDER).join("copy");
    let mut unviable = BTreeSet::new();
    loop {
        let viable: Vec<_> =
            mutants.iter().filter(|chosen| !unviable.contains(&chosen.number)).copied().collect();
        write(&copy, &viable)?;
        let mut command = Command::new("cargo");
        command.args(BUILD.split_whitespace()).current_dir(&copy);
        command.env("RUSTC_BOOTSTRAP", "1").env("RUSTFLAGS", "--cap-lints=allow");
        command.env("CARGO_PROFILE_TEST_DEBUG", "0");
        let ended = run_within(&mut command, super::LONGEST_BUILD)?;
        let messages = ended.output.lines().filter_map(|line| serde_json::from_str::<Value>(line).ok());
        let messages: Vec<_> = messages.collect();
        if ended.success {
            return Ok(Built { programs: messages.iter().filter_map(program).collect(), unviable });
        }
        let before = unviable.len();
        unviable.extend(messages.iter().filter_map(|message| refused(&copy, message)));
        if unviable.len() == before {
            let said = messages.iter().filter_map(|message| message["message"]["rendered"].as_str());
            bail!("{}\n{}", said.collect::<String>(), ended.output.lines().last().unwrap_or_default());
        }
    }
}

/// The project as it is here, whether committed or not; what has not changed keeps its time, so that it is not built again.
fn write(copy: &Path, mutants: &[Chosen]) -> Result<()> {
    let files = run(Command::new("git").args(["ls-files", "-co", "--exclude-standard"]).current_dir(root()))?;
    let core: Vec<_> = mutants.chunk_by(|a, b| a.mutant.file == b.mutant.file).collect();
    for file in files.lines() {
        let source = root().join(file);
        let Ok(mut bytes) = fs::read(&source) else { continue }; // deleted, and not committed yet
        if let Some(own) = core.iter().find(|own| own[0].mutant.file == file) {
            bytes = weave(&String::from_utf8(bytes)?, own).into_bytes();
        }
        if file == LIB {
            let head = "#![feature(core_intrinsics, const_eval_select)]\n";
            bytes.splice(..0, head.bytes());
            bytes.extend(format!("mod mutant {{\n{}}}\n", include_str!("switch.rs")).bytes());
        }
        let target = copy.join(file);
        if fs::read(&target).is_ok_and(|there| there == bytes) {
            continue;
        }
        fs::create_dir_all(target.parent().context("a file has a folder")?)?;
        fs::write(target, bytes)?;
    }
    Ok(())
}

/// The mutant that a message of the compiler is about.
fn refused(copy: &Path, message: &Value) -> Option<u32> {
    let message = &message["message"];
    let spans = message["spans"].as_array().filter(|_| message["level"] == "error")?;
    spans.iter().filter(|span| span["is_primary"] == true).find_map(|span| {
        let woven = fs::read_to_string(copy.join(span["file_name"].as_str()?)).ok()?;
        at_line(&woven, span["line_start"].as_u64()? as usize)
    })
}

fn program(message: &Value) -> Option<(PathBuf, PathBuf)> {
    let manifest = Path::new(message["manifest_path"].as_str()?);
    Some((message["executable"].as_str()?.into(), manifest.parent()?.to_owned()))
}
