//! `cargo xtask python`: build of the Python package by maturin, and its tests in a virtual environment below `target`.

use std::fs;
use std::path::PathBuf;
use std::process::Command;
use std::time::Duration;

use anyhow::{Context, Result, bail};

use crate::process::{cargo, root, run, run_within};

const FOLDER: &str = "host/python";

/// Python packages that build and test the package.
const TOOLS: &[&str] = &["maturin>=1.9,<2", "numpy", "scipy>=1.12", "pytest>=8", "mypy>=1.15"];
/// Further Python packages of the figures and the notebooks.
const MORE: &[&str] =
    &["heyoka>=7", "matplotlib", "dask[array]", "pyarrow", "ipykernel", "nbclient", "nbconvert"];

/// Largest wheel, bytes.
const LARGEST_WHEEL: u64 = 1_500_000;

/// Builds the package without link-time optimisation, which takes a third of the time, and runs all tests except those of times. Without
/// Python or a package index, the result is only a remark.
pub(crate) fn check() -> Result<String> {
    let Some(environment) = Environment::provided(TOOLS)? else {
        return Ok("not run: needs Python 3.10 with venv, and a package index that pip can reach".into());
    };
    run(cargo(FOLDER, "clippy --profile quick --all-targets")
        .args(["--", "-D", "warnings"])
        .env("CARGO_TARGET_DIR", target()))?;
    environment.install("quick")?;
    environment.tested()
}

/// Runs the tests of [`check`] with the release build of the wheel, and checks its size, the figures and the notebooks.
pub(crate) fn full() -> Result<()> {
    let Some(environment) = Environment::provided(TOOLS)? else {
        bail!("needs Python 3.10 with venv, and a package index that pip can reach");
    };
    environment.pip(MORE)?;
    let wheel = environment.install("release")?;
    let size = fs::metadata(&wheel)?.len();
    if size > LARGEST_WHEEL {
        bail!("{}: {size} bytes; must be at most {LARGEST_WHEEL}", wheel.display());
    }
    println!("wheel of {size} bytes; {}", environment.tested()?);
    print!("{}", run(environment.python(&["figures.py"]).current_dir(root().join(FOLDER)))?);
    let mut notebooks: Vec<_> =
        fs::read_dir(root().join(FOLDER).join("notebooks"))?.collect::<Result<_, _>>()?;
    notebooks.sort_by_key(fs::DirEntry::file_name);
    for notebook in notebooks.iter().map(fs::DirEntry::path) {
        if notebook.extension().is_some_and(|ending| ending == "ipynb") {
            let mut execute =
                environment.python(&["-m", "nbconvert", "--to", "notebook", "--execute", "--output-dir"]);
            run(execute.arg(target().join("notebooks")).arg(&notebook))?;
            println!("{} ran", notebook.display());
        }
    }
    Ok(())
}

/// Folder of the environment and the builds.
fn target() -> PathBuf {
    root().join("target/python")
}

/// Virtual environment with the tools in it.
struct Environment(PathBuf);

impl Environment {
    /// Environment with these packages; `None` where Python or the package index is missing.
    fn provided(packages: &[&str]) -> Result<Option<Self>> {
        const LIMIT: Duration = Duration::from_secs(600);
        let environment = Self(target().join("venv"));
        let works = "import venv, ensurepip, sys; sys.exit(sys.version_info < (3, 10))";
        let succeeds = |command: &mut Command| run_within(command, LIMIT).is_ok_and(|ended| ended.success);
        if !succeeds(Command::new("python3").args(["-c", works])) {
            return Ok(None);
        }
        if !succeeds(&mut environment.python(&["--version"])) {
            run(Command::new("python3").args(["-m", "venv", "--clear"]).arg(&environment.0))?;
        }
        Ok(succeeds(&mut environment.pip_install(packages)).then_some(environment))
    }

    /// Command that runs the Python of this environment.
    fn python(&self, words: &[&str]) -> Command {
        let folder = if cfg!(windows) { "Scripts" } else { "bin" };
        let mut command = Command::new(self.0.join(folder).join("python"));
        command.args(words).env("CARGO_TARGET_DIR", target()).env("VIRTUAL_ENV", &self.0);
        command
    }

    fn pip_install(&self, packages: &[&str]) -> Command {
        let mut command = self.python(&["-m", "pip", "install", "--quiet", "--disable-pip-version-check"]);
        command.args(packages);
        command
    }

    fn pip(&self, packages: &[&str]) -> Result<()> {
        run(&mut self.pip_install(packages)).map(drop)
    }

    /// Builds the wheel in a profile and installs it.
    fn install(&self, profile: &str) -> Result<PathBuf> {
        let wheels = target().join("wheels").join(profile);
        if wheels.exists() {
            fs::remove_dir_all(&wheels)?;
        }
        let mut build = self.python(&["-m", "maturin", "build", "--profile", profile, "--locked", "--out"]);
        run(build.arg(&wheels).current_dir(root().join(FOLDER)))?;
        let wheel = fs::read_dir(&wheels)?.next().context("maturin wrote no wheel")??.path();
        let path = wheel.to_string_lossy().into_owned();
        self.pip(&["--force-reinstall", "--no-deps", &path])?;
        Ok(wheel)
    }

    /// Runs the tests, and checks types and stubs.
    fn tested(&self) -> Result<String> {
        let folder = root().join(FOLDER);
        let output = run(self.python(&["-m", "pytest"]).current_dir(&folder))?;
        let passed = output.lines().rfind(|line| line.contains(" passed")).unwrap_or_default().to_owned();
        run(self.python(&["-m", "mypy"]).current_dir(&folder))?;
        // in another folder than the sources, so that the installed package is tested
        run(self.python(&["-m", "mypy.stubtest", "toytop"]).current_dir(target()))?;
        if passed.is_empty() {
            bail!("{output}\nno test ran");
        }
        Ok(format!("{}; types and stubs agree", passed.trim_matches('=').trim()))
    }
}
