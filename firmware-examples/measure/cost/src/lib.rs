//! Entry point of the target, and meter of calls, which the programs share.

#![no_std]

pub mod meter;

#[cfg(target_arch = "arm")]
use cortex_m as _; // critical section
#[cfg(target_arch = "arm")]
pub use cortex_m_rt::entry;
#[cfg(target_arch = "riscv32")]
use riscv as _; // critical section
#[cfg(target_arch = "riscv32")]
pub use riscv_rt::entry;
