//! Passes the chip's memory map to the linker: `MEMORY_X`, if it is set, or that of the machine that QEMU emulates.

use std::path::PathBuf;
use std::{env, fs};

fn main() {
    let target = env::var("TARGET").expect("cargo sets TARGET");
    let machine = match target.as_str() {
        "thumbv6m-none-eabi" => "microbit.x",
        "thumbv7em-none-eabihf" => "mps2.x",
        "thumbv8m.main-none-eabihf" => "mps2-an505.x",
        "riscv32imac-unknown-none-elf" => "riscv-virt.x",
        _ => return, // the host
    };
    println!("cargo:rerun-if-env-changed=MEMORY_X");
    // packages in folders below use this script too
    let package = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").expect("cargo sets CARGO_MANIFEST_DIR"));
    let root = package.ancestors().find(|folder| folder.join("memory").is_dir()).expect("a folder `memory`");
    let memory = root.join(env::var("MEMORY_X").unwrap_or_else(|_| format!("memory/{machine}")));
    println!("cargo:rerun-if-changed={}", memory.display());

    let out = PathBuf::from(env::var_os("OUT_DIR").expect("cargo sets OUT_DIR"));
    fs::copy(&memory, out.join("memory.x")).unwrap_or_else(|error| panic!("{}: {error}", memory.display()));
    println!("cargo:rustc-link-search={}", out.display());
    if target.starts_with("riscv") {
        println!("cargo:rustc-link-arg-bins=-Tmemory.x"); // cortex-m-rt's link.x includes it
    } else {
        println!("cargo:rustc-link-arg-bins=--nmagic"); // no padding to pages: flash has none
    }
    println!("cargo:rustc-link-arg-bins=-Tlink.x");
    // the programs in `measure` have no log
    if !package.starts_with(root.join("measure")) {
        println!("cargo:rustc-link-arg-bins=-Tdefmt.x");
    }
}
