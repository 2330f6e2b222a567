//! Build of the core as WebAssembly, which `host/build.rs` puts into every page of `toytop view`.

use std::fs;
use std::path::PathBuf;
use std::process::Command;

use anyhow::{Result, bail};

use crate::process::{run, target_dir};
use crate::tools::{self, PAGE_TARGET, Toolchain};

/// Greatest size, bytes: a page of 400 KB contains it in base 64, beside the scripts.
const MOST: u64 = 200_000;

/// Builds the core, and returns its size as text.
pub(crate) fn check() -> Result<String> {
    let toolchain = tools::page_toolchain()?;
    let file = file_of(toolchain);
    let words = format!("build --package toytop-page --profile page --target {PAGE_TARGET}");
    let mut command = toolchain.cargo(".", &words);
    run(command.arg("--target-dir").arg(folder_of(toolchain)))?;
    let bytes = fs::metadata(&file)?.len();
    if bytes > MOST {
        bail!("{}: {bytes} bytes, more than {MOST}", file.display());
    }
    Ok(format!("{bytes} bytes of WebAssembly"))
}

/// Command that builds the host, with the path of the core if the compiler of the host cannot build it.
pub(crate) fn with_core(mut command: Command) -> Command {
    let file = file_of(Toolchain::Debian);
    if file.exists() && matches!(tools::page_toolchain(), Ok(Toolchain::Debian)) {
        command.env("TOYTOP_PAGE_WASM", file);
    }
    command
}

/// Folder that the compiler shares with `host/build.rs`.
fn folder_of(toolchain: Toolchain) -> PathBuf {
    target_dir().join("page").join(toolchain.subfolder())
}

fn file_of(toolchain: Toolchain) -> PathBuf {
    folder_of(toolchain).join(PAGE_TARGET).join("page/toytop_page.wasm")
}
