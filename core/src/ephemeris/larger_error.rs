//! Estimate of the number of segments that a table with a larger error would need, while a table for a smaller error
//! is computed.

use crate::ephemeris::cell::{Cell, cells_covered};

/// Number of segments of a table with a larger error, estimated from the errors of the cells so far.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LargerError {
    /// Number of halvings of this cell's pair that is enough for the larger error, once it is known.
    level: Option<u32>,
    /// Number of segments of the cells before this one, in half segments.
    halves: usize,
}

impl LargerError {
    /// Greatest quotient of the larger error and the allowed one.
    pub(crate) const FACTOR: f64 = 4.0;
    /// Estimate before the first cell.
    pub(crate) const NONE: Self = Self { level: None, halves: 0 };

    /// Records the number of halvings `level` if a segment of a pair with that number has at most the larger error (`has`).
    pub(crate) fn note(&mut self, has: bool, level: u32) {
        if has && self.level.is_none() {
            self.level = Some(level);
        }
    }

    /// Includes a complete cell with `level` halvings. `coarser` tells whether the next cell may have one halving fewer.
    pub(crate) fn leave(&mut self, level: u32, coarser: bool) {
        let larger = self.level.unwrap_or(level).min(level.saturating_sub(u32::from(coarser)));
        self.halves += cells_covered(level) << larger;
        self.level = None;
    }

    /// Whether a table for the larger error may have at most `most` segments, if its remaining cells have at least
    /// `rest(level)`.
    pub(crate) fn may_fit(&self, level: u32, rest: impl FnOnce(u32) -> usize, most: usize) -> bool {
        let level = self.level.unwrap_or(level);
        level <= Cell::DEEPEST && self.halves.div_ceil(2) + rest(level) <= most
    }
}
