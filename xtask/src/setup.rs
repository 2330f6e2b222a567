//! `cargo xtask setup`: installs the tools of the tests, and prints the result for each of them.

use std::process::{Command, ExitCode};
use std::time::Duration;

use anyhow::{Result, bail};

use crate::process::run_within;
use crate::subcommand::{is_there, nightly_is_there, provide};
use crate::tools;

/// Tool that some test needs besides cargo.
pub(crate) struct Need {
    pub(crate) name: &'static str,
    is_there: fn() -> bool,
    /// Installs the tool if this machine allows it; the error states how to install it by hand.
    bring: fn() -> Result<()>,
}

pub(crate) const LINTS: Need =
    Need { name: "rustfmt and clippy", is_there: lints_are_there, bring: bring_lints };
pub(crate) const COMPILER: Need = Need {
    name: "compiler for the chips",
    is_there: tools::toolchain_is_there,
    bring: || tools::toolchain().map(drop),
};
pub(crate) const PAGE_COMPILER: Need = Need {
    name: "compiler for pages",
    is_there: tools::page_toolchain_is_there,
    bring: || tools::page_toolchain().map(drop),
};
pub(crate) const EMULATOR: Need = Need { name: "QEMU", is_there: tools::qemu_is_there, bring: tools::qemu };
pub(crate) const BROWSER: Need = Need {
    name: "Chromium",
    is_there: || tools::any_chromium().is_some(),
    bring: || tools::chromium().map(drop),
};
pub(crate) const C: Need = Need { name: "tools for C", is_there: tools::c_is_there, bring: tools::c };
const NIGHTLY: Need = Need { name: "nightly compiler", is_there: nightly_is_there, bring: bring_nightly };
const FUZZER: Need = Need { name: "cargo-fuzz", is_there: || is_there("fuzz"), bring: || provide("fuzz") };

/// All tools of the tests. Only the step `fuzz` uses the last two, and runs nothing without them.
const ALL: [Need; 8] = [LINTS, COMPILER, PAGE_COMPILER, EMULATOR, BROWSER, C, NIGHTLY, FUZZER];

impl Need {
    pub(crate) fn is_missing(&self) -> bool {
        !(self.is_there)()
    }

    /// Installs the tool if it is missing; the error states in one line how it is installed.
    pub(crate) fn provide(&self) -> Result<()> {
        (self.bring)()
    }
}

/// Installs all missing tools, and prints a line for each tool.
pub(crate) fn setup() -> Result<ExitCode> {
    let mut code = ExitCode::SUCCESS;
    for need in &ALL {
        let said = match need.is_missing() {
            false => "is there".to_owned(),
            true => match need.provide() {
                Ok(()) => "installed".to_owned(),
                Err(reason) => {
                    code = ExitCode::FAILURE;
                    format!("MISSING: {}", format!("{reason:#}").lines().last().unwrap_or_default())
                }
            },
        };
        println!("{:24}{said}", need.name);
    }
    Ok(code)
}

fn lints_are_there() -> bool {
    is_there("fmt") && is_there("clippy")
}

fn bring_lints() -> Result<()> {
    rustup(&["component", "add", "rustfmt", "clippy"]);
    if !lints_are_there() {
        bail!("to check form and lints: rustup component add rustfmt clippy");
    }
    Ok(())
}

fn bring_nightly() -> Result<()> {
    rustup(&["toolchain", "install", "nightly", "--profile", "minimal"]);
    if !nightly_is_there() {
        bail!("to search with the fuzzer: rustup toolchain install nightly");
    }
    Ok(())
}

/// Runs rustup. Its success is checked by the presence of the tool.
fn rustup(words: &[&str]) {
    let _ = run_within(Command::new("rustup").args(words), Duration::from_secs(600));
}
