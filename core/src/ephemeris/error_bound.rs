//! Error bound of an ephemeris; `core/docs/error_bound.md` derives every term.

use crate::ephemeris::cell::PAIRS;
use crate::ephemeris::evaluation::EvaluationErrors;
use crate::ephemeris::mean_rates::MeanRates;
use crate::ephemeris::speeds::Speeds;
use crate::ephemeris::tabulated::Tabulated;
use crate::phase::Phase;
use crate::scalar::{Extended, Float, Scalar};

/// Upper bound on the orientation error 2 √(|Δα|² + |Δβ|²), rad, relative to the exact motion of the numbers that it
/// was launched from. At tick n it is `constant + |n| per_tick`, [`ErrorBound::after`].
///
/// The errors of the increments, and of the ticks in `f32` and in fixed point, are bounded by the worst case of every
/// rounding. The roundings of set-up, and of the tick in `f64`, are bounded by six standard deviations of a sum of
/// independent roundings. The remainders of series and quadratures are estimated from their last terms. The page
/// `docs/error_bound.md` derives the terms one by one and says which of them are proved.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ErrorBound {
    /// Error at tick 0, from the polynomials, from set-up and from the evaluation, rad.
    pub constant: f64,
    /// Growth of the error per tick away from tick 0, from the rounding of the rates and of the increments, rad.
    pub per_tick: f64,
}

/// One turn in rad.
pub(crate) const TURN: f64 = 2.0 * core::f64::consts::PI;

/// Variance of the orientation error from roundings of set-up that do not depend on the motion, in units of (2^-53
/// rad)²: 24 roundings of numbers up to 1, each with a variance of 1/3.
const FIXED_VARIANCE: f64 = 8.0;
/// Standard deviation of the delay or of the error of θ that a step through the segments causes, over the sum of the
/// magnitudes of its terms, in units of 2^-53: the root of the sum of thirteen variances of 1/3.
const STEP: f64 = 2.1;
/// Standard deviation of the relative rounding error of the half phase at the start, in units of 2^-53.
const START: f64 = 1.0;
/// Standard deviation of the relative rounding error of a coefficient other than the first, in units of 2^-53: the root
/// of the sum of three variances of 1/3, of the coefficient, of the product with x and of the sum.
const COEFFICIENT: f64 = 1.0;
/// Relative error of the `f64` nearest to 1/2π, in units of 2^-53. It is common to all conversions from rad to turns.
const PER_TURN: f64 = 0.56;
/// Number of roundings of a derivative of θ in the number type of the rates, as an orientation error: the derivative is the difference of
/// two numbers that may be much larger.
const SLOPE_OPERATIONS: f64 = 32.0;
/// Number of standard deviations in the bound. One of 5e8 normal sums exceeds six.
const DEVIATIONS: f64 = 6.0;

/// Upper bound on the relative rounding error of the coefficients other than the first in set-up.
pub(crate) const COEFFICIENTS: f64 = DEVIATIONS * COEFFICIENT * <f64 as Scalar>::ROUNDING;

impl ErrorBound {
    /// Bound of a table before its set-up.
    pub(crate) const NONE: Self = Self { constant: 0.0, per_tick: 0.0 };
    /// Bound of a table that must not be used.
    pub(crate) const INFINITE: Self = Self { constant: f64::INFINITY, per_tick: 0.0 };

    /// Upper bound on the error, rad, at a number of ticks from tick 0, which may be fractional and of either sign.
    #[must_use]
    pub fn after(&self, ticks: f64) -> f64 {
        self.constant + self.per_tick * Float::abs(ticks)
    }

    /// Error bound of a table whose phases have these errors per tick, in turns.
    pub(crate) fn of(
        errors: &EvaluationErrors,
        rates: &MeanRates,
        tabulated: &Tabulated,
        per_tick: [f64; 3],
    ) -> Self {
        let Tabulated { truncation, speeds, .. } = *tabulated;
        let tick = errors.tick + errors.slope * speeds.steepness;
        let place = errors.place * speeds.sweep / PAIRS as f64;
        let end = if rates.is_periodic { 0.0 } else { rates.rounding };
        let slopes = SLOPE_OPERATIONS * errors.operation * (rates.greatest_turning() + speeds.turning);
        let rounded = rounded(errors.tick_deviation, tabulated);
        let rounded = if rounded > tabulated.defect { rounded } else { rounded + tabulated.defect };
        Self {
            constant: truncation
                + tick
                + place
                + end
                + slopes
                + rounded
                + Self::of_phases(speeds.sweep, [CLOCK; 3]),
            per_tick: Self::of_phases(speeds.sweep, per_tick),
        }
    }

    /// Orientation error, rad, caused by these errors of the three phases, in turns. The error of the nutation phase
    /// is multiplied by the greatest speed [`Speeds::sweep`]; of the slow phases only the larger error counts, because |α|² + |β|² = 1.
    pub(crate) fn of_phases(sweep: f64, [nutation, alpha, beta]: [f64; 3]) -> f64 {
        let slow = if alpha > beta { alpha } else { beta };
        2.0 * (sweep * nutation + TURN * slow)
    }
}

/// Errors of the phases per tick of a given length, in turns: the errors of the rates plus `increment_errors`, by
/// which the increments differ from the rates.
#[inline(never)] // one copy for all scalars
pub(crate) fn phase_errors(rates: &MeanRates, length: f64, increment_errors: [f64; 3]) -> [f64; 3] {
    let mut errors = increment_errors;
    for (error, of_rate) in errors.iter_mut().zip(rates.errors) {
        *error = Float::abs(*error) + of_rate * length;
    }
    errors
}

/// Truncation of a phase to its 64 leading bits, in turns.
pub(crate) const TRUNCATION: f64 = 0.5 / (1_u64 << 63) as f64;
/// Error of the phases at a tick, in turns: the phases of the first tick and of the current tick are each truncated.
const CLOCK: f64 = 2.0 * TRUNCATION;

/// Orientation error, rad, of all arithmetic in `f64`: the part common to all steps, plus six standard deviations of
/// the independent part.
fn rounded(tick_deviation: f64, tabulated: &Tabulated) -> f64 {
    const ROUNDING: f64 = <f64 as Scalar>::ROUNDING;
    let tick = tick_deviation / ROUNDING;
    let Speeds { sweep, turning, steepness, .. } = tabulated.speeds;
    let [delays, angles] = tabulated.squares;
    let steps = STEP * STEP * (delays * (sweep * sweep + turning * turning) + 4.0 * angles);
    let start = START * tabulated.speeds.delay(tabulated.start_share);
    let coefficients = COEFFICIENT * steepness;
    let variance = FIXED_VARIANCE + tick * tick + steps + start * start + coefficients * coefficients;
    let systematic = PER_TURN * (sweep + TURN);
    (systematic + DEVIATIONS * Float::sqrt(variance)) * ROUNDING
}

/// Two upper bounds on the delay of a tick near tick 0, in half periods: the delay caused by truncated phases and series,
/// and the delay caused by the roundings of the steps of set-up, which are random.
pub(crate) fn delays(place: f64, tabulated: &Tabulated) -> [f64; 2] {
    let Tabulated { squares: [delays, _], start_share, defect, stepping, speeds, .. } = *tabulated;
    let variance = STEP * STEP * delays + START * START * start_share * start_share;
    let stepping_delay = if speeds.sweep > 0.0 { (defect + stepping) / speeds.sweep } else { 0.0 };
    let truncated = place / PAIRS as f64 + 2.0 * CLOCK + stepping_delay;
    [truncated, DEVIATIONS * Float::sqrt(variance) * <f64 as Scalar>::ROUNDING]
}

/// Exact step minus increment, in turns; whole turns are ignored.
pub(crate) fn increment_error(increment: Phase, exact: Extended) -> f64 {
    let difference = (exact - increment.into()).to_f64();
    difference - libm::round(difference)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ephemeris::evaluation::EphemerisScalar;
    use crate::ephemeris::speeds::Speeds;
    use crate::scalar::Ring;

    /// Errors of the rates far above the rounding of the increments: the bound must contain each of them completely.
    #[test]
    fn the_rates_errors_are_in_it() {
        let speeds = Speeds { sweep: 5.0, turning: 3.0, steepness: 0.1, ..Speeds::ZERO };
        let tabulated = Tabulated { speeds, ..Tabulated::EMPTY };
        let nothing = Extended::ZERO;
        let rates = |errors| MeanRates {
            half_period: Extended::ONE,
            is_periodic: true,
            theta_offset: [nothing; 2],
            turns: [Extended::ONE; 3],
            errors,
            rounding: <f64 as Scalar>::ROUNDING,
        };
        let per_tick = |errors, increment_errors| {
            let rates = rates(errors);
            ErrorBound::of(&f64::ERRORS, &rates, &tabulated, phase_errors(&rates, 0.5, increment_errors))
                .per_tick
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
