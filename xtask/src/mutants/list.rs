//! What cargo-mutants would change: here it only makes the list.

use std::process::Command;

use anyhow::{Context, Result, bail};
use serde_json::Value;

use crate::process::root;

/// A line and a column, both from 1.
pub(super) type Place = (usize, usize);

/// A piece of a file, from a place up to another.
#[derive(Clone, Copy, PartialEq)]
pub(super) struct Span {
    pub(super) start: Place,
    pub(super) end: Place,
}

/// A function of core in which a piece of the text is another.
pub(super) struct Mutant {
    /// File, line, column and change.
    pub(super) name: String,
    pub(super) file: String,
    /// The function that it is in.
    pub(super) function: Span,
    pub(super) span: Span,
    pub(super) replacement: String,
}

/// All mutants of the functions of some files, in their order. Not those of constants: no running process can choose there.
pub(super) fn list(files: &[&str]) -> Result<Vec<Mutant>> {
    let mut command = Command::new("cargo");
    command.args(["mutants", "--list", "--json", "--package", "toytop"]).current_dir(root());
    command.args(files.iter().flat_map(|file| ["--file", file]));
    let output = command.output().context("cannot run cargo mutants")?;
    if !output.status.success() {
        bail!("cargo mutants: {}", String::from_utf8_lossy(&output.stderr).trim_end());
    }
    let all: Vec<Value> = serde_json::from_slice(&output.stdout)?;
    let in_functions = all.iter().filter(|entry| !entry["function"].is_null());
    let read = |entry: &Value| mutant(entry).with_context(|| format!("cargo mutants --json: {entry}"));
    in_functions.map(read).collect()
}

fn mutant(entry: &Value) -> Option<Mutant> {
    let text = |key: &str| entry[key].as_str().map(str::to_owned);
    Some(Mutant {
        name: text("name")?,
        file: text("file")?,
        function: span(&entry["function"]["span"])?,
        span: span(&entry["span"])?,
        replacement: text("replacement")?,
    })
}

fn span(value: &Value) -> Option<Span> {
    let number = |value: &Value| value.as_u64().map(|number| number as usize);
    let place = |value: &Value| Some((number(&value["line"])?, number(&value["column"])?));
    Some(Span { start: place(&value["start"])?, end: place(&value["end"])? })
}
