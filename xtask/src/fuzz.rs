//! `cargo xtask fuzz`: runs of the targets of tests/support/hostile under libFuzzer, by cargo-fuzz and a nightly compiler.

use std::fs;
use std::process::Command;
use std::time::Duration;

use anyhow::{Result, bail};

use crate::process::{in_ci, root, run, run_within};
use crate::subcommand::{is_there, nightly_is_there, provide, show, succeeds};

/// Targets of core, which are built in a minute or two, and are part of the tests if a nightly compiler is installed.
const CORE: [&str; 4] = ["launch", "ephemeris", "fixed", "bake"];
/// Target of the host, whose build needs all of its crates.
const SCENARIO: &str = "scenario";

const FOLDER: &str = "tests/fuzz";
/// Longest time of an input, s, in which tables of increasing sizes may be tried.
const LONGEST: u32 = 60;

/// Searches with each target, or with one, for this many seconds, and keeps new inputs in tests/fuzz/corpus.
pub(crate) fn fuzz(seconds: u32, only: Option<&str>) -> Result<()> {
    let all: Vec<_> = CORE.into_iter().chain([SCENARIO]).collect();
    let chosen = match only {
        None => all,
        Some(name) => match all.iter().find(|target| **target == name) {
            Some(target) => vec![*target],
            None => bail!("no target {name}; there are: {}", all.join(" ")),
        },
    };
    if !nightly_is_there() {
        bail!("cargo-fuzz needs a nightly compiler: rustup toolchain install nightly");
    }
    provide("fuzz")?;
    for target in chosen {
        show(&mut search(target, seconds, "corpus")?)?;
    }
    Ok(())
}

/// Short search with core's targets from the seeds, for the test command; without the tools only a remark.
pub(crate) fn briefly() -> Result<String> {
    const SECONDS: u32 = 10;
    let fetch = format!("+nightly fetch --quiet --manifest-path {FOLDER}/Cargo.toml");
    let fetched = || succeeds(&mut cargo(&fetch));
    if !nightly_is_there() || !is_there("fuzz") || !fetched() {
        return Ok("not run: needs cargo-fuzz and a nightly compiler; the tests run the seeds".into());
    }
    let build = format!("+nightly fuzz build --sanitizer none --fuzz-dir {FOLDER}");
    run(&mut cargo(&build))?;
    let mut inputs = 0;
    for target in CORE {
        let ended = run_within(&mut search(target, SECONDS, "target/corpus")?, Duration::from_secs(300))?;
        let executed =
            ended.output.lines().find_map(|line| line.strip_prefix("stat::number_of_executed_units:"));
        match executed.and_then(|number| number.trim().parse::<u64>().ok()) {
            Some(executed) if ended.success => inputs += executed,
            _ => bail!("{}\n{target}: the file named above repeats it", ended.output.trim_end()),
        }
    }
    Ok(format!("{} targets, {inputs} inputs, {SECONDS} s each", CORE.len()))
}

/// Command that runs libFuzzer with a target, from its seeds and from the inputs of earlier runs in a folder of tests/fuzz.
fn search(target: &str, seconds: u32, learned: &str) -> Result<Command> {
    let learned = root().join(FOLDER).join(learned).join(target);
    fs::create_dir_all(&learned)?;
    let (features, longest) = if target == SCENARIO { ("--features scenario", 2000) } else { ("", 400) };
    // core has no unsafe code: without a sanitizer it is twice as fast
    let run = format!("+nightly fuzz run --sanitizer none --fuzz-dir {FOLDER} {features} {target}");
    let mut command = cargo(&run);
    command.arg(learned).arg(root().join(FOLDER).join("seeds").join(target)).arg("--");
    command.arg(format!("-max_total_time={seconds}")).arg(format!("-timeout={LONGEST}"));
    command.args([&format!("-max_len={longest}"), "-len_control=0", "-print_final_stats=1"]);
    if in_ci() {
        command.arg("-seed=1");
    }
    Ok(command)
}

fn cargo(words: &str) -> Command {
    let mut command = Command::new("cargo");
    command.current_dir(root()).args(words.split_whitespace());
    command
}
