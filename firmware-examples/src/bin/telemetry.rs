//! States from an interrupt to the main loop by a lock-free queue. The log shows that no state is lost, and the greatest length of the
//! queue.

#![no_std]
#![no_main]

use core::cell::RefCell;
use core::sync::atomic::{AtomicU32, Ordering};

use cortex_m::{asm, singleton};
use cortex_m_rt::exception;
use critical_section::Mutex;
use heapless::spsc::{Producer, Queue};
use toytop::{Orientation, Table};
use toytop_firmware::{entry, exit, set_up, start_systick, toy_top};

/// Clock of the processor, Hz. The emulated board has 25 MHz.
const CLOCK: u32 = 25_000_000;
/// Ticks in a second.
const TICK_RATE: u32 = 1000;
/// Number of ticks in which the main loop does not read the queue.
const AWAY: u32 = 40;
/// Size of the queue, which holds one state fewer than its size.
const SIZE: usize = 64;

/// Item of the queue.
struct Sample {
    tick: u32,
    orientation: Orientation<f32>,
}

/// Data that the interrupt owns.
struct Source {
    table: &'static Table<f32>,
    queue: Producer<'static, Sample>,
    tick: u32,
}

static SOURCE: Mutex<RefCell<Option<Source>>> = Mutex::new(RefCell::new(None));
/// Number of states that were lost because the queue was full.
static LOST: AtomicU32 = AtomicU32::new(0);

#[entry]
fn main() -> ! {
    let table = set_up(&toy_top().expect("a possible top"), TICK_RATE);
    let queue = singleton!(: Queue<Sample, SIZE> = Queue::new()).expect("taken once");
    let (producer, mut consumer) = queue.split();
    let source = Source { table, queue: producer, tick: 0 };
    critical_section::with(|cs| SOURCE.replace(cs, Some(source)));

    start_systick(CLOCK, TICK_RATE);

    let (mut taken, mut missing, mut fullest) = (0, 0, 0);
    while taken < TICK_RATE {
        for _ in 0..AWAY {
            asm::wfi(); // other work of the program
        }
        fullest = fullest.max(consumer.len());
        let (mut lowest, mut highest) = (1.0_f32, -1.0_f32);
        while let Some(Sample { tick, orientation }) = consumer.dequeue() {
            missing += tick - 1 - taken;
            taken = tick;
            let u = orientation.u();
            (lowest, highest) = (lowest.min(u), highest.max(u));
        }
        if taken % 200 == 0 {
            defmt::info!(
                "{=u32} ms: since the last look, u between {=f32} and {=f32}",
                taken,
                lowest,
                highest
            );
        }
    }
    let lost = LOST.load(Ordering::Relaxed);
    defmt::info!("{=u32} states, {=u32} missing, {=u32} refused", taken, missing, lost);
    defmt::info!("the queue held at most {=usize} of {=usize}", fullest, consumer.capacity());
    exit()
}

#[exception]
fn SysTick() {
    critical_section::with(|cs| {
        let mut source = SOURCE.borrow_ref_mut(cs);
        let Some(Source { table, queue, tick }) = source.as_mut() else { return };
        *tick += 1;
        let orientation = table.at_tick(i64::from(*tick)).orientation();
        if queue.enqueue(Sample { tick: *tick, orientation }).is_err() {
            LOST.fetch_add(1, Ordering::Relaxed);
        }
    });
}
