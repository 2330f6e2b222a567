//! Program for RISC-V without an FPU: the machine's timer ends the sleep between two ticks.

#![no_std]
#![no_main]

use riscv::asm::wfi;
use riscv::register::mie;
use toytop_firmware::{entry, exit, set_up, toy_top};

/// Frequency of the timer of QEMU's "virt" machine, Hz.
const TIMER: u64 = 10_000_000;
/// Address of the count of the timer (CLINT).
const MTIME: *const u64 = 0x0200_bff8 as *const u64;
/// Address of the count at which the timer requests an interrupt.
const MTIMECMP: *mut u64 = 0x0200_4000 as *mut u64;
/// Ticks in a second.
const TICK_RATE: u32 = 1000;

#[entry]
fn main() -> ! {
    let table = set_up(&toy_top().expect("a possible top"), TICK_RATE);

    // An interrupt that is masked (mstatus.MIE is off) still ends the sleep.
    // SAFETY: no handler can run, so none can see incomplete data
    unsafe { mie::set_mtimer() };
    // SAFETY: the timer's registers on this machine
    let mut due = unsafe { MTIME.read_volatile() };
    let mut cursor = table.cursor(1);
    for tick in 1..=TICK_RATE {
        due += TIMER / u64::from(TICK_RATE);
        // SAFETY: as above
        unsafe { MTIMECMP.write_volatile(due) };
        // SAFETY: as above
        while unsafe { MTIME.read_volatile() } < due {
            wfi();
        }
        let now = cursor.next(table);
        let axis = now.axis();
        if tick % 250 == 0 {
            let ([x, y, height], tip) = (axis, now.tip());
            defmt::info!("{=u32} ms: axis ({}, {}, {}), tip ({}, {}) m", tick, x, y, height, tip.re, tip.im);
        }
    }
    exit()
}
