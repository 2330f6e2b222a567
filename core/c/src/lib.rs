#![doc = include_str!("../README.md")]
#![cfg_attr(not(test), no_std)]
#![allow(non_camel_case_types, reason = "the names are those of the header")]
#![allow(clippy::missing_safety_doc, reason = "the header and its page say once which pointers are valid")]

// Modules in the order of dependence: each one uses only those above it.

// Memory of the caller, and status codes.
mod status;

mod memory;

// Functions that run once per launch and can fail.
mod input;

mod motion;

mod table;

// Each module below ends with its functions of each scalar, `toytop_f32_...`, `toytop_f64_...` and `toytop_q31_...`.

mod set_up;

// Functions that run at every tick.
mod sample;

mod cursor;

mod events;

pub use cursor::*;
pub use events::*;
pub use input::*;
pub use motion::*;
pub use sample::*;
pub use set_up::*;
pub use status::*;
pub use table::*;

/// Panic handler, which the compiler requires in an archive. It calls a function that does not exist. If no code can panic, the archive
/// contains neither of them, which `cargo xtask c-archive` checks.
#[cfg(toytop_archive)]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    unsafe extern "C" {
        fn toytop_can_panic() -> !;
    }
    // SAFETY: a program with a path to here cannot be linked.
    unsafe { toytop_can_panic() }
}
