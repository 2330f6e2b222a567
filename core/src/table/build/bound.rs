//! Error bounds of an ephemeris; `core/docs/error_bound.md` derives every term.

use super::expansion::larger_or_nan;
use super::mean_rates::MeanRates;
use crate::motion::Motion;
use crate::scalar::{Extended, Float, Ring, Scalar};
use crate::table::data::ErrorBound;
use crate::table::evaluation::{EvaluationErrors, TABLE_UNIT};

/// One turn in rad.
const TURN: f64 = 2.0 * core::f64::consts::PI;
/// Number of standard deviations in a bound.
const DEVIATIONS: f64 = 6.0;
/// Variance of the roundings that do not depend on the motion, in (2^-53 rad)².
const FIXED_VARIANCE: f64 = 12.0;
/// Relative errors of the `f64` nearest to 1/2π and of two phases of 64 bits, in units of 2^-53.
const PER_TURN: f64 = 0.56 + 1.0 / 512.0;
/// Standard deviation of a step's rounding, relative to its terms, in units of 2^-53.
const STEP: f64 = 2.1;

/// Upper bounds on the speeds of α and β without their mean rotation. The unit of time is half a period.
#[derive(Clone, Copy, Debug)]
pub(super) struct Speeds {
    /// Angular speed 2 √(|dα/dt|² + |dβ/dt|²), rad.
    angular: f64,
    /// Twice the greater rate of a residual phase, rad.
    residual: f64,
    /// Acceleration 2 √(|d²α/dt²|² + |d²β/dt²|²), rad.
    acceleration: f64,
    /// Truncation error of the angular speed, rad.
    angular_error: f64,
    /// Rate of the local coordinate x.
    x_rate: f64,
}

impl Speeds {
    pub(super) const ZERO: Self =
        Self { angular: 0.0, residual: 0.0, acceleration: 0.0, angular_error: 0.0, x_rate: 0.0 };

    /// Includes the speeds on a segment.
    ///
    /// * `x_rate`: rate of x per half period
    /// * `residual_rate`: bound on the rates of the residual phases by x
    pub(super) fn include(&mut self, segment: &SegmentErrors, x_rate: f32, residual_rate: f32) {
        let root = |squares: f32| 2.0 * TABLE_UNIT as f32 * Float::sqrt(squares);
        let include = |greatest: &mut f64, speed: f32| *greatest = larger_or_nan(*greatest, speed.into());
        include(&mut self.angular, root(segment.slope) * x_rate);
        include(&mut self.residual, 2.0 * residual_rate * x_rate);
        include(&mut self.acceleration, root(segment.curvature) * x_rate * x_rate);
        include(&mut self.angular_error, root(segment.slope_error) * x_rate);
        include(&mut self.x_rate, x_rate);
    }

    /// Greatest change of the orientation on half a segment, which is at most one cell, rad.
    fn half_segment_change(&self) -> f64 {
        self.angular / 16.0
    }

    /// Orientation error by a delay of χ alone, in half periods.
    pub(super) fn error_of_delay(&self, delay: f64) -> f64 {
        (self.angular + self.residual) * delay
    }

    /// Orientation error, rad, of all roundings in `f64`.
    ///
    /// * `delays`, `angles`: sums of the squares of the steps' terms of χ, as delays in half periods, and of the residual phases, rad
    /// * `start`: delay by a rounding of χ at t = 0, in half periods
    pub(super) fn rounding(&self, [delays, angles]: [f64; 2], start: f64) -> f64 {
        let Self { angular, residual, .. } = *self;
        let steps = STEP * STEP * (delays * (angular * angular + residual * residual) + 4.0 * angles);
        // of the half phase at the launch, and of the coefficients after the first
        let others = self.error_of_delay(start).squared() + self.half_segment_change().squared();
        let deviation = Float::sqrt(FIXED_VARIANCE + steps + others);
        (DEVIATIONS * deviation + PER_TURN * (angular + TURN)) * f64::ROUNDING
    }
}

/// Errors and derivatives of a segment, in units of 2^-62. `f64` is slow without an FPU for it.
#[derive(Default)]
pub(super) struct SegmentErrors {
    /// Greatest error of the stored coefficients.
    pub(super) stored: f32,
    /// Sum of the squares of the truncation errors. Those below are of first derivatives, of their errors, and of second derivatives.
    pub(super) change: f32,
    pub(super) slope: f32,
    pub(super) slope_error: f32,
    pub(super) curvature: f32,
}

impl SegmentErrors {
    /// Orientation error by truncation and rounding, in units of 2^-62 rad.
    pub(super) fn error(&self) -> f32 {
        larger_or_nan(2.0 * Float::sqrt(self.change), self.stored)
    }
}

/// Error bounds of orientation and angular velocity, from the length of a tick and the table's `error`.
pub(super) fn error_bounds(
    errors: &EvaluationErrors,
    motion: &Motion,
    tick: Extended,
    rates: &MeanRates,
    speeds: &Speeds,
    error: f64,
) -> [ErrorBound; 2] {
    let Speeds { angular, acceleration, .. } = *speeds;
    let mut growth = rates.errors;
    for (growth, turns) in growth.iter_mut().zip(rates.turns) {
        *growth = *growth * tick.to_f64() + increment_error(turns * tick).abs();
    }
    let [nutation, alpha, beta] = growth;
    let constant = error + errors.orientation + errors.coordinate * speeds.half_segment_change();
    let orientation = ErrorBound { constant, per_tick: 2.0 * (angular * nutation + TURN * alpha.max(beta)) };

    // terms of the angular velocity, which may cancel: transverse, and all
    let [frequency, alpha_rate, beta_rate] = rates.turns;
    let half_periods = 2.0 * frequency.to_f64();
    let mean = TURN * (alpha_rate + beta_rate).to_f64().abs();
    let terms = angular * half_periods + mean;
    let whole = terms + motion.axial_rate().abs();
    let rotor = motion.top().rotor_momentum().abs() / motion.top().transverse_inertia();
    // change of the angular velocity by a delay of half a period, and by a turn of 1 rad
    let delay = acceleration * half_periods + angular * whole;
    let turned = if angular > 0.0 { acceleration / angular * half_periods } else { 0.0 };
    let relative = errors.relative_omega + DEVIATIONS * f64::ROUNDING;
    let rate = ErrorBound {
        constant: speeds.angular_error * half_periods
            + errors.omega * (speeds.x_rate * half_periods + mean)
            + relative * (whole + rotor)
            + (turned + terms + whole) * constant,
        per_tick: 2.0 * nutation * delay + TURN * (alpha + beta) * whole,
    };
    [orientation, rate]
}

/// Rounding error of an increment as a phase, in turns; whole turns do not count.
fn increment_error(turns: Extended) -> f64 {
    let difference = (turns - turns.to_phase().into()).to_f64();
    difference - libm::round(difference)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::phase::Phase;
    use crate::table::evaluation::EphemerisScalar;
    use crate::{InitialPhases, Signs, Top, TopParameters};

    /// Errors of the rates far above the rounding of the increments: the bound must contain each of them completely.
    #[test]
    fn the_rates_errors_are_in_it() {
        let speeds = Speeds { angular: 5.0, residual: 3.0, ..Speeds::ZERO };
        let parameters = TopParameters {
            transverse_inertia: 1.0,
            axial_inertia: 0.7,
            com_height: 1.0,
            mass_moment: 1.0,
            ..TopParameters::default()
        };
        let top = Top::sliding(&parameters).unwrap();
        let motion =
            Motion::from_branch_points(&top, [-0.5, 0.5, 1.5], Signs::default(), &InitialPhases::default())
                .unwrap();
        let per_tick = |errors, turns| {
            let rates = MeanRates { turns: [turns; 3], errors };
            let [bound, _] = error_bounds(&f64::ERRORS, &motion, 0.5.into(), &rates, &speeds, 0.0);
            bound.per_tick
        };
        let whole = Extended::from(2.0);
        for (errors, allowed) in [
            ([1e-20, 0.0, 0.0], 5e-20),
            ([0.0, 1e-20, 0.0], TURN * 1e-20),
            ([0.0, 0.0, 1e-20], TURN * 1e-20),
            ([1e-20; 3], (5.0 + TURN) * 1e-20),
        ] {
            assert!((per_tick(errors, whole) / allowed - 1.0).abs() < 1e-12, "{errors:?}");
        }
        // an increment of a third of a turn, off by a third of the last place
        let third = whole / Extended::from(3.0);
        let expected = 2.0 * (5.0 + TURN) * Phase::RESOLUTION / 3.0;
        assert!((per_tick([0.0; 3], third) / expected - 1.0).abs() < 1e-9);
        assert_eq!(per_tick([0.0; 3], whole), 0.0);
    }

    #[test]
    fn an_increment_error_is_known_to_the_last_place() {
        let third = Extended::ONE / Extended::from(3.0);
        let error = increment_error(third) / Phase::RESOLUTION;
        assert!((error - 1.0 / 3.0).abs() < 1e-3, "{error}");
        // whole turns beyond 2^32 do not matter
        assert!(increment_error(third + Extended::from(2_f64.powi(40))).abs() < 1e-18);
    }
}
