//! Relaunch while an interrupt continues to sample: after each kick the main loop sets up a new table and passes its memory to the interrupt,
//! which returns that of the old one. Two lock-free queues carry the two memories, and need neither `unsafe` nor a compare-and-swap. Until the
//! table is ready, the interrupt uses a stepper.
//!
//! QEMU executes 10⁹ instructions a second. A chip of 100 MHz needs some fifteen times as many ticks as the log states.

#![no_std]
#![no_main]

use core::cell::Cell;

use cortex_m::{asm, singleton};
use cortex_m_rt::exception;
use critical_section::Mutex;
use heapless::spsc::{Consumer, Producer, Queue};
use toytop::{
    AttitudeState, Cursor, Motion, Orientation, ParameterError, PointImpulse, State, Stepper, Table,
    TableF32, TableMemory, TableSettings, Tick, Top, Workspace,
};
use toytop_firmware::{entry, exit, start_systick, toy_top};

/// Clock of the processor, Hz. The emulated boards have 25 MHz.
const CLOCK: u32 = 25_000_000;
/// Ticks in a second.
const TICK_RATE: u32 = 1000;
/// Length of a tick, s.
const TICK_LENGTH: f32 = 1.0 / TICK_RATE as f32;
/// Ticks of the simulated kicks.
const KICKS: [i64; 3] = [100, 300, 500];
/// Kick along the second fixed axis that presses down a little, at a point of the axis 30 mm above the centre of mass.
const KICK: PointImpulse = PointImpulse { impulse: [0.0, 3.0e-3, -1.0e-3], point: [0.0, 0.0, 0.06] };

/// Memory of a table, whose capacity is not in its type.
type Memory = TableMemory<Table<f32>>;
/// Memory in a static, which has one owner at a time.
type Owned = &'static mut Memory;

/// Kick that the interrupt reports: the tick, and the state without the kick.
struct Kick {
    tick: i64,
    state: AttitudeState<f32>,
}

/// Change of the interrupt to the stepper or to the new table.
struct TakeOver {
    by: &'static str,
    tick: i64,
    /// Jumps of the orientation, rad: from the propagator that the interrupt used before, and from the old table.
    jumps: [f32; 2],
}

/// Data that the interrupt owns.
struct Source {
    memory: Owned,
    cursor: Cursor<f32>,
    stepper: Option<Stepper<f32>>,
    kicks: Producer<'static, Kick>,
    bridges: Consumer<'static, (i64, Stepper<f32>)>,
    fresh: Consumer<'static, Owned>,
    used: Producer<'static, Owned>,
    log: Producer<'static, TakeOver>,
}

impl Source {
    /// Orientation at the next tick.
    fn next(&mut self) -> Orientation<f32> {
        let old = self.cursor.next(set_up(self.memory)).orientation();
        let tick = self.cursor.tick();
        let mut now = old;
        if let Some(stepper) = &mut self.stepper {
            stepper.step(TICK_LENGTH);
            now = stepper.orientation();
        }
        if let Some((kick, mut stepper)) = self.bridges.dequeue() {
            (kick..tick).for_each(|_| stepper.step(TICK_LENGTH));
            now = self.take_over("stepper", [now, old], stepper.orientation());
            self.stepper = Some(stepper);
        }
        if let Some(memory) = self.fresh.dequeue() {
            now = self.take_over("table", [now, old], set_up(memory).at_tick(tick).orientation());
            self.stepper = None;
            self.cursor = set_up(memory).cursor(tick + 1);
            let old = core::mem::replace(&mut self.memory, memory);
            assert!(self.used.enqueue(old).is_ok(), "there are but two tables");
        }
        if KICKS.contains(&tick) {
            let state = set_up(self.memory).at_tick(tick).attitude_state();
            assert!(self.kicks.enqueue(Kick { tick, state }).is_ok(), "kicks come too fast");
        }
        now
    }

    fn take_over(
        &mut self,
        by: &'static str,
        before: [Orientation<f32>; 2],
        now: Orientation<f32>,
    ) -> Orientation<f32> {
        let jumps = before.map(|before| before.distance(&now));
        let _ = self.log.enqueue(TakeOver { by, tick: self.cursor.tick(), jumps });
        now
    }
}

/// Table in this memory.
fn set_up(memory: &Memory) -> &Table<f32> {
    memory.get().expect("the main loop set it up")
}

/// Source that the main loop passes to the interrupt.
static SOURCE: Mutex<Cell<Option<Source>>> = Mutex::new(Cell::new(None));

#[exception]
fn SysTick() {
    static mut OWN: Option<Source> = None;
    if OWN.is_none() {
        *OWN = critical_section::with(|cs| SOURCE.borrow(cs).take());
    }
    if let Some(source) = OWN {
        let _orientation = source.next(); // a program uses the orientation here
    }
}

#[entry]
fn main() -> ! {
    let [first, second] = [
        singleton!(: TableMemory<TableF32> = TableMemory::new()).expect("taken once"),
        singleton!(: TableMemory<TableF32> = TableMemory::new()).expect("taken once"),
    ];
    let (kicks, mut kicks_taken) = singleton!(: Queue<Kick, 4> = Queue::new()).expect("taken once").split();
    let (mut bridge, bridges) =
        singleton!(: Queue<(i64, Stepper<f32>), 2> = Queue::new()).expect("taken once").split();
    let (mut ready, fresh) = singleton!(: Queue<Owned, 2> = Queue::new()).expect("taken once").split();
    let (used, mut spare) = singleton!(: Queue<Owned, 2> = Queue::new()).expect("taken once").split();
    let (log, mut logged) = singleton!(: Queue<TakeOver, 4> = Queue::new()).expect("taken once").split();

    let workspace = singleton!(: Workspace = Workspace::new()).expect("taken once");

    let memory: Owned = first;
    let top = launch(workspace, memory).expect("a possible launch");
    let mut second: Option<Owned> = Some(second);
    let cursor = set_up(memory).cursor(1);
    let source = Source { memory, cursor, stepper: None, kicks, bridges, fresh, used, log };
    critical_section::with(|cs| SOURCE.borrow(cs).set(Some(source)));
    start_systick(CLOCK, TICK_RATE);

    for kick in KICKS {
        let Kick { tick: at, state } = wait(&mut kicks_taken);
        let memory = second.take().unwrap_or_else(|| wait(&mut spare));
        relaunch(&top, &state, at, workspace, memory, |stepper| {
            assert!(bridge.enqueue((at, stepper)).is_ok(), "the last one is taken");
        })
        .expect("a possible kick");
        assert!(ready.enqueue(memory).is_ok(), "the last one is taken");
        let [stale, without] = [(); 2].map(|()| {
            let TakeOver { by, tick, jumps: [jump, unbridged] } = wait(&mut logged);
            defmt::info!(
                "{=i64} ms: the {=str} takes over; a jump of {=f32} rad, from the old table {=f32} rad",
                tick,
                by,
                jump,
                unbridged
            );
            tick - at - 1 // at the tick of the kick itself the orientation is right
        });
        defmt::info!(
            "kick at {=i64} ms: {=i64} stale ticks; without the stepper {=i64}",
            kick,
            stale,
            without
        );
    }
    exit()
}

/// Next item of a queue; the processor sleeps until there is one.
fn wait<T>(queue: &mut Consumer<'static, T>) -> T {
    loop {
        if let Some(item) = queue.dequeue() {
            return item;
        }
        asm::wfi();
    }
}

/// Sets up the table of the first launch, and returns its top.
#[inline(never)] // its motion does not remain on the stack
fn launch(workspace: &mut Workspace, memory: &mut Memory) -> Result<Top, ParameterError> {
    let launched = toy_top(); // by reference from here on: a motion is large
    let motion = launched.as_ref().map_err(|error| *error)?;
    memory.set_up(workspace, motion, Tick::hertz(TICK_RATE)?, &mut || {}).expect("an ordinary motion");
    Ok(*motion.top())
}

/// Launches the motion after a kick at tick `at`, passes its stepper on, and sets up its table.
#[inline(never)]
fn relaunch(
    top: &Top,
    before: &AttitudeState<f32>,
    at: i64,
    workspace: &mut Workspace,
    memory: &mut Memory,
    bridge: impl FnOnce(Stepper<f32>),
) -> Result<(), ParameterError> {
    let launched = Motion::launch(top, &State::from_attitude(before)?.with_impulse(top, &KICK)?);
    let motion = launched.as_ref().map_err(|error| *error)?;
    bridge(Stepper::new(motion));
    let settings = TableSettings { epoch: at, ..TableSettings::new(Tick::hertz(TICK_RATE)?) };
    memory.set_up(workspace, motion, settings, &mut || {}).expect("an ordinary motion");
    Ok(())
}
