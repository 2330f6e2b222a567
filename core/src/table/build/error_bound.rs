//! Error bounds of a table, with the terms of [the error bound](crate::error_bound).

use super::half_period::TabulatedHalfPeriod;
use crate::motion::Motion;
use crate::scalar::{Extended, Float, Ring};
use crate::table::build::mean_rates::MeanRates;
use crate::table::data::ErrorBound;
use crate::table::evaluation::TickErrors;
use crate::table::time::Phases;

/// One turn in rad.
const TURN: f64 = 2.0 * core::f64::consts::PI;

impl TabulatedHalfPeriod {
    /// Error bounds of orientation and angular velocity for ticks of this length.
    pub(crate) fn error_bounds(
        &self,
        terms: usize,
        errors: &TickErrors,
        motion: &Motion,
        tick: Extended,
    ) -> [ErrorBound; 2] {
        let MeanRates { rates, errors: rate_errors } = self.mean_rates;
        let Phases { nutation, alpha, beta } = rate_errors
            .zip_map(rates, |error, rate| error * tick.to_f64() + increment_error(rate * tick).abs());
        let bounds = &self.division.bounds;
        let angular = f64::from(bounds.angular_speed);
        let orientation = ErrorBound {
            constant: self.error + errors.orientation + errors.coordinate * bounds.half_segment_change(),
            per_tick: 2.0 * (angular * nutation + TURN * alpha.larger_or_nan(beta)),
        };

        let half_periods = 2.0 * rates.nutation.to_f64();
        let x_rate = f64::from(bounds.coordinate_rate) * half_periods;
        let mean = TURN * (rates.alpha + rates.beta).to_f64().abs();
        // terms of the angular velocity, which may cancel
        let whole = angular * half_periods + mean + motion.first_integrals().spin.abs();
        let rotor = motion.top().rotor_momentum().abs() / motion.top().transverse_inertia();
        // relative rate of change of the angular velocity
        let change = 0.25 * x_rate + whole;
        // |T_k'| <= k² for a dropped term of degree k; those after the first are much smaller
        let slope = ((terms + 1) as f64).squared() * f64::from(bounds.error);
        let rate = ErrorBound {
            constant: slope * x_rate
                + errors.omega * (x_rate + mean)
                + errors.relative_omega * (whole + rotor)
                + (change + whole) * orientation.constant,
            per_tick: 2.0 * angular * nutation * change + TURN * (alpha + beta) * whole,
        };
        [orientation, rate]
    }
}

/// Rounding error of an increment as a phase, in turns; whole turns do not count.
fn increment_error(increment: Extended) -> f64 {
    let difference = (increment - increment.to_phase().into()).to_f64();
    difference - libm::round(difference)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::phase::Phase;
    use crate::table::build::path::PathScratch;
    use crate::table::build::segment::SegmentBounds;
    use crate::table::build::tabulation::Division;
    use crate::table::build::tests::nutating_motion;
    use crate::table::evaluation::TableScalar;
    use crate::{Release, SizedTable, State, Tick, Top, TopParameters};

    /// Errors of the rates far above the rounding of the increments: the bound must contain each of them completely.
    #[test]
    fn the_bound_contains_the_errors_of_the_rates() {
        let motion = nutating_motion();
        let per_tick = |errors, rate| {
            let half_period = TabulatedHalfPeriod {
                mean_rates: MeanRates {
                    rates: Phases::from_array([rate; 3]),
                    errors: Phases::from_array(errors),
                },
                division: Division {
                    bounds: SegmentBounds { angular_speed: 5.0, ..SegmentBounds::ZERO },
                    ..Division::ZERO
                },
                ..TabulatedHalfPeriod::ZERO
            };
            let [bound, _] = half_period.error_bounds(f64::TERMS, &f64::ERRORS, &motion, 0.5.into());
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

    /// Numbers of the example on the page of the error bound.
    #[test]
    fn the_example_is_computed() {
        let top = Top::sliding(&TopParameters::TOY).unwrap();
        let state = State::from_release(&Release { tilt: 0.35, spin: 150.0, ..Release::default() }).unwrap();
        let motion = Motion::launch(&top, &state).unwrap();
        let (mut half_period, mut scratch) = (TabulatedHalfPeriod::ZERO, PathScratch::ZERO);
        let mut segments = [f32::ZERO_SEGMENT; 25];
        let result =
            half_period.compute::<f32>(&motion, f32::TRUNCATION, &mut scratch, &mut segments, 25, &mut || {});
        assert!(result.is_ok());
        let bounds = half_period.error_bounds(f32::TERMS, &f32::ERRORS, &motion, 0.001.into());
        let segment = f64::from(half_period.division.bounds.error);
        let [orientation, rates] = bounds.map(|bound| [bound.constant, bound.per_tick]);
        let steps = half_period.error - segment;
        let coordinate = f32::ERRORS.coordinate * half_period.division.bounds.half_segment_change();
        let page = include_str!("../../../docs/error_bound.md");
        for number in
            [segment, steps, f32::ERRORS.orientation, coordinate].into_iter().chain(orientation).chain(rates)
        {
            let cell = format!("| {number:.2e} |");
            assert!(page.contains(&cell), "{cell}");
        }
    }

    /// Bound on the orientation error of that motion at tick 0 in each scalar, rounded up to two digits, on the page of the scalars.
    #[test]
    fn the_bounds_of_the_scalars_are_computed() {
        fn check<R: TableScalar, const SEGMENTS: usize>() {
            let top = Top::sliding(&TopParameters::TOY).unwrap();
            let state = State::from_release(&Release { tilt: 0.35, spin: 150.0, ..Release::default() });
            let motion = Motion::launch(&top, &state.unwrap()).unwrap();
            let table = SizedTable::<R, SEGMENTS>::new(&motion, Tick::hertz(1000).unwrap()).unwrap();
            let bound = table.error_bound().constant;
            let unit = 10_f64.powi(bound.log10().floor() as i32 - 1);
            let cell = format!("| {:.1e} |", (bound / unit).ceil() * unit);
            assert!(include_str!("../evaluation.rs").contains(&cell), "{cell}");
        }
        check::<f32, 25>();
        check::<f64, 48>();
        #[cfg(feature = "fixed")]
        check::<fixed::types::I2F30, 32>();
        #[cfg(feature = "fixed")]
        check::<fixed::types::I2F14, 16>();
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
