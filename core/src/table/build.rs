//! Build of a table: from the equations of a motion to the polynomials of half a period.

mod mean_rates;

mod series;

mod bound;

mod limits;

mod span_series;

mod path;

mod cut;

mod set_up;

use crate::motion::phase_equations::PhaseEquations;
use crate::phase::Phase;
use crate::scalar::{Extended, power_of_two};
use crate::table::build::series::expansion::{Expansion, PhasePoint};
use crate::table::data::cell::{CELLS, Cell, LEVEL_0_BITS};
use bound::Speeds;
use span_series::{Series, SpanSeries};

use limits::Limits;
use mean_rates::MeanRates;

pub use set_up::SetUpError;

/// Span: one of the 2^depth equal parts of half a period, with one expansion of the motion for all its segments.
#[derive(Clone, Copy, Debug)]
struct Span {
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

/// Point of the path along half a period, with the errors of the steps to it.
#[derive(Clone, Copy, Debug)]
struct PathPoint {
    phases: PhasePoint,
    /// Truncation error.
    truncation: f64,
    /// Sums of the squares of the terms of χ, as delays in half periods, and of θ, rad.
    squares: [f32; 2],
}

impl PathPoint {
    /// Point u = e₁.
    const FIRST: Self = Self { phases: PhasePoint::ZERO, truncation: 0.0, squares: [0.0; 2] };
}

/// Start of a motion.
#[derive(Debug)]
pub(crate) struct Start {
    /// Half phase, folded into [0, 1/4] turn; `None` once its span is found.
    chi: Option<Phase>,
    /// Whether u is falling.
    mirrored: bool,
    /// Nutation phase and mean slow phases.
    pub(crate) phases: [Phase; 3],
    /// Delay by a relative rounding of χ or of a quarter turn minus χ, in half periods.
    delay: f64,
}

/// Cell whose segments are computed, or two cells with one segment. The unit is the shortest segment.
#[derive(Debug)]
struct OpenCell {
    begin: usize,
    end: usize,
    level: u32,
    /// Point at the beginning, if a span begins there.
    beginning: PathPoint,
    /// Speeds up to here, and the greatest error in the cell, in units of 2^-62 rad.
    speeds: Speeds,
    error: f32,
}

impl OpenCell {
    const NONE: Self =
        Self { begin: 0, end: 0, level: 0, beginning: PathPoint::FIRST, speeds: Speeds::ZERO, error: 0.0 };
}

/// Cells of a table, and what its error bounds follow from.
#[derive(Debug)]
pub(crate) struct Outline {
    pub(crate) cells: [u16; CELLS],
    /// Number of segments.
    pub(crate) segments: usize,
    /// Orientation error besides that of a tick, rad.
    pub(crate) error: f64,
    pub(crate) speeds: Speeds,
}

impl Outline {
    const NONE: Self = Self { cells: [0; CELLS], segments: 0, error: 0.0, speeds: Speeds::ZERO };
}

/// Memory of a set-up, 4.2 KiB, and the truncation error that it allows. A program with a small stack keeps it in a static;
/// [`Cursor`](crate::Cursor) shows its use.
#[derive(Debug)]
pub struct SetUp {
    /// Truncation error, rad; `None` for that of the scalar.
    pub(crate) truncation: Option<f64>,
    // constants of the motion
    equations: PhaseEquations<Extended>,
    pub(crate) rates: MeanRates,
    limits: Limits,
    /// Rates of χ, θ_A and θ_B together at the faster turning point, rad per half period.
    fastest: f64,
    pub(crate) start: Start,
    // a span: its beginning, its centre (where it is known) and its end, and the series of α and of β
    span: Span,
    beginning: PathPoint,
    centre: Option<PathPoint>,
    end: PathPoint,
    expansion: Expansion,
    series: [SpanSeries; 2],
    // a cell, and a series on one of its segments
    cell: OpenCell,
    segment: Series,
    // the result
    pub(crate) outline: Outline,
}

impl Default for SetUp {
    fn default() -> Self {
        Self::new()
    }
}

impl SetUp {
    /// Set-up with the truncation error of the scalar, [`EphemerisScalar::TRUNCATION`](crate::EphemerisScalar::TRUNCATION). A static of it
    /// takes no flash.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            truncation: None,
            equations: PhaseEquations::ZERO,
            rates: MeanRates::ZERO,
            limits: Limits::NONE,
            fastest: 0.0,
            start: Start { chi: None, mirrored: false, phases: [Phase::ZERO; 3], delay: 0.0 },
            span: Span { begin: 0, depth: 0 },
            beginning: PathPoint::FIRST,
            centre: None,
            end: PathPoint::FIRST,
            expansion: Expansion::EMPTY,
            series: [SpanSeries::ZERO; 2],
            cell: OpenCell::NONE,
            segment: Series::ZERO,
            outline: Outline::NONE,
        }
    }

    /// Set-up with another truncation error, rad, finite and positive: a smaller table for a larger error.
    #[must_use]
    pub const fn with_truncation(truncation: f64) -> Self {
        Self { truncation: Some(truncation), ..Self::new() }
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
