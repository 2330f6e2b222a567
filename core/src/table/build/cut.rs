//! Cutting of half a nutation period into cells and segments; the other half is its mirror image.
//!
//! ```text
//! u = e₁                                                                    u = e₂
//! |    |    |    |    |    |    |    |    |    |    |    |    |    |    |    |    |    16 cells
//! |         |         |    |    |    |  |  |  |  ||||||||    |    |         |         |    segments: one polynomial of α and one of β
//! |                   |         |         |      |  |  |     |         |              |    spans: one expansion of the motion
//! ```
//!
//! The segments of a cell are equal, and the longest with an allowed error. A cell whose segments prove too long is cut again.

use super::bound::{SegmentErrors, Speeds};
use super::{CELL, HALF_PERIOD, Limits, OpenCell, SetUp};
use crate::motion::Motion;
use crate::table::build::series::TERMS;
use crate::table::data::cell::{Cell, cells_covered, segments_per_cell};
use crate::table::scalar::TABLE_UNIT;

/// Function that stores a polynomial. Its arguments are the segment, the column of the real part and the coefficients of both parts. It
/// returns the errors of the orientation and of the derivative by their rounding. All are in units of 2^-62.
pub(crate) type Store<'a> = dyn FnMut(usize, usize, [&[i64; TERMS]; 2]) -> [f32; 2] + 'a;

impl SetUp {
    /// Computes all segments; `None` where they are too many. One may be stored more than once.
    #[inline(never)]
    pub(crate) fn build<const WORDS: usize>(
        &mut self,
        motion: &Motion,
        limits: Limits,
        store: &mut Store<'_>,
        pause: &mut dyn FnMut(),
    ) -> Option<()> {
        self.begin::<WORDS>(motion, limits, pause);
        if motion.is_steady() {
            self.store_constants(store);
            return Some(());
        }
        pause();
        let mut place = 0;
        while place < HALF_PERIOD {
            self.enter_span::<WORDS>(place, pause)?;
            place = self.cut_span(store, pause)?;
        }
        self.outline.error += self.path_error();
        Some(())
    }

    /// Stores the polynomials of a motion in which u is constant.
    #[inline(never)]
    fn store_constants(&mut self, store: &mut Store<'_>) {
        for (series, column) in self.series.iter().zip([0, 2]) {
            let [plus, minus] = series.exponentials;
            let mut re = [0; TERMS];
            re[0] = libm::round((plus + minus) / TABLE_UNIT) as i64;
            store(0, column, [&re, &[0; TERMS]]);
        }
        self.outline.segments = 1;
        self.outline.error = Speeds::ZERO.rounding([0.0; 2], 0.0);
    }

    /// Expands the motion on the span that begins at `place`, which is the next one unless a cell is cut again.
    fn enter_span<const WORDS: usize>(&mut self, place: usize, pause: &mut dyn FnMut()) -> Option<()> {
        if place > self.span.begin {
            self.next_span(place == self.cell.end && self.coarser(place) < self.span.least_level());
        } else if place < self.span.begin {
            self.go_to(place, self.cell.beginning);
        }
        while self.expand_span::<WORDS>(pause).is_none() {
            self.shorten_span()?;
        }
        Some(())
    }

    /// Computes the series of α and β on the span; `None` where they are not accurate.
    fn expand_span<const WORDS: usize>(&mut self, pause: &mut dyn FnMut()) -> Option<()> {
        self.expand_motion::<WORDS>(pause)?;
        for (slow, series) in self.series.iter_mut().enumerate() {
            pause();
            series.compute(&mut self.expansion, slow, &self.limits, pause)?;
        }
        pause();
        self.start.search(&self.expansion, self.end.phases.chi, self.span);
        Some(())
    }

    /// Level that is tried first: segments of twice the length. Two cells with one segment begin with an even number.
    fn coarser(&self, begin: usize) -> u32 {
        self.cell.level.saturating_sub(1).max((begin / CELL % 2) as u32)
    }

    /// Cuts the span into segments. Returns its end, or the place of a cell that must be cut again from an earlier span on.
    fn cut_span(&mut self, store: &mut Store<'_>, pause: &mut dyn FnMut()) -> Option<usize> {
        let span = self.span;
        let (mut place, least) = (span.begin, span.least_level());
        if place < self.cell.end && self.cell.level < least {
            // the segments of the unfinished cell are longer than the span
            self.cut_again(least)?;
            place = self.cell.begin;
        }
        while span.begin <= place && place < span.end() {
            if place == self.cell.end {
                (self.cell.begin, self.cell.beginning) = (place, self.beginning);
                self.cut_again(self.coarser(place).max(least))?;
            }
            let error = self.store_segment(place, store, pause);
            if error <= self.limits.segment(self.cell.level) {
                self.cell.error = self.cell.error.max(error);
                place += segment_length(self.cell.level);
                if place == self.cell.end {
                    self.end_cell();
                }
            } else {
                self.cut_again(self.cell.level + 1)?;
                place = self.cell.begin;
            }
        }
        Some(place)
    }

    /// Begins the cell anew with segments of this level; `None` where they are too many.
    fn cut_again(&mut self, level: u32) -> Option<()> {
        let end = self.cell.begin + cells_covered(level) * CELL;
        self.cell = OpenCell { end, level, speeds: self.outline.speeds, error: 0.0, ..self.cell };
        let rest = HALF_PERIOD.saturating_sub(end).div_ceil(2 * CELL);
        let segments = self.outline.segments + segments_per_cell(level) + rest;
        (segments <= self.limits.capacity && level <= Cell::DEEPEST).then_some(())
    }

    fn end_cell(&mut self) {
        let OpenCell { begin, level, speeds, error, .. } = self.cell;
        let Cell(entry) = Cell::new(self.outline.segments, begin / segment_length(level), level);
        self.outline
            .cells
            .iter_mut()
            .skip(begin / CELL)
            .take(cells_covered(level))
            .for_each(|cell| *cell = entry);
        self.outline.segments += segments_per_cell(level);
        self.outline.error = self.outline.error.max(TABLE_UNIT * f64::from(error));
        self.outline.speeds = speeds;
    }

    /// Stores the polynomials of the segment at `place`. Returns their error in units of 2^-62 rad.
    fn store_segment(&mut self, place: usize, store: &mut Store<'_>, pause: &mut dyn FnMut()) -> f32 {
        let Self { segment, cell, limits, span, .. } = self;
        let length = segment_length(cell.level);
        let halvings = span.halvings(cell.level);
        let parts = (1_u32 << halvings) as f32;
        let index = self.outline.segments + (place - cell.begin) / length;
        let mut errors = SegmentErrors::default();
        for (series, column) in self.series.iter_mut().zip([0, 2]) {
            series.restrict(place / length, halvings, limits.left_out, segment);
            segment.shorten(limits.terms, i64::MAX);
            pause();
            let omitted = [series.omitted, TERMS as f32 * series.omitted / parts];
            let parts = segment.parts.each_ref().map(|part| &part.coefficients);
            segment.add_errors(&mut errors, omitted, store(index, column, parts));
            pause();
        }
        let part = span.half_length() as f32 / parts;
        errors.include_in(&mut cell.speeds, 1.0 / part, self.expansion.greatest_theta_slope() / parts);
        errors.error()
    }
}

fn segment_length(level: u32) -> usize {
    1 << (Cell::DEEPEST - level)
}
