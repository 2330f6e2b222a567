//! Ticks of a table that is asked for times.

use crate::constants::period;
use toytop::scalar::Float;
use toytop::{Motion, ParameterError, Stepper, Tick};

/// Ticks in a unit of time, a power of two: at least a thousand in a period, and more than one in a turn.
pub fn ticks_per_time(motion: &Motion) -> f64 {
    /// A [`Tick`] has 32 bits on both sides.
    const MOST: f64 = (1_u32 << 31) as f64;
    let [x, y, z] = Stepper::<f64>::new(motion).attitude_state().omega();
    let fastest = Float::sqrt(x * x + y * y + z * z).max(1000.0 / period(motion));
    let mut rate = MOST.recip();
    while rate < fastest.min(MOST) {
        rate *= 2.0;
    }
    rate
}

/// Tick of a motion.
///
/// # Errors
/// None: the rate is a power of two from 2^-31 to 2^31.
pub fn tick(motion: &Motion) -> Result<Tick, ParameterError> {
    let rate = ticks_per_time(motion);
    if rate >= 1.0 { Tick::hertz(rate as u32) } else { Tick::ratio(1, rate.recip() as u32) }
}
