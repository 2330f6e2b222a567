//! The tests, one by one: which functions each calls, and whether one that calls a mutant's function notices it.

use std::collections::BTreeSet;
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};
use std::{fmt, fs};

use anyhow::{Context, Result, bail};

use super::build::{Built, FOLDER};
use super::weave::Chosen;
use crate::process::{root, run, wait};

/// A mutant may take longer than none, but a test that takes this many times as long, and some seconds, hangs.
const PATIENCE: u32 = 10;
const SOME_SECONDS: Duration = Duration::from_secs(10);

/// One test in a process of its own.
pub(super) struct Test {
    program: PathBuf,
    folder: PathBuf,
    pub(super) name: String,
    took: Duration,
    /// Functions, by their numbers.
    calls: BTreeSet<u32>,
}

/// What the tests make of a mutant.
pub(super) enum Verdict {
    Caught(String),
    TimedOut(String),
    Missed,
    /// No test calls the function.
    NotCalled,
    /// The compiler refuses it.
    Unviable,
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Caught(test) => write!(f, "caught: by {test}"),
            Self::TimedOut(test) => write!(f, "timed out: in {test}"),
            Self::Missed => write!(f, "missed"),
            Self::NotCalled => write!(f, "not called"),
            Self::Unviable => write!(f, "unviable"),
        }
    }
}

/// The slowest tests, that take the rest of the time, judge no mutant: what only they would notice counts as missed.
const QUICK_SHARE: f64 = 1.0 / 3.0;

/// All tests without a mutant: they must pass. The quick ones are returned, the quickest first.
pub(super) fn tests(built: &Built) -> Result<Vec<Test>> {
    let notes = root().join(FOLDER).join("notes");
    let mut tests = Vec::new();
    for (program, folder) in &built.programs {
        let listed = run(Command::new(program).args(["--list", "--format", "terse"]))?;
        for name in listed.lines().filter_map(|line| line.strip_suffix(": test")) {
            let _ = fs::remove_file(&notes); // there may be none
            let mut test = Test {
                program: program.clone(),
                folder: folder.clone(),
                name: name.to_owned(),
                took: super::LONGEST_BUILD,
                calls: BTreeSet::new(),
            };
            let start = Instant::now();
            if test.passes(&["MUTANT_NOTES", &notes.to_string_lossy()])? != Some(true) {
                bail!("{name} fails without a mutant");
            }
            test.took = start.elapsed();
            let called = fs::read_to_string(&notes).unwrap_or_default(); // none, if none is called
            test.calls = called.lines().map(str::parse).collect::<Result<_, _>>().context("notes")?;
            tests.push(test);
        }
    }
    tests.sort_by_key(|test| test.took);
    let all: Duration = tests.iter().map(|test| test.took).sum();
    let mut sum = Duration::ZERO;
    let quick = tests.iter().take_while(|test| {
        sum += test.took;
        sum < all.mul_f64(QUICK_SHARE)
    });
    tests.truncate(quick.count());
    Ok(tests)
}

/// Runs the tests that call the mutant's function until one fails.
pub(super) fn judge(tests: &[Test], chosen: &Chosen) -> Result<Verdict> {
    let mut verdict = Verdict::NotCalled;
    for test in tests.iter().filter(|test| test.calls.contains(&chosen.function)) {
        verdict = Verdict::Missed;
        match test.passes(&["MUTANT", &chosen.number.to_string()])? {
            Some(true) => {}
            Some(false) => return Ok(Verdict::Caught(test.name.clone())),
            None => return Ok(Verdict::TimedOut(test.name.clone())),
        }
    }
    Ok(verdict)
}

impl Test {
    /// None if it takes too long.
    fn passes(&self, [variable, value]: &[&str; 2]) -> Result<Option<bool>> {
        let mut command = Command::new(&self.program);
        command.args(["--exact", &self.name, "--test-threads", "1"]).current_dir(&self.folder);
        command.env(variable, value).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
        let mut child = command.spawn()?;
        let ended = wait(&mut child, PATIENCE * self.took + SOME_SECONDS)?;
        Ok(ended.map(|status| status.success()))
    }
}
