//! Steps of `cargo xtask test`. The steps that find failures soonest come first. The steps of the chips, which wait for an emulator on one
//! core, run in parallel with the steps of the host.

use std::process::ExitCode;
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
    every_change: bool,
    /// Tools that it needs besides cargo.
    needs: &'static [Tool],
    /// Function that runs the step and returns a remark.
    run: fn() -> Result<String>,
    /// Function that runs it with `--all`.
    run_all: fn() -> Result<String>,
}

const fn every_change(name: &'static str, needs: &'static [Tool], run: fn() -> Result<String>) -> Step {
    Step { name, every_change: true, needs, run, run_all: run }
}

const fn only_with_all(name: &'static str, needs: &'static [Tool], run: fn() -> Result<String>) -> Step {
    Step { name, every_change: false, needs, run, run_all: run }
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
    only_with_all("docs", &[PAGE], checks::docs),
    only_with_all("c-cmake", &[C, PAGE], c::check_cmake),
    only_with_all("package", &[], checks::package),
    only_with_all("fuzz", &[FUZZER], checks::fuzz),
    only_with_all("coverage", &[COVERAGE], checks::coverage),
];

/// Steps of the programs for the chips, and of the Python package, so that both lists take equally long.
const ON_CHIPS: &[Step] = &[
    every_change("bits", &[CHIPS, QEMU], firmware::bits),
    Step { run_all: firmware::no_panic_on_all, ..every_change("no-panic", &[CHIPS], firmware::no_panic) },
    every_change("clippy-firmware", &[CHIPS, LINTS], checks::clippy_firmware),
    Step { run_all: checks::budget_on_all, ..every_change("budget", &[CHIPS, PAGE, QEMU], checks::budget) },
    Step { run_all: python::full, ..every_change("python", &[PAGE, PYTHON], python::check) },
    only_with_all("firmware", &[CHIPS, QEMU], firmware::programs),
    only_with_all("c-chip", &[C, CHIPS, PAGE, QEMU], c::check_on_chip),
    only_with_all("features", &[CHIPS, HACK], checks::features),
];

impl Step {
    /// Runs the step, prints its result and returns whether it has passed.
    fn passes(&self, all: bool, provided: Result<()>) -> bool {
        let begin = Instant::now();
        let result = provided.and_then(|()| if all { (self.run_all)() } else { (self.run)() });
        let seconds = begin.elapsed().as_secs_f64();
        match &result {
            Ok(remark) => println!("{:16} ok       {seconds:6.1} s   {remark}", self.name),
            Err(error) => println!("{:16} FAILED   {seconds:6.1} s\n{error:#}\n", self.name),
        }
        result.is_ok()
    }
}

/// Prints the names of the steps.
pub(crate) fn list() {
    for Step { name, every_change, .. } in ON_HOST.iter().chain(ON_CHIPS) {
        println!("{name:16} {}", if *every_change { "every change" } else { "--all" });
    }
}

/// Runs the steps before every change, or all steps, or only one. A step whose tools cannot be installed fails.
pub(crate) fn run(all: bool, only: Option<&str>) -> Result<ExitCode> {
    let start = Instant::now();
    let only = only.map(|name| named("step", name, ON_HOST.iter().chain(ON_CHIPS), |step| step.name));
    let only = only.transpose()?.map(|step| step.name);
    let chosen = |step: &Step| only.map_or(all || step.every_change, |name| name == step.name);
    // before the steps, because two installations would wait for each other's lock
    let provided = |step: &'static Step| (step, step.needs.iter().try_for_each(Tool::provide));
    let [on_host, on_chips] =
        [ON_HOST, ON_CHIPS].map(|steps| steps.iter().filter(|step| chosen(step)).map(provided).collect());
    let results = move |steps: Vec<(&Step, Result<()>)>| -> Vec<_> {
        steps.into_iter().map(|(step, provided)| (step.name, step.passes(all, provided))).collect()
    };
    let results = thread::scope(|scope| {
        let on_chips = scope.spawn(move || results(on_chips));
        let on_host = results(on_host);
        [on_host, on_chips.join().expect("a step returns its failures")].concat()
    });
    let failed: Vec<_> = results.iter().filter(|(_, passed)| !passed).map(|(name, _)| *name).collect();
    let seconds = start.elapsed().as_secs_f64();
    println!("\n{} steps passed in {seconds:.0} s", results.len() - failed.len());
    if failed.is_empty() {
        return Ok(ExitCode::SUCCESS);
    }
    println!("failed: {}", failed.join(" "));
    Ok(ExitCode::FAILURE)
}

#[cfg(test)]
mod tests {
    use anyhow::bail;

    use super::{Result, every_change};

    #[test]
    fn a_step_that_fails_or_cannot_run_has_not_passed() {
        let good = every_change("runs", &[], || Ok(String::new()));
        assert!(good.passes(false, Ok(())) && !good.passes(false, missing()));
        assert!(!every_change("fails", &[], || bail!("wrong")).passes(true, Ok(())));
    }

    fn missing() -> Result<()> {
        bail!("a tool is missing")
    }
}
