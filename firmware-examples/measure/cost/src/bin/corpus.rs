//! Costs of 200 launches on a chip, slow, fast, upright, hanging and slender tops among them.
//!
//! QEMU runs with one nanosecond per instruction, so that a timer counts instructions (the SysTick of a Cortex-M in
//! units of 40 at 25 MHz, the counter of RISC-V in units of 1). The program prints one line per launch: `SCALAR NUMBER
//! RESULT motion INSTRUCTIONS table INSTRUCTIONS slice GREATEST`, where RESULT is `ready` or `refused`.

#![no_std]
#![no_main]

use core::hint::black_box;

use fixed::types::I2F30;
use semihosting::{println, process};
use toytop::{
    Motion, ParameterError, Release, SizedTable, State, Table, TableMemory, TableScalar, Tick, Top,
    TopParameters, Workspace,
};
use toytop_cost::entry;

const LAUNCHES: u32 = 200;

#[entry]
fn main() -> ! {
    let counter = Counter::start();
    let mut single = TableMemory::<SizedTable<f32, 64>>::new();
    let mut fixed = TableMemory::<SizedTable<I2F30, 64>>::new();
    let mut double = TableMemory::<SizedTable<f64, 64>>::new();
    for number in 0..LAUNCHES {
        run("f32", number, &mut single, &counter);
        run("q31", number, &mut fixed, &counter);
        run("f64", number, &mut double, &counter);
    }
    process::exit(0)
}

#[inline(never)]
fn run<R: TableScalar>(scalar: &str, number: u32, memory: &mut TableMemory<Table<R>>, counter: &Counter) {
    let (top, state) = launch(number).expect("a possible launch");
    let (launched, of_motion, longest_of_motion) =
        interrupted(counter, |pause| Motion::launch_with_pauses(black_box(&top), black_box(&state), pause));
    let Ok(motion) = launched else {
        println!("{scalar} {number} refused motion {of_motion} table 0 slice {longest_of_motion}");
        return;
    };
    let tick = Tick::hertz(1000).expect("positive");
    let mut workspace = Workspace::new();
    let (result, of_table, longest_of_table) =
        interrupted(counter, |pause| memory.set_up(&mut workspace, &motion, tick, pause).map(drop));
    let longest = longest_of_motion.max(longest_of_table);
    let result = if result.is_ok() { "ready" } else { "refused" };
    println!("{scalar} {number} {result} motion {of_motion} table {of_table} slice {longest}");
}

/// Result of a computation that calls other work in between, and the instructions of all of it and of its longest part.
fn interrupted<T>(counter: &Counter, work: impl FnOnce(&mut dyn FnMut()) -> T) -> (T, u64, u64) {
    let (mut all, mut longest, mut begin) = (0, 0, counter.now());
    let mut count = || {
        let part = counter.since(begin);
        (all, longest) = (all + part, longest.max(part));
        begin = counter.now();
    };
    let result = work(&mut count);
    count();
    (result, all, longest)
}

/// Launch of this number. Tilt, the root of the spin and the logarithm of A/(ps) are spread evenly (a sequence of low
/// discrepancy); every eighth launch is an extreme case.
fn launch(number: u32) -> Result<(Top, State), ParameterError> {
    let [first, second, third] = [3_518_319_155_u32, 2_882_110_345, 2_360_945_575]
        .map(|step| f64::from(number.wrapping_add(1).wrapping_mul(step)) / f64::from(u32::MAX));
    // s = 30 mm, p = 1.5e-3 kg m; A/(ps) from 0.01 to 1000
    let (com_height, mass) = (0.03, 0.05);
    let sliding = number.is_multiple_of(2);
    let about_the_centre = mass * com_height * com_height * libm::exp10(5.0 * third - 2.0);
    let of_the_height = if sliding { 0.0 } else { mass * com_height * com_height };
    let parameters = TopParameters {
        transverse_inertia: about_the_centre + of_the_height,
        axial_inertia: 0.67 * about_the_centre,
        com_height,
        mass,
        gravity: 9.81,
        ..TopParameters::default()
    };
    let top = if sliding { Top::sliding(&parameters)? } else { Top::fixed(&parameters)? };
    // up to 1000 rad/s, a tenth of them below 10
    let spin = 1000.0 * second * second;
    let critical =
        libm::sqrt(4.0 * top.transverse_inertia() * top.mass_moment() * 9.81) / top.axial_inertia();
    let tilt = core::f64::consts::PI * first;
    let (tilt, spin) = match number % 64 {
        7 => (0.0, spin),
        15 => (1e-6, 0.999 * critical),
        23 => (1e-3, 1.001 * critical),
        31 => (core::f64::consts::PI - 1e-6, spin),
        39 => (tilt, 0.0),
        47 => (1e-9, 0.5 * critical),
        55 => (0.5 * core::f64::consts::PI, 1000.0),
        63 => (0.0, 0.5 * critical),
        _ => (tilt, spin),
    };
    Ok((top, State::from_release(&Release { tilt, spin, ..Release::default() })?))
}

/// Counter of instructions.
struct Counter {
    #[cfg(target_arch = "arm")]
    systick: cortex_m::peripheral::SYST,
}

#[cfg(target_arch = "arm")]
impl Counter {
    const RANGE: u32 = 1 << 24;

    fn start() -> Self {
        let mut systick = cortex_m::Peripherals::take().expect("taken once").SYST;
        systick.set_clock_source(cortex_m::peripheral::syst::SystClkSource::Core);
        systick.set_reload(Self::RANGE - 1);
        systick.clear_current();
        systick.enable_counter();
        Self { systick }
    }

    fn now(&self) -> u32 {
        let _ = &self.systick;
        cortex_m::peripheral::SYST::get_current()
    }

    /// Number of instructions since `begin`, at most 671 million.
    fn since(&self, begin: u32) -> u64 {
        40 * u64::from(begin.wrapping_sub(self.now()) % Self::RANGE)
    }
}

#[cfg(target_arch = "riscv32")]
impl Counter {
    fn start() -> Self {
        Self {}
    }

    fn now(&self) -> u32 {
        riscv::register::mcycle::read() as u32
    }

    fn since(&self, begin: u32) -> u64 {
        self.now().wrapping_sub(begin).into()
    }
}
