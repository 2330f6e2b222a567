//! Cost of a fit on a chip: 250 samples of a gyroscope and an accelerometer and 25 of a magnetometer, from the samples to
//! the launch, for `toytop budget`.

#![no_std]
#![no_main]

use core::hint::black_box;

use semihosting::process;
use toytop::{Top, TopParameters};
use toytop_cost::entry;
use toytop_cost::meter::Meter;
use toytop_fit::{Fit, Sensor};
use toytop_recording::{ACCELEROMETER, GYROSCOPE, MAGNETOMETER, measurements};

#[entry]
fn main() -> ! {
    let top = Top::sliding(&TopParameters::TOY).expect("a possible top");
    let sensors: [&dyn Sensor<f32>; 3] = [&GYROSCOPE, &ACCELEROMETER, &MAGNETOMETER];
    let mut fit = Fit::new(&top, &sensors, &[]).expect("three sensors");
    let mut meter = Meter::start();
    meter.measure("bench_fit", size_of_val(&fit), 1, |_| {
        assert!(bench_fit(black_box(&mut fit)), "the fit converges");
    });
    process::exit(0)
}

#[inline(never)]
#[unsafe(no_mangle)]
extern "C" fn bench_fit(fit: &mut Fit<'_, f32>) -> bool {
    fit.run(measurements()).is_ok_and(|fitted| fitted.is_trusted())
}
