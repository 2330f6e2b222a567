//! Error bound of the angular velocity; `core/docs/error_bound.md` derives it.

use crate::ephemeris::error_bound::{COEFFICIENTS, ErrorBound, delays};
use crate::ephemeris::evaluation::EphemerisScalar;
use crate::ephemeris::tabulated::Tabulated;
use crate::scalar::Float;

/// Rates of a motion, rad per unit time.
pub(crate) struct MotionRates {
    /// Half a nutation period, in units of time; 0 where u is constant.
    pub(crate) half_period: f64,
    /// Mean rate of A + B.
    pub(crate) mean: f64,
    /// Axial component (n - K)/C of the angular velocity.
    pub(crate) axial: f64,
    /// Rate |K|/A of a rotor's momentum. It is in the rates of χ and of the slow phases, and cancels in the angular velocity of
    /// the body.
    pub(crate) rotor: f64,
}

/// Upper bound on the error of the angular velocity in either frame, rad per unit time, from the error bound of the
/// orientation.
pub(crate) fn rate_error<R: EphemerisScalar>(
    orientation: &ErrorBound,
    motion: &MotionRates,
    tabulated: &Tabulated,
) -> ErrorBound {
    let MotionRates { half_period, mean, axial, rotor } = *motion;
    let speeds = &tabulated.speeds;
    let per_time = if half_period > 0.0 { 1.0 / half_period } else { 0.0 };
    let mean = Float::abs(mean);
    let transverse = speeds.sweep * per_time + mean;
    let whole = transverse + Float::abs(axial);
    let [truncated, random] = delays::<R>(tabulated).map(|delay| delay * speeds.acceleration);
    let coefficients = COEFFICIENTS * speeds.sweep;
    let rounded = Float::sqrt(coefficients * coefficients + random * random);
    let own = (speeds.sweep_error + truncated + rounded) * per_time
        + R::RATE_ERROR * (speeds.x_rate * per_time + mean)
        + R::SLOPE_ROUNDING * speeds.bend * per_time
        + R::RATE_ROUNDING * whole
        + COEFFICIENTS * rotor;
    // a delay changes the transverse part at this rate, over its share in the error of the orientation
    let delayed = if speeds.sweep > 0.0 { speeds.acceleration / speeds.sweep * per_time } else { 0.0 };
    let turned = mean + whole;
    ErrorBound {
        constant: own + turned * orientation.constant,
        per_tick: (delayed + turned) * orientation.per_tick,
    }
}
