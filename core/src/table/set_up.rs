//! Set-up of an ephemeris: from a motion to the table and the clock.

use core::fmt;

use crate::constants::Regime;
use crate::motion::Motion;
use crate::scalar::Float;
use crate::table::build::bound::{ErrorBound, error_bounds};
use crate::table::build::builder::{TableBuilder, TooManySegments};
use crate::table::build::errors::Limits;
use crate::table::build::mean_rates::MeanRates;
use crate::table::build::polynomial::{Polynomial, Store};
use crate::table::cell::{Cell, LONGEST};
use crate::table::clock::Clock;
use crate::table::ephemeris::{Ephemeris, EphemerisMemory, EphemerisView, ReadyEphemeris, put};
use crate::table::scalar::EphemerisScalar;
use crate::table::tick::Tick;

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
    /// Allowed truncation error, rad; `None` for that of the scalar.
    truncation: Option<f64>,
    builder: TableBuilder,
}

/// Reason why a motion has no table.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum SetUpError {
    /// The table has too few segments for the truncation error.
    TooSmall {
        /// Allowed truncation error, rad.
        truncation: f64,
        /// Number of segments of the table; [`EphemerisView::segments_needed`](crate::EphemerisView::segments_needed) finds a sufficient
        /// one.
        segments: u32,
    },
    /// The motion is aperiodic; a stepper or its closed form follows it.
    Aperiodic,
    /// The truncation error is not finite and positive.
    Truncation,
}

impl fmt::Display for SetUpError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooSmall { truncation, segments } => {
                write!(
                    f,
                    "a table of {segments} segments cannot follow the motion to within {truncation:.1e} rad"
                )
            }
            Self::Aperiodic => f.write_str("an aperiodic motion has no table"),
            Self::Truncation => f.write_str("truncation: must be finite and positive"),
        }
    }
}

impl core::error::Error for SetUpError {}

impl Default for SetUp {
    fn default() -> Self {
        Self::new()
    }
}

impl SetUp {
    /// Set-up with the truncation error of the scalar, [`EphemerisScalar::TRUNCATION`]. A static of it takes no flash.
    #[must_use]
    pub const fn new() -> Self {
        Self { truncation: None, builder: TableBuilder::EMPTY }
    }

    /// Set-up with another truncation error, rad, finite and positive: a smaller table for a larger error.
    #[must_use]
    pub const fn within(truncation: f64) -> Self {
        Self { truncation: Some(truncation), builder: TableBuilder::EMPTY }
    }

    /// Fills a table.
    #[inline(never)]
    fn fill<R: EphemerisScalar>(
        &mut self,
        table: &mut EphemerisView<R>,
        motion: &Motion,
        tick: Tick,
        epoch: i64,
        between: &mut dyn FnMut(),
    ) -> Result<(), SetUpError> {
        table.error_bound = ErrorBound::NONE;
        let rates = self.mean_rates::<R>(motion, between);
        between();
        let segments = &mut table.segments;
        let capacity = segments.len();
        let store =
            &mut |segment: usize, which: usize, parts: &Polynomial| put::<R>(segments, segment, which, parts);
        self.tabulate::<R>(motion, &rates, capacity, store, between)?;
        self.describe(table, motion, tick, epoch, &rates, between);
        Ok(())
    }

    /// Computes the mean rates of a motion in the numbers of a scalar.
    fn mean_rates<R: EphemerisScalar>(&mut self, motion: &Motion, between: &mut dyn FnMut()) -> MeanRates {
        match R::RATE_WORDS {
            1 => self.builder.path.mean_rates::<1>(motion, between),
            _ => self.builder.path.mean_rates::<2>(motion, between),
        }
    }

    /// Computes the polynomials.
    fn tabulate<R: EphemerisScalar>(
        &mut self,
        motion: &Motion,
        rates: &MeanRates,
        capacity: usize,
        store: &mut Store<'_>,
        between: &mut dyn FnMut(),
    ) -> Result<(), SetUpError> {
        let truncation = self.truncation.unwrap_or(R::TRUNCATION);
        if !(truncation > 0.0 && truncation < f64::INFINITY) {
            return Err(SetUpError::Truncation);
        }
        if motion.regime() == Regime::Aperiodic {
            return Err(SetUpError::Aperiodic);
        }
        if motion.is_steady() {
            self.builder.steady(motion, store);
            return Ok(());
        }
        let limits = Limits::new(R::TERMS, truncation, R::TRUNCATION, capacity);
        self.builder.begin(motion, rates, limits);
        between();
        let segments = capacity as u32;
        self.builder
            .tabulate(motion, store, between)
            .map_err(|TooManySegments| SetUpError::TooSmall { truncation, segments })
    }

    /// Writes the cells, the clock and the error bounds.
    #[inline(never)]
    fn describe<R: EphemerisScalar>(
        &self,
        table: &mut EphemerisView<R>,
        motion: &Motion,
        tick: Tick,
        epoch: i64,
        rates: &MeanRates,
        between: &mut dyn FnMut(),
    ) {
        let summary = &self.builder.summary;
        table.cells = summary.cells.map(|Cell(bits)| bits);
        table.segments.get_mut(summary.segments..).unwrap_or_default().fill(R::ZERO_SEGMENT);
        table.clock = Clock::new(motion, tick, epoch, rates, summary);
        between();
        table.start_tip_angle(motion, summary.start, epoch, between);
        between();
        let [x_rate, mean, axial] = table.clock.rates.map(Float::to_f64);
        let top = motion.top();
        // x changes by 2 over each segment
        let half_periods = x_rate / (2 * LONGEST) as f64;
        let rotor = Float::abs(top.rotor_momentum()) / top.transverse_inertia();
        let motion_rates = [half_periods, mean, axial, rotor];
        let per_tick = (tick.length().to_f64(), table.clock.increment_errors());
        [table.error_bound, table.rate_error_bound] =
            error_bounds(&R::ERRORS, rates, summary, motion_rates, per_tick);
        between();
    }
}

impl<R: EphemerisScalar> EphemerisMemory<EphemerisView<R>> {
    /// Sets up the table of a motion.
    ///
    /// * `epoch`: tick of the launch on a running counter
    /// * `between`: called at least every 50 000 cycles of a Cortex-M4F (200 000 of a Cortex-M0+)
    ///
    /// # Errors
    /// [`SetUpError`]; the memory then contains no table.
    pub fn set_up(
        &mut self,
        set_up: &mut SetUp,
        motion: &Motion,
        tick: Tick,
        epoch: i64,
        between: &mut dyn FnMut(),
    ) -> Result<ReadyEphemeris<'_, R>, SetUpError> {
        set_up.fill(self.table_mut(), motion, tick, epoch, between)?;
        Ok(ReadyEphemeris::new(self))
    }
}

impl<R: EphemerisScalar, const SEGMENTS: usize> Ephemeris<R, SEGMENTS> {
    /// Ephemeris of a motion that is launched at tick 0. It takes much stack: see [`EphemerisMemory::set_up`].
    ///
    /// # Errors
    /// [`SetUpError`]
    pub fn new(motion: &Motion, tick: Tick) -> Result<Self, SetUpError> {
        Self::within(motion, tick, R::TRUNCATION)
    }

    /// Ephemeris with a given truncation error, rad, finite and positive: a smaller table for a larger error.
    ///
    /// # Errors
    /// [`SetUpError`]
    pub fn within(motion: &Motion, tick: Tick, truncation: f64) -> Result<Self, SetUpError> {
        let mut ephemeris = Self::EMPTY;
        SetUp::within(truncation).fill(&mut ephemeris, motion, tick, 0, &mut || {})?;
        Ok(ephemeris)
    }
}

impl<R: EphemerisScalar> EphemerisView<R> {
    /// Number of segments that is enough for a motion with a given truncation error, rad; `None` if 4096, the largest number, are not
    /// enough, or the motion has no table.
    #[must_use]
    pub fn segments_needed(motion: &Motion, truncation: f64) -> Option<u32> {
        let mut set_up = SetUp::within(truncation);
        let store = &mut |_: usize, _: usize, parts: &Polynomial| put::<R>(&mut [], 0, 0, parts);
        let rates = set_up.mean_rates::<R>(motion, &mut || {});
        set_up.tabulate::<R>(motion, &rates, Cell::MOST_SEGMENTS, store, &mut || {}).ok()?;
        Some(set_up.builder.summary.segments.max(LONGEST) as u32)
    }
}
