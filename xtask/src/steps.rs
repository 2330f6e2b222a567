//! Steps of `cargo xtask test` and of `cargo xtask ci`. The steps that find failures soonest come first. The steps of the chips, which wait
//! for an emulator on one core, run in parallel with those of the host.

use std::process::ExitCode;
use std::sync::{Mutex, PoisonError};
use std::thread;
use std::time::Instant;

use anyhow::{Result, bail};
use toytop_chips::{M0, RISCV};

use crate::chip::TARGETS;
use crate::firmware::{self, PROGRAMS};
use crate::host::tests;
use crate::process::{cargo, in_ci, run};
use crate::setup::{BROWSER, C, COMPILER, EMULATOR, Need, PAGE_COMPILER};
use crate::{c, features, fuzz, lint, nopanic, package, python, tools, web};

/// One step of the test command.
struct Step {
    name: &'static str,
    /// Tools that it needs besides cargo.
    needs: &'static [Need],
    /// Function that runs the step and returns a remark.
    run: Box<dyn Fn() -> Result<String> + Send>,
}

impl Step {
    fn new(
        name: &'static str,
        needs: &'static [Need],
        run: impl Fn() -> Result<String> + Send + 'static,
    ) -> Self {
        Self { name, needs, run: Box::new(run) }
    }

    fn is_of_chips(&self) -> bool {
        self.needs.iter().any(|need| need.name == COMPILER.name)
    }

    /// Runs the step if its tools are installed, and prints its result.
    fn result(&self, provided: &Result<()>) -> Outcome {
        let Self { name, run, .. } = self;
        let begin = Instant::now();
        let seconds = || begin.elapsed().as_secs_f64();
        match provided.as_ref().map(|()| run()) {
            Ok(Ok(remark)) => {
                println!("{name:15} ok       {:6.1} s   {remark}", seconds());
                Outcome::Passed
            }
            Ok(Err(error)) => {
                println!("{name:15} FAILED   {:6.1} s\n{error:#}\n", seconds());
                Outcome::Failed
            }
            Err(missing) if in_ci() => {
                println!("{name:15} FAILED   {missing:#}");
                Outcome::Failed
            }
            Err(missing) => {
                println!("{name:15} SKIPPED  {missing:#}");
                Outcome::Skipped
            }
        }
    }
}

#[derive(Clone, Copy, PartialEq)]
enum Outcome {
    Passed,
    Failed,
    Skipped,
}

fn steps() -> Vec<Step> {
    let (compiler, emulator) = (&[COMPILER], &[COMPILER, EMULATOR]);
    let mut steps = vec![
        Step::new("no-std", compiler, no_std),
        Step::new("page", &[PAGE_COMPILER], web::check),
        Step::new("tests", &[], || cargo_test("--lib --bins --tests --examples")),
        Step::new("doctests", &[], || cargo_test("--doc")),
        Step::new("examples", &[], package::examples),
        Step::new("package", &[], package::check),
        Step::new("docs", &[], docs),
        Step::new("benches", &[], benches),
        Step::new("fuzz", &[], fuzz::briefly),
        Step::new("python", &[], python::check),
        Step::new("no-panic", compiler, nopanic::check),
        Step::new("c-header", &[C], c::check_header),
        Step::new("c-host", &[C], c::check_on_host),
        Step::new("c-cmake", &[C], c::check_cmake),
        Step::new("browser", &[PAGE_COMPILER, BROWSER], browser),
    ];
    steps.extend(
        PROGRAMS.iter().map(|program| Step::new(program.name, emulator, || firmware::check(program))),
    );
    // these wait for builds of the host's steps
    steps.push(Step::new("c-chip", &[C, COMPILER, EMULATOR], c::check_on_chip));
    steps.push(Step::new("features", compiler, features::check));
    steps.push(Step::new("budget", emulator, budget));
    steps
}

/// Runs all steps, or one.
pub(crate) fn test(only: Option<&str>) -> Result<ExitCode> {
    let mut steps = steps();
    if let Some(name) = only {
        let names: Vec<_> = steps.iter().map(|step| step.name).collect();
        if !names.contains(&name) {
            bail!("no step {name}; there are: {}", names.join(" "));
        }
        steps.retain(|step| step.name == name);
    }
    run_all(steps)
}

/// Runs clippy on all crates, and all steps of [`test()`].
pub(crate) fn ci() -> Result<ExitCode> {
    let mut all =
        vec![Step::new("clippy", &[], lint::host), Step::new("clippy-firmware", &[COMPILER], lint::firmware)];
    all.extend(steps());
    run_all(all)
}

/// Runs steps. Missing tools are named; in CI they are a failure.
fn run_all(steps: Vec<Step>) -> Result<ExitCode> {
    let missing = missing(&steps);
    if !missing.is_empty() {
        println!("missing: {}; trying to install, as `cargo xtask setup` does", missing.join(", "));
    }
    let start = Instant::now();
    // one after the other, because two installations would wait for each other's lock
    let count = steps.len();
    let provided = steps.into_iter().map(|step| (step.needs.iter().try_for_each(Need::provide), step));
    let (chips, host): (Vec<_>, Vec<_>) = provided.partition(|(_, step)| step.is_of_chips());
    let outcomes = Mutex::new(Vec::new());
    let in_order = |steps: Vec<(Result<()>, Step)>| {
        for (provided, step) in steps {
            let outcome = step.result(&provided);
            outcomes.lock().unwrap_or_else(PoisonError::into_inner).push((step.name, outcome));
        }
    };
    thread::scope(|scope| {
        scope.spawn(|| in_order(chips));
        in_order(host);
    });

    let outcomes = outcomes.into_inner().unwrap_or_else(PoisonError::into_inner);
    let names = |of: Outcome| -> Vec<&str> {
        outcomes.iter().filter(|(_, outcome)| *outcome == of).map(|(name, _)| *name).collect()
    };
    let (passed, failed, skipped) =
        (names(Outcome::Passed).len(), names(Outcome::Failed), names(Outcome::Skipped));
    print!("\n{passed} of {} steps passed in {:.0} s", count, start.elapsed().as_secs_f64());
    for (what, names) in [("failed", &failed), ("skipped", &skipped)] {
        if !names.is_empty() {
            print!("; {what}: {}", names.join(" "));
        }
    }
    println!();
    Ok(if failed.is_empty() && passed > 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Names of the tools that some of the steps need and this machine does not have.
fn missing(steps: &[Step]) -> Vec<&'static str> {
    let mut needs: Vec<&Need> = steps.iter().flat_map(|step| step.needs).collect();
    needs.sort_by_key(|need| need.name);
    needs.dedup_by_key(|need| need.name);
    needs.into_iter().filter(|need| need.is_missing()).map(|need| need.name).collect()
}

/// Checks core on targets without `std`: for every chip without features, and for one chip of each architecture with all features. The
/// Arm chip is the smallest one, which is the strictest test, because it has neither an FPU nor atomic exchanges. The other chips are
/// not checked with all features, because most of the time is that of the optional dependencies.
fn no_std() -> Result<String> {
    let toolchain = tools::toolchain()?;
    let without = TARGETS.iter().map(|target| (*target, ""));
    let with_all = [M0, RISCV].map(|chip| (chip.target, "--all-features"));
    for (target, features) in without.chain(with_all) {
        let words = format!("check --release --lib --package toytop --target {target} {features}");
        let mut command = toolchain.cargo(".", &words);
        command.arg("--target-dir").arg(firmware::target_dir(toolchain, "core"));
        run(&mut command)?;
    }
    Ok(format!("{} targets without features, {} and {} with all", TARGETS.len(), M0.name, RISCV.name))
}

/// Runs tests, and returns the closing lines of every test binary.
fn cargo_test(words: &str) -> Result<String> {
    let output = run(&mut tests(words))?;
    let closing: Vec<_> = output.lines().filter(|line| line.starts_with("test result:")).collect();
    let count = |label: &str| -> u32 {
        let before = |line: &&str| line.split(label).next()?.split_whitespace().last()?.parse::<u32>().ok();
        closing.iter().filter_map(before).sum()
    };
    let passed = count(" passed");
    if passed == 0 {
        bail!("{output}\nno test ran");
    }
    Ok(format!("{passed} passed, {} ignored\n{}", count(" ignored"), closing.join("\n")))
}

/// Runs every bench once, without regard to times, so that none fails to build. The profile is that of the tests, whose build is shared.
fn benches() -> Result<String> {
    let output = run(&mut tests("--benches"))?;
    let ran = output.matches("\nSuccess").count();
    if ran == 0 {
        bail!("{output}\nno bench ran");
    }
    Ok(format!("{ran} ran once each"))
}

/// Tests the pages of `toytop view` in Chromium, by the binary that the tests have built.
fn browser() -> Result<String> {
    let mut command = tests("--test cli");
    command.args(["--", "--ignored", "--nocapture", "view::browser::"]).env("CHROMIUM", tools::chromium()?);
    let output = run(&mut command)?;
    let remark = |before: &str| output.split_once(before).and_then(|(_, rest)| rest.lines().next());
    match (remark("evaluated by "), remark("from slider to picture in ")) {
        (Some(engines), Some(time)) if output.contains("9 passed") => {
            Ok(format!("{engines}; from slider to picture in {time}"))
        }
        _ => bail!("{output}\nthe tests did not run"),
    }
}

/// Runs `toytop budget --check`, by the binary that the tests have built.
fn budget() -> Result<String> {
    let mut command = tests("--test cli");
    command.args(["--", "--ignored", "--exact", "budget::every_call_is_within_its_budget"]);
    let output = run(&mut command)?;
    if !output.contains("1 passed") {
        bail!("{output}\nthe test did not run");
    }
    Ok("every call on every chip".into())
}

fn docs() -> Result<String> {
    run(cargo(".", "doc --workspace --no-deps --all-features").env("RUSTDOCFLAGS", "-D warnings"))?;
    Ok("no warnings".into())
}
