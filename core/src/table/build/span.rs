//! Parts of half a period with one expansion of the motion.

use crate::phase::Phase;
use crate::scalar::power_of_two;
use crate::table::data::cell::{CELLS, Cell};

/// One of the 2^depth equal parts of half a period. Positions are in shortest segments.
#[derive(Clone, Copy, Debug)]
pub(super) struct Span {
    pub(super) begin: usize,
    pub(super) depth: u32,
}

pub(super) const HALF_PERIOD: usize = 1 << Span::DEEPEST;

pub(super) const CELL: usize = HALF_PERIOD / CELLS;

impl Span {
    const SHALLOWEST: u32 = 2;
    /// Greatest depth, that of the shortest segment.
    pub(super) const DEEPEST: u32 = Cell::DEEPEST;

    /// Longest span from u = e₁ on.
    pub(super) const FIRST: Self = Self { begin: 0, depth: Self::SHALLOWEST };

    /// Whether the half period is divided so.
    pub(super) fn exists(self) -> bool {
        self.depth >= Self::SHALLOWEST && self.begin.is_multiple_of(HALF_PERIOD >> self.depth)
    }

    pub(super) fn end(self) -> usize {
        self.begin + (HALF_PERIOD >> self.depth)
    }

    /// Half the length, in half periods.
    pub(super) fn half_length(self) -> f64 {
        power_of_two(-1 - self.depth as i32)
    }

    /// Nutation phase at x in [-1, 1].
    pub(super) fn phase(self, x: f64) -> Phase {
        // the half period is half a turn
        let unit = Phase::from_bits(Phase::QUARTER.to_bits() >> Self::DEEPEST);
        unit * (self.begin + self.end()) as i64 + Phase::new(0.5 * x * self.half_length())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_span_has_the_phases_of_its_position() {
        assert!(Span::FIRST.exists() && !Span { begin: CELL, ..Span::FIRST }.exists());
        let second = Span { begin: Span::FIRST.end(), ..Span::FIRST };
        assert_eq!((second.phase(-1.0), second.phase(1.0)), (Phase::from_bits(1 << 93), Phase::QUARTER));
        let last = Span { begin: HALF_PERIOD - 1, depth: Span::DEEPEST };
        assert_eq!((last.end(), last.phase(1.0)), (HALF_PERIOD, Phase::HALF));
    }
}
