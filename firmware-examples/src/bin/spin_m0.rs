//! Cortex-M0: no FPU, no division, 16 KiB of RAM. A tick in `f32` by software takes a part of a millisecond only.

#![no_std]
#![no_main]

use cortex_m::peripheral::SCB;
use cortex_m::{asm, interrupt, singleton};
use toytop::{EphemerisF32, Tick};
use toytop_firmware::{entry, exit, start_systick, toy_top};

/// Of the processor, Hz. The emulated chip has 16 MHz (and a SysTick, which a real nRF51 lacks).
const CLOCK: u32 = 16_000_000;
/// Ticks a second: the model says 0.3 ms a tick at 64 MHz.
const TICK_RATE: u32 = 200;

#[entry]
fn main() -> ! {
    let motion = toy_top().expect("a possible top");
    let tick = Tick::hertz(TICK_RATE).expect("a positive rate");
    let ephemeris = singleton!(: EphemerisF32 = EphemerisF32::EMPTY).expect("taken once");
    ephemeris.set_up(&motion, tick, 1e-6).expect("an ordinary motion");

    start_systick(CLOCK, TICK_RATE);
    // An interrupt that is masked still ends the sleep.
    interrupt::disable();

    let mut cursor = ephemeris.cursor(1);
    for tick in 1..=TICK_RATE {
        asm::wfi();
        SCB::clear_pendst();
        let (phi, tip) = cursor.next().phi_and_tip();
        if tick % 50 == 0 {
            let ([x, y, height], ms) = (phi.axis(), tick * 1000 / TICK_RATE);
            defmt::info!("{=u32} ms: axis ({}, {}, {}), tip ({}, {}) m", ms, x, y, height, tip.re, tip.im);
        }
    }
    exit()
}
