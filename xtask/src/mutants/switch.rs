//! Goes into the woven copy of core, not into xtask: which mutant this process is to run, and which functions it has called.

extern crate std;

use core::sync::atomic::{AtomicBool, Ordering};
use std::fs::OpenOptions;
use std::io::Write;
use std::sync::LazyLock;

/// The number of the chosen mutant, 0 for none. While a constant is evaluated none is: then there is no process to choose for.
pub(crate) const fn chosen(function: u32) -> u32 {
    core::intrinsics::const_eval_select((function,), while_compiling, while_running)
}

const fn while_compiling(_: u32) -> u32 {
    0
}

fn while_running(function: u32) -> u32 {
    static CHOSEN: LazyLock<u32> =
        LazyLock::new(|| std::env::var("MUTANT").map_or(0, |number| number.parse().unwrap()));
    if *CHOSEN == 0 {
        note(function);
    }
    *CHOSEN
}

/// Each function once, as a line of the file that the environment names.
fn note(function: u32) {
    static NOTES: LazyLock<Option<std::ffi::OsString>> = LazyLock::new(|| std::env::var_os("MUTANT_NOTES"));
    static CALLED: [AtomicBool; 1 << 14] = [const { AtomicBool::new(false) }; 1 << 14];
    let Some(notes) = &*NOTES else { return };
    let called = &CALLED[function as usize];
    if !called.load(Ordering::Relaxed) && !called.swap(true, Ordering::Relaxed) {
        let line = std::format!("{function}\n");
        let file = OpenOptions::new().append(true).create(true).open(notes);
        file.and_then(|mut file| file.write_all(line.as_bytes())).unwrap();
    }
}
