//! Build of a table: from the equations of a motion to the polynomials of half a period.

mod mean_rates;

pub(super) mod bound;

mod limits;

mod span;

mod series;

mod path;

mod cut;

use crate::motion::phase_equations::PhaseEquations;
use crate::phase::Phase;
use crate::scalar::Extended;
use crate::table::cell::CELLS;
use crate::table::series::expansion::{Expansion, PhasePoint};
use bound::Speeds;
use series::{Series, SpanSeries};
use span::Span;

pub(super) use limits::Limits;
pub(super) use mean_rates::MeanRates;

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

/// Memory of a set-up, 4.4 KiB, and the truncation error that it allows. A program with a small stack keeps it in a static.
///
/// ```
/// use toytop::{EphemerisF32, EphemerisMemory, Motion, Release, SetUp, State, Tick, Top, TopParameters};
/// # let top = Top::sliding(&TopParameters {
/// #     transverse_inertia: 3.0e-5,
/// #     axial_inertia: 2.0e-5,
/// #     com_height: 0.03,
/// #     mass: 0.05,
/// #     ..TopParameters::default()
/// # })?;
/// # let release = Release { tilt: 0.35, spin: 150.0, ..Release::default() };
/// let motion = Motion::launch(&top, &State::release(&release)?)?;
/// let mut set_up = SetUp::new();
/// let mut memory = EphemerisMemory::<EphemerisF32>::new();
/// let launched_at = 5000; // tick of a running counter
/// let table = memory.set_up(&mut set_up, &motion, Tick::hertz(1000)?, launched_at, &mut || {
///     // feed the watchdog
/// })?;
/// assert!(table.at_tick(launched_at).u() > 0.93);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
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
    pub const fn within(truncation: f64) -> Self {
        Self { truncation: Some(truncation), ..Self::new() }
    }
}
