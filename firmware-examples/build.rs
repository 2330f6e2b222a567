//! Passes the chip's memory map to the linker: `MEMORY_X`, if it is set, or that of the machine that QEMU emulates.

use std::path::{Path, PathBuf};
use std::{env, fs};

fn main() {
    let target = env::var("TARGET").expect("cargo sets TARGET");
    let package = env::var("CARGO_PKG_NAME").expect("cargo sets CARGO_PKG_NAME");
    let is_measured = package == "toytop-cost" || package == "toytop-nopanic";
    let machine = match target.as_str() {
        "thumbv6m-none-eabi" if !is_measured => "microbit.x",
        "thumbv6m-none-eabi" => "mps2.x", // has memory for every table
        "thumbv7em-none-eabihf" => "mps2.x",
        "thumbv8m.main-none-eabihf" => "mps2-an505.x",
        "riscv32imac-unknown-none-elf" => "riscv-virt.x",
        _ => return, // the host
    };
    println!("cargo:rerun-if-env-changed=MEMORY_X");
    // the memory maps are beside this script; packages in folders of their own use them too
    let here = if Path::new("memory").is_dir() { Path::new(".") } else { Path::new("..") };
    let memory =
        here.join(env::var_os("MEMORY_X").map_or_else(|| Path::new("memory").join(machine), PathBuf::from));
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
    if !is_measured {
        println!("cargo:rustc-link-arg-bins=-Tdefmt.x"); // these packages have no log
    }
}
