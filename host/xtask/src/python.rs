//! Builds of the Python package by maturin, and its tests in a virtual environment below `target`.

use std::fs;
use std::path::PathBuf;
use std::process::Command;

use anyhow::{Context, Result, bail};

use crate::process::{command, root, run, target_dir};

const FOLDER: &str = "host/python";
/// Python packages that build and test the package.
const TOOLS: &str = "maturin>=1.9,<2 numpy scipy>=1.12 pytest>=8 mypy>=1.15";
/// Further Python packages of the computing times, and of the tests of the notebooks and the recipes.
const MORE: &str = "heyoka>=7 matplotlib dask pyarrow polars pandas ray";
/// Largest wheel, bytes.
const LARGEST_WHEEL: u64 = 1_500_000;

/// Builds the package without link-time optimisation, which takes a third of the time, and runs all tests except of times.
pub(crate) fn check() -> Result<String> {
    provide(TOOLS)?;
    install("quick")?;
    tested()
}

/// Runs the tests of [`check`] with the release build of the wheel, and checks its size and the computing times. The tests run the notebooks and
/// the recipes too, whose libraries are installed.
pub(crate) fn full() -> Result<String> {
    provide(&format!("{TOOLS} {MORE}"))?;
    let wheel = install("release")?;
    let size = fs::metadata(&wheel)?.len();
    if size > LARGEST_WHEEL {
        bail!("{}: {size} bytes; must be at most {LARGEST_WHEEL}", wheel.display());
    }
    let tested = tested()?;
    run(python("timings.py").current_dir(root().join(FOLDER)))?;
    Ok(format!("wheel of {size} bytes; {tested}; computing times ran"))
}

/// Folder of the environment and the builds.
fn target() -> PathBuf {
    target_dir().join("python")
}

/// Command that runs the Python of the environment.
fn python(words: &str) -> Command {
    let program = if cfg!(windows) { "Scripts/python" } else { "bin/python" };
    let environment = target().join("venv");
    let mut python = Command::new(environment.join(program));
    python.args(words.split_whitespace()).current_dir(root());
    python.env("CARGO_TARGET_DIR", target()).env("VIRTUAL_ENV", environment);
    python
}

/// Makes the environment with these packages.
fn provide(packages: &str) -> Result<()> {
    if run(&mut python("--version")).is_err() {
        run(command(".", "python3 -m venv --clear").arg(target().join("venv")))?;
    }
    let install = format!("-m pip install --quiet --disable-pip-version-check {packages}");
    run(&mut python(&install)).map(drop)
}

/// Builds the wheel in a profile, installs it and returns its path.
fn install(profile: &str) -> Result<PathBuf> {
    let wheels = target().join("wheels").join(profile);
    if wheels.exists() {
        fs::remove_dir_all(&wheels)?;
    }
    let mut build = python(&format!("-m maturin build --profile {profile} --locked --out"));
    run(build.arg(&wheels).current_dir(root().join(FOLDER)))?;
    let wheel = fs::read_dir(&wheels)?.next().context("maturin wrote no wheel")??.path();
    run(python("-m pip install --quiet --force-reinstall --no-deps").arg(&wheel))?;
    Ok(wheel)
}

/// Runs the tests, and checks types and stubs.
fn tested() -> Result<String> {
    let folder = root().join(FOLDER);
    let output = run(python("-m pytest").current_dir(&folder))?;
    run(python("-m mypy").current_dir(&folder))?;
    // in another folder than the sources, so that the installed package is tested
    run(python("-m mypy.stubtest toytop").current_dir(target()))?;
    let passed = output.lines().rfind(|line| line.contains(" passed")).context("no test ran")?;
    Ok(format!("{}; types and stubs agree", passed.trim_matches('=').trim()))
}
