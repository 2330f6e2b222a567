//! Cutting of half a nutation period into cells and segments; the other half is its mirror image.
//!
//! ```text
//! u = e₁                                                                    u = e₂
//! |    |    |    |    |    |    |    |    |    |    |    |    |    |    |    |    |    16 cells
//! |         |         |    |    |    |  |  |  |  ||||||||    |    |         |         |    segments: one polynomial of α and one of β
//! |                   |         |         |      |  |  |     |         |              |    spans: one expansion of the motion
//! ```
//!
//! The segments of a cell are equal, and the longest with an allowed error; a cell whose segments prove too long is cut again. Positions are in
//! units of the shortest segment. A segment of depth d is 2^-d of half a period.

use super::bound::{SegmentErrors, Speeds};
use super::limits::Limits;
use super::path::{Path, PathPoint};
use super::polynomial::Polynomial;
use super::series::MOST_TERMS;
use super::span::{CELL, HALF_PERIOD, Span};
use crate::table::data::cell::{CELLS, Cell};
use crate::table::evaluation::{LEAST_DEPTH, TABLE_UNIT};

/// Storage of a polynomial of α (column 0) or β (column 2): from segment, column and coefficients to the errors of orientation and derivative by
/// their rounding, in units of 2^-62 rad.
pub(super) type Store<'a> = dyn FnMut(usize, usize, [&[i64; MOST_TERMS]; 2]) -> [f32; 2] + 'a;

/// Cell whose segments are computed, or two cells with one segment.
#[derive(Debug)]
struct OpenCell {
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
pub(super) struct Cut {
    pub(super) cells: [u16; CELLS],
    pub(super) segments: usize,
    /// Orientation error besides that of a tick, rad.
    pub(super) error: f64,
    pub(super) speeds: Speeds,
    cell: OpenCell,
    /// Polynomial of α or β on a segment.
    segment: Polynomial,
}

impl Cut {
    pub(super) const ZERO: Self = Self {
        cells: [0; CELLS],
        segments: 0,
        error: 0.0,
        speeds: Speeds::ZERO,
        cell: OpenCell {
            begin: 0,
            end: 0,
            depth: 0,
            beginning: PathPoint::FIRST,
            speeds: Speeds::ZERO,
            error: 0.0,
        },
        segment: Polynomial::ZERO,
    };

    /// Stores the polynomials of a constant u.
    #[inline(never)]
    pub(super) fn store_constants(&mut self, ellipses: &[[f64; 2]; 2], store: &mut Store<'_>) {
        for ([plus, minus], column) in ellipses.iter().zip([0, 2]) {
            let mut re = [0; MOST_TERMS];
            re[0] = libm::round((plus + minus) / TABLE_UNIT) as i64;
            store(0, column, [&re, &[0; MOST_TERMS]]);
        }
        self.segments = 1;
        self.error = Speeds::ZERO.rounding([0.0; 2], 0.0);
    }

    pub(super) fn enter_span(&self, path: &mut Path, position: usize) {
        if position > path.span.begin {
            path.go_to_next_span(position == self.cell.end && self.first_depth(position) < path.span.depth);
        } else if position < path.span.begin {
            path.set_beginning(position, self.cell.beginning);
        }
    }

    /// Depth that is tried first, for twice the length. Two cells with one segment begin with an even one.
    fn first_depth(&self, begin: usize) -> u32 {
        self.cell.depth.saturating_sub(1).max(LEAST_DEPTH + (begin / CELL % 2) as u32)
    }

    /// Cuts the span into segments. Returns its end, or the beginning of a cell that must be cut again; `None` where the segments are too many.
    ///
    /// * `polynomials`: those of α and β on the span
    pub(super) fn cut_span(
        &mut self,
        path: &Path,
        polynomials: &[Polynomial; 2],
        limits: &Limits,
        store: &mut Store<'_>,
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
            let index = self.segments + (position - self.cell.begin) / length;
            for (whole, column) in polynomials.iter().zip([0, 2]) {
                self.segment.restrict(whole, position / length, halvings, limits.dropped);
                self.segment.shorten(limits.coefficients, i64::MAX);
                pause();
                let parts = self.segment.parts.each_ref().map(|part| &part.coefficients);
                let stored = store(index, column, parts);
                self.segment.add_errors(&mut errors, halvings, stored);
                pause();
            }
            let parts = (1_u32 << halvings) as f32;
            let residual_rate = path.expansion.greatest_residual_rate() / parts;
            self.cell.speeds.include(&errors, parts / span.half_length() as f32, residual_rate);
            let error = errors.error();
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

    /// Begins the cell anew with segments of this depth; `None` where they are too many.
    fn restart_cell(&mut self, depth: u32, limits: &Limits) -> Option<()> {
        if depth > Span::DEEPEST {
            return None;
        }
        let end = self.cell.begin + CELL.max(segment_length(depth));
        self.cell = OpenCell { end, depth, speeds: self.speeds, error: 0.0, ..self.cell };
        let remainder = HALF_PERIOD.saturating_sub(end).div_ceil(2 * CELL);
        let segments = self.segments + self.cell.segments() + remainder;
        (segments <= limits.capacity).then_some(())
    }

    fn finish_cell(&mut self) {
        let OpenCell { begin, end, depth, speeds, error, .. } = self.cell;
        let Cell(entry) = Cell::new(self.segments, begin / segment_length(depth), depth);
        let cells = self.cells.iter_mut().skip(begin / CELL).take((end - begin) / CELL);
        cells.for_each(|cell| *cell = entry);
        self.segments += self.cell.segments();
        self.error = self.error.max(TABLE_UNIT * f64::from(error));
        self.speeds = speeds;
    }
}

impl OpenCell {
    fn segments(&self) -> usize {
        (self.end - self.begin) / segment_length(self.depth)
    }
}

fn segment_length(depth: u32) -> usize {
    1 << (Span::DEEPEST - depth)
}
