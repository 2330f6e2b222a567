//! Core for the page of `toytop view`.
//!
//! | module | content |
//! |---|---|
//! | [`page_motion`] | table or closed form of a motion in `f64`: any time, at the same cost |
//! | [`runge_kutta`] | classical Runge-Kutta method, for comparison |
//! | [`exports`] | functions that JavaScript calls |
//!
//! On WebAssembly the crate has no `std` and no allocator. Elsewhere it is an ordinary library, whose tests run on the host.

#![cfg_attr(target_family = "wasm", no_std)]

pub mod exports;
pub mod page_motion;
pub mod runge_kutta;

/// Page with a `{{NAME}}` for each text that depends on the motion.
pub const TEMPLATE: &str = include_str!(concat!(env!("OUT_DIR"), "/page.html"));

/// A panic, which no function of the core can reach, stops the page with an error that its console shows.
#[cfg(target_family = "wasm")]
#[panic_handler]
fn stop(_: &core::panic::PanicInfo<'_>) -> ! {
    core::arch::wasm32::unreachable()
}
