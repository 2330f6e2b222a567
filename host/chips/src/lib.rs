//! Chips that toytop is tested on: builds for them, runs under QEMU, and the cost of each call.
//!
//! | module | contents |
//! |---|---|
//! | [`chip`] | chips with their compilers and emulators |
//! | `trace` | blocks of code that QEMU executes |
//! | `cycles` | cycles of an instruction, from published timings |
//! | `costs` | cost of each call: the blocks between its entry and its return |
//!
//! A module uses only those above it. The last three need the feature `costs`.

pub mod chip;

#[cfg(feature = "costs")]
pub mod trace;

#[cfg(feature = "costs")]
pub mod cycles;

#[cfg(feature = "costs")]
pub mod costs;
