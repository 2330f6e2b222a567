//! Build of a table: the data that its parts share.

mod mean_rates;

pub(super) mod bound;

pub(super) mod builder;

use crate::phase::Phase;
use crate::scalar::{Extended, Float, Ring, power_of_two};
use crate::table::cell::{CELLS, Cell, LEVEL_0_BITS};
use crate::table::series::expansion::{TABLE_UNIT, larger_or_nan};

/// Rates of the nutation phase and of the mean slow phases.
#[derive(Debug)]
pub(crate) struct MeanRates {
    /// Half period T/2; 0 where u is constant.
    half_period: Extended,
    /// Constants θ_A' - ψ_A' and θ_B' - ψ_B': ±τ/2 minus the mean rate, rad per unit time.
    theta_offset: [Extended; 2],
    /// Nutation frequency 1/T and mean rates of α and β, in turns per unit time.
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

/// Span: one of the 2^depth equal parts of half a period, with one expansion of the motion for all its segments.
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
    /// Least depth.
    const SHALLOWEST: u32 = 2;
    /// Greatest depth: a span has at least one segment.
    const DEEPEST: u32 = LEVEL_0_BITS + Cell::DEEPEST;

    /// Longest span from u = e₁ on.
    const FIRST: Self = Self { begin: 0, depth: Self::SHALLOWEST };

    /// Whether the half period is divided so.
    fn exists(self) -> bool {
        self.depth >= Self::SHALLOWEST && self.begin.is_multiple_of(HALF_PERIOD >> self.depth)
    }

    /// End in units of the shortest segment.
    fn end(self) -> usize {
        self.begin + (HALF_PERIOD >> self.depth)
    }

    /// Level of the longest segments in the span.
    fn least_level(self) -> u32 {
        self.depth.saturating_sub(LEVEL_0_BITS)
    }

    /// Number of halvings that make segments of this level.
    fn halvings(self, level: u32) -> u32 {
        (LEVEL_0_BITS + level).saturating_sub(self.depth)
    }

    /// Half the length, in half periods.
    fn half_length(self) -> f64 {
        power_of_two(-1 - self.depth as i32)
    }

    /// Nutation phase at x in [-1, 1].
    fn phase(self, x: f64) -> Phase {
        // the half period is half a turn
        let unit = Phase::from_bits(Phase::QUARTER.to_bits() >> Self::DEEPEST);
        unit.times((self.begin + self.end()) as i64) + Phase::new(0.5 * x * self.half_length())
    }
}

/// Upper bounds on the speeds of α and β without their mean rotation, from the magnitudes of coefficients.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Speeds {
    /// Angular velocity 2 √(|dα/dt|² + |dβ/dt|²), rad per half period.
    sweep: f64,
    /// Twice the rate of θ_A or θ_B, rad per half period.
    turning: f64,
    /// Acceleration 2 √(|d²α/dt²|² + |d²β/dt²|²), rad per half period squared.
    acceleration: f64,
    /// Truncation error of the angular velocity, rad per half period.
    sweep_error: f64,
    /// Rate of the local coordinate x, per half period.
    x_rate: f64,
}

impl Speeds {
    const ZERO: Self = Self { sweep: 0.0, turning: 0.0, acceleration: 0.0, sweep_error: 0.0, x_rate: 0.0 };
}

/// Errors and slopes of a segment, in units of 2^-62, in `f32` because soft `f64` is slow.
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
    /// Orientation error by truncation and rounding, in units of 2^-62 rad.
    fn error(&self) -> f32 {
        larger_or_nan(2.0 * Float::sqrt(self.change), self.stored)
    }

    /// Includes the speeds on the segment, for the rate of x per half period and a bound on dθ/dx.
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
    /// Truncation error of all steps, rad.
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
/// Part of a polynomial's allowed error reserved for terms left out of the series of a span.
const LEFT_OUT: f32 = 1.0 / 512.0;
/// Part reserved for terms beyond the sixteenth.
const OMITTED: f32 = 1.0 / 32.0;
/// Part that a segment of two cells may use, because its derivative is less accurate.
const LONG: f32 = 0.125;
/// Negligible part of the allowed error.
const NEGLIGIBLE: f64 = 1.0 / 256.0;

impl Limits {
    /// Limits for a truncation error `allowed`, rad, with series at least as accurate as for the error `usual`.
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

    /// Negligible term of α and β in units of 2^-62. The terms after two such ones are not larger.
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
