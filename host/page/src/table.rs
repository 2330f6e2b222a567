//! Table of a motion in `f64`: the orientation at any time, at the same cost.

use crate::constants::period;
use toytop::scalar::Float;
use toytop::{Complex, Ephemeris, Motion, Orientation, ParameterError, Stepper, Tick};

/// Table with the largest capacity that there is.
pub type Table = Ephemeris<f64, 4096>;

/// Orientation, u, axis and tip at one time: Re α, Im α, Re β, Im β, u, r₁, r₂, r₃, c₁, c₂.
pub type Moment = [f64; 10];

/// Truncation errors that a table may have, rad: the least one that the capacity allows is taken.
const TRUNCATIONS: [f64; 4] = [2.0 * f64::EPSILON, 1e-12, 1e-9, 1e-6];

/// Sets the table up for another motion.
///
/// # Errors
/// `e3`: the motion is so close to the separatrix that no table holds it.
pub fn set_up(table: &mut Table, motion: &Motion) -> Result<(), ParameterError> {
    let tick = tick(motion)?;
    let fits = |truncation: &f64| table.set_up(motion, tick, *truncation).is_ok();
    if TRUNCATIONS.iter().any(fits) {
        return Ok(());
    }
    let allowed = "further from e2: no table holds this motion";
    Err(ParameterError::OutOfRange { parameter: "e3", allowed })
}

/// Moment t after t = 0, with t taken as exact.
#[must_use]
pub fn moment_at(table: &Table, t: f64) -> Moment {
    let (orientation, tip) = table.at(t).orientation_and_tip();
    moment(&orientation, tip)
}

/// Numbers of a moment.
#[must_use]
pub fn moment(orientation: &Orientation<f64>, tip: Complex<f64>) -> Moment {
    let (Orientation { alpha, beta }, [x, y, z]) = (orientation, orientation.axis());
    [alpha.re, alpha.im, beta.re, beta.im, orientation.clamped_u(), x, y, z, tip.re, tip.im]
}

/// Ticks in a unit of time, a power of two: at least a thousand in a period, and more than one in a turn.
#[must_use]
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

/// Tick of a motion. A page asks for times and not for ticks, so that any tick will do that is short enough.
///
/// # Errors
/// None: the rate is a power of two from 2^-31 to 2^31.
pub fn tick(motion: &Motion) -> Result<Tick, ParameterError> {
    let rate = ticks_per_time(motion);
    if rate >= 1.0 { Tick::hertz(rate as u32) } else { Tick::ratio(1, rate.recip() as u32) }
}
