//! Top as a task of the Embassy executor, which waits for the tick of an interrupt, beside a task that waits for turning points.

#![no_std]
#![no_main]

use cortex_m_rt::exception;
use embassy_executor::Spawner;
use embassy_sync::blocking_mutex::raw::CriticalSectionRawMutex;
use embassy_sync::signal::Signal;
use toytop::{Event, Table};
use toytop_firmware::{exit, set_up, start_systick, toy_top};

/// Clock of the processor, Hz. The emulated board has 25 MHz.
const CLOCK: u32 = 25_000_000;
/// Ticks in a second.
const TICK_RATE: u32 = 1000;

static TICK: Signal<CriticalSectionRawMutex, ()> = Signal::new();
static TURN: Signal<CriticalSectionRawMutex, Event> = Signal::new();

#[embassy_executor::main]
async fn main(spawner: Spawner) {
    let table = set_up(&toy_top().expect("a possible top"), TICK_RATE);
    spawner.spawn(log_turns(table).expect("spawned once"));

    start_systick(CLOCK, TICK_RATE);

    let mut turns = table.turning_points(1).peekable();
    for tick in 1..=200 {
        TICK.wait().await;
        if let Some(turn) = turns.next_if(|turn| turn.tick < tick) {
            TURN.signal(turn);
        }
    }
    exit()
}

#[embassy_executor::task]
async fn log_turns(table: &'static Table<f32>) {
    loop {
        let turn = TURN.wait().await;
        let place = if turn.upward { "upright" } else { "low" };
        defmt::info!("{=i64} ms: most {=str}, {}", turn.tick, place, table.at_event(&turn));
    }
}

#[exception]
fn SysTick() {
    TICK.signal(());
}
