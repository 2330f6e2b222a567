//! Program in double precision in hardware: the main loop sleeps between ticks and advances a cursor at each tick.

#![no_std]
#![no_main]

use cortex_m::peripheral::SCB;
use cortex_m::{asm, interrupt, singleton};
use toytop::{ErrorBound, TableF64, TableMemory, Tick, Workspace};
use toytop_firmware::{entry, exit, start_systick, toy_top};

/// Clock of the processor, Hz. The emulated board has 25 MHz.
const CLOCK: u32 = 25_000_000;
/// Ticks in a second.
const TICK_RATE: u32 = 1000;

#[entry]
fn main() -> ! {
    let motion = toy_top().expect("a possible top");
    let memory = singleton!(: TableMemory<TableF64> = TableMemory::new()).expect("taken once");
    let workspace = singleton!(: Workspace = Workspace::new()).expect("taken once");
    let tick = Tick::hertz(TICK_RATE).expect("a positive rate");
    let table = memory.set_up(workspace, &motion, tick, &mut || {}).expect("an ordinary motion");
    let ErrorBound { constant, per_tick } = table.error_bound();
    defmt::info!("at tick n within {=f64} rad + n * {=f64}", constant, per_tick);

    start_systick(CLOCK, TICK_RATE);
    // An interrupt that is masked still ends the sleep.
    interrupt::disable();

    let mut cursor = table.cursor(1);
    for tick in 1..=TICK_RATE {
        asm::wfi();
        SCB::clear_pendst();
        let now = cursor.next(table);
        if tick % 250 == 0 {
            let state = now.attitude_state();
            let ([x, y, height], tip) = (state.orientation.axis(), now.tip());
            defmt::info!("{=u32} ms: axis ({}, {}, {}), u' {} / s", tick, x, y, height, state.udot());
            defmt::info!("        tip ({}, {}) m", tip.re, tip.im);
        }
    }
    exit()
}
