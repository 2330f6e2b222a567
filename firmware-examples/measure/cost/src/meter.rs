//! Costs of a call that a trace does not show: its stack, and on a board its cycles.

use core::arch::asm;
use core::hint::black_box;

use semihosting::println;

/// Size of the memory below the stack pointer that is painted, bytes.
const DEPTH: usize = 32 * 1024;
/// Word with which the stack is painted. No call leaves it by chance in every word of a frame.
const PAINT: u32 = 0x5afe_c0de;

/// Meter of the calls of one kind after another.
pub struct Meter {
    #[cfg(feature = "dwt")]
    cycles: cycles::Counter,
}

impl Meter {
    /// Meter, whose counter of cycles runs.
    pub fn start() -> Self {
        Self {
            #[cfg(feature = "dwt")]
            cycles: cycles::Counter::start(),
        }
    }

    /// Runs `call` several times and prints the costs of the costliest one. `ram` is the memory that is kept
    /// between the calls, bytes.
    #[inline(never)]
    pub fn measure(&mut self, name: &str, ram: usize, calls: usize, mut call: impl FnMut(usize)) {
        let top = stack_pointer();
        paint(top);
        #[cfg(feature = "dwt")]
        let cycles = (0..calls).map(|number| self.cycles.of(|| call(number))).max().unwrap_or(0);
        #[cfg(not(feature = "dwt"))]
        for number in 0..calls {
            call(number);
        }
        let stack = top - lowest_touched(top);
        assert!(stack < DEPTH, "more stack than was painted");
        #[cfg(feature = "dwt")]
        println!("{name} stack {stack} ram {ram} cycles {cycles}");
        #[cfg(not(feature = "dwt"))]
        println!("{name} stack {stack} ram {ram}");
    }
}

#[inline(always)]
fn stack_pointer() -> usize {
    let pointer: usize;
    // SAFETY: reads a register
    unsafe {
        #[cfg(target_arch = "arm")]
        asm!("mov {}, sp", out(reg) pointer, options(nomem, nostack, preserves_flags));
        #[cfg(target_arch = "riscv32")]
        asm!("mv {}, sp", out(reg) pointer, options(nomem, nostack, preserves_flags));
    }
    pointer
}

/// Paints the stack. The function is inlined, because the frame of a call would be in the painted memory.
#[inline(always)]
fn paint(top: usize) {
    let mut address = top - DEPTH;
    while address < top {
        // SAFETY: the memory below the stack pointer is unused stack: the memory map is large enough, and no interrupt is enabled
        unsafe { (black_box(address) as *mut u32).write_volatile(PAINT) };
        address += 4;
    }
}

#[inline(always)]
fn lowest_touched(top: usize) -> usize {
    let mut address = top - DEPTH;
    // SAFETY: as above
    while address < top && unsafe { (black_box(address) as *const u32).read_volatile() } == PAINT {
        address += 4;
    }
    address
}

/// Cycle counter of a Cortex-M. In QEMU it is always 0.
#[cfg(feature = "dwt")]
mod cycles {
    use cortex_m::Peripherals;
    use cortex_m::peripheral::DWT;

    pub(super) struct Counter {
        /// Cycles of an empty call.
        overhead: u32,
    }

    impl Counter {
        pub(super) fn start() -> Self {
            let mut peripherals = Peripherals::take().expect("taken once");
            peripherals.DCB.enable_trace();
            peripherals.DWT.enable_cycle_counter();
            let mut counter = Self { overhead: 0 };
            counter.overhead = counter.of(|| ());
            counter
        }

        pub(super) fn of(&self, call: impl FnOnce()) -> u32 {
            let begin = DWT::cycle_count();
            call();
            DWT::cycle_count().wrapping_sub(begin).wrapping_sub(self.overhead)
        }
    }
}
