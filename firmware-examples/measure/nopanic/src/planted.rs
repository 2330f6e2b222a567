//! Program with a deliberate panic, which the panic handler of `toytop-nopanic` must keep from linking. It calls nothing else, so that it is
//! built fast.

#![no_std]
#![no_main]

use core::hint::black_box;

use panic_never as _;

#[cfg(target_arch = "arm")]
use cortex_m_rt::entry;
#[cfg(target_arch = "riscv32")]
use riscv_rt::entry;

#[entry]
fn main() -> ! {
    loop {
        let table = [1, 2, 3];
        black_box(table[black_box(3)]);
    }
}
