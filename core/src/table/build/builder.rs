//! State of a set-up, which a program may keep in a static.

mod series;

mod path;

mod cut;

use super::{Limits, MeanRates, Span, Speeds};
use crate::motion::phase_equations::PhaseEquations;
use crate::phase::Phase;
use crate::scalar::Extended;
use crate::table::cell::CELLS;
use crate::table::series::TERMS;
use crate::table::series::expansion::{Expansion, PhasePoint, Slopes};

/// Position on the path, with the errors of the steps to it.
#[derive(Clone, Copy, Debug)]
struct Position {
    point: PhasePoint,
    /// Truncation error.
    truncation: f64,
    /// Sums of the squares of the terms of χ, as delays in half periods, and of θ, rad.
    squares: [f32; 2],
}

impl Position {
    /// Position u = e₁.
    const BEGINNING: Self = Self { point: PhasePoint::ZERO, truncation: 0.0, squares: [0.0; 2] };
}

/// Start of a motion.
#[derive(Debug)]
pub(crate) struct Start {
    /// Half phase, folded into [0, 1/4] turn; `None` once its place is found.
    chi: Option<Phase>,
    /// Whether u is falling.
    mirrored: bool,
    /// Nutation phase and mean slow phases.
    pub(crate) phases: [Phase; 3],
    /// Delay by a relative rounding of χ or of a quarter turn minus χ, in half periods.
    delay: f64,
}

/// Real or imaginary part of a series.
#[derive(Clone, Copy, Debug)]
struct Part {
    coefficients: [i64; TERMS],
    /// Upper bounds on the changes of the value and of the derivative by the terms left out, in units of 2^-62.
    left_out: i64,
    slope_left_out: i64,
}

/// Power series on an interval, in x from -1 to 1.
#[derive(Clone, Copy, Debug)]
struct Series {
    parts: [Part; 2],
    terms: usize,
}

impl Part {
    const ZERO: Self = Self { coefficients: [0; TERMS], left_out: 0, slope_left_out: 0 };
}

impl Series {
    const ZERO: Self = Self { parts: [Part::ZERO; 2], terms: 0 };
}

/// Series of α or of β on a span, and on the part of it that was halved last.
#[derive(Debug)]
struct SpanSeries {
    /// Coefficients of e^{iχ} and e^{-iχ} in the ellipse.
    exponentials: [f64; 2],
    whole: Series,
    /// Estimate of the terms beyond the last, in units of 2^-62.
    omitted: f32,
    halved: Series,
    /// Number of that part and of the halvings.
    part: Option<(usize, u32)>,
}

impl SpanSeries {
    const ZERO: Self =
        Self { exponentials: [0.0; 2], whole: Series::ZERO, omitted: 0.0, halved: Series::ZERO, part: None };
}

/// Cell that is cut, or two with one segment. The unit is the shortest segment.
#[derive(Debug)]
struct Cut {
    begin: usize,
    end: usize,
    level: u32,
    /// Position at the beginning, if a span begins there.
    border: Position,
    speeds: Speeds,
    /// Greatest error, in units of 2^-62 rad.
    error: f32,
}

impl Cut {
    const NONE: Self =
        Self { begin: 0, end: 0, level: 0, border: Position::BEGINNING, speeds: Speeds::ZERO, error: 0.0 };
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
    law: PhaseEquations<Extended>,
    rounded_law: PhaseEquations<f64>,
    /// Function [`SetUp::slopes`] in the numbers of the mean rates.
    slopes_of: Option<fn(&Self, Extended) -> Slopes>,
    pub(crate) rates: MeanRates,
    limits: Limits,
    /// Rates of χ, θ_A and θ_B together at the faster turning point, rad per half period.
    fastest: f64,
    /// dχ/dt at u = e₂, rad per half period.
    nutation_at_end: f64,
    pub(crate) start: Start,
    span: Span,
    /// Beginning, centre (where it is known) and end of the span.
    border: Position,
    centre: Option<Position>,
    end: Position,
    expansion: Expansion,
    /// Series of α and of β.
    series: [SpanSeries; 2],
    /// Upper bound on |dθ/dx| on the span.
    theta_slope: f32,
    cut: Cut,
    segment: Series,
    pub(crate) cells: [u16; CELLS],
    pub(crate) segments: usize,
    /// Orientation error besides that of a tick, rad.
    pub(crate) error: f64,
    pub(crate) speeds: Speeds,
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
        Self::with(None)
    }

    /// Set-up with another truncation error, rad, finite and positive: a smaller table for a larger error.
    #[must_use]
    pub const fn within(truncation: f64) -> Self {
        Self::with(Some(truncation))
    }

    const fn with(truncation: Option<f64>) -> Self {
        Self {
            truncation,
            law: PhaseEquations::ZERO,
            rounded_law: PhaseEquations::ZERO,
            slopes_of: None,
            rates: MeanRates::ZERO,
            limits: Limits { terms: 0, capacity: 0, steps: 0.0, polynomial: 0.0, left_out: 0, least: 0.0 },
            fastest: 0.0,
            nutation_at_end: 0.0,
            start: Start { chi: None, mirrored: false, phases: [Phase::ZERO; 3], delay: 0.0 },
            span: Span { begin: 0, depth: 0 },
            border: Position::BEGINNING,
            centre: None,
            end: Position::BEGINNING,
            expansion: Expansion::EMPTY,
            series: [SpanSeries::ZERO; 2],
            theta_slope: 0.0,
            cut: Cut::NONE,
            segment: Series::ZERO,
            cells: [0; CELLS],
            segments: 0,
            error: 0.0,
            speeds: Speeds::ZERO,
        }
    }
}
