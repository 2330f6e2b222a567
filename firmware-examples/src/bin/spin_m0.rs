//! Program for a Cortex-M0 without FPU and division, with 16 KiB of RAM. The table is in flash, so that there is no set-up, and in fixed point,
//! so that a tick uses sums and products of integers. It was made by
//! `toytop bake host/scenarios/toy_top.toml --scalar q31 -o firmware-examples/src/tables/toy_top.rs`.

#![no_std]
#![no_main]

use cortex_m::peripheral::SCB;
use cortex_m::{asm, interrupt};
use toytop::fixed::types::I2F30;
use toytop_firmware::{TOY_TOP, entry, exit, start_systick};

/// Clock of the processor, Hz. The emulated chip has 16 MHz (and a SysTick, which a real nRF51 does not have).
const CLOCK: u32 = 16_000_000;
/// Ticks in a second, for which the table was made.
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
        let now = cursor.next(&TOY_TOP);
        // a program uses the axis here, integers in units of 2^-30
        let axis = now.axis();
        if tick % 100 == 0 {
            let [x, y, height] = axis.map(I2F30::to_num::<f32>);
            let tip = now.tip();
            defmt::info!("{=u32} ms: axis ({}, {}, {}), tip ({}, {}) m", tick, x, y, height, tip.re, tip.im);
        }
    }
    exit()
}
