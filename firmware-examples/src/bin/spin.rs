//! The smallest useful program: throw a top, step it from a 1 kHz interrupt, log where it is every 100 ms.

#![no_std]
#![no_main]

use core::cell::{Cell, RefCell};

use cortex_m::peripheral::syst::SystClkSource;
use cortex_m::{Peripherals, asm};
use cortex_m_rt::exception;
use critical_section::Mutex;
use toytop::{Heaviness, LaunchError, Motion, Release, State, Stepper, Top};
use toytop_firmware::{entry, exit};

/// Of the processor, Hz. The emulated board has 25 MHz.
const CLOCK: u32 = 25_000_000;
/// Ticks a second.
const TICK_RATE: u32 = 1000;
/// Ticks between two lines of the log.
const LOG_EVERY: u32 = 100;

/// The top, as the interrupt spins it.
static SPINNING: Mutex<RefCell<Option<Spinning>>> = Mutex::new(RefCell::new(None));
/// What the interrupt last left for the log.
static SNAPSHOT: Mutex<Cell<Option<Spinning>>> = Mutex::new(Cell::new(None));

#[derive(Clone, Copy)]
struct Spinning {
    stepper: Stepper<f32>,
    ticks: u32,
}

#[entry]
fn main() -> ! {
    // Fallible, in f64, once.
    let motion = launch().expect("a possible top");
    let spinning = Spinning { stepper: Stepper::new(&motion), ticks: 0 };
    critical_section::with(|cs| SPINNING.replace(cs, Some(spinning)));

    let mut systick = Peripherals::take().expect("taken once").SYST;
    systick.set_clock_source(SystClkSource::Core);
    systick.set_reload(CLOCK / TICK_RATE - 1);
    systick.clear_current();
    systick.enable_counter();
    systick.enable_interrupt();

    loop {
        asm::wfi();
        let Some(Spinning { stepper, ticks }) = critical_section::with(|cs| SNAPSHOT.borrow(cs).take())
        else {
            continue;
        };
        let [x, y, height] = stepper.phi().axis();
        let tip = stepper.tip();
        defmt::info!("{=u32} ms: axis ({}, {}, {}), tip ({}, {}) m", ticks, x, y, height, tip.c.re, tip.c.im);
        if ticks == TICK_RATE {
            exit();
        }
    }
}

/// A 50 g top with its centre of mass 30 mm above the tip, let go at 20 degrees with 150 rad/s.
fn launch() -> Result<Motion, LaunchError> {
    let top = Top::sliding(3.0e-5, 2.0e-5, 0.03, Heaviness::Mass(0.05), 9.81)?;
    let release = Release { tilt: 20.0_f64.to_radians(), spin: 150.0, ..Release::default() };
    Motion::launch(&top, &State::release(&release)?)
}

/// Infallible, in f32, every millisecond.
#[exception]
fn SysTick() {
    critical_section::with(|cs| {
        if let Some(spinning) = SPINNING.borrow_ref_mut(cs).as_mut() {
            spinning.stepper.step(1.0 / TICK_RATE as f32);
            spinning.ticks += 1;
            if spinning.ticks % LOG_EVERY == 0 {
                SNAPSHOT.borrow(cs).set(Some(*spinning));
            }
        }
    });
}
