//! Core's calls.

use fixed::types::{I2F14, I2F30};
use toytop::real::{Real, Ring, Scalar};
use toytop::{
    Complex, Cursor, Ephemeris, EphemerisF32, EphemerisF64, FixedStepper, Heaviness, LaunchError, Motion,
    Phi, Release, State, Stepper, Tabular, Tick, Top,
};

/// Ticks a second.
pub(crate) const TICK_RATE: u32 = 1000;

/// What every tick must leave in memory.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Output<R> {
    pub(crate) phi: Phi<R>,
    pub(crate) u: R,
    /// The tip, m.
    pub(crate) c: Complex<R>,
}

impl<R: Ring> Default for Output<R> {
    fn default() -> Self {
        Self { phi: Phi::IDENTITY, u: R::ZERO, c: Complex::new(R::ZERO, R::ZERO) }
    }
}

/// Measured numbers, before anything is computed from them.
pub(crate) struct Measured {
    /// A and C, kg m².
    inertia: [f64; 2],
    /// s, m.
    com_height: f64,
    /// kg.
    mass: f64,
    release: Release,
}

impl Default for Measured {
    /// 50 g, let go at 0.35 rad with 150 rad/s.
    fn default() -> Self {
        let release = Release { tilt: 0.35, spin: 150.0, ..Release::default() };
        Self { inertia: [3.0e-5, 2.0e-5], com_height: 0.03, mass: 0.05, release }
    }
}

impl Measured {
    pub(crate) fn state(&self) -> Result<State, LaunchError> {
        State::release(&self.release)
    }

    pub(crate) fn motion(&self) -> Result<Motion, LaunchError> {
        let [a, c] = self.inertia;
        let top = Top::sliding(a, c, self.com_height, Heaviness::Mass(self.mass), 9.81)?;
        Motion::launch(&top, &self.state()?)
    }
}

/// What `Ephemeris::new` allows.
pub(crate) fn truncation<R: Scalar>() -> f64 {
    4.0 * R::ROUNDING
}

/// Set-up, from measured numbers to a table ready to tick. Once per throw.
#[inline(never)]
#[unsafe(no_mangle)]
pub(crate) extern "C" fn bench_launch(ephemeris: &mut EphemerisF32, measured: &Measured) -> bool {
    let (Ok(motion), Ok(tick)) = (measured.motion(), Tick::hertz(TICK_RATE)) else { return false };
    ephemeris.set_up(&motion, tick, truncation::<f32>()).is_ok()
}

#[inline(never)]
#[unsafe(no_mangle)]
pub(crate) extern "C" fn bench_ephemeris_f32(ephemeris: &EphemerisF32, tick: i64, out: &mut Output<f32>) {
    let (phi, c) = ephemeris.at_tick(tick).phi_and_tip();
    *out = Output { phi, u: phi.u(), c };
}

#[inline(never)]
#[unsafe(no_mangle)]
pub(crate) extern "C" fn bench_ephemeris_f64(ephemeris: &EphemerisF64, tick: i64, out: &mut Output<f64>) {
    let (phi, c) = ephemeris.at_tick(tick).phi_and_tip();
    *out = Output { phi, u: phi.u(), c };
}

/// A table with its way through consecutive ticks, whatever its size.
pub(crate) trait Table {
    type Cursor<'a>
    where
        Self: 'a;
}

impl<R: Tabular + 'static, const SEGMENTS: usize, const TERMS: usize> Table
    for Ephemeris<R, SEGMENTS, TERMS>
{
    type Cursor<'a> = Cursor<'a, R, SEGMENTS, TERMS>;
}

pub(crate) type CursorOf<'a, T> = <T as Table>::Cursor<'a>;

#[inline(never)]
#[unsafe(no_mangle)]
pub(crate) extern "C" fn bench_cursor_f32(cursor: &mut CursorOf<'_, EphemerisF32>, out: &mut Output<f32>) {
    let (phi, c) = cursor.next().phi_and_tip();
    *out = Output { phi, u: phi.u(), c };
}

#[inline(never)]
#[unsafe(no_mangle)]
pub(crate) extern "C" fn bench_cursor_f64(cursor: &mut CursorOf<'_, EphemerisF64>, out: &mut Output<f64>) {
    let (phi, c) = cursor.next().phi_and_tip();
    *out = Output { phi, u: phi.u(), c };
}

/// In fixed point the tip is in units of s.
pub(crate) type EphemerisQ31 = Ephemeris<I2F30, 32, 4>;
/// The size that 16 bits need for the same motion.
pub(crate) type EphemerisQ15 = Ephemeris<I2F14, 16, 3>;

#[inline(never)]
#[unsafe(no_mangle)]
pub(crate) extern "C" fn bench_ephemeris_q31(ephemeris: &EphemerisQ31, tick: i64, out: &mut Output<I2F30>) {
    let (phi, c) = ephemeris.at_tick(tick).phi_and_tip();
    *out = Output { phi, u: phi.u(), c };
}

#[inline(never)]
#[unsafe(no_mangle)]
pub(crate) extern "C" fn bench_cursor_q31(cursor: &mut CursorOf<'_, EphemerisQ31>, out: &mut Output<I2F30>) {
    let (phi, c) = cursor.next().phi_and_tip();
    *out = Output { phi, u: phi.u(), c };
}

#[inline(never)]
#[unsafe(no_mangle)]
pub(crate) extern "C" fn bench_ephemeris_q15(ephemeris: &EphemerisQ15, tick: i64, out: &mut Output<I2F14>) {
    let (phi, c) = ephemeris.at_tick(tick).phi_and_tip();
    *out = Output { phi, u: phi.u(), c };
}

#[inline(never)]
#[unsafe(no_mangle)]
pub(crate) extern "C" fn bench_cursor_q15(cursor: &mut CursorOf<'_, EphemerisQ15>, out: &mut Output<I2F14>) {
    let (phi, c) = cursor.next().phi_and_tip();
    *out = Output { phi, u: phi.u(), c };
}

/// A stepper, and 2 s for the tip.
pub(crate) struct Stepping<R> {
    stepper: Stepper<R>,
    tip_scale: R,
}

impl<R: Real> Stepping<R> {
    pub(crate) fn new(motion: &Motion) -> Self {
        Self { stepper: Stepper::new(motion), tip_scale: R::from_f64(2.0 * motion.top().s()) }
    }

    #[inline(always)]
    pub(crate) fn step(&mut self, out: &mut Output<R>) {
        self.stepper.step(R::from_f64(1.0 / TICK_RATE as f64));
        *out = Output::of(self.stepper.phi(), self.tip_scale);
    }
}

impl<R: Ring> Output<R> {
    #[inline(always)]
    pub(crate) fn of(phi: Phi<R>, tip_scale: R) -> Self {
        Self { phi, u: phi.u(), c: (phi.alpha * phi.beta).scaled(tip_scale) }
    }
}

/// Set-up, from measured numbers to a stepper in fixed point.
#[inline(never)]
#[unsafe(no_mangle)]
pub(crate) extern "C" fn bench_launch_stepper_q31(
    stepper: &mut Option<FixedStepper>,
    measured: &Measured,
) -> bool {
    let (Ok(motion), Ok(tick)) = (measured.motion(), Tick::hertz(TICK_RATE)) else { return false };
    *stepper = FixedStepper::new(&motion, tick).ok();
    stepper.is_some()
}

#[inline(never)]
#[unsafe(no_mangle)]
pub(crate) extern "C" fn bench_stepper_q31(stepper: &mut FixedStepper, out: &mut Output<I2F30>) {
    stepper.step();
    let (phi, c) = stepper.phi_and_tip();
    *out = Output { phi, u: stepper.u(), c };
}

#[inline(never)]
#[unsafe(no_mangle)]
pub(crate) extern "C" fn bench_stepper_f32(stepping: &mut Stepping<f32>, out: &mut Output<f32>) {
    stepping.step(out);
}

#[inline(never)]
#[unsafe(no_mangle)]
pub(crate) extern "C" fn bench_stepper_f64(stepping: &mut Stepping<f64>, out: &mut Output<f64>) {
    stepping.step(out);
}
