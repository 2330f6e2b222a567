//! Build of a table: spans of half a nutation period, the limits of the errors, and their sums.
//!
//! On each span one expansion of the law is used. A span can contain several segments, whose series follow from that of the span.

mod mean_rates;

pub(super) mod bound;

pub(super) mod builder;

use crate::phase::Phase;
use crate::scalar::{Extended, Float, Ring, power_of_two};
use crate::table::cell::{CELLS, Cell, LONGEST_BITS};
use crate::table::series::expansion::{TABLE_UNIT, larger_or_nan};

/// Rates of the nutation phase and of the mean slow phases, with the values needed to step through the half period.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MeanRates {
    /// Half period T/2; 0 where u is constant.
    half_period: Extended,
    /// Constant rates of θ_A and θ_B besides ψ_A' and ψ_B': ±τ/2 minus the mean rate, rad per unit time.
    theta_offset: [Extended; 2],
    /// Nutation frequency 1/T, and the mean rates of α and β, in turns per unit time.
    pub(super) turns: [Extended; 3],
    /// Errors of `turns`, turns per unit time.
    errors: [f64; 3],
}

impl MeanRates {
    const ZERO: Self = Self {
        half_period: Extended::ZERO,
        theta_offset: [Extended::ZERO; 2],
        turns: [Extended::ZERO; 3],
        errors: [0.0; 3],
    };
}

/// One of the 2^depth parts of equal length into which half a period is divided.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Span {
    /// Beginning in units of the shortest segment.
    begin: usize,
    depth: u32,
}

/// Half a period in units of the shortest segment.
const HALF_PERIOD: usize = 1 << Span::DEEPEST;

/// Cell in units of the shortest segment.
const CELL: usize = HALF_PERIOD / CELLS;

impl Span {
    /// Base-2 logarithm of the number of spans in half a period, at least.
    const SHALLOWEST: u32 = 2;
    /// Base-2 logarithm of the number of spans in half a period, at most: a span has at least one segment.
    const DEEPEST: u32 = LONGEST_BITS + Cell::DEEPEST;

    /// Longest span from u = e₁ on.
    const FIRST: Self = Self { begin: 0, depth: Self::SHALLOWEST };

    /// Whether it is one of the parts.
    fn exists(self) -> bool {
        self.depth >= Self::SHALLOWEST && self.begin.is_multiple_of(HALF_PERIOD >> self.depth)
    }

    /// End in units of the shortest segment.
    fn end(self) -> usize {
        self.begin + (HALF_PERIOD >> self.depth)
    }

    /// Least level of segments that are not longer than the span.
    fn least_level(self) -> u32 {
        self.depth.saturating_sub(LONGEST_BITS)
    }

    /// Number of halvings of the span that make segments of this level.
    fn halvings(self, level: u32) -> u32 {
        (LONGEST_BITS + level).saturating_sub(self.depth)
    }

    /// Half the length, in units of half a period.
    fn half_length(self) -> f64 {
        power_of_two(-1 - self.depth as i32)
    }

    /// Nutation phase at x ∈ [-1, 1] of the span.
    fn phase(self, x: f64) -> Phase {
        // the half period is half a turn
        let unit = Phase::from_bits(Phase::QUARTER.to_bits() >> Self::DEEPEST);
        unit.times((self.begin + self.end()) as i64) + Phase::new(0.5 * x * self.half_length())
    }
}

/// Upper bounds on the speeds of α and β without their mean rotation: sums of the magnitudes of coefficients.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Speeds {
    /// Greatest angular velocity 2 √(|dα/dt|² + |dβ/dt|²), in rad per half period.
    sweep: f64,
    /// Twice the greatest rate of θ_A or θ_B, in rad per half period.
    turning: f64,
    /// Greatest acceleration 2 √(|d²α/dt²|² + |d²β/dt²|²), in rad per half period squared.
    acceleration: f64,
    /// Truncation error of the angular velocity, in rad per half period.
    sweep_error: f64,
    /// Greatest rate dx/dt of the local coordinate, per half period.
    x_rate: f64,
}

impl Speeds {
    const ZERO: Self = Self { sweep: 0.0, turning: 0.0, acceleration: 0.0, sweep_error: 0.0, x_rate: 0.0 };
}

/// Errors and slopes of a segment, in units of 2^-62. They are in `f32`, because soft `f64` took a third of the time of a polynomial.
#[derive(Default)]
struct SegmentErrors {
    /// Greatest error of the stored coefficients.
    stored: f32,
    /// Sums of the squares of the truncation errors, the slopes, the errors of the slopes and the curvatures.
    change: f32,
    slope: f32,
    slope_error: f32,
    curvature: f32,
}

impl SegmentErrors {
    /// Truncation and rounding error of the segment, as an orientation error, in units of 2^-62 rad.
    fn error(&self) -> f32 {
        larger_or_nan(2.0 * Float::sqrt(self.change), self.stored)
    }

    /// Includes the speeds on the segment, on which the local coordinate has this rate per half period and dθ/dx this bound.
    fn include_in(&self, speeds: &mut Speeds, x_rate: f32, theta_slope: f32) {
        let root = |squares: f32| 2.0 * TABLE_UNIT as f32 * Float::sqrt(squares);
        let include = |greatest: &mut f64, speed: f32| *greatest = larger_or_nan(*greatest, speed.into());
        include(&mut speeds.sweep, root(self.slope) * x_rate);
        include(&mut speeds.turning, 2.0 * theta_slope * x_rate);
        include(&mut speeds.acceleration, root(self.curvature) * x_rate * x_rate);
        include(&mut speeds.sweep_error, root(self.slope_error) * x_rate);
        include(&mut speeds.x_rate, x_rate);
    }
}

/// Limits of the errors and of the size of a table.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Limits {
    /// Number of coefficients of a polynomial.
    terms: usize,
    /// Largest number of segments.
    capacity: usize,
    /// Truncation error of all steps together, rad.
    steps: f64,
    /// Truncation error of a polynomial, in units of 2^-62 rad.
    polynomial: f32,
    /// Sum of the terms that may be left out of a span's series, in units of 2^-62.
    left_out: i64,
    /// Term of a series that is negligible, rad.
    least: f64,
}

/// Part of the allowed error reserved for the steps.
const STEPS: f64 = 0.125;
/// Parts of a polynomial's allowed error: for the last terms that are left out of a span's series, for the estimated terms that the
/// series omits, and for all of a segment of two cells, whose derivative needs the accuracy.
const LEFT_OUT: f32 = 1.0 / 512.0;
const OMITTED: f32 = 1.0 / 32.0;
const LONG: f32 = 0.125;
/// Number of segments of which each may omit this part of the allowed error, divided by it.
const NEGLIGIBLE: f64 = 1.0 / 256.0;

impl Limits {
    /// Limits for a truncation error `allowed`, rad. The series are at least as accurate as for the error `usual`.
    pub(super) fn new(terms: usize, allowed: f64, usual: f64, capacity: usize) -> Self {
        let polynomial = |error: f64| (((1.0 - STEPS) * error / TABLE_UNIT) as f32).clamp(f32::MIN, f32::MAX);
        let of_series = allowed.min(usual);
        Self {
            terms,
            capacity,
            steps: STEPS * allowed,
            polynomial: polynomial(allowed),
            left_out: (LEFT_OUT * polynomial(of_series)) as i64,
            least: NEGLIGIBLE * of_series,
        }
    }

    /// Truncation error of a segment of this level, in units of 2^-62 rad.
    fn segment(&self, level: u32) -> f32 {
        if level == 0 { LONG * self.polynomial } else { self.polynomial }
    }

    /// Negligible term of α and β in units of 2^-62. What follows two such terms is not larger.
    fn least_term(&self) -> i64 {
        (self.least / TABLE_UNIT) as i64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_span_has_the_phases_of_its_place() {
        assert!(Span::FIRST.exists() && !Span { begin: CELL, ..Span::FIRST }.exists());
        let second = Span { begin: Span::FIRST.end(), ..Span::FIRST };
        assert_eq!((second.phase(-1.0), second.phase(1.0)), (Phase::from_bits(1 << 93), Phase::QUARTER));
        let last = Span { begin: HALF_PERIOD - 1, depth: Span::DEEPEST };
        assert_eq!((last.end(), last.phase(1.0)), (HALF_PERIOD, Phase::HALF));
        assert_eq!((last.least_level(), last.halvings(Cell::DEEPEST)), (Cell::DEEPEST, 0));
        assert_eq!((Span::FIRST.least_level(), Span::FIRST.halvings(0)), (0, 1));
    }
}
