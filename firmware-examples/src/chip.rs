//! Basis of every program: start-up code, the transport of the `defmt` log, and the end of the program.
//!
//! Every error ends the program with an exit code that is not 0, never in an endless loop: a panic with 101 (the
//! panic handler of `semihosting`, which prints the message), a fault with 102.

#[cfg(target_arch = "arm")]
use cortex_m as _; // critical section
#[cfg(feature = "rtt")]
use defmt_rtt as _; // log transport
#[cfg(not(feature = "rtt"))]
use defmt_semihosting as _; // log transport
#[cfg(target_arch = "riscv32")]
use riscv as _; // critical section
use semihosting::process;
use toytop::{Motion, Table, TableF32, TableMemory, Tick, Workspace};

#[cfg(target_arch = "arm")]
pub use cortex_m_rt::entry;
#[cfg(target_arch = "riscv32")]
pub use riscv_rt::entry;

/// Ends the program with success.
pub fn exit() -> ! {
    defmt::flush();
    process::exit(0)
}

/// Table of a motion with `rate` ticks in a second, in static memory, which can be set up once. `bin/spin.rs` shows the code without this
/// function.
pub fn set_up(motion: &Motion, rate: u32) -> &'static Table<f32> {
    #[cfg(target_arch = "arm")]
    use cortex_m::singleton;
    #[cfg(target_arch = "riscv32")]
    use riscv::singleton;
    let memory = singleton!(: TableMemory<TableF32> = TableMemory::new()).expect("taken once");
    let workspace = singleton!(: Workspace = Workspace::new()).expect("taken once");
    let tick = Tick::hertz(rate).expect("a positive rate");
    memory.set_up(workspace, motion, tick, &mut || {}).expect("an ordinary motion")
}

/// Starts SysTick, an interrupt with the frequency `rate`, Hz, of a processor with the clock `clock`, Hz. `bin/spin.rs` shows the code
/// without this function.
#[cfg(target_arch = "arm")]
pub fn start_systick(clock: u32, rate: u32) {
    run_systick(cortex_m::Peripherals::take().expect("taken once").SYST, clock, rate);
}

/// Starts SysTick like [`start_systick`], for a program that has taken the peripherals.
#[cfg(target_arch = "arm")]
pub fn run_systick(mut systick: cortex_m::peripheral::SYST, clock: u32, rate: u32) {
    systick.set_clock_source(cortex_m::peripheral::syst::SystClkSource::Core);
    systick.set_reload(clock / rate - 1);
    systick.clear_current();
    systick.enable_counter();
    systick.enable_interrupt();
}

const FAULT: i32 = 102;

#[cfg(target_arch = "arm")]
#[cortex_m_rt::exception]
unsafe fn HardFault(frame: &cortex_m_rt::ExceptionFrame) -> ! {
    defmt::error!("fault at {=u32:#010x}", frame.pc());
    process::exit(FAULT)
}

#[cfg(target_arch = "riscv32")]
#[unsafe(export_name = "ExceptionHandler")]
extern "C" fn exception_handler(_: &riscv_rt::TrapFrame) -> ! {
    defmt::error!("fault at {=usize:#010x}", riscv::register::mepc::read());
    process::exit(FAULT)
}
