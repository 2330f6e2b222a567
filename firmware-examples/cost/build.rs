//! Passes a memory map with space for every table to the linker: `MEMORY_X`, if set, or that of the machine that
//! QEMU emulates.

use std::path::{Path, PathBuf};
use std::{env, fs};

fn main() {
    let target = env::var("TARGET").expect("cargo sets TARGET");
    let machine = match target.as_str() {
        "thumbv6m-none-eabi" | "thumbv7em-none-eabihf" => "mps2.x",
        "thumbv8m.main-none-eabihf" => "mps2-an505.x",
        "riscv32imac-unknown-none-elf" => "riscv-virt.x",
        _ => return,
    };
    println!("cargo:rerun-if-env-changed=MEMORY_X");
    let folder = Path::new("..");
    let memory = env::var_os("MEMORY_X")
        .map_or_else(|| folder.join("memory").join(machine), |path| folder.join(PathBuf::from(path)));
    println!("cargo:rerun-if-changed={}", memory.display());
    let out = PathBuf::from(env::var_os("OUT_DIR").expect("cargo sets OUT_DIR"));
    fs::copy(&memory, out.join("memory.x")).unwrap_or_else(|error| panic!("{}: {error}", memory.display()));
    println!("cargo:rustc-link-search={}", out.display());
    if target.starts_with("riscv") {
        println!("cargo:rustc-link-arg-bins=-Tmemory.x");
    } else {
        println!("cargo:rustc-link-arg-bins=--nmagic");
    }
    println!("cargo:rustc-link-arg-bins=-Tlink.x");
}
