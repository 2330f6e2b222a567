//! Set-up of an ephemeris: from a motion to the table and the clock.

use core::fmt;

use super::bound::error_bounds;
use super::cut::{Cut, Store};
use super::expansion::ParameterSeries;
use super::limits::Limits;
use super::mean_rates::MeanRates;
use super::path::{ComputeOrigin, Path};
use super::polynomial::Polynomial;
use super::series::MOST_TERMS;
use super::span::HALF_PERIOD;
use super::start::Start;
use crate::constants::Regime;
use crate::motion::Motion;
use crate::motion::cayley_klein::Ellipses;
use crate::scalar::{Float, short_float};
use crate::table::data::cell::{Cell, SEGMENTS_AT_LEVEL_0};
use crate::table::data::{Clock, Ephemeris, EphemerisMemory, EphemerisView, ReadyEphemeris, Tick};
use crate::table::scalar::{Coefficient, EphemerisScalar};

/// Reason why a motion has no table.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum SetUpError {
    /// The table has too few segments for the truncation error.
    TooSmall {
        /// Allowed truncation error, rad.
        truncation: f64,
        /// Number of segments; [`EphemerisView::segments_needed`](crate::EphemerisView::segments_needed) finds a sufficient one.
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

/// Memory of a set-up, and the truncation error that it allows. A program with a small stack keeps it in a static;
/// [`Cursor`](crate::Cursor) shows its use.
#[derive(Debug)]
pub struct SetUp {
    /// Truncation error, rad; `None` for that of the scalar.
    truncation: Option<f64>,
    limits: Limits,
    rates: MeanRates,
    start: Start,
    path: Path,
    series: ParameterSeries,
    /// Polynomials of α and β on a span, and one of them on a segment.
    polynomials: [Polynomial; 2],
    segment: Polynomial,
    cut: Cut,
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
            limits: Limits::ZERO,
            rates: MeanRates::ZERO,
            start: Start::ZERO,
            path: Path::ZERO,
            series: ParameterSeries::ZERO,
            polynomials: [Polynomial::ZERO; 2],
            segment: Polynomial::ZERO,
            cut: Cut::ZERO,
        }
    }

    /// Set-up with another truncation error, rad, finite and positive: a smaller table for a larger error.
    #[must_use]
    pub const fn with_truncation(truncation: f64) -> Self {
        Self { truncation: Some(truncation), ..Self::new() }
    }

    /// Computes the segments. The memory may hold none.
    fn tabulate<R: EphemerisScalar>(
        &mut self,
        motion: &Motion,
        segments: &mut [R::Segment],
        capacity: usize,
        pause: &mut dyn FnMut(),
    ) -> Result<(), SetUpError> {
        let truncation = self.truncation.unwrap_or(R::TRUNCATION);
        if !(truncation > 0.0 && truncation < f64::INFINITY) {
            return Err(SetUpError::Truncation);
        }
        if motion.regime() == Regime::Aperiodic {
            return Err(SetUpError::Aperiodic);
        }
        self.limits = Limits::new(R::TERMS, truncation, R::TRUNCATION, capacity);
        let store =
            &mut |segment, column, parts: [&_; 2]| store_polynomial::<R>(segments, segment, column, parts);
        let origin: ComputeOrigin = match R::RATE_WORDS {
            1 => |path| path.compute_origin(Float::to_f64),
            _ => |path| path.compute_origin(|constant| constant),
        };
        self.begin::<R>(motion, pause);
        let built = self.build(motion, origin, store, pause);
        built.ok_or(SetUpError::TooSmall { truncation, segments: capacity as u32 })
    }

    /// Computes the equations and the mean rates; begins at u = e₁.
    #[inline(never)]
    fn begin<R: EphemerisScalar>(&mut self, motion: &Motion, pause: &mut dyn FnMut()) {
        let mut period = None;
        if !motion.is_steady() {
            self.path.equations = motion.equations();
            pause();
            period = match R::RATE_WORDS {
                1 => motion.period::<1>(&self.path.equations, pause),
                _ => motion.period::<2>(&self.path.equations, pause),
            };
        }
        self.rates = MeanRates::new(motion, period.as_ref());
        pause();
        (self.start, self.cut) = (Start::new(motion), Cut::ZERO);
        if let Some(period) = period {
            self.path.begin(motion, period.time.halved(), &self.rates, &self.limits);
        }
    }

    /// Computes all segments; `None` where they are too many. One may be stored more than once.
    #[inline(never)]
    fn build(
        &mut self,
        motion: &Motion,
        origin: ComputeOrigin,
        store: &mut Store<'_>,
        pause: &mut dyn FnMut(),
    ) -> Option<()> {
        let Ellipses { alpha, beta } = motion.ellipses::<f64>();
        let ellipses = [alpha, beta].map(|ellipse| ellipse.exponentials());
        if motion.is_steady() {
            self.cut.store_constants(&ellipses, store);
            return Some(());
        }
        pause();
        let Self { limits, start, path, polynomials, segment, cut, .. } = self;
        let mut place = 0;
        while place < HALF_PERIOD {
            cut.enter_span(path, place);
            while path
                .expand(origin, pause)
                .and_then(|()| {
                    let ellipses = ellipses.iter().enumerate();
                    polynomials.iter_mut().zip(ellipses).try_for_each(|(polynomial, (index, ellipse))| {
                        pause();
                        polynomial.compute(
                            &mut self.series,
                            &path.expansion,
                            (index, *ellipse),
                            limits,
                            pause,
                        )
                    })
                })
                .is_none()
            {
                path.shorten_span()?;
            }
            pause();
            start.search(&path.expansion, path.end.phases.chi, path.span);
            place = cut.cut_span(path, polynomials, segment, limits, store, pause)?;
        }
        cut.error += path.error(&cut.speeds, start.delay);
        Some(())
    }

    /// Writes the cells, the clock and the error bounds.
    #[inline(never)]
    fn finish<R: EphemerisScalar>(
        &self,
        table: &mut EphemerisView<R>,
        motion: &Motion,
        tick: Tick,
        epoch: i64,
        pause: &mut dyn FnMut(),
    ) {
        let Cut { cells, segments, error, speeds, .. } = &self.cut;
        table.cells = *cells;
        table.segments.get_mut(*segments..).unwrap_or_default().fill(R::ZERO_SEGMENT);
        table.clock = Clock::new(motion, tick, epoch, self.rates.turns, self.start.phases);
        pause();
        table.start_tip_angle(motion, self.start.phases, epoch, pause);
        pause();
        [table.error_bound, table.rate_error_bound] =
            error_bounds(&R::ERRORS, motion, tick.length(), &self.rates, speeds, *error);
        pause();
    }
}

impl<R: EphemerisScalar> EphemerisMemory<EphemerisView<R>> {
    /// Sets up the table of a motion.
    ///
    /// * `epoch`: tick of the launch on a running counter
    /// * `pause`: called at least every 50 000 cycles of a Cortex-M4F (200 000 of a Cortex-M0+)
    ///
    /// # Errors
    /// [`SetUpError`]; the memory then contains no table.
    pub fn set_up(
        &mut self,
        set_up: &mut SetUp,
        motion: &Motion,
        tick: Tick,
        epoch: i64,
        pause: &mut dyn FnMut(),
    ) -> Result<ReadyEphemeris<'_, R>, SetUpError> {
        let Self { is_set_up, table } = self;
        *is_set_up = false;
        let capacity = table.capacity();
        set_up.tabulate::<R>(motion, &mut table.segments, capacity, pause)?;
        pause();
        set_up.finish(table, motion, tick, epoch, pause);
        *is_set_up = true;
        Ok(ReadyEphemeris(self))
    }
}

impl<R: EphemerisScalar, const SEGMENTS: usize> Ephemeris<R, SEGMENTS> {
    /// Ephemeris of a motion that is launched at tick 0. It needs 14 KiB of stack on a Cortex-M4F in `f32`; [`EphemerisMemory::set_up`] needs 5 KiB.
    ///
    /// # Errors
    /// [`SetUpError`]
    pub fn new(motion: &Motion, tick: Tick) -> Result<Self, SetUpError> {
        Self::with_truncation(motion, tick, R::TRUNCATION)
    }

    /// Ephemeris with a given truncation error, rad, finite and positive: a smaller table for a larger error.
    ///
    /// # Errors
    /// [`SetUpError`]
    pub fn with_truncation(motion: &Motion, tick: Tick, truncation: f64) -> Result<Self, SetUpError> {
        let mut memory = EphemerisMemory::<Self>::new();
        memory.set_up(&mut SetUp::with_truncation(truncation), motion, tick, 0, &mut || {})?;
        Ok(memory.table)
    }
}

impl<R: EphemerisScalar> EphemerisView<R> {
    /// Number of segments that is enough for a truncation error, rad; `None` if 4096, the largest number, are not, or the motion has no table.
    #[must_use]
    pub fn segments_needed(motion: &Motion, truncation: f64) -> Option<u32> {
        let mut set_up = SetUp::with_truncation(truncation);
        set_up.tabulate::<R>(motion, &mut [], Cell::MOST_SEGMENTS, &mut || {}).ok()?;
        Some(set_up.cut.segments.max(SEGMENTS_AT_LEVEL_0) as u32)
    }
}

/// Stores a polynomial in two columns of a segment, if the table contains it. Returns the error of the orientation by short products and
/// coefficients out of range, and that of the derivative by rounding, in units of 2^-62 rad.
fn store_polynomial<R: EphemerisScalar>(
    segments: &mut [R::Segment],
    segment: usize,
    column: usize,
    parts: [&[i64; MOST_TERMS]; 2],
) -> [f32; 2] {
    let place = segments.get_mut(segment).map_or(&mut [][..], |segment| segment.as_mut());
    let (mut largest, mut slope_squares) = (0.0, 0.0);
    for (column, part) in (column..).zip(parts) {
        let part = part.get(..R::TERMS).unwrap_or(part);
        // Σ k |error of c_k|
        let (mut errors, mut slope_error) = (0_u64, 0_u64);
        for (power, (four, &value)) in place.iter_mut().zip(part).enumerate().rev() {
            if let Some(held) = four.get_mut(column) {
                let (coefficient, error) = R::Coefficient::nearest(value, power);
                *held = coefficient;
                if power > 0 {
                    errors = errors.saturating_add(error.unsigned_abs());
                    slope_error = slope_error.saturating_add(errors);
                }
            }
        }
        let error = R::Coefficient::error(part);
        largest = if error > largest { error } else { largest };
        let slope_error = short_float(slope_error);
        slope_squares += slope_error * slope_error;
    }
    [4.0 * largest, Float::sqrt(slope_squares)]
}
