#![doc = include_str!("../README.md")]
#![cfg_attr(not(test), no_std)]
#![allow(non_camel_case_types, reason = "the names are those of the header")]
#![allow(clippy::missing_safety_doc, reason = "the header and its page say once which pointers are valid")]

// Modules in the order of dependence: each one uses only those above it.

// Memory of the caller, and status codes.
mod status;

mod memory;

// Functions that run once per launch and can fail.
mod launch;

mod motion;

mod partials;

// Functions that run at every tick.
mod table;

mod set_up;

mod sample;

mod events;

mod scalars;

pub use events::toytop_event;
pub use launch::{
    TOYTOP_FIXED, TOYTOP_FREE, TOYTOP_SLIDING, TOYTOP_STANDARD_GRAVITY, toytop_impulse,
    toytop_reaction_impulse, toytop_release, toytop_state, toytop_state_from_quaternion_and_gyro,
    toytop_state_from_release, toytop_top,
};
pub use motion::{
    TOYTOP_MOTION_SIZE, toytop_constants, toytop_launch, toytop_motion, toytop_motion_constants,
    toytop_regime,
};
pub use partials::{toytop_motion_partials, toytop_partials};
pub use sample::{
    TOYTOP_EPHEMERIS_CURSOR_SIZE, TOYTOP_EPHEMERIS_SAMPLE_SIZE, toytop_ephemeris_cursor,
    toytop_ephemeris_cursor_tick, toytop_ephemeris_sample,
};
pub use scalars::*;
pub use set_up::{TOYTOP_SET_UP_SIZE, toytop_between, toytop_set_up};
pub use status::{TOYTOP_TEXT_SIZE, toytop_error, toytop_status, toytop_status_text};
pub use table::{
    TOYTOP_EPHEMERIS_ALIGNMENT, TOYTOP_EPHEMERIS_F32_SIZE, TOYTOP_EPHEMERIS_F64_SIZE,
    TOYTOP_EPHEMERIS_Q31_SIZE, toytop_ephemeris_f32, toytop_ephemeris_f64, toytop_ephemeris_q31,
    toytop_error_bounds, toytop_hertz, toytop_tick,
};

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
