//! `cargo xtask coverage`: lines of core that its tests execute, by file, measured by cargo-llvm-cov.

use std::process::Command;

use anyhow::{Result, bail};

use crate::page::rewrite;
use crate::process::{root, run};
use crate::subcommand::provide;

/// Share of a file's lines in percent, below which a reason is required.
const ENOUGH: f64 = 95.0;

/// Files of core below this share, each with the reason.
const REASONS: &[(&str, &str)] = &[
    ("ephemeris/evaluation/integer.rs", BITS_32),
    ("ephemeris/evaluation/micromath.rs", "a scalar of the benchmarks, which tests of the host execute"),
    ("fit/launch.rs", FITS),
    ("fit/outcome.rs", FITS),
    ("law/block.rs", BITS_32),
    ("scalar.rs", "absolute values of the scalar of the benchmarks"),
];
const BITS_32: &str = "the rest is for 32 bits: `cargo xtask narrow` and the chips execute it";
const FITS: &str = "the rest is executed by the fits of the host's tests";

const PAGE: &str = "host/docs/coverage.md";
const MARKS: [&str; 2] =
    ["<!-- coverage: written by `cargo xtask coverage --accept` -->\n", "<!-- coverage: end -->"];

/// File of core, below core/src.
struct File {
    name: String,
    lines: u32,
    run: u32,
}

impl File {
    fn share(&self) -> f64 {
        100.0 * f64::from(self.run) / f64::from(self.lines.max(1))
    }

    fn reason(&self) -> Option<&'static str> {
        REASONS.iter().find(|(name, _)| *name == self.name).map(|(_, reason)| *reason)
    }
}

/// Prints the table, and writes the page if `accept`. A file below the share without a reason is an error.
pub(crate) fn coverage(accept: bool) -> Result<()> {
    provide("llvm-cov")?;
    let mut command = Command::new("cargo");
    command.args(["llvm-cov", "--package", "toytop", "--package", "toytop-tests"]);
    command.args(["--features", "toytop/fixed,toytop/nalgebra", "--lib", "--test", "suite"]);
    command.args(["--lcov", "--quiet"]).current_dir(root());
    // cargo-llvm-cov fetches the compiler's LLVM tools, unless LLVM_COV and LLVM_PROFDATA are set
    let files = files(&run(command.env("CARGO_TERM_COLOR", "never"))?);
    if files.is_empty() {
        bail!("no line of core was executed");
    }
    let table = table(&files);
    println!("{table}");
    if accept {
        let version = env!("CARGO_PKG_VERSION");
        rewrite(PAGE, MARKS, |_| format!("Version {version}:\n\n{table}"))?;
    }
    let unexplained = files.iter().filter(|file| file.share() < ENOUGH && file.reason().is_none());
    let names: Vec<_> = unexplained.map(|file| file.name.as_str()).collect();
    if !names.is_empty() {
        bail!("below {ENOUGH} % without a reason in xtask/src/coverage.rs: {}", names.join(" "));
    }
    let idle = |name: &str| files.iter().all(|file| file.name != name || file.share() >= ENOUGH);
    if let Some((name, _)) = REASONS.iter().find(|(name, _)| idle(name)) {
        bail!("{name} no longer needs a reason in xtask/src/coverage.rs");
    }
    Ok(())
}

/// Files of a report in lcov's format: a record for each file, with LF lines of which LH were executed.
fn files(lcov: &str) -> Vec<File> {
    let mut files = Vec::new();
    for record in lcov.split("end_of_record") {
        let field = |key: &str| record.lines().find_map(|line| line.strip_prefix(key));
        let name = field("SF:").and_then(|path| path.split_once("core/src/"));
        let count = |key: &str| field(key).and_then(|number| number.parse().ok());
        if let (Some((_, name)), Some(lines), Some(run)) = (name, count("LF:"), count("LH:")) {
            files.push(File { name: name.to_owned(), lines, run });
        }
    }
    files.sort_by(|a, b| a.name.cmp(&b.name));
    files
}

fn table(files: &[File]) -> String {
    let mut table = String::from("| core/src/ | lines | run | % | |\n|---|--:|--:|--:|---|\n");
    let row = |file: &File| {
        let File { name, lines, run } = file;
        let reason = file.reason().unwrap_or_default();
        format!("| {name} | {lines} | {run} | {:.1} | {reason} |\n", file.share())
    };
    files.iter().for_each(|file| table += &row(file));
    let sum = |count: fn(&File) -> u32| files.iter().map(count).sum();
    table + &row(&File { name: "**all**".into(), lines: sum(|file| file.lines), run: sum(|file| file.run) })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn records_of_core_are_read() {
        let lcov = "SF:/x/core/src/top.rs\nDA:1,1\nLF:40\nLH:39\nend_of_record\nSF:/x/tests/a.rs\nLF:2\nLH:1\nend_of_record\n";
        let files = files(lcov);
        assert_eq!(files.len(), 1);
        assert_eq!((files[0].name.as_str(), files[0].share()), ("top.rs", 97.5));
    }
}
