//! Tests of core's examples, and of its package as a crate outside of the repository.

use std::fs;
use std::process::Command;

use anyhow::{Context, Result, bail};

use crate::process::{cargo, root, run, target_dir};

/// Runs each example of core, which ends with assertions, so that its exit code shows whether it is right.
pub(crate) fn examples() -> Result<String> {
    let mut names = Vec::new();
    for entry in fs::read_dir(root().join("core/examples"))? {
        let path = entry?.path();
        let Some(name) = path.file_stem().and_then(|name| name.to_str()) else { continue };
        let output = run(&mut cargo(".", &format!("run --quiet --package toytop --example {name}")))?;
        if output.trim().is_empty() {
            bail!("core/examples/{name}: printed nothing");
        }
        names.push(name.to_owned());
    }
    if names.is_empty() {
        bail!("core/examples: no example found");
    }
    names.sort();
    Ok(names.join(", "))
}

/// Packages core, unpacks the package, and runs its tests without the rest of the repository.
pub(crate) fn check() -> Result<String> {
    let folder = target_dir().join("package");
    run(&mut cargo(".", "package --package toytop --no-verify --allow-dirty"))?;
    let name = format!("toytop-{}", env!("CARGO_PKG_VERSION"));
    let unpacked = folder.join(&name);
    if unpacked.exists() {
        fs::remove_dir_all(&unpacked)?;
    }
    run(Command::new("tar").arg("xzf").arg(folder.join(format!("{name}.crate"))).arg("-C").arg(&folder))?;
    for file in ["LICENSE-MIT", "LICENSE-APACHE", "README.md"] {
        if !unpacked.join(file).is_file() {
            bail!("the package of core lacks {file}");
        }
    }
    // the package is a workspace of its own, although it is in a folder of this one
    let manifest = unpacked.join("Cargo.toml");
    let text = fs::read_to_string(&manifest).with_context(|| format!("{}", manifest.display()))?;
    fs::write(&manifest, text + "\n[workspace]\n")?;
    let mut test = Command::new("cargo");
    test.current_dir(&unpacked)
        .args(["test", "--locked", "--all-features", "--lib", "--examples"])
        .env("CARGO_TARGET_DIR", folder.join("build"))
        .env("CARGO_PROFILE_TEST_DEBUG", "0");
    let output = run(&mut test)?;
    let Some(line) = output.lines().find(|line| line.starts_with("test result: ok.")) else {
        bail!("{output}\nno test ran");
    };
    Ok(format!("{name}: {}", line.trim_start_matches("test result: ok. ")))
}
