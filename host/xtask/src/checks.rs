//! Checks of the host's crates, most of which are one command.

use std::fs;
use std::path::PathBuf;
use std::process::Command;
use std::time::Duration;

use anyhow::{Context, Result, bail};
use toytop_chips::chip::{M0, M4F, M7, RISCV};

use crate::firmware::all_on;
use crate::process::{cargo, command, firmware_target_dir, root, run, run_within, target_dir};

/// Folders with a workspace of their own.
const WORKSPACES: [&str; 4] = [".", "firmware-examples", "host/python", "tests/fuzz"];

/// Runs a command that must succeed, and has no remark.
fn passes(command: &mut Command) -> Result<String> {
    run(command).map(|_| String::new())
}

/// Checks the form of every workspace.
pub(crate) fn fmt() -> Result<String> {
    for folder in WORKSPACES {
        run(&mut command(folder, "cargo fmt --all --check"))?;
    }
    Ok(String::new())
}

/// Runs clippy on the crates for the host.
pub(crate) fn clippy() -> Result<String> {
    clippy_with(cargo(".", "clippy --workspace --all-targets --all-features"))?;
    let python = cargo("host/python", "clippy --all-targets");
    clippy_with(with_target_dir(python, target_dir()))?;
    // the default features of a crate alone; the workspace's would add the features of its other crates
    for package in ["toytop", "toytop-closed-forms", "toytop-fit"] {
        clippy_with(cargo(".", &format!("clippy --lib --package {package}")))?;
    }
    Ok(String::new())
}

/// Runs clippy on the programs for the chips.
pub(crate) fn clippy_firmware() -> Result<String> {
    let in_firmware =
        |words: &str| clippy_with(with_target_dir(cargo("firmware-examples", words), firmware_target_dir()));
    in_firmware("clippy --package toytop-firmware-decoder")?;
    for chip in [M4F, M7, RISCV] {
        in_firmware(&format!("clippy --release --target {} --lib {}", chip.target, all_on(&chip)))?;
    }
    in_firmware(&format!(
        "clippy --release --target {} --workspace --exclude toytop-firmware-decoder \
         --exclude toytop-firmware-examples --features toytop-cost/dwt",
        M4F.target
    ))?;
    Ok(String::new())
}

fn clippy_with(mut clippy: Command) -> Result<()> {
    run(clippy.args(["--", "-D", "warnings"])).map(drop)
}

fn with_target_dir(mut command: Command, folder: PathBuf) -> Command {
    command.arg("--target-dir").arg(folder);
    command
}

/// Checks the scripts of the page and of its tests by TypeScript's compiler, joined as on a page: names, types, arguments, and that nothing is
/// unused.
pub(crate) fn scripts() -> Result<String> {
    let read =
        |file: &str| fs::read_to_string(root().join("host").join(file)).with_context(|| file.to_owned());
    let page = read("page/view/page.html")?;
    let mut joined = String::new();
    for file in page.split("<script src=\"").skip(1).filter_map(|rest| rest.split('"').next()) {
        joined += &read(&format!("page/view/{file}"))?;
    }
    for file in ["probes.js", "controls.js"] {
        joined += &read(&format!("tests/cli/pictures/view/browser/{file}"))?;
    }
    // what the tests call
    joined += "export { ready, operate, moveSliders, restored, visit, describe, shownAt };\n";
    let path = target_dir().join("scripts.js");
    fs::write(&path, joined)?;
    let options = "tsc --noEmit --allowJs --checkJs --target es2022 --noUnusedLocals --noUnusedParameters";
    passes(command(".", options).arg(path))
}

/// Runs all tests and core's examples, and returns the closing line of every test binary.
pub(crate) fn tests() -> Result<String> {
    let output = run(&mut cargo(".", "test --workspace --lib --bins --tests"))?;
    let closing: Vec<_> = output.lines().filter(|line| line.starts_with("test result: ok")).collect();
    if closing.len() < 5 {
        bail!("{output}\ntoo few tests ran");
    }
    Ok(format!("\n{}\nexamples: {}", closing.join("\n"), examples()?))
}

/// Runs core's examples, which end with assertions.
fn examples() -> Result<String> {
    run(&mut cargo(".", "build --workspace --profile test --examples"))?;
    let mut names = Vec::new();
    for entry in fs::read_dir(root().join("core/examples"))? {
        let path = entry?.path();
        let name = path.file_stem().context("a file")?.to_string_lossy().into_owned();
        let output = run(&mut Command::new(target_dir().join("debug/examples").join(&name)))?;
        if output.trim().is_empty() {
            bail!("{}: printed nothing", path.display());
        }
        names.push(name);
    }
    names.sort();
    Ok(names.join(" "))
}

/// Tests the examples in the documentation.
pub(crate) fn doctests() -> Result<String> {
    passes(&mut cargo(".", "test --workspace --doc"))
}

/// Builds the documentation of the libraries without a broken link, that of core's crates as its public site does, with the features of
/// each item.
pub(crate) fn docs() -> Result<String> {
    let others =
        "doc --package toytop-c --package toytop-chips --package toytop-host --no-deps --all-features";
    run(cargo(".", others).env("RUSTDOCFLAGS", "-D warnings"))?;
    let core =
        "doc --package toytop --package toytop-closed-forms --package toytop-fit --no-deps --all-features";
    // in a folder of its own, because a change of RUSTC_BOOTSTRAP builds proc-macro2 and all that depends on it anew
    let mut core = with_target_dir(cargo(".", core), target_dir().join("docs"));
    // `doc_cfg`, which labels an item with its feature, is not stable
    core.env("RUSTC_BOOTSTRAP", "1");
    passes(core.env("RUSTDOCFLAGS", "-D warnings --cfg docsrs"))
}

/// Tests the pages of `toytop view` in Chromium, by the binary that the tests have built.
pub(crate) fn browser() -> Result<String> {
    let mut test = cargo(".", "test --workspace --test cli -- --ignored --nocapture view::browser::");
    let output = run(&mut test)?;
    // packages without such tests have a result of none
    let mut results = output.lines().filter(|line| line.starts_with("test result: ok"));
    let result = results.find(|line| !line.contains(" 0 passed"));
    result.map(str::to_owned).with_context(|| format!("{output}\nno test ran"))
}

/// Path of the program `toytop` as the tests build it.
pub(crate) fn program() -> Result<PathBuf> {
    run(&mut cargo(".", "test --workspace --test cli --no-run"))?;
    Ok(target_dir().join("debug/toytop"))
}

fn budget_of(chips: &str) -> Result<String> {
    let mut budget = Command::new(program()?);
    passes(budget.current_dir(root()).args(["budget", "--check"]).args(chips.split_whitespace()))
}

/// Compares the cost of every call with its budget, on the two chips whose cycles have a model.
pub(crate) fn budget() -> Result<String> {
    budget_of("--chip m0plus --chip m4f")
}

/// Compares the cost of every call with its budget on all chips.
pub(crate) fn budget_on_all() -> Result<String> {
    budget_of("")
}

/// Builds core with every set of its features, for the smallest chip, and the suite without the host's crate.
pub(crate) fn features() -> Result<String> {
    run(&mut cargo(".", "check --package toytop-tests --no-default-features --tests"))?;
    let words = "hack check --package toytop --package toytop-closed-forms --package toytop-fit --lib --feature-powerset --target";
    passes(cargo(".", words).arg(M0.target).env("RUSTFLAGS", "-D warnings"))
}

/// Packages the crates that are published, and builds them from their packages.
pub(crate) fn package() -> Result<String> {
    let words = "package --allow-dirty --package toytop --package toytop-closed-forms --package toytop-fit";
    passes(&mut cargo(".", words))
}

/// Measures the lines that the tests of core execute; at least 95 of 100 must be. The names of defmt's symbols would not link with the page.
pub(crate) fn coverage() -> Result<String> {
    let words = "llvm-cov --package toytop --package toytop-closed-forms --package toytop-fit --package toytop-tests --features toytop/fixed,toytop/nalgebra --lib --test suite \
                 --summary-only --fail-under-lines 95";
    let output = run(&mut cargo(".", words))?;
    Ok(output.lines().rfind(|line| line.starts_with("TOTAL")).unwrap_or_default().to_owned())
}

/// Targets of the fuzzer in tests/fuzz that search core.
const TARGETS: [&str; 3] = ["launch", "table", "fixed"];

/// Searches with each target for ten seconds, from the seeds.
pub(crate) fn fuzz() -> Result<String> {
    let fuzz = "cargo +nightly fuzz run --sanitizer none --fuzz-dir tests/fuzz";
    for target in TARGETS {
        let corpus = root().join("tests/fuzz/target/corpus").join(target);
        fs::create_dir_all(&corpus)?;
        let mut search = command(".", &format!("{fuzz} {target}"));
        search.arg(&corpus).arg(format!("tests/fuzz/seeds/{target}"));
        search.args(["--", "-max_total_time=10", "-timeout=60", "-max_len=400", "-len_control=0", "-seed=1"]);
        let ended = run_within(&mut search, Duration::from_secs(900))?;
        if !ended.success {
            bail!("{}\n{target}: the file named above repeats it", ended.output.trim_end());
        }
    }
    Ok(TARGETS.join(" "))
}
