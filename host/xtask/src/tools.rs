//! Tools that some steps need besides cargo. They are installed before the first step, by rustup, cargo, pip or Debian's packages.

use std::process::Command;
use std::time::Duration;

use anyhow::{Result, bail};
use toytop_chips::chip::Chip;

use crate::process::run_within;

/// Tool with commands of the shell.
#[derive(Clone, Copy)]
pub(crate) struct Tool {
    /// Command that succeeds where the tool is installed. $TARGETS are the targets of the chips, here and in the next one.
    works: &'static str,
    /// Command that installs it.
    install: &'static str,
}

const fn tool(works: &'static str, install: &'static str) -> Tool {
    Tool { works, install }
}

pub(crate) const LINTS: Tool =
    tool("cargo fmt --version && cargo clippy --version", "rustup component add rustfmt clippy");
pub(crate) const CHIPS: Tool = tool(
    "for target in $TARGETS; do test -d $(rustc --print target-libdir --target $target) || exit 1; done",
    "rustup target add $TARGETS",
);
pub(crate) const PAGE: Tool = tool(
    "test -d $(rustc --print target-libdir --target wasm32-unknown-unknown)",
    "rustup target add wasm32-unknown-unknown",
);
pub(crate) const TYPESCRIPT: Tool = tool("tsc --version", "apt-get install node-typescript");
pub(crate) const QEMU: Tool = tool(
    "qemu-system-arm --version && qemu-system-riscv32 --version",
    "apt-get install qemu-system-arm qemu-system-misc",
);
pub(crate) const CHROMIUM: Tool = tool(
    "chromium --version || chromium-browser --version || google-chrome --version",
    "apt-get install chromium",
);
pub(crate) const C: Tool = tool(
    "gcc --version && g++ --version && clang --version && clang++ --version && ld.lld --version && cmake --version && pkg-config --version",
    "apt-get install gcc g++ clang lld cmake pkg-config",
);
pub(crate) const PYTHON: Tool = tool(
    "python3 -c 'import venv, ensurepip, sys; sys.exit(sys.version_info < (3, 10))'",
    "apt-get install python3 python3-venv",
);
pub(crate) const FUZZER: Tool = tool(
    "cargo +nightly fuzz --version",
    "rustup toolchain install nightly --profile minimal && cargo install --locked cargo-fuzz",
);
pub(crate) const HACK: Tool = tool("cargo hack --version", "cargo install --locked cargo-hack");
pub(crate) const COVERAGE: Tool = tool("cargo llvm-cov --version", "cargo install --locked cargo-llvm-cov");

impl Tool {
    /// Installs the tool if it is missing. The error says in one line how to install it.
    pub(crate) fn provide(&self) -> Result<()> {
        let targets = Chip::one_per_target().iter().map(|chip| chip.target).collect::<Vec<_>>().join(" ");
        let [works, install] = [self.works, self.install].map(|script| script.replace("$TARGETS", &targets));
        if succeeds(&works) {
            return Ok(());
        }
        eprintln!("installing: {install}");
        let sudo = "[ $(id -u) = 0 ] || sudo='sudo -n'; $sudo apt-get update && \
                    $sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends";
        if !succeeds(&install.replace("apt-get install", sudo)) || !succeeds(&works) {
            bail!("missing: {install}");
        }
        Ok(())
    }
}

/// Whether a command of the shell succeeds.
fn succeeds(script: &str) -> bool {
    let mut command = Command::new("sh");
    run_within(command.args(["-c", script]), Duration::from_secs(900)).is_ok_and(|ended| ended.success)
}
