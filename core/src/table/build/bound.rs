//! Error bounds of an ephemeris; `core/docs/error_bound.md` derives every term.

use crate::phase::Phase;
use crate::scalar::{Extended, Float, Scalar};
use crate::table::build::errors::{DEVIATIONS, TURN, TableSummary};
use crate::table::build::mean_rates::MeanRates;
use crate::table::scalar::EvaluationErrors;

/// Upper bound on an error at any tick: `constant` plus `per_tick` for each tick from the launch.
///
/// That of the orientation is 2 √(|Δα|² + |Δβ|²), relative to the exact motion of the numbers that were launched. It counts the worst case
/// of integer roundings, six standard deviations of those in `f64`, and an estimate of the series' remainders.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ErrorBound {
    /// Error at the tick of the launch, rad (rad per unit time for rates).
    pub constant: f64,
    /// Growth of the error per tick from the launch, rad (rad per unit time for rates).
    pub per_tick: f64,
}

impl ErrorBound {
    /// Bound of a table before its set-up.
    pub(crate) const NONE: Self = Self { constant: 0.0, per_tick: 0.0 };

    /// Upper bound on the error at a number of ticks from the launch, which may be fractional and of either sign.
    #[must_use]
    pub fn after(&self, ticks: f64) -> f64 {
        self.constant + self.per_tick * Float::abs(ticks)
    }
}

/// Number of roundings of a derivative of θ.
const SLOPE_OPERATIONS: f64 = 32.0;
/// Errors of the phases at a tick, in turns: two truncations to 64 bits.
const CLOCK: f64 = 1.0 / (1_u64 << 63) as f64;

/// Error bounds of the orientation and of the angular velocity.
///
/// * `rates`: number of half nutation periods, mean rate of A + B, axial component (n - K)/C of the angular velocity and rate |K|/A of a
///   rotor's momentum, per unit time
/// * `increments`: errors of the increments of the phases, turns per tick
/// * `tick`: length of a tick
#[inline(never)] // one copy for all scalars
pub(crate) fn error_bounds(
    errors: &EvaluationErrors,
    mean_rates: &MeanRates,
    summary: &TableSummary,
    [half_periods, mean, axial, rotor]: [f64; 4],
    (tick, increments): (f64, [f64; 3]),
) -> [ErrorBound; 2] {
    let TableSummary { error, speeds, .. } = *summary;
    let sweep = speeds.sweep;
    let [mut nutation, mut alpha, mut beta] = increments;
    for (error, of_rate) in [&mut nutation, &mut alpha, &mut beta].into_iter().zip(mean_rates.errors) {
        *error = Float::abs(*error) + of_rate * tick;
    }
    let of_phases = |nutation: f64, slow: f64| 2.0 * (sweep * nutation + TURN * slow);
    let slopes = SLOPE_OPERATIONS * errors.operation * (mean_rates.greatest_turning() + speeds.turning);
    let evaluation = errors.tick + errors.slope * speeds.steepness();
    let constant = error + evaluation + slopes + of_phases(CLOCK, CLOCK);
    let orientation = ErrorBound { constant, per_tick: of_phases(nutation, alpha.max(beta)) };

    // terms of the angular velocity, which may cancel: of the transverse part, and of the whole
    let terms = sweep * half_periods + Float::abs(mean);
    let whole = terms + Float::abs(axial);
    // change of the angular velocity by a delay of half a period, and by one in which the orientation turns by 1 rad
    let delay = (speeds.acceleration * half_periods) + sweep * whole;
    let turned = if sweep > 0.0 { speeds.acceleration / sweep * half_periods } else { 0.0 };
    let relative = errors.relative_rate + DEVIATIONS * <f64 as Scalar>::ROUNDING;
    let rate = ErrorBound {
        constant: speeds.sweep_error * half_periods
            + errors.rate * (speeds.x_rate * half_periods + Float::abs(mean))
            + relative * (whole + rotor)
            + (turned + terms + whole) * constant,
        per_tick: 2.0 * nutation * delay + TURN * (alpha + beta) * whole,
    };
    [orientation, rate]
}

/// Exact step minus increment, in turns; whole turns are ignored.
pub(crate) fn increment_error(increment: Phase, exact: Extended) -> f64 {
    let difference = (exact - increment.into()).to_f64();
    difference - libm::round(difference)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::Ring;
    use crate::table::build::errors::Speeds;
    use crate::table::scalar::EphemerisScalar;

    /// Errors of the rates far above the rounding of the increments: the bound must contain each of them completely.
    #[test]
    fn the_rates_errors_are_in_it() {
        let speeds = Speeds { sweep: 5.0, turning: 3.0, ..Speeds::ZERO };
        let summary = TableSummary { speeds, ..TableSummary::EMPTY };
        let nothing = Extended::ZERO;
        let motion = [1.0, 0.0, 0.0, 0.0];
        let per_tick = |errors, increment_errors| {
            let rates = MeanRates {
                half_period: Extended::ONE,
                theta_offset: [nothing; 2],
                turns: [Extended::ONE; 3],
                errors,
            };
            let [bound, _] = error_bounds(&f64::ERRORS, &rates, &summary, motion, (0.5, increment_errors));
            bound.per_tick
        };
        for (errors, allowed) in [
            ([1e-20, 0.0, 0.0], 5e-20),
            ([0.0, 1e-20, 0.0], TURN * 1e-20),
            ([0.0, 0.0, 1e-20], TURN * 1e-20),
            ([1e-20; 3], (5.0 + TURN) * 1e-20),
        ] {
            assert!((per_tick(errors, [0.0; 3]) / allowed - 1.0).abs() < 1e-12, "{errors:?}");
        }
        assert!((per_tick([0.0; 3], [-1e-29; 3]) / (2.0 * (5.0 + TURN) * 1e-29) - 1.0).abs() < 1e-12);
        assert_eq!(per_tick([0.0; 3], [0.0; 3]), 0.0);
    }

    #[test]
    fn an_increment_error_is_known_to_the_last_place() {
        let third = Extended::ONE / Extended::from(3.0);
        let error = increment_error(third.to_phase(), third) / Phase::RESOLUTION;
        assert!((error - 1.0 / 3.0).abs() < 1e-3, "{error}");
        // whole turns beyond 2^32 do not matter
        let far = third + Extended::from(2_f64.powi(40));
        assert!(increment_error(far.to_phase(), far).abs() < 1e-18);
    }
}
