//! Top in an RTIC application: `init` sets the table up, the task of SysTick advances the cursor, and `idle` reads what they share.

#![no_std]
#![no_main]

#[rtic::app(device = lm3s6965, peripherals = false)]
mod app {
    use cortex_m::asm;
    use toytop::{Cursor, Table};
    use toytop_firmware::{exit, run_systick, set_up, toy_top};

    /// Clock of the processor, Hz. The emulated board has 25 MHz.
    const CLOCK: u32 = 25_000_000;
    /// Ticks in a second.
    const TICK_RATE: u32 = 1000;

    #[shared]
    struct Shared {
        /// Tick of the last interrupt, and the top's axis.
        now: (i64, [f32; 3]),
    }

    #[local]
    struct Local {
        table: &'static Table<f32>,
        cursor: Cursor<f32>,
    }

    #[init]
    fn init(context: init::Context) -> (Shared, Local) {
        let table = set_up(&toy_top().expect("a possible top"), TICK_RATE);
        run_systick(context.core.SYST, CLOCK, TICK_RATE);
        (Shared { now: (0, [0.0; 3]) }, Local { table, cursor: table.cursor(1) })
    }

    #[task(binds = SysTick, local = [table, cursor], shared = [now])]
    fn tick(mut context: tick::Context) {
        let (table, cursor) = (context.local.table, context.local.cursor);
        let axis = cursor.next(table).axis();
        context.shared.now.lock(|now| *now = (cursor.tick(), axis));
    }

    #[idle(shared = [now])]
    fn idle(mut context: idle::Context) -> ! {
        let mut before = 0;
        loop {
            asm::wfi();
            let (tick, [x, y, height]) = context.shared.now.lock(|now| *now);
            if tick != before && tick % 50 == 0 {
                defmt::info!("{=i64} ms: axis ({}, {}, {})", tick, x, y, height);
            }
            if tick >= 200 {
                exit();
            }
            before = tick;
        }
    }
}
