//! Smallest useful program: it launches a top, computes its orientation in a 1 kHz interrupt, and logs it every 100 ms.

#![no_std]
#![no_main]

use core::cell::Cell;

use cortex_m::peripheral::syst::SystClkSource;
use cortex_m::{Peripherals, asm, singleton};
use cortex_m_rt::exception;
use critical_section::Mutex;
use toytop::{
    Complex, Motion, Orientation, ParameterError, Release, State, Table, TableF32, TableMemory, Tick, Top,
    TopParameters, Workspace,
};
use toytop_firmware::{entry, exit};

/// Clock of the processor, Hz. The emulated board has 25 MHz.
const CLOCK: u32 = 25_000_000;
/// Ticks in a second.
const TICK_RATE: u32 = 1000;
/// Ticks between two lines of the log.
const LOG_EVERY: i64 = 100;

/// Table of the motion, for the interrupt.
static TABLE: Mutex<Cell<Option<&Table<f32>>>> = Mutex::new(Cell::new(None));
/// Last data of the interrupt for the log.
static SNAPSHOT: Mutex<Cell<Option<Snapshot>>> = Mutex::new(Cell::new(None));

struct Snapshot {
    tick: i64,
    orientation: Orientation<f32>,
    tip: Complex<f32>,
}

#[entry]
fn main() -> ! {
    // Set-up, which runs once and can fail.
    let motion = launch().expect("a possible top");
    let tick = Tick::hertz(TICK_RATE).expect("a positive rate");
    // The table of 2 KiB is set up in static memory, not on the stack.
    let memory = singleton!(: TableMemory<TableF32> = TableMemory::new()).expect("taken once");
    let workspace = singleton!(: Workspace = Workspace::new()).expect("taken once");
    let table = memory.set_up(workspace, &motion, tick, &mut || {}).expect("an ordinary motion");
    critical_section::with(|cs| TABLE.borrow(cs).set(Some(table)));

    let mut systick = Peripherals::take().expect("taken once").SYST;
    systick.set_clock_source(SystClkSource::Core);
    systick.set_reload(CLOCK / TICK_RATE - 1);
    systick.clear_current();
    systick.enable_counter();
    systick.enable_interrupt();

    loop {
        asm::wfi();
        let Some(Snapshot { tick, orientation, tip }) =
            critical_section::with(|cs| SNAPSHOT.borrow(cs).take())
        else {
            continue;
        };
        let [x, y, height] = orientation.axis();
        defmt::info!("{=i64} ms: axis ({}, {}, {}), tip ({}, {}) m", tick, x, y, height, tip.re, tip.im);
        if tick == i64::from(TICK_RATE) {
            exit();
        }
    }
}

/// Motion of a 50 g top with its centre of mass 30 mm above the tip, released at 20 degrees with 150 rad/s.
fn launch() -> Result<Motion, ParameterError> {
    let top = Top::sliding(&TopParameters {
        transverse_inertia: 3.0e-5,
        axial_inertia: 2.0e-5,
        com_height: 0.03,
        mass: 0.05,
        gravity: 9.81,
        ..TopParameters::default()
    })?;
    let release = Release { tilt: 20.0_f64.to_radians(), spin: 150.0, ..Release::default() };
    Motion::launch(&top, &State::from_release(&release)?)
}

/// Interrupt in every millisecond. It computes in f32 and cannot fail.
#[exception]
fn SysTick() {
    static mut TICK: i64 = 0;
    *TICK += 1;
    critical_section::with(|cs| {
        let Some(table) = TABLE.borrow(cs).get() else { return };
        let sample = table.at_tick(*TICK);
        let orientation = sample.orientation();
        if *TICK % LOG_EVERY == 0 {
            SNAPSHOT.borrow(cs).set(Some(Snapshot { tick: *TICK, orientation, tip: sample.tip() }));
        }
    });
}
