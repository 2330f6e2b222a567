//! Intervals of half a nutation period: spans, cells and segments.

use crate::integer::power_of_two;
use crate::phase::Phase;
use crate::table::data::cell::Cell;

/// Number of shortest segments in half a period, the unit of positions.
pub(super) const SHORTEST_SEGMENTS: usize = 1 << Cell::MAX_DEPTH;

/// One of the 2^depth equal parts of half a period: a span, a cell or a segment. Positions are in shortest segments.
#[derive(Clone, Copy, Debug)]
pub(super) struct Interval {
    pub(super) begin: usize,
    pub(super) depth: u32,
}

impl Interval {
    pub(super) const HALF_PERIOD: Self = Self { begin: 0, depth: 0 };

    /// Depth of the longest interval that begins at a position.
    pub(super) fn least_depth_at(position: usize) -> u32 {
        Cell::MAX_DEPTH.saturating_sub(position.trailing_zeros())
    }

    pub(super) fn length(self) -> usize {
        SHORTEST_SEGMENTS >> self.depth
    }

    pub(super) fn end(self) -> usize {
        self.begin + self.length()
    }

    /// Number of the part among all parts of this depth.
    pub(super) fn number(self) -> usize {
        self.begin >> (Cell::MAX_DEPTH - self.depth)
    }

    /// Half the length, in half periods.
    pub(super) fn half_length(self) -> f64 {
        power_of_two(-1 - self.depth as i32)
    }

    /// Nutation phase at x in [-1, 1].
    pub(super) fn phase(self, x: f64) -> Phase {
        // the half period is half a turn
        let unit = Phase::from_bits(Phase::QUARTER.to_bits() >> Cell::MAX_DEPTH);
        unit * (self.begin + self.end()) as i64 + Phase::from_turns(0.5 * x * self.half_length())
    }

    /// Number of equal parts of this depth.
    pub(super) fn part_count(self, depth: u32) -> usize {
        1 << depth.saturating_sub(self.depth)
    }

    /// Equal parts of this depth.
    pub(super) fn parts(self, depth: u32) -> impl Iterator<Item = Self> {
        (0..self.part_count(depth))
            .map(move |index| Self { begin: self.begin + index * (SHORTEST_SEGMENTS >> depth), depth })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_span_has_the_phases_of_its_position() {
        let second = Interval { begin: SHORTEST_SEGMENTS / 4, depth: 2 };
        assert_eq!((second.phase(-1.0), second.phase(1.0)), (Phase::from_bits(1 << 93), Phase::QUARTER));
        let last = Interval { begin: SHORTEST_SEGMENTS - 1, depth: Cell::MAX_DEPTH };
        assert_eq!((last.end(), last.phase(1.0)), (SHORTEST_SEGMENTS, Phase::HALF));
    }
}
