//! `cargo xtask mutants`: does a test notice when a line of core's stages is wrong?
//!
//! cargo-mutants says what to change. Here the changes become one program that chooses among them when it runs, so a mutant
//! costs a few tests instead of a build.

mod build;
mod judge;
mod list;
mod weave;

use std::fs::File;
use std::io::Write;
use std::time::{Duration, Instant};

use anyhow::{Result, bail};

use crate::page::rewrite;
use crate::process::root;
use crate::subcommand::provide;
use judge::Verdict;
use list::Mutant;
use weave::Chosen;

/// The numbers, what is thrown, and the stages: what runs once per throw, what runs every tick, and the law between them.
const FILES: [&str; 5] =
    ["core/src/*.rs", "core/src/launch/**", "core/src/nutation/**", "core/src/real/**", "core/src/tick/**"];

/// A build of some hundred mutants takes minutes.
const LONGEST_BUILD: Duration = Duration::from_secs(3600);

/// What becomes of them: the columns of the page.
const KINDS: [&str; 5] = ["caught", "timed out", "missed", "not called", "unviable"];
const PAGE: &str = "host/docs/mutants.md";
const MARKS: [&str; 2] =
    ["<!-- mutants: written by `cargo xtask mutants --shard I/N --accept` -->\n", "<!-- mutants: end -->"];

/// Which mutants.
pub(crate) enum Choice<'a> {
    /// Part I of N, from 0: every N-th mutant, a sample of all files; whether its row on the page is written anew.
    Shard { shard: &'a str, accept: bool },
    /// Those with one of these in their names: file, line and column, function, change.
    Named(&'a [&'a str]),
}

/// Tries the chosen mutants with core's unit tests and the suite, without what needs the host's crate; says what no test
/// notices.
pub(crate) fn mutants(choice: &Choice) -> Result<()> {
    provide("mutants")?;
    let all = list::list(&FILES)?;
    let chosen = numbered(&chosen(&all, choice)?);
    let begin = Instant::now();
    let since = || begin.elapsed().as_secs();
    let built = build::build(&chosen)?;
    eprintln!("built after {} s", since());
    let tests = judge::tests(&built)?;
    eprintln!("{} quick tests, known after {} s", tests.len(), since());
    let mut log = File::create(root().join(build::FOLDER).join("log"))?;
    let mut counts = KINDS.map(|kind| (kind, 0));
    for chosen in &chosen {
        let verdict = match built.unviable.contains(&chosen.number) {
            true => Verdict::Unviable,
            false => judge::judge(&tests, chosen)?,
        };
        let (name, verdict) = (&chosen.mutant.name, verdict.to_string());
        let kind = verdict.split(':').next().unwrap_or_default();
        if matches!(kind, "missed" | "not called") {
            println!("{name}: {kind}");
        }
        writeln!(log, "{name}: {verdict}")?;
        counts.iter_mut().filter(|(name, _)| *name == kind).for_each(|(_, count)| *count += 1);
    }
    let said: Vec<_> = counts.iter().map(|(kind, count)| format!("{count} {kind}")).collect();
    println!("{} mutants of {} in {} s: {}", chosen.len(), all.len(), since(), said.join(", "));
    if let Choice::Shard { shard, accept: true } = choice {
        let key = format!("| {} | {shard} |", env!("CARGO_PKG_VERSION"));
        let numbers = [all.len(), chosen.len()].into_iter().chain(counts.map(|(_, count)| count));
        let row = numbers.fold(key.clone(), |row, number| format!("{row} {number} |"));
        rewrite(PAGE, MARKS, |rows| {
            let others = rows.lines().filter(|row| !row.starts_with(&key));
            others.chain([&*row]).map(|row| format!("{row}\n")).collect()
        })?;
    }
    Ok(())
}

fn chosen<'a>(all: &'a [Mutant], choice: &Choice) -> Result<Vec<&'a Mutant>> {
    match choice {
        Choice::Named(parts) => {
            let named = |mutant: &&Mutant| parts.iter().any(|part| mutant.name.contains(part));
            Ok(all.iter().filter(named).collect())
        }
        Choice::Shard { shard, .. } => {
            let numbers = shard.split_once('/').map(|(part, of)| (part.parse(), of.parse()));
            match numbers {
                Some((Ok(part), Ok(of))) if part < of => Ok(all.iter().skip(part).step_by(of).collect()),
                _ => bail!("--shard: must be I/N with I < N, such as 0/8, not {shard}"),
            }
        }
    }
}

fn numbered<'a>(mutants: &[&'a Mutant]) -> Vec<Chosen<'a>> {
    let mut chosen: Vec<Chosen> = Vec::new();
    for (number, mutant) in (1..).zip(mutants) {
        let same =
            |last: &&Chosen| last.mutant.file == mutant.file && last.mutant.function == mutant.function;
        let function = chosen.last().filter(same).map_or(number, |last| last.function);
        chosen.push(Chosen { number, function, mutant });
    }
    chosen
}
