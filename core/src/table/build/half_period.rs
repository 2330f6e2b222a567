//! Half a nutation period in cells and segments; the other half is its mirror image.
//!
//! ```text
//! u = e₁                                                                    u = e₂
//! |    |    |    |    |    |    |    |    |    |    |    |    |    |    |    |    |    16 cells
//! |         |         |    |    |    |  |  |  |  ||||||||    |    |         |         |    segments: one polynomial of a and one of b
//! |         |         |         |         |    |  |  |  |         |         |         |    spans: one expansion of the motion
//! ```
//!
//! All segments of a cell have one length. The first attempt at a cell has segments twice as long as those of the cell before. They are halved until
//! their error is small enough. A segment does not cross the ends of a span.

mod stored_segment;

mod bound;

use stored_segment::{SegmentBounds, store_polynomial, store_segment};

use super::error_budget::ErrorBudget;
use super::interval::{Interval, SHORTEST_SEGMENTS};
use super::mean_rates::MeanRates;
use super::path::polynomial::Polynomial;
use super::path::{Path, PathScratch};
use crate::motion::Motion;
use crate::motion::ellipses::Ellipses;
use crate::motion::period::Period;
use crate::phase::Phase;
use crate::scalar::Float;
use crate::table::data::Phases;
use crate::table::data::cell::{CELLS, Cell, MIN_DEPTH};
use crate::table::evaluation::TableScalar;

/// Quantities of half a period besides its segments.
#[derive(Debug)]
pub(super) struct HalfPeriod {
    pub(super) mean_rates: MeanRates,
    /// Nutation phase and mean phases of the launch.
    pub(super) launch_phases: Phases<Phase>,
    pub(super) cells: [u16; CELLS],
    pub(super) segment_count: usize,
    bounds: SegmentBounds,
    /// Constant orientation error, without the roundings of a tick, rad.
    error: f64,
}

/// Length of a cell, in shortest segments.
const CELL_LENGTH: usize = SHORTEST_SEGMENTS / CELLS;

impl HalfPeriod {
    /// Half a period before a set-up. All its bits are 0.
    pub(super) const ZERO: Self = Self {
        mean_rates: MeanRates::ZERO,
        launch_phases: Phases::from_array([Phase::ZERO; 3]),
        cells: [0; CELLS],
        segment_count: 0,
        bounds: SegmentBounds::ZERO,
        error: 0.0,
    };

    /// Computes the segments and stores them; `None` as soon as they cannot fit.
    ///
    /// * `segments`: memory of the segments; a segment beyond it overwrites the last place. To count the segments, one place is enough
    /// * `capacity`: greatest number of segments
    pub(super) fn compute<R: TableScalar>(
        &mut self,
        motion: &Motion,
        budget: &ErrorBudget,
        scratch: &mut PathScratch,
        segments: &mut [R::Segment],
        capacity: usize,
        pause: &mut dyn FnMut(),
    ) -> Option<()> {
        *self = Self::ZERO;
        scratch.set_equations(motion);
        pause();
        // a steady motion has the period of an infinitesimal nutation, which does not count
        let equations = &scratch.equations;
        let period = if motion.is_steady() { None } else { motion.period::<R::RateNumber>(equations, pause) };
        self.mean_rates = MeanRates::new(motion, period.as_ref());
        pause();
        match period {
            Some(Period { time, .. }) => {
                let mut path =
                    Path::new(scratch, budget, motion, time.halved(), self.mean_rates.rates, pause);
                self.tabulate_path::<R>(&mut path, segments, capacity)
            }
            None => {
                let [alpha, beta] = motion.slow_phases;
                self.launch_phases = Phases { alpha, beta, ..self.launch_phases };
                self.store_constants::<R>(motion, segments);
                Some(())
            }
        }
    }

    /// Tabulates the motion from u = e₁ to u = e₂.
    #[inline(never)]
    fn tabulate_path<R: TableScalar>(
        &mut self,
        path: &mut Path<'_, R::RateNumber>,
        segments: &mut [R::Segment],
        capacity: usize,
    ) -> Option<()> {
        self.divide::<R>(path, segments, capacity)?;
        self.launch_phases = path.launch.phases;
        let [delay, residual] = path.errors();
        let bounds = &self.bounds;
        self.error = f64::from(bounds.error) + bounds.error_of_delay(delay) + 2.0 * residual;
        Some(())
    }

    /// Stores one segment with constant a and b, for a steady motion.
    fn store_constants<R: TableScalar>(&mut self, motion: &Motion, segments: &mut [R::Segment]) {
        let Ellipses { alpha, beta } = motion.ellipses;
        let Some(first) = segments.first_mut() else { return };
        for (index, ellipse) in [alpha, beta].into_iter().enumerate() {
            let [plus, minus] = ellipse.exponentials();
            store_polynomial::<R>(first, index, &Polynomial::constant(plus + minus));
        }
        self.segment_count = 1;
    }

    /// Divides the half period into cells, and these into segments.
    fn divide<R: TableScalar>(
        &mut self,
        path: &mut Path<'_, R::RateNumber>,
        segments: &mut [R::Segment],
        capacity: usize,
    ) -> Option<()> {
        let mut position = 0;
        let mut depth = MIN_DEPTH;
        while position < SHORTEST_SEGMENTS {
            // Segments twice as long as the last ones are tried first. A segment of two cells begins at an even cell.
            depth = (depth - 1).max(MIN_DEPTH + (position / CELL_LENGTH % 2) as u32);
            let start = path.begin_cell(position, depth);
            let (cell, bounds) = loop {
                let cell = Interval { begin: position, depth: depth.min(CELLS.ilog2()) };
                let least_after = (SHORTEST_SEGMENTS - cell.end()).div_ceil(SHORTEST_SEGMENTS >> MIN_DEPTH);
                let count = self.segment_count + cell.part_count(depth) + least_after;
                if depth > Cell::MAX_DEPTH || count > capacity {
                    return None;
                }
                if let Some(bounds) = self.fill_cell::<R>(cell, depth, path, segments) {
                    break (cell, bounds);
                }
                path.rewind(position, start);
                depth += 1;
            };
            let first = Interval { begin: position, depth };
            let Cell(entry) = Cell::new(self.segment_count, first.number(), depth);
            self.cells
                .iter_mut()
                .skip(position / CELL_LENGTH)
                .take(cell.length() / CELL_LENGTH)
                .for_each(|stored| *stored = entry);
            self.segment_count += cell.part_count(depth);
            self.bounds.include(&bounds);
            position = cell.end();
        }
        Some(())
    }

    /// Fills one cell with segments, or two cells with one segment; `None` if the segments are too long.
    ///
    /// * `depth`: depth of the segments
    fn fill_cell<R: TableScalar>(
        &mut self,
        cell: Interval,
        depth: u32,
        path: &mut Path<'_, R::RateNumber>,
        segments: &mut [R::Segment],
    ) -> Option<SegmentBounds> {
        let mut bounds = SegmentBounds::ZERO;
        for (segment, number) in cell.parts(depth).zip(self.segment_count..) {
            let span = path.span_at(segment.begin, depth)?;
            let last = segments.len().checked_sub(1)?;
            let stored = segments.get_mut(number.min(last))?;
            bounds.include(&store_segment::<R>(span, segment, stored));
            let is_accurate = bounds.error <= path.budget.segment_error_at(depth);
            if !is_accurate {
                return None;
            }
        }
        Some(bounds)
    }
}
