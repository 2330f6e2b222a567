//! Top as a task of the Embassy executor, which waits for the tick of an interrupt, beside a task that waits for turning points.

#![no_std]
#![no_main]

use cortex_m::singleton;
use cortex_m_rt::exception;
use embassy_executor::Spawner;
use embassy_sync::blocking_mutex::raw::CriticalSectionRawMutex;
use embassy_sync::signal::Signal;
use toytop::{EphemerisF32, EphemerisMemory, EphemerisView, SetUp, Tick, TurningPoint};
use toytop_firmware::{exit, start_systick, toy_top};

/// Clock of the processor, Hz. The emulated board has 25 MHz.
const CLOCK: u32 = 25_000_000;
/// Ticks in a second.
const TICK_RATE: u32 = 1000;

static TICK: Signal<CriticalSectionRawMutex, ()> = Signal::new();
static TURN: Signal<CriticalSectionRawMutex, TurningPoint> = Signal::new();

#[embassy_executor::main]
async fn main(spawner: Spawner) {
    let motion = toy_top().expect("a possible top");
    let memory = singleton!(: EphemerisMemory<EphemerisF32> = EphemerisMemory::new()).expect("taken once");
    let set_up = singleton!(: SetUp = SetUp::new()).expect("taken once");
    let tick = Tick::hertz(TICK_RATE).expect("a positive rate");
    let table = memory.set_up(set_up, &motion, tick, 0, &mut || {}).expect("an ordinary motion");
    let ephemeris = table.share();
    spawner.spawn(log_turns(ephemeris).expect("spawned once"));

    start_systick(CLOCK, TICK_RATE);

    let mut next = ephemeris.next_turning_point(1);
    for tick in 1..=200 {
        TICK.wait().await;
        if let Some(turn) = next.filter(|turn| turn.tick <= tick) {
            TURN.signal(turn);
            next = ephemeris.next_turning_point(tick + 1);
        }
    }
    exit()
}

#[embassy_executor::task]
async fn log_turns(ephemeris: &'static EphemerisView<f32>) {
    loop {
        let TurningPoint { tick, upper } = TURN.wait().await;
        let place = if upper { "upright" } else { "low" };
        defmt::info!("{=i64} ms: most {=str}, {}", tick, place, ephemeris.at_tick(tick));
    }
}

#[exception]
fn SysTick() {
    TICK.signal(());
}
