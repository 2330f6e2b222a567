//! From sensors to an ephemeris: a recording in flash is fitted, and a cursor of the fitted launch runs in an interrupt.
//!
//! The gyroscope is blind along the axis, where the top turns four times as fast as it can read; its biases are found with the launch.
//! A recording of your own replaces [`imu`]; the numbers of the sensors are those of their data sheets.

#![no_std]
#![no_main]

use core::cell::RefCell;

use cortex_m::{asm, singleton};
use cortex_m_rt::exception;
use critical_section::Mutex;
use toytop::fit::{Accelerometer, Fit, Gyroscope, Magnetometer, Measurement, Mounting, Noise, Sensor};
use toytop::{Cursor, EphemerisF32, Tick};
use toytop_firmware::{entry, exit, imu, start_systick, toy_top};

/// Frequency of the processor, Hz. The emulated board has 25 MHz.
const CLOCK: u32 = 25_000_000;
/// Samples and ticks a second.
const TICK_RATE: u32 = 1000;
/// Range of the gyroscope, rad/s: 2000 degrees per second.
const GYROSCOPE_RANGE: f64 = 34.906_585_039_886_59;
/// Range of the accelerometer, m/s^2: 16 g.
const ACCELEROMETER_RANGE: f64 = 157.0;
/// Unit of the magnetometer, microtesla.
const MAGNETIC_UNIT: f64 = 0.15;
/// Magnetometer readings are one in so many samples.
const EVERY: usize = 10;

struct Follower {
    ephemeris: &'static EphemerisF32,
    cursor: Cursor,
    tick: u32,
}

static FOLLOWER: Mutex<RefCell<Option<Follower>>> = Mutex::new(RefCell::new(None));

#[entry]
fn main() -> ! {
    let mounting = Mounting::default();
    let gyroscope = Gyroscope {
        noise: Noise { deviation: 0.002, bias: 0.0175 },
        mounting,
        range: 0.999 * GYROSCOPE_RANGE,
    };
    let accelerometer = Accelerometer {
        noise: Noise { deviation: 0.022, bias: 0.2 },
        mounting,
        range: 0.999 * ACCELEROMETER_RANGE,
    };
    let magnetometer =
        Magnetometer { noise: Noise { deviation: 0.6, bias: 0.0 }, mounting, field: [20.0, 0.0, -43.0] };
    let sensors: [&dyn Sensor; 3] = [&gyroscope, &accelerometer, &magnetometer];

    // the top is known, its throw is not
    let top = *toy_top().expect("a possible top").top();
    let mut fit = Fit::new(&top, &sensors, &[]).expect("three sensors");
    let fitted = fit.run(measurements()).expect("finite readings in order");
    match fitted.reason {
        None => defmt::info!("converged"),
        Some(_) => defmt::error!("not converged"),
    }
    let statistics = fitted.statistics;
    defmt::info!(
        "{=u32} values, {=u32} beyond the range, {=u32} outliers, chi squared {=f32}",
        statistics.used,
        statistics.unused,
        statistics.outliers,
        statistics.reduced_chi_squared(fitted.count) as f32
    );
    let deviations = fitted.deviations();
    for (name, (value, deviation)) in
        ["x", "y", "z"].iter().zip(fitted.launch.omega.iter().zip(deviations.iter().skip(3)))
    {
        defmt::info!("omega_{=str}: {=f32} +- {=f32} rad/s", name, *value as f32, *deviation as f32);
    }
    defmt::info!("state of the fit: {=usize} bytes", size_of::<Fit<'_>>());

    let motion = fitted.motion(&top).expect("a possible launch");
    let ephemeris = singleton!(: EphemerisF32 = EphemerisF32::EMPTY).expect("taken once");
    ephemeris
        .set_up(&motion, Tick::hertz(TICK_RATE).expect("a positive rate"), 1e-6)
        .expect("an ordinary motion");
    let cursor = ephemeris.cursor(0);
    let follower = Follower { ephemeris, cursor, tick: 0 };
    critical_section::with(|cs| FOLLOWER.replace(cs, Some(follower)));
    start_systick(CLOCK, TICK_RATE);
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

/// Measurements of the recording, in SI units.
fn measurements() -> impl Iterator<Item = Measurement> + Clone {
    imu::INERTIAL.iter().enumerate().flat_map(|(n, registers)| {
        let time = n as f64 / f64::from(TICK_RATE);
        let three = |registers: &[i16], unit: f64| {
            let mut values = [0.0; 4];
            for (value, register) in values.iter_mut().zip(registers) {
                *value = f64::from(*register) * unit;
            }
            values
        };
        let (gyroscope, accelerometer) = registers.split_at(3);
        let magnetic = imu::MAGNETIC.get(n / EVERY).filter(|_| n % EVERY == 0);
        [
            Some((0, three(gyroscope, GYROSCOPE_RANGE / 32768.0))),
            Some((1, three(accelerometer, ACCELEROMETER_RANGE / 32768.0))),
            magnetic.map(|registers| (2, three(registers, MAGNETIC_UNIT))),
        ]
        .into_iter()
        .flatten()
        .map(move |(sensor, values)| Measurement { time, sensor, values })
    })
}

#[exception]
fn SysTick() {
    critical_section::with(|cs| {
        let mut follower = FOLLOWER.borrow_ref_mut(cs);
        let Some(Follower { ephemeris, cursor, tick }) = follower.as_mut() else { return };
        let orientation = cursor.next(*ephemeris).orientation();
        if *tick % 250 == 0 {
            let [x, y, z] = orientation.axis();
            defmt::info!("{=u32} ms: axis ({=f32}, {=f32}, {=f32})", *tick, x, y, z);
        }
        *tick += 1;
    });
}
