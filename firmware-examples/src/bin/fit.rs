//! From sensors to a table: a recording in flash is fitted, and a cursor of the fitted launch runs in an interrupt.
//!
//! The gyroscope is saturated along the axis, where the top turns at four times its range; its biases are found with
//! the launch. The fit computes in `f32`. A recording of your own replaces [`toytop_recording`], which also has the numbers of the
//! sensors' data sheets.

#![no_std]
#![no_main]

use core::cell::RefCell;

use cortex_m::asm;
use cortex_m_rt::exception;
use critical_section::Mutex;
use toytop::{Cursor, Table};
use toytop_firmware::{entry, exit, set_up, start_systick, toy_top};
use toytop_fit::{Fit, Sensor};
use toytop_recording::{ACCELEROMETER, GYROSCOPE, MAGNETOMETER, SAMPLE_RATE, measurements};

/// Frequency of the processor, Hz. The emulated board has 25 MHz.
const CLOCK: u32 = 25_000_000;

struct Follower {
    table: &'static Table<f32>,
    cursor: Cursor<f32>,
    tick: u32,
}

static FOLLOWER: Mutex<RefCell<Option<Follower>>> = Mutex::new(RefCell::new(None));

#[entry]
fn main() -> ! {
    let sensors: [&dyn Sensor<f32>; 3] = [&GYROSCOPE, &ACCELEROMETER, &MAGNETOMETER];

    // the top is known, and its launch is not
    let top = *toy_top().expect("a possible top").top();
    let mut fit = Fit::new(&top, &sensors, &[]).expect("three sensors");
    let fitted = fit.run(measurements()).expect("finite readings in order");
    match fitted.warning {
        None => defmt::info!("converged"),
        Some(_) => defmt::error!("not converged"),
    }
    let statistics = fitted.statistics;
    defmt::info!(
        "{=u32} values, {=u32} beyond the range, {=u32} outliers, chi squared {=f32}",
        statistics.used,
        statistics.unused,
        statistics.outliers,
        statistics.reduced_chi_squared(fitted.unknown_count) as f32
    );
    let deviations = fitted.deviations();
    for (name, (value, deviation)) in
        ["x", "y", "z"].iter().zip(fitted.launch.omega.iter().zip(deviations.iter().skip(3)))
    {
        defmt::info!("omega_{=str}: {=f32} +- {=f32} rad/s", name, *value as f32, *deviation as f32);
    }
    defmt::info!("state of the fit: {=usize} bytes", size_of::<Fit<'_, f32>>());

    let motion = fitted.motion().expect("a possible launch");
    let table = set_up(&motion, SAMPLE_RATE);
    let follower = Follower { table, cursor: table.cursor(0), tick: 0 };
    critical_section::with(|cs| FOLLOWER.replace(cs, Some(follower)));
    start_systick(CLOCK, SAMPLE_RATE);
    loop {
        asm::wfi();
        let done = critical_section::with(|cs| {
            FOLLOWER.borrow_ref(cs).as_ref().is_some_and(|follower| follower.tick > 1000)
        });
        if done {
            exit()
        }
    }
}

#[exception]
fn SysTick() {
    critical_section::with(|cs| {
        let mut follower = FOLLOWER.borrow_ref_mut(cs);
        let Some(Follower { table, cursor, tick }) = follower.as_mut() else { return };
        let orientation = cursor.next(table).orientation();
        if *tick % 250 == 0 {
            let [x, y, z] = orientation.axis();
            defmt::info!("{=u32} ms: axis ({=f32}, {=f32}, {=f32})", *tick, x, y, z);
        }
        *tick += 1;
    });
}
