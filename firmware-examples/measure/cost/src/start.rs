//! Entry point of the target.

#[cfg(target_arch = "arm")]
use cortex_m as _; // critical section
#[cfg(target_arch = "arm")]
pub(crate) use cortex_m_rt::entry;
#[cfg(target_arch = "riscv32")]
use riscv as _; // critical section
#[cfg(target_arch = "riscv32")]
pub(crate) use riscv_rt::entry;
