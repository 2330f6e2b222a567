//! Steps of `cargo xtask test`. The steps that find failures soonest come first. The steps of the chips, which wait for an emulator on one
//! core, run in parallel with those of the host.

use std::process::ExitCode;
use std::sync::{Mutex, PoisonError};
use std::thread;
use std::time::Instant;

use anyhow::{Context, Result};

use crate::tools::{C, CHIPS, CHROMIUM, COVERAGE, FUZZER, HACK, LINTS, PAGE, PYTHON, QEMU, Tool};
use crate::{c, checks, firmware, python, size};

/// One step of the test command.
pub(crate) struct Step {
    name: &'static str,
    /// Whether every change needs the step; the others are run by `--all`.
    pub(crate) guards: bool,
    /// Tools that it needs besides cargo.
    needs: &'static [Tool],
    /// Function that runs the step and returns a remark.
    run: fn() -> Result<String>,
}

const fn guard(name: &'static str, needs: &'static [Tool], run: fn() -> Result<String>) -> Step {
    Step { name, guards: true, needs, run }
}

const fn other(name: &'static str, needs: &'static [Tool], run: fn() -> Result<String>) -> Step {
    Step { name, guards: false, needs, run }
}

/// Steps of the host's crates.
const ON_HOST: &[Step] = &[
    guard("size", &[], size::check),
    guard("fmt", &[LINTS], checks::fmt),
    guard("clippy", &[LINTS, PAGE], checks::clippy),
    guard("tests", &[PAGE], checks::tests),
    guard("doctests", &[PAGE], checks::doctests),
    guard("docs", &[PAGE], checks::docs),
    guard("browser", &[PAGE, CHROMIUM], checks::browser),
    guard("c-header", &[C], c::check_header),
    guard("c-host", &[C, PAGE], c::check_on_host),
    guard("c-cmake", &[C, PAGE], c::check_cmake),
    guard("python", &[PAGE, PYTHON], python::check),
    other("python-full", &[PAGE, PYTHON], python::full),
    other("package", &[], checks::package),
    other("fuzz", &[FUZZER], checks::fuzz),
    other("coverage", &[COVERAGE], checks::coverage),
];

/// Steps of the programs for the chips. The last ones wait for builds of the host's.
const ON_CHIPS: &[Step] = &[
    guard("bits", &[CHIPS, QEMU], firmware::bits),
    guard("firmware", &[CHIPS, QEMU], firmware::programs),
    guard("no-panic", &[CHIPS], firmware::no_panic),
    guard("clippy-firmware", &[CHIPS, LINTS], checks::clippy_firmware),
    guard("c-chip", &[C, CHIPS, PAGE, QEMU], c::check_on_chip),
    guard("budget", &[CHIPS, PAGE, QEMU], checks::budget),
    other("budget-on-all", &[CHIPS, PAGE, QEMU], checks::budget_on_all),
    other("features", &[CHIPS, HACK], checks::features),
];

#[derive(Debug, PartialEq)]
enum Outcome {
    Passed,
    Failed,
    /// A tool is missing and cannot be installed.
    NotRun,
}

impl Step {
    /// Runs the step and prints its result.
    fn result(&self) -> Outcome {
        let Self { name, needs, run, .. } = self;
        let begin = Instant::now();
        // one after the other, because two installations would wait for each other's lock
        static INSTALLATION: Mutex<()> = Mutex::new(());
        let provided = {
            let _one = INSTALLATION.lock();
            needs.iter().try_for_each(Tool::provide)
        };
        let seconds = || begin.elapsed().as_secs_f64();
        match provided.map(|()| run()) {
            Ok(Ok(remark)) => {
                println!("{name:16} ok       {:6.1} s   {remark}", seconds());
                Outcome::Passed
            }
            Ok(Err(error)) => {
                println!("{name:16} FAILED   {:6.1} s\n{error:#}\n", seconds());
                Outcome::Failed
            }
            Err(missing) => {
                println!("{name:16} NOT RUN  {missing:#}");
                Outcome::NotRun
            }
        }
    }
}

/// Prints the names of the steps.
pub(crate) fn list() {
    for Step { name, guards, .. } in ON_HOST.iter().chain(ON_CHIPS) {
        println!("{name:16} {}", if *guards { "every change" } else { "--all" });
    }
}

/// Runs one step.
pub(crate) fn run_one(name: &str) -> Result<ExitCode> {
    let names = || ON_HOST.iter().chain(ON_CHIPS).map(|step| step.name).collect::<Vec<_>>().join(" ");
    let found = ON_HOST.iter().chain(ON_CHIPS).find(|step| step.name == name);
    let step = found.with_context(|| format!("no step {name}; there are: {}", names()))?;
    run(|other| other.name == step.name)
}

/// Runs the chosen steps. A step that could not run is not a success.
pub(crate) fn run(chosen: impl Fn(&Step) -> bool + Sync) -> Result<ExitCode> {
    let start = Instant::now();
    let results = Mutex::new(Vec::new());
    let in_order = |steps: &'static [Step]| {
        for step in steps.iter().filter(|step| chosen(step)) {
            let result = (step.name, step.result());
            results.lock().unwrap_or_else(PoisonError::into_inner).push(result);
        }
    };
    thread::scope(|scope| {
        scope.spawn(|| in_order(ON_CHIPS));
        in_order(ON_HOST);
    });
    let results = results.into_inner().unwrap_or_else(PoisonError::into_inner);
    let with =
        |outcome| results.iter().filter(|(_, other)| *other == outcome).map(|(name, _)| *name).collect();
    let [passed, failed, not_run]: [Vec<&str>; 3] =
        [Outcome::Passed, Outcome::Failed, Outcome::NotRun].map(with);
    print!("\n{} steps passed in {:.0} s", passed.len(), start.elapsed().as_secs_f64());
    for (what, names) in [("failed", &failed), ("not run", &not_run)] {
        if !names.is_empty() {
            print!("; {what}: {}", names.join(" "));
        }
    }
    println!();
    Ok(ExitCode::from(exit_code(!failed.is_empty(), !not_run.is_empty())))
}

/// Exit code of the test command.
fn exit_code(has_failed: bool, has_not_run: bool) -> u8 {
    if has_failed { 1 } else { 2 * u8::from(has_not_run) }
}

#[cfg(test)]
mod tests {
    use anyhow::bail;

    use super::{Outcome, Step, exit_code, guard};
    use crate::tools::Tool;

    #[test]
    fn a_step_that_cannot_run_has_not_passed() {
        const GOOD: fn() -> anyhow::Result<String> = || Ok(String::new());
        let missing = const { &[Tool::missing()] };
        let outcomes =
            [guard("runs", &[], GOOD), guard("fails", &[], || bail!("wrong")), guard("waits", missing, GOOD)];
        assert_eq!(
            outcomes.map(|step: Step| step.result()),
            [Outcome::Passed, Outcome::Failed, Outcome::NotRun]
        );
        assert_eq!([(false, false), (true, false), (true, true)].map(|(f, n)| exit_code(f, n)), [0, 1, 1]);
        assert_eq!(exit_code(false, true), 2, "a step that did not run is no success");
    }
}
