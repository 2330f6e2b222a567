//! Length of a tick for a motion that is computed at times, not at ticks.

use crate::Failure;
use crate::motion::propagate::period;
use toytop::{Motion, ParameterError, Stepper, Tick};

/// Ticks in a unit of time, a power of two: at least a thousand in a period, and more than one in a turn. An ephemeris that is used
/// for times only may have ticks of any length.
#[must_use]
pub fn ticks_per_time(motion: &Motion) -> f64 {
    ticks_for(motion, period(motion))
}

/// Ticks in a unit of time, as [`ticks_per_time`], where the period (or the natural time) is known.
#[must_use]
pub fn ticks_for(motion: &Motion, period: f64) -> f64 {
    let [x, y, z] = Stepper::<f64>::new(motion).attitude_state().omega();
    let rate = (x * x + y * y + z * z).sqrt().max(1000.0 / period);
    rate.log2().ceil().clamp(-MOST_EXPONENT, MOST_EXPONENT).exp2()
}

pub(super) fn free_tick(motion: &Motion, period: f64) -> Result<Tick, Failure> {
    tick(ticks_for(motion, period)).map_err(|error| Failure::Method(error.to_string()))
}

/// Largest exponent of a power of two that is allowed as numerator and denominator of a [`Tick`].
const MOST_EXPONENT: f64 = 31.0;

/// Tick of this frequency per unit of time. The frequency or its reciprocal is a whole number.
pub fn tick(frequency: f64) -> Result<Tick, ParameterError> {
    if frequency >= 1.0 { Tick::hertz(frequency as u32) } else { Tick::ratio(1, frequency.recip() as u32) }
}

/// Greatest distance of a time from t = 0 at which an ephemeris can be evaluated, because ticks are counted in 64 bits.
#[must_use]
pub fn furthest_time(motion: &Motion) -> f64 {
    62_f64.exp2() / ticks_per_time(motion)
}
