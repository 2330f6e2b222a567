//! Cortex-M0: no FPU, no division, 16 KiB of RAM. The table is in flash, so that nothing is set up: made by
//! `toytop bake host/scenarios/toy_top.toml -o firmware-examples/src/tables/toy_top.rs`.

#![no_std]
#![no_main]

use cortex_m::peripheral::SCB;
use cortex_m::{asm, interrupt};
use toytop_firmware::{TOY_TOP, entry, exit, start_systick};

/// Of the processor, Hz. The emulated chip has 16 MHz (and a SysTick, which a real nRF51 lacks).
const CLOCK: u32 = 16_000_000;
/// Ticks a second, as the table has it.
const TICK_RATE: u32 = 1000;

#[entry]
fn main() -> ! {
    start_systick(CLOCK, TICK_RATE);
    // An interrupt that is masked still ends the sleep.
    interrupt::disable();

    let mut cursor = TOY_TOP.cursor(1);
    for tick in 1..=TICK_RATE {
        asm::wfi();
        SCB::clear_pendst();
        let (phi, tip) = cursor.next().phi_and_tip();
        if tick % 100 == 0 {
            let [x, y, height] = phi.axis();
            defmt::info!("{=u32} ms: axis ({}, {}, {}), tip ({}, {}) m", tick, x, y, height, tip.re, tip.im);
        }
    }
    exit()
}
