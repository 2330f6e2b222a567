//! Archives of `toytop-c`, in folders by processor core and float ABI.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};

use crate::process::{self, cargo, command, run};

/// Folder of an archive, with the settings of the compiler.
struct Archive {
    folder: &'static str,
    /// Target triple; none for the host.
    target: Option<&'static str>,
    /// Name of the processor core, where it schedules better than the target's own.
    cpu: Option<&'static str>,
    /// Folder in which Arduino looks for it: processor core, then FPU and float ABI.
    arduino: Option<&'static str>,
}

const fn archive(
    folder: &'static str,
    target: &'static str,
    cpu: Option<&'static str>,
    arduino: Option<&'static str>,
) -> Archive {
    Archive { folder, target: Some(target), cpu, arduino }
}

/// All archives. The name contains the float ABI where a processor core has two. With the soft ABI a core does not use its FPU.
const ARCHIVES: &[Archive] = &[
    Archive { folder: "host", target: None, cpu: None, arduino: None },
    archive("cortex-m0plus", "thumbv6m-none-eabi", None, Some("cortex-m0plus")),
    archive("cortex-m3", "thumbv7m-none-eabi", None, Some("cortex-m3")),
    archive("cortex-m4-soft", "thumbv7em-none-eabi", None, Some("cortex-m4")),
    archive("cortex-m4-hard", "thumbv7em-none-eabihf", Some("cortex-m4"), Some("cortex-m4/fpv4-sp-d16-hard")),
    archive("cortex-m7-hard", "thumbv7em-none-eabihf", Some("cortex-m7"), Some("cortex-m7/fpv5-d16-hard")),
    archive("cortex-m33-soft", "thumbv8m.main-none-eabi", None, Some("cortex-m33")),
    archive("cortex-m33-hard", "thumbv8m.main-none-eabihf", None, Some("cortex-m33/fpv5-sp-d16-hard")),
    archive("rv32imac", "riscv32imac-unknown-none-elf", None, None),
];

/// Folder below which everything of this module is built.
pub(super) fn target_dir() -> PathBuf {
    process::target_dir().join("c-archive")
}

/// Prints the folders and their targets.
pub(crate) fn list() {
    for Archive { folder, target, .. } in ARCHIVES {
        println!("{folder:16} {}", target.unwrap_or("this machine"));
    }
}

/// Makes archives, by their folders or by a target triple, with header, CMake files and, but for the host alone, packages, and returns
/// their paths.
pub(crate) fn make(wanted: &str, to: Option<&str>) -> Result<String> {
    let chosen: Vec<_> = ARCHIVES
        .iter()
        .filter(|archive| wanted == "all" || archive.folder == wanted || archive.target == Some(wanted))
        .collect();
    if chosen.is_empty() {
        bail!("--target: {wanted}: must be all, or one that `cargo xtask c-archive --list` lists");
    }
    let to = to.map_or_else(target_dir, PathBuf::from);
    for archive in &chosen {
        archive.build(&to).with_context(|| archive.folder)?;
    }
    fs::create_dir_all(&to)?;
    if wanted == "host" {
        // a prefix of a PC keeps no files of other build systems
        run(command("core/c", "cp -r packages/lib include").arg(&to))?;
    } else {
        run(command("core/c", "cp -r packages/. include").arg(&to))?;
        run(command("core/c", "cp -r include/.").arg(to.join("src")))?;
    }
    let folders: Vec<_> = chosen.iter().map(|archive| archive.folder).collect();
    Ok(format!("{}: {}", to.display(), folders.join(" ")))
}

impl Archive {
    fn build(&self, to: &Path) -> Result<()> {
        let folder = to.join("lib").join(self.folder);
        let archive = self.build_as("staticlib", "libtoytop_c.a")?;
        refuse_panics(&archive)?;
        for folder in
            [Some(folder), self.arduino.map(|folder| to.join("src").join(folder))].into_iter().flatten()
        {
            fs::create_dir_all(&folder)?;
            fs::write(folder.join("libtoytop.a"), &archive)?;
        }
        // apart from the archive, because a linker would prefer it
        if self.target.is_none() && cfg!(target_os = "linux") {
            let folder = to.join("lib/host-shared");
            fs::create_dir_all(&folder)?;
            fs::write(folder.join("libtoytop.so"), self.build_as("cdylib", "libtoytop_c.so")?)?;
        }
        Ok(())
    }

    /// Builds a library of a crate type, and returns its bytes.
    fn build_as(&self, crate_type: &str, file: &str) -> Result<Vec<u8>> {
        let words = format!("rustc --package toytop-c --lib --crate-type {crate_type} --profile c-archive");
        let mut build = cargo(".", &words);
        if let Some(target) = self.target {
            run(&mut command(".", &format!("rustup target add {target}")))?;
            build.args(["--target", target]);
        }
        if let Some(cpu) = self.cpu {
            let flags = std::env::var("RUSTFLAGS").unwrap_or_default();
            build.env("RUSTFLAGS", format!("{flags} -C target-cpu={cpu}").trim_start());
        }
        let folder = target_dir().join("build");
        run(build.arg("--target-dir").arg(&folder).args(["--", "--cfg", "toytop_archive"]))?;
        let built = folder.join(self.target.unwrap_or_default()).join("c-archive").join(file);
        fs::read(&built).with_context(|| format!("{}", built.display()))
    }
}

/// Error for an archive in which a function can reach the panic handler, which then contains the name of the function that the handler
/// calls.
fn refuse_panics(archive: &[u8]) -> Result<()> {
    let has = |name: &[u8]| archive.windows(name.len()).any(|bytes| bytes == name);
    if has(b"toytop_can_panic") {
        bail!("a function of the archive can panic: the archive contains its panic handler");
    }
    if has(b"rust_begin_unwind") || !has(b"toytop_launch") {
        bail!("the archive contains a panic handler, or no toytop_launch");
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use std::fs;

    use crate::process::root;

    #[test]
    fn manifests_have_this_version() {
        let version = env!("CARGO_PKG_VERSION");
        for (manifest, line) in [
            ("idf_component.yml", format!("version: \"{version}\"")),
            ("library.json", format!("\"version\": \"{version}\"")),
            ("library.properties", format!("version={version}\n")),
            ("lib/cmake/toytop/toytop-config-version.cmake", format!("PACKAGE_VERSION {version})")),
        ] {
            let text = fs::read_to_string(root().join("core/c/packages").join(manifest)).expect(manifest);
            assert!(text.contains(&line), "{manifest}: no {line}");
        }
    }
}
