//! The length of a tick, where times are asked for and not ticks.

use crate::Failure;
use crate::motion::propagate::period;
use toytop::{Motion, ParameterError, Stepper, Tick};

/// Ticks in a unit of time, a power of two: an ephemeris that is asked for times only is free to choose. At least a
/// thousand in a period, and more than one in a turn.
#[must_use]
pub fn ticks_per_time(motion: &Motion) -> f64 {
    ticks_for(motion, period(motion))
}

/// The same, where the period (or the natural time) is known.
#[must_use]
pub fn ticks_for(motion: &Motion, period: f64) -> f64 {
    let [x, y, z] = Stepper::<f64>::new(motion).attitude_state().omega();
    let rate = (x * x + y * y + z * z).sqrt().max(1000.0 / period);
    rate.log2().ceil().clamp(-MOST_EXPONENT, MOST_EXPONENT).exp2()
}

pub(super) fn free_tick(motion: &Motion, period: f64) -> Result<Tick, Failure> {
    tick(ticks_for(motion, period)).map_err(|error| Failure::Method(error.to_string()))
}

/// 2^31 fits the numerator and the denominator of a [`Tick`].
const MOST_EXPONENT: f64 = 31.0;

/// So many ticks in a unit of time, or one in so many: a whole number.
pub(crate) fn tick(frequency: f64) -> Result<Tick, ParameterError> {
    if frequency >= 1.0 { Tick::hertz(frequency as u32) } else { Tick::ratio(1, frequency.recip() as u32) }
}

/// The times that can be asked for are within ± this: ticks are counted in 64 bits.
#[must_use]
pub fn furthest_time(motion: &Motion) -> f64 {
    62_f64.exp2() / ticks_per_time(motion)
}
