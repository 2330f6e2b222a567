//! Compiles the core to WebAssembly for the pages of `toytop view`, where the compiler has that target.
//!
//! Without it the program is built without pages.

use std::env::{self, var_os};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

const TARGET: &str = "wasm32-unknown-unknown";
/// Environment variables of cargo for the build of the program, which must not affect that of the page.
const VARIABLES_OF_PROGRAM: [&str; 6] = [
    "RUSTFLAGS",
    "CARGO_ENCODED_RUSTFLAGS",
    "CARGO_BUILD_TARGET",
    "CARGO_TARGET_DIR",
    "RUSTC_WRAPPER",
    "RUSTC_WORKSPACE_WRAPPER",
];

fn main() {
    let sources = ["../core/src", "../core/closed-forms/src", "model", "page"];
    let manifests =
        ["../Cargo.toml", "../Cargo.lock", "../core/Cargo.toml", "../core/closed-forms/Cargo.toml"];
    for input in sources.into_iter().chain(manifests) {
        println!("cargo:rerun-if-changed={input}");
    }
    let bytes = if has_target() { fs::read(compiled()).expect("the compiled core") } else { Vec::new() };
    fs::write(out_dir().join("core.wasm"), bytes).expect("the folder of build output is writable");
}

fn out_dir() -> PathBuf {
    var_os("OUT_DIR").expect("cargo sets OUT_DIR").into()
}

/// Whether the compiler has its standard library for WebAssembly.
fn has_target() -> bool {
    let rustc = var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let output = Command::new(rustc).args(["--print", "target-libdir", "--target", TARGET]).output();
    let text = output.map_or(String::new(), |output| String::from_utf8_lossy(&output.stdout).into_owned());
    // the folder lib/rustlib/TARGET/lib, and rustup's list of targets, which changes when one is added
    let folder = Path::new(text.trim());
    if let Some(list) = folder.ancestors().nth(2).map(|rustlib| rustlib.join("components"))
        && list.exists()
    {
        println!("cargo:rerun-if-changed={}", list.display());
    }
    folder.exists()
}

/// Path of the compiled core, in a folder that all profiles share.
fn compiled() -> PathBuf {
    // target/PROFILE/build/PACKAGE/out
    let out = out_dir();
    let target = out.ancestors().nth(4).map_or(out.join("page"), |target| target.join("page"));
    let mut cargo = Command::new(var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    // the dependencies have been fetched for the program itself
    cargo.args(["build", "--package", "toytop-page", "--profile", "page", "--locked", "--offline"]);
    cargo.current_dir(env!("CARGO_MANIFEST_DIR")).args(["--target", TARGET, "--target-dir"]).arg(&target);
    // the sources of the Python package have no other workspace
    if !Path::new("../Cargo.lock").exists() {
        cargo.args(["--manifest-path", "python/Cargo.toml"]);
    }
    let is_of_program =
        |name: &str| VARIABLES_OF_PROGRAM.contains(&name) || name.starts_with("CARGO_PROFILE_");
    for (name, _) in env::vars_os().filter(|(name, _)| name.to_str().is_some_and(is_of_program)) {
        cargo.env_remove(name);
    }
    let output = cargo.output().expect("cargo runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    target.join(TARGET).join("page/toytop_page.wasm")
}
