//! Steps of `cargo xtask test`. The steps that find failures soonest come first. The steps of the chips, which wait for an emulator on one
//! core, run in parallel with the steps of the host.

use std::process::ExitCode;
use std::sync::{Mutex, PoisonError};
use std::thread;
use std::time::Instant;

use anyhow::Result;

use crate::process::named;
use crate::tools::{C, CHIPS, CHROMIUM, COVERAGE, FUZZER, HACK, LINTS, PAGE, PYTHON, QEMU, TYPESCRIPT, Tool};
use crate::{c, checks, firmware, python, size};

/// One step of the test command.
pub(crate) struct Step {
    name: &'static str,
    /// Whether the step runs before every change; the others run with `--all`.
    pub(crate) every_change: bool,
    /// Tools that it needs besides cargo.
    needs: &'static [Tool],
    /// Function that runs the step and returns a remark.
    run: fn() -> Result<String>,
}

const fn every_change(name: &'static str, needs: &'static [Tool], run: fn() -> Result<String>) -> Step {
    Step { name, every_change: true, needs, run }
}

const fn only_with_all(name: &'static str, needs: &'static [Tool], run: fn() -> Result<String>) -> Step {
    Step { name, every_change: false, needs, run }
}

/// Steps of the host's crates.
const ON_HOST: &[Step] = &[
    every_change("size", &[], size::check),
    every_change("fmt", &[LINTS], checks::fmt),
    every_change("clippy", &[LINTS, PAGE], checks::clippy),
    every_change("scripts", &[TYPESCRIPT], checks::scripts),
    every_change("tests", &[PAGE], checks::tests),
    every_change("doctests", &[PAGE], checks::doctests),
    every_change("browser", &[PAGE, CHROMIUM], checks::browser),
    every_change("c-header", &[C], c::check_header),
    every_change("c-host", &[C, PAGE], c::check_on_host),
    every_change("python", &[PAGE, PYTHON], python::check),
    only_with_all("docs", &[PAGE], checks::docs),
    only_with_all("c-cmake", &[C, PAGE], c::check_cmake),
    only_with_all("python-full", &[PAGE, PYTHON], python::full),
    only_with_all("package", &[], checks::package),
    only_with_all("fuzz", &[FUZZER], checks::fuzz),
    only_with_all("coverage", &[COVERAGE], checks::coverage),
];

/// Steps of the programs for the chips.
const ON_CHIPS: &[Step] = &[
    every_change("bits", &[CHIPS, QEMU], firmware::bits),
    every_change("no-panic", &[CHIPS], firmware::no_panic),
    every_change("clippy-firmware", &[CHIPS, LINTS], checks::clippy_firmware),
    every_change("budget", &[CHIPS, PAGE, QEMU], checks::budget),
    only_with_all("firmware", &[CHIPS, QEMU], firmware::programs),
    only_with_all("c-chip", &[C, CHIPS, PAGE, QEMU], c::check_on_chip),
    only_with_all("no-panic-on-all", &[CHIPS], firmware::no_panic_on_all),
    only_with_all("budget-on-all", &[CHIPS, PAGE, QEMU], checks::budget_on_all),
    only_with_all("features", &[CHIPS, HACK], checks::features),
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
    for Step { name, every_change, .. } in ON_HOST.iter().chain(ON_CHIPS) {
        println!("{name:16} {}", if *every_change { "every change" } else { "--all" });
    }
}

/// Runs one step.
pub(crate) fn run_one(name: &str) -> Result<ExitCode> {
    let step = named("step", name, ON_HOST.iter().chain(ON_CHIPS), |step| step.name)?;
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

    use super::{Outcome, Step, every_change, exit_code};
    use crate::tools::Tool;

    #[test]
    fn a_step_that_cannot_run_has_not_passed() {
        const GOOD: fn() -> anyhow::Result<String> = || Ok(String::new());
        let missing = const { &[Tool::missing()] };
        let outcomes = [
            every_change("runs", &[], GOOD),
            every_change("fails", &[], || bail!("wrong")),
            every_change("waits", missing, GOOD),
        ];
        assert_eq!(
            outcomes.map(|step: Step| step.result()),
            [Outcome::Passed, Outcome::Failed, Outcome::NotRun]
        );
        assert_eq!([(false, false), (true, false), (true, true)].map(|(f, n)| exit_code(f, n)), [0, 1, 1]);
        assert_eq!(exit_code(false, true), 2, "a step that did not run is no success");
    }
}
