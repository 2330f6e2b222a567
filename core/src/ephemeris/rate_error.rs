//! Error bound of the angular velocity; `core/docs/error_bound.md` derives it.

use crate::ephemeris::error_bound::{COEFFICIENTS, ErrorBound, TURN, delays};
use crate::ephemeris::evaluation::EvaluationErrors;
use crate::ephemeris::tabulated::Tabulated;
use crate::scalar::Float;

/// Rates of a motion, rad per unit time.
pub(crate) struct MotionRates {
    /// Number of half nutation periods per unit of time; 0 where u is constant.
    pub(crate) half_periods: f64,
    /// Mean rate of A + B.
    pub(crate) mean: f64,
    /// Axial component (n - K)/C of the angular velocity.
    pub(crate) axial: f64,
    /// Rate |K|/A of a rotor's momentum. It is in the rates of χ and of the slow phases, and cancels in the angular velocity of
    /// the body.
    pub(crate) rotor: f64,
    /// Upper bound on the transverse part of the angular velocity; infinite where it is not known.
    pub(crate) transverse: f64,
    /// Upper bound on the sine of the tilt.
    pub(crate) sine: f64,
}

impl MotionRates {
    /// Sum of the magnitudes of the terms of the transverse part, from the table's greatest `Speeds::sweep`.
    fn terms(&self, sweep: f64) -> f64 {
        sweep * self.half_periods + Float::abs(self.mean)
    }
}

/// Error of the angular velocity in either frame from errors of the phases.
pub(crate) struct PhaseErrors {
    /// Error caused by a delay of half a period, rad per unit time.
    delay: f64,
    /// Greatest part of the angular velocity that errors of A and B turn, rad per unit time.
    turned: f64,
}

impl PhaseErrors {
    /// Errors with these greatest speeds of the table, [`Speeds::sweep`] and [`Speeds::acceleration`].
    pub(crate) fn new(motion: &MotionRates, sweep: f64, acceleration: f64) -> Self {
        let (mean, axial) = (Float::abs(motion.mean), Float::abs(motion.axial));
        let terms = motion.terms(sweep);
        let transverse = if motion.transverse < terms { motion.transverse } else { terms };
        Self {
            // the derivative of N, and the rotation of Ω by the delay of a and b
            delay: acceleration * motion.half_periods + sweep * (mean + transverse + axial),
            turned: transverse + axial * motion.sine,
        }
    }

    /// Error of the angular velocity, rad per unit time, caused by these errors of the three phases, in turns.
    pub(crate) fn of(&self, [nutation, alpha, beta]: [f64; 3]) -> f64 {
        2.0 * nutation * self.delay + TURN * (alpha + beta) * self.turned
    }
}

/// Upper bound on the error of the angular velocity in either frame, rad per unit time, from the error of the
/// orientation at tick 0, rad, and from the errors of the phases per tick, in turns.
pub(crate) fn rate_error(
    errors: &EvaluationErrors,
    orientation: f64,
    per_tick: [f64; 3],
    motion: &MotionRates,
    tabulated: &Tabulated,
) -> ErrorBound {
    let speeds = &tabulated.speeds;
    let (per_time, mean) = (motion.half_periods, Float::abs(motion.mean));
    // errors are relative to the terms, which may cancel
    let terms = motion.terms(speeds.sweep);
    let whole = terms + Float::abs(motion.axial);
    let [truncated, random] = delays(errors.place, tabulated).map(|delay| delay * speeds.acceleration);
    let coefficients = COEFFICIENTS * speeds.sweep;
    let rounded = Float::sqrt(coefficients * coefficients + random * random);
    let own = (speeds.sweep_error + truncated + rounded) * per_time
        + errors.rate * (speeds.x_rate * per_time + mean)
        + errors.slope * speeds.velocity_change * per_time
        + errors.relative_rate * whole
        + COEFFICIENTS * motion.rotor;
    ErrorBound {
        // errors of a and b in N, and of the rotation of N and Ω
        constant: own + (terms + whole) * orientation,
        per_tick: PhaseErrors::new(motion, speeds.sweep, speeds.acceleration).of(per_tick),
    }
}
