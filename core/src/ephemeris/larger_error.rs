//! Estimate of the table that a larger error would need, while one for a smaller error is made.

use crate::ephemeris::cell::{Cell, cells_covered};

/// Number of segments with a larger error, estimated from the errors of the cells so far.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LargerError {
    /// Number of halvings of this cell's pair with which the larger error would do, once it is known.
    level: Option<u32>,
    /// Segments of the cells before this one, in halves.
    halves: usize,
}

impl LargerError {
    /// Quotient of the larger error and the allowed one.
    pub(crate) const FACTOR: f64 = 4.0;
    /// Estimate before the first cell.
    pub(crate) const NONE: Self = Self { level: None, halves: 0 };

    /// Notes that a segment of a pair with `level` halvings has at most the larger error, if it has.
    pub(crate) fn note(&mut self, has: bool, level: u32) {
        if has && self.level.is_none() {
            self.level = Some(level);
        }
    }

    /// Includes a complete cell with `level` halvings, after which the next may have one fewer.
    pub(crate) fn leave(&mut self, level: u32, coarser: bool) {
        let larger = self.level.unwrap_or(level).min(level.saturating_sub(u32::from(coarser)));
        self.halves += cells_covered(level) << larger;
        self.level = None;
    }

    /// Whether a table for the larger error, whose rest has at least `rest(level)` segments, may have at most `most`.
    pub(crate) fn may_fit(&self, level: u32, rest: impl FnOnce(u32) -> usize, most: usize) -> bool {
        let level = self.level.unwrap_or(level);
        level <= Cell::DEEPEST && self.halves.div_ceil(2) + rest(level) <= most
    }
}
