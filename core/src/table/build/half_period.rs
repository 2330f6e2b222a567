//! Half a nutation period in cells and segments; the other half is its mirror image.
//!
//! ```text
//! u = e₁                                                                    u = e₂
//! |    |    |    |    |    |    |    |    |    |    |    |    |    |    |    |    |    16 cells
//! |         |         |    |    |    |  |  |  |  ||||||||    |    |         |         |    segments: one polynomial of a and one of b
//! |         |         |         |         |    |  |  |  |         |         |         |    spans: one expansion of the motion
//! ```
//!
//! The segments of a cell are equal, and the longest with an allowed error. A segment is part of a span, or all of it.

mod bound;

use super::interval::{HALF_PERIOD, Interval};
use super::launch_place::LaunchPlace;
use super::limits::Limits;
use super::mean_rates::MeanRates;
use super::path::{Path, PathPoint, SpanMemory};
use super::polynomial::Polynomial;
use super::segment::{SegmentBounds, SegmentStore, store_segment};
use crate::motion::Motion;
use crate::motion::cayley_klein::Ellipses;
use crate::motion::phase_equations::PhaseEquations;
use crate::scalar::{Extended, Float, Ring};
use crate::table::data::cell::LEAST_DEPTH;
use crate::table::data::cell::{CELLS, Cell};

/// What a table of half a period has besides its segments.
#[derive(Debug)]
pub(super) struct HalfPeriod {
    pub(super) mean_rates: MeanRates,
    pub(super) launch: LaunchPlace,
    pub(super) cells: [u16; CELLS],
    /// Number of segments.
    pub(super) segments: usize,
    pub(super) bounds: SegmentBounds,
    /// Orientation error that does not grow, without that of a tick, rad.
    pub(super) error: f64,
}

/// Length of a cell, in shortest segments.
const CELL: usize = HALF_PERIOD / CELLS;

impl HalfPeriod {
    /// Half a period before a set-up. All its bits are 0.
    pub(super) const ZERO: Self = Self {
        mean_rates: MeanRates { rates: [Extended::ZERO; 3], errors: [0.0; 3] },
        launch: LaunchPlace::ZERO,
        cells: [0; CELLS],
        segments: 0,
        bounds: SegmentBounds::ZERO,
        error: 0.0,
    };

    /// Computes and stores all segments; `None` if they are too many.
    pub(super) fn compute(
        &mut self,
        motion: &Motion,
        limits: &Limits,
        memory: &mut SpanMemory,
        store: &mut dyn SegmentStore,
        pause: &mut dyn FnMut(),
    ) -> Option<()> {
        match self.begin(motion, limits, &mut memory.equations.equations, pause) {
            Some(length) => self.follow(motion, length, limits, memory, store, pause)?,
            None => self.store_constants(motion, store),
        }
        Some(())
    }

    /// Begins with the mean rates. Sets the phase equations, and returns the length of half a period, s; `None` for a constant u.
    #[inline(never)]
    fn begin(
        &mut self,
        motion: &Motion,
        limits: &Limits,
        equations: &mut PhaseEquations<Extended>,
        pause: &mut dyn FnMut(),
    ) -> Option<Extended> {
        let mut period = None;
        if !motion.is_steady() {
            *equations = motion.equations();
            pause();
            period = (limits.period)(motion, equations, pause);
        }
        *self = Self::ZERO;
        self.mean_rates = MeanRates::new(motion, period.as_ref());
        self.launch = LaunchPlace::new(motion);
        pause();
        period.map(|period| period.time.halved())
    }

    /// Follows the motion from u = e₁ to u = e₂; `None` if the segments are too many.
    #[inline(never)]
    fn follow(
        &mut self,
        motion: &Motion,
        length: Extended,
        limits: &Limits,
        memory: &mut SpanMemory,
        store: &mut dyn SegmentStore,
        pause: &mut dyn FnMut(),
    ) -> Option<()> {
        let mut path = Path::new(memory, limits, motion, length, self.mean_rates.rates);
        self.divide(&mut path, store, pause)?;
        let ([delay, slow], bounds) = (path.errors(), &self.bounds);
        self.error = bounds.truncation() + bounds.error_of_delay(delay) + 2.0 * slow;
        Some(())
    }

    /// Stores one segment with constant a and b, for a constant u.
    #[inline(never)] // its polynomials must not stay on the stack
    fn store_constants(&mut self, motion: &Motion, store: &mut dyn SegmentStore) {
        let Ellipses { alpha, beta } = motion.ellipses::<f64>();
        for (index, ellipse) in [alpha, beta].into_iter().enumerate() {
            let [plus, minus] = ellipse.exponentials();
            store.store(0, index, &Polynomial::constant(plus + minus));
        }
        self.segments = 1;
    }

    /// Divides the half period into cells, and these into segments; `None` if they are too many.
    fn divide(
        &mut self,
        path: &mut Path<'_>,
        store: &mut dyn SegmentStore,
        pause: &mut dyn FnMut(),
    ) -> Option<()> {
        let (mut position, mut depth) = (0, LEAST_DEPTH);
        while position < HALF_PERIOD {
            // first segments twice as long as those before; one of two cells begins at an even cell
            depth = (depth - 1).max(LEAST_DEPTH + (position / CELL % 2) as u32);
            let point = path.point_at(position);
            path.lengthen(depth);
            let (cell, bounds) = loop {
                let cell = Interval { begin: position, depth: depth.min(CELLS.ilog2()) };
                let remainder = (HALF_PERIOD - cell.end()).div_ceil(HALF_PERIOD >> LEAST_DEPTH);
                let segments = self.segments + (1 << (depth - cell.depth)) + remainder;
                if depth > Cell::DEEPEST || segments > path.limits.capacity {
                    return None;
                }
                if let Some(bounds) = self.fill(cell, depth, point, path, store, pause) {
                    break (cell, bounds);
                }
                depth += 1;
            };
            let Cell(entry) = Cell::new(self.segments, position / (HALF_PERIOD >> depth), depth);
            self.cells
                .iter_mut()
                .skip(position / CELL)
                .take(cell.length() / CELL)
                .for_each(|cell| *cell = entry);
            self.segments += 1 << (depth - cell.depth);
            self.bounds.include(&bounds);
            position = cell.end();
        }
        Some(())
    }

    /// Computes and stores the segments of a cell, or one of two cells; `None` if they are too long.
    ///
    /// * `depth`: that of the segments
    /// * `point`: beginning of the cell
    fn fill(
        &mut self,
        cell: Interval,
        depth: u32,
        mut point: PathPoint,
        path: &mut Path<'_>,
        store: &mut dyn SegmentStore,
        pause: &mut dyn FnMut(),
    ) -> Option<SegmentBounds> {
        let (mut position, mut number) = (cell.begin, self.segments);
        let mut bounds = SegmentBounds::ZERO;
        while position < cell.end() {
            let span = path.enter(position, point, depth, pause)?;
            self.launch.search(&path.memory.expansion, path.end.phases.chi, span);
            point = path.end;
            let part = if span.depth < cell.depth { cell } else { span };
            for segment in part.parts(depth) {
                bounds.include(&store_segment(path, span, segment, (number, store), pause));
                (bounds.error <= path.limits.segment_error(depth)).then_some(())?;
                number += 1;
            }
            position = part.end();
        }
        Some(bounds)
    }
}
