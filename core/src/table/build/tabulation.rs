//! Tabulation of a path in spans, cells and segments.
//!
//! ```text
//! u = e₁                                                                    u = e₂
//! |    |    |    |    |    |    |    |    |    |    |    |    |    |    |    |    |    16 cells
//! |         |         |    |    |    |  |  |  |  ||||||||    |    |         |         |    segments: one polynomial of a and one of b
//! |                   |         |    |    |    |  |  |  |    |    |                   |    spans: one expansion of the motion
//! ```
//!
//! A span has whole cells, or a cell has several spans of one length. All segments of a cell have one length, and none crosses the end of a span.
//! If a span or the segments of a cell are not accurate, half their length is tried. After a success twice the length is tried: for segments at the
//! next cell, for spans where a span of twice the length may begin. If a cell of several spans fails, it begins again at its first span. A
//! span longer than a cell is kept.

use crate::table::build::interval::{Interval, SHORTEST_SEGMENTS};
use crate::table::build::path::{MIN_SPAN_DEPTH, Path};
use crate::table::build::segment::{SegmentBounds, store_segment};
use crate::table::data::cell::{CELLS, Cell, MIN_DEPTH};
use crate::table::evaluation::TableScalar;

/// Depth of a cell.
const CELL_DEPTH: u32 = CELLS.ilog2();

/// Length of a cell, in shortest segments.
const CELL_LENGTH: usize = SHORTEST_SEGMENTS / CELLS;

/// Division of half a period into cells and segments.
#[derive(Debug)]
pub(super) struct Division {
    pub(super) cells: [u16; CELLS],
    pub(super) segment_count: usize,
    pub(super) bounds: SegmentBounds,
}

impl Division {
    pub(super) const ZERO: Self = Self { cells: [0; CELLS], segment_count: 0, bounds: SegmentBounds::ZERO };
}

/// Tabulation of a path up to a position.
pub(super) struct Tabulation<'a, 'p, R: TableScalar> {
    division: &'a mut Division,
    path: &'a mut Path<'p, R::SetUpFloat>,
    segments: &'a mut [R::Segment],
    capacity: usize,
    /// End of the last cell.
    position: usize,
    /// End of the last span.
    span_end: usize,
    /// Depth of the next span.
    span_depth: u32,
    /// Depth of the next segments.
    depth: u32,
}

impl<'a, 'p, R: TableScalar> Tabulation<'a, 'p, R> {
    /// Tabulation that begins at u = e₁, with the parameters of `TabulatedHalfPeriod::compute`.
    pub(super) fn new(
        division: &'a mut Division,
        path: &'a mut Path<'p, R::SetUpFloat>,
        segments: &'a mut [R::Segment],
        capacity: usize,
    ) -> Self {
        let (span_depth, depth) = (MIN_SPAN_DEPTH, MIN_DEPTH);
        Self { division, path, segments, capacity, position: 0, span_end: 0, span_depth, depth }
    }

    /// Tabulates the path to u = e₂; `None` as soon as the segments cannot fit.
    #[inline(never)]
    pub(super) fn tabulate(&mut self) -> Option<()> {
        while self.position < SHORTEST_SEGMENTS {
            let start = self.path.end();
            if self.tabulate_cell()? {
                if Interval::least_depth_at(self.position) + 2 <= self.span_depth {
                    // never longer than the longest span, because the least depth inside the half period is at least 1
                    self.span_depth -= 1;
                }
            } else if self.span_depth > CELL_DEPTH {
                self.path.return_to(start);
                self.span_end = self.position;
            }
        }
        Some(())
    }

    /// Tabulates the next cell, or the next two. Returns whether spans and segments are accurate.
    fn tabulate_cell(&mut self) -> Option<bool> {
        let least_depth = Interval::least_depth_at(self.position).max(self.span_depth).max(MIN_DEPTH);
        self.depth = self.depth.max(least_depth);
        let cell = self.next_cell()?;
        let mut bounds = SegmentBounds::ZERO;
        for part in cell.parts(self.span_depth.max(cell.depth)) {
            if part.begin == self.span_end {
                let span = Interval { begin: part.begin, depth: self.span_depth };
                if self.path.advance(span).is_none() {
                    self.span_depth += 1;
                    return Some(false);
                }
                self.span_end = span.end();
            }
            if self.store_segments(part, &mut bounds).is_none() {
                self.depth += 1;
                return Some(false);
            }
        }
        self.complete_cell(cell, &bounds);
        Some(true)
    }

    /// Next cell, or the next two; `None` if its segments cannot fit.
    fn next_cell(&self) -> Option<Interval> {
        // a segment may have two cells
        let cell = Interval { begin: self.position, depth: self.depth.min(CELL_DEPTH) };
        let least_after = (SHORTEST_SEGMENTS - cell.end()).div_ceil(SHORTEST_SEGMENTS >> MIN_DEPTH);
        let count = self.division.segment_count + cell.part_count(self.depth) + least_after;
        (self.depth <= Cell::MAX_DEPTH && count <= self.capacity).then_some(cell)
    }

    /// Stores the segments of the next cell, or of a part of it; `None` if they are not accurate.
    #[inline(never)]
    fn store_segments(&mut self, part: Interval, bounds: &mut SegmentBounds) -> Option<()> {
        for segment in part.parts(self.depth) {
            let first = Interval { begin: self.position, depth: self.depth };
            let number = self.division.segment_count + (segment.number() - first.number());
            let last = self.segments.len().checked_sub(1)?;
            let stored = self.segments.get_mut(number.min(last))?;
            bounds.include(&store_segment::<R>(self.path, segment, stored));
            let is_accurate = bounds.error <= self.path.budget.segment_error_at(self.depth);
            if !is_accurate {
                return None;
            }
        }
        Some(())
    }

    /// Completes the next cell, or two, whose segments are stored.
    fn complete_cell(&mut self, cell: Interval, bounds: &SegmentBounds) {
        let Division { cells, segment_count, bounds: all_bounds } = &mut *self.division;
        let first = Interval { begin: cell.begin, depth: self.depth };
        let Cell(entry) = Cell::new(*segment_count, first.number(), self.depth);
        let (begin, count) = (cell.begin / CELL_LENGTH, cell.length() / CELL_LENGTH);
        cells.iter_mut().skip(begin).take(count).for_each(|stored| *stored = entry);
        *segment_count += cell.part_count(self.depth);
        all_bounds.include(bounds);
        self.position = cell.end();
        self.depth -= 1;
    }
}
