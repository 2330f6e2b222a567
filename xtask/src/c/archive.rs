//! Archives of `toytop-c`, in folders by processor core and float ABI.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};

use crate::process::{self, cargo, root, run};
use crate::tools;

/// Folder of an archive, with the settings of the compiler.
struct Archive {
    folder: &'static str,
    /// Target triple; none for the host.
    target: Option<&'static str>,
    /// Name of the processor core, where it schedules better than the target's own.
    cpu: Option<&'static str>,
}

const fn archive(folder: &'static str, target: &'static str, cpu: Option<&'static str>) -> Archive {
    Archive { folder, target: Some(target), cpu }
}

/// All archives. The name contains the float ABI where a processor core has two. With the soft ABI a core does not use its FPU.
const ARCHIVES: &[Archive] = &[
    Archive { folder: "host", target: None, cpu: None },
    archive("cortex-m0plus", "thumbv6m-none-eabi", None),
    archive("cortex-m3", "thumbv7m-none-eabi", None),
    archive("cortex-m4-soft", "thumbv7em-none-eabi", None),
    archive("cortex-m4-hard", "thumbv7em-none-eabihf", Some("cortex-m4")),
    archive("cortex-m7-hard", "thumbv7em-none-eabihf", Some("cortex-m7")),
    archive("cortex-m33-soft", "thumbv8m.main-none-eabi", None),
    archive("cortex-m33-hard", "thumbv8m.main-none-eabihf", None),
    archive("rv32imac", "riscv32imac-unknown-none-elf", None),
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

/// Makes archives, by their folders or by a target triple, with header and CMake files, and returns their paths.
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
    for (from, folder) in [("include/toytop.h", "include"), ("cmake/toytop-config.cmake", "lib/cmake/toytop")]
    {
        copy(&root().join("core/c").join(from), &to.join(folder))?;
    }
    let folders: Vec<_> = chosen.iter().map(|archive| archive.folder).collect();
    Ok(format!("{}: {}", to.display(), folders.join(" ")))
}

impl Archive {
    fn build(&self, to: &Path) -> Result<()> {
        let words = "rustc --package toytop-c --lib --crate-type staticlib --profile c-archive";
        let mut command = match self.target {
            None => cargo(".", words),
            Some(target) => tools::toolchain_for(target)?.cargo(".", &format!("{words} --target {target}")),
        };
        if let Some(cpu) = self.cpu {
            let flags = std::env::var("RUSTFLAGS").unwrap_or_default();
            command.env("RUSTFLAGS", format!("{flags} -C target-cpu={cpu}").trim_start());
        }
        let build = target_dir().join("build");
        run(command.arg("--target-dir").arg(&build).args(["--", "--cfg", "toytop_archive"]))?;
        let built = build.join(self.target.unwrap_or_default()).join("c-archive/libtoytop_c.a");
        let bytes = fs::read(&built).with_context(|| format!("{}", built.display()))?;
        refuse_panics(&bytes)?;
        let folder = to.join("lib").join(self.folder);
        fs::create_dir_all(&folder)?;
        fs::write(folder.join("libtoytop.a"), bytes)?;
        Ok(())
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

fn copy(from: &Path, to: &Path) -> Result<()> {
    fs::create_dir_all(to)?;
    let name = from.file_name().context("a file")?;
    fs::copy(from, to.join(name)).with_context(|| format!("{}", from.display()))?;
    Ok(())
}
