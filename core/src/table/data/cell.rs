//! Cells, by which a tick finds its segment: sixteenths of half a nutation period.
//!
//! The segments of a cell are equal. At level l the half period would have 8 · 2^l segments; one of level 0 covers two cells.

/// Number of cells in half a period.
pub(crate) const CELLS: usize = 16;

/// Number of segments in half a period at level 0.
pub(crate) const SEGMENTS_AT_LEVEL_0: usize = 1 << LEVEL_0_BITS;

/// Base-2 logarithm of [`SEGMENTS_AT_LEVEL_0`].
pub(crate) const LEVEL_0_BITS: u32 = 3;

/// Entry of a cell: the level of its segments in the lower 4 bits, and an offset m in the upper 12. Segment i of half a period at that level
/// is number m + i of the table, modulo 4096.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Cell(pub(crate) u16);

impl Cell {
    const LEVEL_BITS: u32 = 4;
    /// Largest number of segments of a table.
    pub(crate) const MOST_SEGMENTS: usize = 1 << (u16::BITS - Self::LEVEL_BITS);
    /// Greatest level; one cell could then contain all segments.
    pub(crate) const DEEPEST: u32 = Self::MOST_SEGMENTS.ilog2() + 1;

    /// Cell in which segment `index` of half a period at this level is `number` of the table.
    pub(crate) const fn new(number: usize, index: usize, level: u32) -> Self {
        Self((number.wrapping_sub(index) as u16) << Self::LEVEL_BITS | level as u16)
    }

    /// Number of the segment at a phase, given by the 32 leading bits of the fraction of half a period.
    #[inline(always)]
    pub(crate) const fn segment(self, phase: u32) -> usize {
        let shift = u32::BITS - LEVEL_0_BITS - self.level();
        ((self.0 as u32 >> Self::LEVEL_BITS) + (phase >> shift)) as usize % Self::MOST_SEGMENTS
    }

    /// Whether all segments of the cell with this number are among so many.
    pub(crate) const fn is_within(self, number: u32, segments: usize) -> bool {
        let begin = number << 28;
        let [first, last] = [self.segment(begin), self.segment(begin | ((1 << 28) - 1))];
        self.level() <= Self::DEEPEST && first <= last && last < segments
    }

    /// Level, below 16.
    #[inline(always)]
    pub(crate) const fn level(self) -> u32 {
        (self.0 & ((1 << Self::LEVEL_BITS) - 1)) as u32
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cell_finds_its_segments() {
        for (number, first, level) in [
            (0, 0, 0),
            (2, 1, 0),
            (3, 6, 1),
            (1, 1, 5),
            (15, Cell::MOST_SEGMENTS - 1, 1),
            (1, 0, Cell::DEEPEST),
        ] {
            let count = [1, 1, 2, 4, 8, 16].get(level as usize).copied().unwrap_or(Cell::MOST_SEGMENTS);
            let index = (number << level) >> 1;
            let cell = Cell::new(first, index, level);
            let (begin, length) = ((number as u32) << 28, (1 << 29) >> level);
            for index in [0, count - 1] {
                let inside = begin + length * index as u32;
                let found = [inside, inside + (length - 1)].map(|phase| cell.segment(phase));
                assert_eq!(found, [(first + index) % Cell::MOST_SEGMENTS; 2]);
            }
        }
    }
}
