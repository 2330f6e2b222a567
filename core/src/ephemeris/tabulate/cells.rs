//! Cells of a tabulation, and the segments into which each is divided.

use crate::ephemeris::cell::{Cell, cells_covered, segments_per_cell};
use crate::ephemeris::larger_error::LargerError;
use crate::ephemeris::polynomial::Store;
use crate::ephemeris::segment_errors::SegmentErrors;
use crate::ephemeris::segment_estimate::SegmentEstimate;
use crate::ephemeris::tabulate::{Piece, Tabulation};
use crate::law::series::{TERMS, UNIT, larger_or_nan};

/// Upper bound on the error of a segment from the rounding of the coefficients of its series, in units of 2^-62 rad.
const ROUNDED: f32 = 16.0;

impl Tabulation {
    /// Enters the cell in which the span begins, or which begins in the span.
    pub(super) fn enter(&mut self) -> Result<Piece, ()> {
        let least = self.span.least_level();
        if self.place > 0 && least <= self.level {
            return Ok(Piece::Polynomial(0));
        }
        // both cells of a pair share a segment, or neither does
        self.divide(self.level.max(least).max((self.number % 2) as u32))
    }

    /// Divides the cell into segments of a level, and begins with the first of them.
    pub(super) fn divide(&mut self, level: u32) -> Result<Piece, ()> {
        self.level = level;
        self.check_capacity(level)?;
        let cells = self.tabulated.cells.iter_mut().enumerate();
        for (number, cell) in cells.skip(self.number).take(cells_covered(level)) {
            *cell = Cell::new(number, self.tabulated.segments, level);
        }
        (self.place, self.error, self.speeds) = (0, 0.0, self.speeds_before);
        let begin = self.segment_begin();
        if self.span.begin() <= begin {
            return Ok(Piece::Polynomial(0));
        }
        self.span = self.span.at(begin);
        self.path.return_to_mark();
        self.found_start = self.found_start.filter(|_| self.found_before);
        Ok(Piece::Rates(false))
    }

    /// Refuses a number of halvings with which the table would have too many segments.
    pub(super) fn check_capacity(&self, level: u32) -> Result<(), ()> {
        let fits = self.tabulated.segments + self.least_rest(level, &self.estimate) <= self.requirements.most;
        (level <= Cell::DEEPEST && fits).then_some(()).ok_or(())
    }

    /// Least number of segments of the cell at a level and of those after it.
    fn least_rest(&self, level: u32, estimate: &SegmentEstimate) -> usize {
        segments_per_cell(level.min(Cell::DEEPEST))
            + estimate.least_segments(self.number + cells_covered(level))
    }

    /// Whether a refused table might have fitted with the larger error, from the errors of the cells so far and the estimate of the
    /// others.
    pub(crate) fn may_fit_with_larger_error(&self, estimate: &SegmentEstimate) -> bool {
        self.larger.may_fit(self.level, |level| self.least_rest(level, estimate), self.requirements.most)
    }

    /// Number of the segment among all of this length.
    fn segment_number(&self) -> usize {
        ((self.number << self.level) >> 1) + self.place
    }

    /// Beginning of the segment in units of the shortest one.
    fn segment_begin(&self) -> usize {
        self.segment_number() << (Cell::DEEPEST - self.level)
    }

    /// Stores the series of α or of β on a segment as a polynomial of reduced degree.
    #[inline(never)]
    pub(super) fn shorten(&mut self, which: usize, store: &mut Store<'_>) -> Result<Piece, ()> {
        let halvings = self.span.halvings(self.level);
        let number = self.segment_number();
        let (Some(span), Some(upper)) = (self.series.get_mut(which), self.upper_halves.get_mut(which)) else {
            return Err(());
        };
        let part = [number, halvings as usize];
        let series = upper.restrict(span, part, self.requirements.negligible(), &mut self.lower_half);
        if which == 0 {
            self.segment = SegmentErrors::NONE;
        }
        let omitted = self.omitted.get(which).copied().unwrap_or_default();
        // the derivative by the coordinate of the segment
        let omitted = [omitted, TERMS as f32 * omitted / (1_u32 << halvings) as f32];
        let place = (self.tabulated.segments + self.place, which);
        self.segment.shorten(series, omitted, self.requirements.terms, place, store);
        if which == 0 { Ok(Piece::Polynomial(1)) } else { self.judge() }
    }

    /// Next piece after a segment.
    fn judge(&mut self) -> Result<Piece, ()> {
        let parts = (1_u32 << self.span.halvings(self.level)) as f32;
        self.speeds.note(self.segment.speeds(), self.theta_slope / parts, self.path.part() as f32 / parts);
        self.error = larger_or_nan(self.error, self.segment.error());
        self.larger.note(
            self.error <= LargerError::FACTOR as f32 * self.requirements.of_segment(self.level),
            self.level,
        );
        if self.error <= self.requirements.of_segment(self.level) {
            self.accept()
        } else {
            self.longer.failed(self.error / self.requirements.of_segment(self.level));
            self.divide(self.finer_level())
        }
    }

    /// Number of halvings with which the segments of the cell may have the allowed error, or the larger one.
    fn finer_level(&self) -> u32 {
        // no term decreases faster than the last, and segments that are too short would take memory
        const GREATEST_DECREASE: f32 = 1.0 / (1_u32 << TERMS) as f32;
        let (mut level, mut error) = (self.level + 1, self.error * GREATEST_DECREASE);
        while error > LargerError::FACTOR as f32 * self.requirements.of_segment(level)
            && level < Cell::DEEPEST
        {
            (level, error) = (level + 1, error * GREATEST_DECREASE);
        }
        level
    }

    /// Goes on to the next segment.
    fn accept(&mut self) -> Result<Piece, ()> {
        self.place += 1;
        let position = self.segment_begin();
        if self.place == segments_per_cell(self.level) {
            self.leave();
        }
        if position >= self.span.end() { Ok(Piece::Step) } else { self.enter() }
    }

    /// Leaves a complete cell. The segments of the next have the same or twice the length.
    fn leave(&mut self) {
        let level = self.level;
        // roundings of the coefficients and terms left out do not depend on the length; a change of α and of β by a unit of
        // 2^-61 each is an orientation error of up to 4 √2 units of 2^-62
        let other_errors = ROUNDED + 5.7 * self.requirements.negligible() as f32;
        let longer_error = (self.error - other_errors) * (1_u32 << self.requirements.terms) as f32;
        self.tabulated.truncation = larger_or_nan(self.tabulated.truncation, UNIT * f64::from(self.error));
        self.tabulated.segments += segments_per_cell(level);
        self.speeds_before = self.speeds;
        self.number += cells_covered(level);
        let longest = (self.number % 2) as u32;
        let coarser = self.longer.may_do(match level.checked_sub(1) {
            Some(coarser) if level > longest => longer_error / self.requirements.of_segment(coarser),
            _ => f32::INFINITY,
        });
        self.larger.leave(level, coarser);
        self.level -= u32::from(coarser);
        (self.place, self.error) = (0, 0.0);
    }
}
