//! Errors of a table: the limits that it must keep, those of a segment, and those of the whole.

use crate::phase::Phase;
use crate::scalar::{Float, Scalar};
use crate::table::build::polynomial::Store;
use crate::table::build::series::Series;
use crate::table::cell::{CELLS, Cell};
use crate::table::series::expansion::{TABLE_UNIT, larger_or_nan};

/// One turn in rad.
pub(crate) const TURN: f64 = 2.0 * core::f64::consts::PI;

/// Upper bounds on the speeds of α and β without their mean rotation: sums of the magnitudes of coefficients.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Speeds {
    /// Greatest angular velocity 2 √(|dα/dt|² + |dβ/dt|²), in rad per half period.
    pub(crate) sweep: f64,
    /// Twice the greatest rate of θ_A or θ_B, in rad per half period.
    pub(crate) turning: f64,
    /// Greatest acceleration 2 √(|d²α/dt²|² + |d²β/dt²|²), in rad per half period squared.
    pub(crate) acceleration: f64,
    /// Truncation error of the angular velocity, in rad per half period.
    pub(crate) sweep_error: f64,
    /// Greatest rate dx/dt of the local coordinate, per half period.
    pub(crate) x_rate: f64,
}

/// Number of standard deviations in a bound.
pub(crate) const DEVIATIONS: f64 = 6.0;
/// Variance of the roundings that do not depend on the motion, in units of (2^-53 rad)².
const FIXED_VARIANCE: f64 = 12.0;
/// Relative error of the `f64` nearest to 1/2π, in units of 2^-53.
const PER_TURN: f64 = 0.56;
/// Standard deviation of a step's rounding error over the magnitudes of its terms, in units of 2^-53.
const STEP: f64 = 2.1;

impl Speeds {
    pub(crate) const ZERO: Self =
        Self { sweep: 0.0, turning: 0.0, acceleration: 0.0, sweep_error: 0.0, x_rate: 0.0 };

    /// Greatest change of the orientation on half a segment, which is at most a cell, rad.
    pub(crate) fn steepness(&self) -> f64 {
        self.sweep / 16.0
    }

    /// Orientation error, rad, if χ alone is delayed by `share` half periods.
    pub(crate) fn delay(&self, share: f64) -> f64 {
        (self.sweep + self.turning) * share
    }

    /// Orientation error, rad, of `remainder`: the sum of the errors of θ and of those of χ, times `fastest` over the rate of χ.
    pub(crate) fn truncation_error(&self, remainder: f64, fastest: f64) -> f64 {
        self.delay(remainder / fastest) + 2.0 * remainder
    }

    /// Orientation error, rad, of all roundings in `f64`.
    ///
    /// * `delays`, `angles`: sums of the squares of the steps' terms, of χ as delays in half periods and of θ in rad
    /// * `start`: sensitivity of the start time to a rounding of χ, in half periods
    pub(crate) fn rounding(&self, [delays, angles]: [f64; 2], start: f64) -> f64 {
        let Self { sweep, turning, .. } = *self;
        let steps = STEP * STEP * (delays * (sweep * sweep + turning * turning) + 4.0 * angles);
        // of the half phase at the launch, and of the coefficients other than the first
        let (start, coefficients) = (self.delay(start), self.steepness());
        let variance = FIXED_VARIANCE + steps + start * start + coefficients * coefficients;
        (DEVIATIONS * Float::sqrt(variance) + PER_TURN * (sweep + TURN)) * <f64 as Scalar>::ROUNDING
    }
}

/// Errors and slopes of a segment, in units of 2^-62. They are in `f32`, because soft `f64` took a third of the time of a polynomial.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct SegmentErrors {
    /// Sum of the squares of the truncation errors.
    squares: f32,
    /// Greatest error of the stored coefficients.
    stored: f32,
    /// Sums of the squares of the slopes, of their errors and of the curvatures.
    slopes: [f32; 3],
}

impl SegmentErrors {
    /// Errors before the first polynomial.
    pub(crate) const NONE: Self = Self { squares: 0.0, stored: 0.0, slopes: [0.0; 3] };

    /// Stores the polynomial of α (0) or of β (1), and includes its errors.
    ///
    /// * `beyond`, `slope_beyond`: errors of the series itself, and of its derivative
    #[inline(never)] // the stack frames of set-up must not add up
    pub(crate) fn store(
        &mut self,
        series: &Series,
        [beyond, slope_beyond]: [f32; 2],
        (segment, which): (usize, usize),
        store: &mut Store<'_>,
    ) {
        let bounds = series.bounds();
        let [stored, rounded_slope] = store(segment, which, &series.polynomial);
        let change = bounds.change + beyond;
        let slope_error = bounds.slope_change + slope_beyond + rounded_slope;
        self.squares += change * change;
        self.stored = larger_or_nan(self.stored, stored);
        let each = [bounds.slope_squares, slope_error * slope_error, bounds.curvature_squares];
        self.slopes.iter_mut().zip(each).for_each(|(sum, squares)| *sum += squares);
    }

    /// Truncation and rounding error of the segment, as an orientation error, in units of 2^-62 rad.
    pub(crate) fn error(&self) -> f32 {
        larger_or_nan(2.0 * Float::sqrt(self.squares), self.stored)
    }

    /// Includes the speeds on the segment, whose half length is the fraction `part` of half a period, with the greatest dθ/dx.
    pub(crate) fn note(&self, speeds: &mut Speeds, theta_slope: f32, part: f32) {
        let [slope, slope_error, curvature] =
            self.slopes.map(|squares| 2.0 * TABLE_UNIT as f32 * Float::sqrt(squares));
        let x_rate = 1.0 / part;
        let greater = |greatest: f64, speed: f32| larger_or_nan(greatest, speed.into());
        *speeds = Speeds {
            sweep: greater(speeds.sweep, slope * x_rate),
            turning: greater(speeds.turning, 2.0 * theta_slope * x_rate),
            acceleration: greater(speeds.acceleration, curvature * x_rate * x_rate),
            sweep_error: greater(speeds.sweep_error, slope_error * x_rate),
            x_rate: greater(speeds.x_rate, x_rate),
        };
    }
}

/// Limits of the errors and of the size of a table.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Limits {
    /// Number of coefficients of a polynomial.
    pub(crate) terms: usize,
    /// Largest number of segments.
    pub(crate) capacity: usize,
    /// Truncation error of all steps together, rad.
    pub(crate) steps: f64,
    /// Truncation error of a polynomial, in units of 2^-62 rad.
    pub(crate) polynomial: f32,
    /// Sum of the terms that may be left out of a span's series, in units of 2^-62.
    pub(crate) left_out: i64,
    /// Term of a series that is negligible, rad.
    pub(crate) least: f64,
}

/// Part of the allowed error reserved for the steps.
const STEPS_SHARE: f64 = 0.125;

/// Part of the allowed error reserved for the last terms that are left out of a span's series.
const LEFT_OUT_SHARE: f32 = 1.0 / 512.0;

/// Number of segments of which each may omit this part of the allowed error, divided by it.
const NEGLIGIBLE_SHARE: f64 = 1.0 / 256.0;

/// Part of the allowed error that a segment of two cells may have, for the accuracy of its derivative.
const LONG_SHARE: f32 = 0.125;

impl Limits {
    pub(crate) const NONE: Self =
        Self { terms: 0, capacity: 0, steps: 0.0, polynomial: 0.0, left_out: 0, least: 0.0 };

    /// Limits for a truncation error `allowed`, rad. The series are at least as accurate as for the error `usual`.
    pub(crate) fn new(terms: usize, allowed: f64, usual: f64, capacity: usize) -> Self {
        let polynomial =
            |error: f64| (((1.0 - STEPS_SHARE) * error / TABLE_UNIT) as f32).clamp(f32::MIN, f32::MAX);
        let of_series = allowed.min(usual);
        Self {
            terms,
            capacity,
            steps: STEPS_SHARE * allowed,
            polynomial: polynomial(allowed),
            left_out: (LEFT_OUT_SHARE * polynomial(of_series)) as i64,
            least: NEGLIGIBLE_SHARE * of_series,
        }
    }

    /// Truncation error of a segment of this level, in units of 2^-62 rad.
    pub(crate) fn segment(&self, level: u32) -> f32 {
        if level == 0 { LONG_SHARE * self.polynomial } else { self.polynomial }
    }
}

/// Summary of a table, for the clock and the error bounds.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TableSummary {
    /// Cells with their segments.
    pub(crate) cells: [Cell; CELLS],
    /// Number of segments.
    pub(crate) segments: usize,
    /// Nutation phase (0 at u = e₁), and the mean slow phases of α and β, at t = 0.
    pub(crate) start: [Phase; 3],
    /// Orientation error, rad: truncation, distance of the last point from the upper turning point, and roundings in `f64`.
    pub(crate) error: f64,
    pub(crate) speeds: Speeds,
}

impl TableSummary {
    pub(crate) const EMPTY: Self = Self {
        cells: [Cell(0); CELLS],
        segments: 0,
        start: [Phase::ZERO; 3],
        error: 0.0,
        speeds: Speeds::ZERO,
    };
}
