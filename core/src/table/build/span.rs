//! Spans of half a nutation period: the parts on each of which one expansion of the law is used.
//!
//! A span can contain several segments, whose series follow from that of the span.

use crate::phase::Phase;
use crate::scalar::power_of_two;
use crate::table::cell::{CELLS, Cell, LONGEST_BITS};

/// One of the 2^depth parts of equal length into which half a period is divided.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Span {
    /// Beginning in units of the shortest segment.
    pub(crate) begin: usize,
    pub(crate) depth: u32,
}

/// Half a period in units of the shortest segment.
pub(crate) const HALF_PERIOD: usize = 1 << Span::DEEPEST;

/// Cell in units of the shortest segment.
pub(crate) const CELL: usize = HALF_PERIOD / CELLS;

impl Span {
    /// Base-2 logarithm of the number of spans in half a period, at least.
    const SHALLOWEST: u32 = 2;
    /// Base-2 logarithm of the number of spans in half a period, at most: a span has at least one segment.
    pub(crate) const DEEPEST: u32 = LONGEST_BITS + Cell::DEEPEST;

    pub(crate) const NONE: Self = Self { begin: 0, depth: 0 };

    /// Longest span from u = e₁ on.
    pub(crate) const FIRST: Self = Self { begin: 0, depth: Self::SHALLOWEST };

    /// Whether it is one of the parts.
    pub(crate) fn exists(self) -> bool {
        self.depth >= Self::SHALLOWEST && self.begin.is_multiple_of(HALF_PERIOD >> self.depth)
    }

    /// End in units of the shortest segment.
    pub(crate) fn end(self) -> usize {
        self.begin + (HALF_PERIOD >> self.depth)
    }

    pub(crate) fn is_last(self) -> bool {
        self.end() == HALF_PERIOD
    }

    /// Least level of segments that are not longer than the span.
    pub(crate) fn least_level(self) -> u32 {
        self.depth.saturating_sub(LONGEST_BITS)
    }

    /// Number of halvings of the span that make segments of this level.
    pub(crate) fn halvings(self, level: u32) -> u32 {
        (LONGEST_BITS + level).saturating_sub(self.depth)
    }

    /// Half the length, in units of half a period.
    pub(crate) fn half_length(self) -> f64 {
        power_of_two(-1 - self.depth as i32)
    }

    /// Nutation phase at x ∈ [-1, 1] of the span.
    pub(crate) fn phase(self, x: f64) -> Phase {
        // the half period is half a turn
        let halves = 2 * (self.begin >> (Self::DEEPEST - self.depth)) as i64 + 1;
        let half = Phase::from_bits(Phase::ONE.to_bits() >> (2 + self.depth));
        half.times(halves) + Phase::new(0.5 * x * self.half_length())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_span_has_the_phases_of_its_place() {
        assert!(Span::FIRST.exists() && !Span { begin: CELL, ..Span::FIRST }.exists());
        let second = Span { begin: Span::FIRST.end(), ..Span::FIRST };
        assert_eq!((second.phase(-1.0), second.phase(1.0)), (Phase::from_bits(1 << 93), Phase::QUARTER));
        let last = Span { begin: HALF_PERIOD - 1, depth: Span::DEEPEST };
        assert_eq!((last.end(), last.phase(1.0)), (HALF_PERIOD, Phase::HALF));
        assert_eq!((last.least_level(), last.halvings(Cell::DEEPEST)), (Cell::DEEPEST, 0));
        assert_eq!((Span::FIRST.least_level(), Span::FIRST.halvings(0)), (0, 1));
    }
}
