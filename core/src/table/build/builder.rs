//! Builder of a table: half a nutation period as short polynomials; the other half is its mirror image.
//!
//! ```text
//! u = e₁                                                                    u = e₂
//! |    |    |    |    |    |    |    |    |    |    |    |    |    |    |    |    |    16 cells
//! |         |         |    |    |    |  |  |  |  ||||||||    |    |         |         |    segments: one polynomial of α and one of β
//! |                   |         |         |      |  |  |     |         |              |    spans: one expansion of the motion
//! ```
//!
//! A span ends where its series would exceed the allowed error. The segments of a cell are equal, and the longest with which the error is allowed.
//! Where they prove too long, the cell is cut again from its beginning.

use crate::cayley_klein::Ellipses;
use crate::motion::Motion;
use crate::phase::Phase;
use crate::scalar::times_power_of_two;
use crate::table::build::errors::{Limits, SegmentErrors, Speeds, TableSummary};
use crate::table::build::mean_rates::MeanRates;
use crate::table::build::path::{Path, Position};
use crate::table::build::polynomial::{Store, omitted_terms};
use crate::table::build::series::{Series, SpanSeries};
use crate::table::build::span::{CELL, HALF_PERIOD, Span};
use crate::table::build::start_search::{FoundStart, StartSearch};
use crate::table::cell::{Cell, cells_covered, segments_per_cell};
use crate::table::series::expansion::{TABLE_UNIT, larger_or_nan};
use crate::table::series::integers::TERMS;

/// Fraction of the allowed error that the estimated omitted terms of a span's series may cause.
const OMITTED_SHARE: f32 = 1.0 / 32.0;

/// Memory of a tabulation.
#[derive(Debug)]
pub(crate) struct TableBuilder {
    pub(crate) path: Path,
    /// Coefficients of e^{iχ} and e^{-iχ} in the ellipses of α and of β.
    exponentials: [[f64; 2]; 2],
    search: StartSearch,
    start: Option<FoundStart>,
    limits: Limits,
    pub(crate) summary: TableSummary,
    span: Span,
    cut: Cut,
    /// Series of α and of β on the span.
    series: [SpanSeries; 2],
    /// Estimates of the terms that they omit, in units of 2^-62.
    omitted: [f32; 2],
    /// Greatest |dθ/dx| on the span.
    theta_slope: f32,
    /// Series on a segment.
    segment: Series,
}

/// Cell that is cut, or two cells with one segment, in units of the shortest segment.
#[derive(Clone, Copy, Debug)]
struct Cut {
    begin: usize,
    end: usize,
    level: u32,
    /// Position at the beginning, if a span begins there.
    border: Position,
    speeds: Speeds,
    /// Greatest error of a segment, in units of 2^-62 rad.
    error: f32,
}

/// Error of a tabulation.
pub(crate) struct TooManySegments;

impl TableBuilder {
    pub(crate) const EMPTY: Self = Self {
        path: Path::EMPTY,
        exponentials: [[0.0; 2]; 2],
        search: StartSearch::EMPTY,
        start: None,
        limits: Limits::NONE,
        summary: TableSummary::EMPTY,
        span: Span::EMPTY,
        cut: Cut {
            begin: 0,
            end: 0,
            level: 0,
            border: Position::BEGINNING,
            speeds: Speeds::ZERO,
            error: 0.0,
        },
        series: [SpanSeries::ZERO; 2],
        omitted: [0.0; 2],
        theta_slope: 0.0,
        segment: Series::ZERO,
    };

    /// Tabulates a motion in which u is constant.
    #[inline(never)]
    pub(crate) fn steady(&mut self, motion: &Motion, store: &mut Store<'_>) {
        let ellipses: Ellipses<f64> = motion.ellipses();
        for (which, ellipse) in [&ellipses.alpha, &ellipses.beta].into_iter().enumerate() {
            let [plus, minus] = ellipse.exponentials();
            let mut re = [0; TERMS];
            re[0] = libm::round((plus + minus) / TABLE_UNIT) as i64;
            store(0, which, &[re, [0; TERMS]]);
        }
        let [alpha, beta] = motion.phases;
        let error = Speeds::ZERO.rounding([0.0; 2], 0.0);
        let start = [Phase::ZERO, alpha, beta];
        self.summary = TableSummary { segments: 1, start, error, ..TableSummary::EMPTY };
    }

    /// Takes over a motion that nutates.
    #[inline(never)] // one copy for all scalars
    pub(crate) fn begin(&mut self, motion: &Motion, rates: &MeanRates, limits: Limits) {
        self.path.begin(rates, limits.least);
        let Ellipses { alpha, beta } = motion.ellipses::<f64>();
        self.exponentials = [alpha.exponentials(), beta.exponentials()];
        (self.search, self.start) = (StartSearch::new(motion), None);
        (self.limits, self.summary) = (limits, TableSummary::EMPTY);
        (self.span, self.cut) = (Span::FIRST, Self::EMPTY.cut);
    }

    /// Computes all segments. One may be passed to `store` more than once, and the last time is valid.
    #[inline(never)]
    pub(crate) fn tabulate(
        &mut self,
        motion: &Motion,
        store: &mut Store<'_>,
        between: &mut dyn FnMut(),
    ) -> Result<(), TooManySegments> {
        let mut place = 0;
        while place < HALF_PERIOD {
            self.enter_span(place, between)?;
            place = self.cut_span(store, between)?;
        }
        self.summarise(motion);
        Ok(())
    }

    /// Expands the motion on the span that begins at `place`: the next one, or the first of a cell that is cut again.
    fn enter_span(&mut self, place: usize, between: &mut dyn FnMut()) -> Result<(), TooManySegments> {
        if place > self.span.begin {
            let share = self.share();
            let twice = Span { begin: place, depth: self.span.depth - 1 };
            let is_short = place == self.cut.end && self.coarser(place) < self.span.least_level();
            let doubles = twice.exists() && (is_short || self.path.reaches_twice_as_far(share));
            let x = if doubles { 3 } else { 2 };
            self.path.leave(x, f64::from(x) * share);
            self.span = if doubles { twice } else { Span { begin: place, ..self.span } };
            between();
        } else if place < self.span.begin {
            self.path.go_to(&self.cut.border);
            self.span.begin = place;
        }
        while !self.expand_span(between) {
            self.span.depth += self.path.halvings(self.share());
            if self.span.depth > Span::DEEPEST {
                return Err(TooManySegments);
            }
            self.path.return_to_border();
        }
        Ok(())
    }

    /// Cuts the span into segments. Returns its end, or an earlier place from which on a cell must be cut again.
    fn cut_span(
        &mut self,
        store: &mut Store<'_>,
        between: &mut dyn FnMut(),
    ) -> Result<usize, TooManySegments> {
        let mut place = self.span.begin;
        let least = self.span.least_level();
        if place < self.cut.end && self.cut.level < least {
            // the segments of the cell that goes on are longer than the span
            self.cut_again(self.cut.level.max(least))?;
            place = self.cut.begin;
        }
        while self.span.begin <= place && place < self.span.end() {
            if place == self.cut.end {
                self.begin_cell(place)?;
            }
            let error = self.shorten(place, store, between);
            self.cut.error = larger_or_nan(self.cut.error, error);
            if error.is_nan() || error > self.limits.segment(self.cut.level) {
                self.cut_again(self.cut.level + 1)?;
                place = self.cut.begin;
                continue;
            }
            place += segment_length(self.cut.level);
            if place == self.cut.end {
                self.end_cell();
            }
        }
        Ok(place)
    }

    /// Level that is tried first: segments of twice the length. Two cells that share one begin with an even number.
    fn coarser(&self, begin: usize) -> u32 {
        self.cut.level.saturating_sub(1).max((begin / CELL % 2) as u32)
    }

    /// Begins a cell.
    fn begin_cell(&mut self, begin: usize) -> Result<(), TooManySegments> {
        let level = self.coarser(begin).max(self.span.least_level());
        (self.cut.begin, self.cut.border) = (begin, *self.path.border());
        self.cut_again(level)
    }

    /// Begins the cell anew with segments of this level.
    fn cut_again(&mut self, level: u32) -> Result<(), TooManySegments> {
        let end = self.cut.begin + cells_covered(level) * CELL;
        self.cut = Cut { end, level, speeds: self.summary.speeds, error: 0.0, ..self.cut };
        let rest = HALF_PERIOD.saturating_sub(end).div_ceil(2 * CELL);
        let fits = self.summary.segments + segments_per_cell(level) + rest <= self.limits.capacity;
        if fits && level <= Cell::DEEPEST { Ok(()) } else { Err(TooManySegments) }
    }

    /// Enters the finished cell in the summary.
    fn end_cell(&mut self) {
        let Cut { begin, level, speeds, error, .. } = self.cut;
        let TableSummary { cells, segments, error: greatest, .. } = &mut self.summary;
        let entry = Cell::new(*segments, begin / segment_length(level), level);
        cells.iter_mut().skip(begin / CELL).take(cells_covered(level)).for_each(|cell| *cell = entry);
        *segments += segments_per_cell(level);
        *greatest = larger_or_nan(*greatest, TABLE_UNIT * f64::from(error));
        self.summary.speeds = speeds;
    }

    /// Truncation error of a step over half a span, with which the steps together have their part of the allowed error.
    fn share(&self) -> f64 {
        times_power_of_two(self.limits.steps, -1 - self.span.depth as i32)
    }

    /// Computes the series of α and β on the span. Returns whether they are accurate.
    fn expand_span(&mut self, between: &mut dyn FnMut()) -> bool {
        if !self.path.expand_span(self.span.depth + 1, self.share(), between) {
            return false;
        }
        for which in 0..self.series.len() {
            between();
            if self.turn(which).is_none() {
                return false;
            }
        }
        between();
        self.theta_slope = self.path.expansion().greatest_theta_slope();
        if self.start.is_none() {
            between();
            let (end, is_last) = (self.path.end().point.chi, self.span.end() == HALF_PERIOD);
            self.start = self.search.within(self.path.expansion(), end, is_last, self.span);
        }
        true
    }

    /// Series of α (0) or β (1) on the span from those of the phases; `None` where it is not accurate.
    fn turn(&mut self, which: usize) -> Option<()> {
        let series = self.series.get_mut(which)?.replace();
        series.terms = self.path.turned(which, *self.exponentials.get(which)?, &mut series.polynomial)?;
        let [re, im] = &series.polynomial;
        let omitted = 2.0 * larger_or_nan(omitted_terms(re), omitted_terms(im));
        (2.0 * omitted <= OMITTED_SHARE * self.limits.polynomial).then_some(())?;
        series.shorten(0, self.limits.left_out);
        *self.omitted.get_mut(which)? = omitted + self.path.least_term() as f32;
        Some(())
    }

    /// Stores the polynomials of the segment at `place`. Returns their error in units of 2^-62 rad.
    fn shorten(&mut self, place: usize, store: &mut Store<'_>, between: &mut dyn FnMut()) -> f32 {
        let length = segment_length(self.cut.level);
        let halvings = self.span.halvings(self.cut.level);
        let parts = (1_u32 << halvings) as f32;
        let index = self.summary.segments + (place - self.cut.begin) / length;
        let mut errors = SegmentErrors::NONE;
        for (which, (series, omitted)) in self.series.iter_mut().zip(self.omitted).enumerate() {
            series.restrict([place / length, halvings as usize], self.limits.left_out, &mut self.segment);
            self.segment.shorten(self.limits.terms, i64::MAX);
            between();
            errors.store(&self.segment, [omitted, TERMS as f32 * omitted / parts], (index, which), store);
            between();
        }
        errors.note(&mut self.cut.speeds, self.theta_slope / parts, self.path.part() as f32 / parts);
        errors.error()
    }

    #[inline(never)]
    fn summarise(&mut self, motion: &Motion) {
        let found = self.start.unwrap_or_default();
        let Position { remainder, squares, .. } = *self.path.end();
        let speeds = self.summary.speeds;
        self.summary.start = self.search.start(motion, &found);
        self.summary.error += speeds.truncation_error(remainder, self.path.fastest())
            + self.path.defect(&speeds)
            + speeds.rounding(squares.map(f64::from), found.share);
    }
}

fn segment_length(level: u32) -> usize {
    1 << (Cell::DEEPEST - level)
}
