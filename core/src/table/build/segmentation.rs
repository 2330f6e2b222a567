//! Division of half a nutation period into cells and segments; the other half is its mirror image.
//!
//! ```text
//! u = e₁                                                                    u = e₂
//! |    |    |    |    |    |    |    |    |    |    |    |    |    |    |    |    |    16 cells
//! |         |         |    |    |    |  |  |  |  ||||||||    |    |         |         |    segments: one polynomial of a and one of b
//! |                   |         |         |      |  |  |     |         |              |    spans: one expansion of the motion
//! ```
//!
//! The segments of a cell are equal, and the longest with an allowed error. A cell whose segments prove too long is begun again with shorter
//! ones. A segment of depth d is 2^-d of half a period. Positions are in units of the shortest segment.

use super::limits::Limits;
use super::path::{CELL, HALF_PERIOD, Path, PathPoint, Span};
use super::polynomial::Polynomial;
use super::speeds::{SegmentErrors, Speeds};
use crate::table::data::cell::{CELLS, Cell, LEAST_DEPTH};
use crate::table::evaluation::TABLE_UNIT;

/// Table in which segments are stored.
pub(super) trait SegmentStore {
    /// Rounds and stores the polynomial of a (index 0) or b (1), if the table contains the segment. Returns the orientation error by products
    /// with 16 bits, in units of 2^-62 rad; infinite where a sum could overflow.
    fn store(&mut self, segment: usize, index: usize, polynomial: &Polynomial) -> f32;
}

/// Cell whose segments are computed, or two cells with one segment.
#[derive(Debug)]
struct UnfinishedCell {
    begin: usize,
    end: usize,
    depth: u32,
    /// Point at the beginning, if a span begins there.
    beginning: PathPoint,
    /// Speeds up to here.
    speeds: Speeds,
    /// Greatest error in the cell, in units of 2^-62 rad.
    error: f32,
}

/// Cells and segments of a table, and what its error bounds follow from.
#[derive(Debug)]
pub(super) struct Segmentation {
    pub(super) cells: [u16; CELLS],
    pub(super) segments: usize,
    /// Greatest error of a segment, rad.
    pub(super) truncation: f64,
    pub(super) speeds: Speeds,
    cell: UnfinishedCell,
    /// Polynomial of a or b on a segment.
    segment: Polynomial,
}

impl Segmentation {
    pub(super) const ZERO: Self = Self {
        cells: [0; CELLS],
        segments: 0,
        truncation: 0.0,
        speeds: Speeds::ZERO,
        cell: UnfinishedCell {
            begin: 0,
            end: 0,
            depth: 0,
            beginning: PathPoint::FIRST,
            speeds: Speeds::ZERO,
            error: 0.0,
        },
        segment: Polynomial::ZERO,
    };

    /// Stores one segment with constant a and b, for a constant u.
    #[inline(never)]
    pub(super) fn store_constants(&mut self, values: [f64; 2], store: &mut dyn SegmentStore) {
        for (index, value) in values.into_iter().enumerate() {
            store.store(0, index, &Polynomial::constant(value));
        }
        self.segments = 1;
    }

    /// Leads the path to the span from `position` on.
    pub(super) fn enter_span(&self, path: &mut Path, position: usize) {
        if position > path.span.begin {
            // a new cell begins with longer segments, for which a longer span is tried even if it may fail
            path.go_to_next_span(position == self.cell.end && self.first_depth(position) < path.span.depth);
        } else if position < path.span.begin {
            path.set_beginning(position, self.cell.beginning);
        }
    }

    /// First depth to try: one less than that of the last cell. A segment of two cells begins at an even cell.
    fn first_depth(&self, begin: usize) -> u32 {
        self.cell.depth.saturating_sub(1).max(LEAST_DEPTH + (begin / CELL % 2) as u32)
    }

    /// Divides the span into segments. Returns its end, or the beginning of a cell that needs shorter ones; `None` if they are too many.
    ///
    /// * `polynomials`: those of a and b on the span
    pub(super) fn segment_span(
        &mut self,
        path: &Path,
        polynomials: &[Polynomial; 2],
        limits: &Limits,
        store: &mut dyn SegmentStore,
        pause: &mut dyn FnMut(),
    ) -> Option<usize> {
        let span = path.span;
        let mut position = span.begin;
        if position < self.cell.end && self.cell.depth < span.depth {
            // the segments of the unfinished cell are longer than the span
            self.restart_cell(span.depth, limits)?;
            position = self.cell.begin;
        }
        while span.begin <= position && position < span.end() {
            if position == self.cell.end {
                (self.cell.begin, self.cell.beginning) = (position, path.beginning);
                self.restart_cell(self.first_depth(position).max(span.depth), limits)?;
            }
            let depth = self.cell.depth;
            let mut errors = SegmentErrors::default();
            let (length, halvings) = (segment_length(depth), depth.saturating_sub(span.depth));
            let segment = self.segments + (position - self.cell.begin) / length;
            for (index, whole) in polynomials.iter().enumerate() {
                self.segment.restrict(whole, position / length, halvings, limits.dropped_terms);
                self.segment.shorten(limits.terms, i64::MAX);
                self.segment.add_errors(&mut errors);
                errors.stored = errors.stored.max(store.store(segment, index, &self.segment));
                pause();
            }
            let parts = (1_u32 << halvings) as f32;
            let residual_rate = path.expansion.greatest_residual_rate() / parts;
            self.cell.speeds.include(&errors, parts / span.half_length() as f32, residual_rate);
            let error = errors.orientation();
            if error <= limits.segment_error(depth) {
                self.cell.error = self.cell.error.max(error);
                position += length;
                if position == self.cell.end {
                    self.finish_cell();
                }
            } else {
                self.restart_cell(depth + 1, limits)?;
                position = self.cell.begin;
            }
        }
        Some(position)
    }

    /// Begins the cell anew with segments of this depth; `None` if they are too many.
    fn restart_cell(&mut self, depth: u32, limits: &Limits) -> Option<()> {
        if depth > Span::DEEPEST {
            return None;
        }
        let end = self.cell.begin + CELL.max(segment_length(depth));
        self.cell = UnfinishedCell { end, depth, speeds: self.speeds, error: 0.0, ..self.cell };
        let remainder = HALF_PERIOD.saturating_sub(end).div_ceil(2 * CELL);
        let segments = self.segments + self.cell.segments() + remainder;
        (segments <= limits.capacity).then_some(())
    }

    fn finish_cell(&mut self) {
        let UnfinishedCell { begin, end, depth, speeds, error, .. } = self.cell;
        let Cell(entry) = Cell::new(self.segments, begin / segment_length(depth), depth);
        let cells = self.cells.iter_mut().skip(begin / CELL).take((end - begin) / CELL);
        cells.for_each(|cell| *cell = entry);
        self.segments += self.cell.segments();
        self.truncation = self.truncation.max(TABLE_UNIT * f64::from(error));
        self.speeds = speeds;
    }
}

impl UnfinishedCell {
    fn segments(&self) -> usize {
        (self.end - self.begin) / segment_length(self.depth)
    }
}

fn segment_length(depth: u32) -> usize {
    1 << (Span::DEEPEST - depth)
}
