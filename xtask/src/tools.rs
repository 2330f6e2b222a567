//! Tools for cross compilation, emulation and browsers, which are found, installed, or named in one line.

use std::path::Path;
use std::process::Command;
use std::sync::OnceLock;
use std::time::Duration;

use anyhow::{Context, Result, bail};

use crate::chip::TARGETS;
use crate::process::{self, Ended, run_within};

/// Compiler that can build for the chips, or for a page.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Toolchain {
    /// Compiler of this program, with the added targets.
    Own,
    /// Compiler of Debian's packages, which contain the sources of the standard library, for machines where rustup cannot reach its server.
    Debian,
}

/// Target of the core in a page.
pub(crate) const PAGE_TARGET: &str = "wasm32-unknown-unknown";

const DEBIAN_PACKAGES: &str = "rustc-web cargo-web rust-web-src rust-web-llvm rust-web-clippy lld-22";
const QEMU_PACKAGES: &str = "qemu-system-arm qemu-system-misc";
const C_PACKAGES: &str = "gcc g++ clang lld cmake";
const CHROMIUM_PACKAGE: &str = "chromium";

impl Toolchain {
    /// Command that runs cargo for a target without `std`, in a folder of the repository.
    pub(crate) fn cargo(self, folder: &str, words: &str) -> Command {
        let mut command = process::cargo(folder, words);
        if self == Self::Debian {
            let mut debian = Command::new("/usr/bin/cargo");
            debian.current_dir(process::root().join(folder)).args(command.get_args());
            debian.env("RUSTC_BOOTSTRAP", "1").env("CARGO_UNSTABLE_BUILD_STD", "core");
            debian.env("RUSTC", "/usr/bin/rustc").env("RUSTDOC", "/usr/bin/rustdoc");
            debian.env("PATH", format!("/usr/bin:{}", std::env::var("PATH").unwrap_or_default()));
            for variable in ["RUSTUP_TOOLCHAIN", "LD_LIBRARY_PATH", "CARGO", "RUSTC_WRAPPER"] {
                debian.env_remove(variable);
            }
            command = debian;
        }
        command
    }

    /// Target folder, which two compilers must not share.
    pub(crate) fn subfolder(self) -> &'static str {
        match self {
            Self::Own => "",
            Self::Debian => "debian",
        }
    }
}

/// Toolchain for all [`TARGETS`]. The first call installs it if it is missing.
pub(crate) fn toolchain() -> Result<Toolchain> {
    static FOUND: OnceLock<Option<Toolchain>> = OnceLock::new();
    match FOUND.get_or_init(|| find_toolchain(TARGETS)) {
        Some(toolchain) => Ok(*toolchain),
        None => bail!("to build for the chips: rustup target add {}", TARGETS.join(" ")),
    }
}

/// Toolchain for another target, which is installed if it is missing.
pub(crate) fn toolchain_for(target: &'static str) -> Result<Toolchain> {
    find_toolchain(&[target]).with_context(|| format!("to build for {target}: rustup target add {target}"))
}

/// Toolchain for the pages of `toytop view`. The first call installs it if it is missing.
pub(crate) fn page_toolchain() -> Result<Toolchain> {
    static FOUND: OnceLock<Option<Toolchain>> = OnceLock::new();
    match FOUND.get_or_init(|| find_toolchain(&[PAGE_TARGET])) {
        Some(toolchain) => Ok(*toolchain),
        None => bail!("to build the pages of `toytop view`: rustup target add {PAGE_TARGET}"),
    }
}

/// Whether an installed toolchain can build for all [`TARGETS`].
pub(crate) fn toolchain_is_there() -> bool {
    can_build(TARGETS)
}

/// Whether an installed toolchain can build the pages of `toytop view`.
pub(crate) fn page_toolchain_is_there() -> bool {
    can_build(&[PAGE_TARGET])
}

fn can_build(targets: &[&str]) -> bool {
    missing(targets).is_empty() || debian_is_complete()
}

fn find_toolchain(targets: &[&str]) -> Option<Toolchain> {
    if missing(targets).is_empty() {
        return Some(Toolchain::Own);
    }
    let mut rustup = Command::new("rustup");
    rustup.args(["target", "add"]).args(missing(targets));
    let added = attempt(&mut rustup, 180);
    if missing(targets).is_empty() {
        return Some(Toolchain::Own);
    }
    if let Some(Ended { success: false, output }) = added {
        let reason = output.lines().find(|line| line.starts_with("error")).unwrap_or_default();
        eprintln!("rustup cannot add the targets: {reason}");
    }
    if !debian_is_complete() {
        apt_install(DEBIAN_PACKAGES);
    }
    debian_is_complete().then(|| {
        eprintln!("building for {} with Debian's Rust packages", targets.join(" "));
        Toolchain::Debian
    })
}

fn missing<'a>(targets: &[&'a str]) -> Vec<&'a str> {
    let installed = |target: &str| {
        let found = attempt(Command::new("rustc").args(["--print", "target-libdir", "--target", target]), 60);
        found.is_some_and(|ended| ended.success && Path::new(ended.output.trim()).exists())
    };
    targets.iter().copied().filter(|target| !installed(target)).collect()
}

/// Whether Debian's packages are installed: compiler and clippy, linker, and the sources of `core`.
fn debian_is_complete() -> bool {
    let mut rustc = Command::new("/usr/bin/rustc");
    rustc.args(["--print", "sysroot"]).env_remove("LD_LIBRARY_PATH");
    let sources =
        |sysroot: &str| Path::new(sysroot.trim()).join("lib/rustlib/src/rust/library/core").exists();
    ["/usr/bin/cargo", "/usr/bin/cargo-clippy", "/usr/bin/rust-lld"]
        .iter()
        .all(|path| Path::new(path).exists())
        && attempt(&mut rustc, 60).is_some_and(|ended| sources(&ended.output))
}

/// Whether QEMU is installed for both architectures.
pub(crate) fn qemu_is_there() -> bool {
    works("qemu-system-arm") && works("qemu-system-riscv32")
}

/// Installs QEMU for both architectures if it is missing.
pub(crate) fn qemu() -> Result<()> {
    static FOUND: OnceLock<bool> = OnceLock::new();
    let found = *FOUND.get_or_init(|| {
        qemu_is_there() || {
            apt_install(QEMU_PACKAGES);
            qemu_is_there()
        }
    });
    if !found {
        bail!("to emulate the chips: install QEMU (apt-get install {QEMU_PACKAGES}; brew install qemu)");
    }
    Ok(())
}

/// Programs for C: compilers of C and C++, the linker for chips, and CMake.
const C_PROGRAMS: [&str; 6] = ["gcc", "g++", "clang", "clang++", "ld.lld", "cmake"];

/// Whether the tools for C are installed.
pub(crate) fn c_is_there() -> bool {
    C_PROGRAMS.into_iter().all(works)
}

/// Installs the tools for C if they are missing.
pub(crate) fn c() -> Result<()> {
    if !c_is_there() {
        apt_install(C_PACKAGES);
    }
    let missing: Vec<_> = C_PROGRAMS.into_iter().filter(|program| !works(program)).collect();
    if !missing.is_empty() {
        bail!("to test in C: {} missing (apt-get install {C_PACKAGES})", missing.join(", "));
    }
    Ok(())
}

/// Name of an installed Chromium.
pub(crate) fn any_chromium() -> Option<&'static str> {
    ["chromium", "chromium-browser", "google-chrome"].into_iter().find(|program| works(program))
}

/// Name of a Chromium, which is installed if it is missing.
pub(crate) fn chromium() -> Result<&'static str> {
    static FOUND: OnceLock<Option<&'static str>> = OnceLock::new();
    let found = FOUND.get_or_init(|| {
        any_chromium().or_else(|| {
            apt_install(CHROMIUM_PACKAGE);
            any_chromium()
        })
    });
    match found {
        Some(program) => Ok(program),
        None => {
            bail!("to test the page of `toytop view`: install Chromium (apt-get install {CHROMIUM_PACKAGE})")
        }
    }
}

/// Installs Debian packages, for root only. Success is checked by the presence of the programs.
fn apt_install(packages: &str) {
    let root = attempt(Command::new("id").arg("-u"), 30).is_some_and(|ended| ended.output.trim() == "0");
    if !root || attempt(Command::new("apt-get").arg("--version"), 30).is_none() {
        return;
    }
    eprintln!("installing {packages}");
    attempt(Command::new("apt-get").arg("update"), 180);
    let mut install = Command::new("apt-get");
    install.args(["install", "-y", "--no-install-recommends"]).args(packages.split(' '));
    install.env("DEBIAN_FRONTEND", "noninteractive");
    if let Some(Ended { success: false, output }) = attempt(&mut install, 600) {
        eprintln!("{}", output.trim_end());
    }
}

/// Whether a program is installed and prints its version.
fn works(program: &str) -> bool {
    attempt(Command::new(program).arg("--version"), 60).is_some_and(|ended| ended.success)
}

/// Result of a command; `None` if it is missing or exceeds the time limit.
fn attempt(command: &mut Command, seconds: u64) -> Option<Ended> {
    run_within(command, Duration::from_secs(seconds)).ok()
}
