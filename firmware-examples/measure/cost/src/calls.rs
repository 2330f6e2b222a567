//! Calls of core.

use fixed::types::{I2F14, I2F30};
use toytop::scalar::{Real, Ring};
use toytop::{
    Complex, Cursor, Motion, Orientation, ParameterError, Release, Sample, SizedTable, State, Stepper, Table,
    TableF32, TableF64, TableMemory, TableQ15, TableQ31, TableScalar, Tick, Top, TopParameters, Workspace,
};

/// Number of ticks per second.
pub(crate) const TICK_RATE: u32 = 1000;

/// Result of a tick, which it writes to memory.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Output<R> {
    pub(crate) orientation: Orientation<R>,
    pub(crate) u: R,
    /// Tip in units of s.
    pub(crate) c: Complex<R>,
}

impl<R: Default> Default for Output<R> {
    fn default() -> Self {
        let zero = || Complex::new(R::default(), R::default());
        Self { orientation: Orientation { alpha: zero(), beta: zero() }, u: R::default(), c: zero() }
    }
}

/// Measured numbers, the input of a launch.
pub(crate) struct Measured {
    parameters: TopParameters,
    release: Release,
}

impl Default for Measured {
    /// Numbers of a 50 g top that is released at a tilt of 0.35 rad with 150 rad/s.
    fn default() -> Self {
        Self::released(0.35, 150.0)
    }
}

impl Measured {
    /// Numbers of this top at 5 rad/s, where gravity and not the spin determines the nutation.
    pub(crate) fn slow() -> Self {
        Self::released(0.35, 5.0)
    }

    /// Numbers of this top almost upright, with too little spin to stay upright.
    pub(crate) fn falling() -> Self {
        Self::released(1e-3, 30.0)
    }

    fn released(tilt: f64, spin: f64) -> Self {
        let release = Release { tilt, spin, ..Release::default() };
        Self { parameters: TopParameters::TOY, release }
    }

    pub(crate) fn state(&self) -> Result<State, ParameterError> {
        State::from_release(&self.release)
    }

    pub(crate) fn top(&self) -> Result<Top, ParameterError> {
        Top::sliding(&self.parameters)
    }

    pub(crate) fn motion(&self) -> Result<Motion, ParameterError> {
        Motion::launch(&self.top()?, &self.state()?)
    }
}

/// Memory of a table in `f32` of this many segments.
pub(crate) type Memory<const SEGMENTS: usize> = TableMemory<SizedTable<f32, SEGMENTS>>;

#[inline(never)]
fn set_up(memory: &mut TableMemory<Table<f32>>, workspace: &mut Workspace, top: &Top, state: &State) -> bool {
    let Ok(tick) = Tick::hertz(TICK_RATE) else { return false };
    let motion = Motion::launch(top, state);
    let Ok(motion) = &motion else { return false };
    memory.set_up(workspace, motion, tick, &mut || {}).is_ok()
}

/// Set-up with its own memory on the stack.
#[inline(never)]
fn on_stack(memory: &mut TableMemory<Table<f32>>, measured: &Measured) -> bool {
    let (Ok(top), Ok(state)) = (measured.top(), measured.state()) else { return false };
    set_up(memory, &mut Workspace::new(), &top, &state)
}

/// Cursor with its table, as an interrupt keeps them.
pub(crate) struct Reader<'a, R, T> {
    pub(crate) cursor: Cursor<R>,
    pub(crate) table: &'a T,
}

/// Parameters α and β, and the angular velocity, rad/s: Ω in the body frame, as a gyroscope measures it, or ω in the fixed frame.
type Rates<R> = (Complex<R>, Complex<R>, [f32; 3]);

#[inline(always)]
fn rates<R>((Orientation { alpha, beta }, omega): (Orientation<R>, [f32; 3])) -> Rates<R> {
    (alpha, beta, omega)
}

impl<R: Ring> Output<R> {
    #[inline(always)]
    pub(crate) fn of(orientation: Orientation<R>) -> Self {
        Self { orientation, u: orientation.u(), c: orientation.tip_over_s() }
    }
}

impl<R: TableScalar> From<Sample<'_, R>> for Output<R> {
    #[inline(always)]
    fn from(sample: Sample<'_, R>) -> Self {
        Self { orientation: sample.orientation(), u: sample.u(), c: sample.tip_over_s() }
    }
}

#[inline(always)]
fn step<R: Real>(stepper: &mut Stepper<R>, out: &mut Output<R>) {
    stepper.step(R::from_f64(1.0 / TICK_RATE as f64));
    *out = Output::of(stepper.orientation());
}

symbols! {
    /// Set-up from measured numbers to a complete table, once per launch.
    fn bench_launch(memory: &mut Memory<25>, measured: &Measured) -> bool {
        on_stack(memory, measured)
    }

    /// Set-up as for `bench_launch`, of a table that is made by value on the stack.
    fn bench_new(measured: &Measured, out: &mut Output<f32>) -> bool {
        let (Ok(motion), Ok(tick)) = (measured.motion(), Tick::hertz(TICK_RATE)) else { return false };
        let Ok(table) = TableF32::new(&motion, tick) else { return false };
        *out = table.at_tick(0).into();
        true
    }

    /// Set-up of [`Measured::slow`].
    fn bench_launch_slow(memory: &mut Memory<64>, measured: &Measured) -> bool {
        on_stack(memory, measured)
    }

    /// Set-up of [`Measured::falling`].
    fn bench_launch_falling(memory: &mut Memory<128>, measured: &Measured) -> bool {
        on_stack(memory, measured)
    }

    /// Set-up as for `bench_launch`, with memory that a program keeps in a static.
    fn bench_launch_in_static(scratch: &mut Workspace, memory: &mut Memory<25>, launch: &(Top, State)) -> bool {
        let (top, state) = launch;
        set_up(memory, scratch, top, state)
    }

    fn bench_ephemeris_f32(table: &TableF32, tick: i64, out: &mut Output<f32>) {
        *out = table.at_tick(tick).into();
    }

    fn bench_cursor_f32(reader: &mut Reader<'_, f32, TableF32>, out: &mut Output<f32>) {
        *out = reader.cursor.next(reader.table).into();
    }

    fn bench_ephemeris_f64(table: &TableF64, tick: i64, out: &mut Output<f64>) {
        *out = table.at_tick(tick).into();
    }

    fn bench_cursor_f64(reader: &mut Reader<'_, f64, TableF64>, out: &mut Output<f64>) {
        *out = reader.cursor.next(reader.table).into();
    }

    fn bench_ephemeris_q31(table: &TableQ31, tick: i64, out: &mut Output<I2F30>) {
        *out = table.at_tick(tick).into();
    }

    fn bench_cursor_q31(reader: &mut Reader<'_, I2F30, TableQ31>, out: &mut Output<I2F30>) {
        *out = reader.cursor.next(reader.table).into();
    }

    fn bench_ephemeris_q15(table: &TableQ15, tick: i64, out: &mut Output<I2F14>) {
        *out = table.at_tick(tick).into();
    }

    fn bench_cursor_q15(reader: &mut Reader<'_, I2F14, TableQ15>, out: &mut Output<I2F14>) {
        *out = reader.cursor.next(reader.table).into();
    }

    /// Parameters α and β, and the tip in m.
    fn bench_tip_q31(
        reader: &mut Reader<'_, I2F30, TableQ31>,
        out: &mut (Complex<I2F30>, Complex<I2F30>, Complex<f32>),
    ) {
        let sample = reader.cursor.next(reader.table);
        let Orientation { alpha, beta } = sample.orientation();
        *out = (alpha, beta, sample.tip());
    }

    fn bench_omega_f32(table: &TableF32, tick: i64, out: &mut Rates<f32>) {
        let sample = table.at_tick(tick);
        *out = rates((sample.orientation(), sample.omega_body()));
    }

    fn bench_omega_q31(table: &TableQ31, tick: i64, out: &mut Rates<I2F30>) {
        let sample = table.at_tick(tick);
        *out = rates((sample.orientation(), sample.omega_body()));
    }

    fn bench_omega_fixed_f32(table: &TableF32, tick: i64, out: &mut Rates<f32>) {
        let state = table.at_tick(tick).attitude_state();
        *out = rates((state.orientation, state.omega()));
    }

    fn bench_stepper_f32(stepper: &mut Stepper<f32>, out: &mut Output<f32>) {
        step(stepper, out);
    }

    fn bench_stepper_f64(stepper: &mut Stepper<f64>, out: &mut Output<f64>) {
        step(stepper, out);
    }
}
