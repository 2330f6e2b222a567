//! Cells, by which a tick finds its segment: sixteenths of half a nutation period.
//!
//! The segments of a cell have one length. At depth d half a period would have 2^d of them; a segment of depth 3 covers two cells.

/// Number of cells in half a period.
pub(crate) const CELLS: usize = 16;

/// Depth of the longest segments, which are an eighth of half a period.
pub(crate) const MIN_DEPTH: u32 = 3;

/// Bits of a depth in an entry.
const DEPTH_BITS: u32 = 4;

/// Largest number of segments of a table.
pub const MAX_SEGMENTS: usize = 1 << (u16::BITS - DEPTH_BITS);

/// Number of segments in half a period at the least depth, and least number of a table.
pub const MIN_SEGMENTS: usize = 1 << MIN_DEPTH;

/// Entry of a cell. Segment i of half a period at its depth is number (m + i) modulo 4096 of the table.
///
/// ```text
/// 15          4 3         0
/// | m           | depth - 3 |
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Cell(pub(crate) u16);

impl Cell {
    /// Greatest depth: 4096 segments in one cell.
    pub(crate) const MAX_DEPTH: u32 = (CELLS * MAX_SEGMENTS).ilog2();

    /// Cell in which segment `index` of half a period at this depth is `number` of the table.
    pub(crate) const fn new(number: usize, index: usize, depth: u32) -> Self {
        Self((number.wrapping_sub(index) as u16) << DEPTH_BITS | (depth - MIN_DEPTH) as u16)
    }

    /// Number of the segment at a phase, given by the 32 leading bits of the fraction of half a period.
    #[inline(always)]
    pub(crate) const fn segment(self, phase: u32) -> usize {
        let shift = u32::BITS - self.depth();
        ((self.0 as u32 >> DEPTH_BITS) + (phase >> shift)) as usize % MAX_SEGMENTS
    }

    /// Whether the segments of the cell with this number are below a number of segments.
    pub(crate) const fn is_within(self, number: u32, segments: usize) -> bool {
        let begin = number << 28;
        let [first, last] = [self.segment(begin), self.segment(begin | ((1 << 28) - 1))];
        self.depth() <= Self::MAX_DEPTH && first <= last && last < segments
    }

    /// Depth of the segments. 4 bits allow 3 to 18; a valid table has at most [`Cell::MAX_DEPTH`].
    #[inline(always)]
    pub(crate) const fn depth(self) -> u32 {
        MIN_DEPTH + (self.0 & ((1 << DEPTH_BITS) - 1)) as u32
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cell_finds_its_segments() {
        for (number, first, depth) in
            [(0, 0, 3), (2, 1, 3), (3, 6, 4), (1, 1, 8), (15, MAX_SEGMENTS - 1, 4), (1, 0, Cell::MAX_DEPTH)]
        {
            let count = if depth == 3 { 1 } else { 1 << (depth - 4) };
            let index = (number << depth) >> 4;
            let cell = Cell::new(first, index, depth);
            let (begin, length) = ((number as u32) << 28, ((1_u64 << 32) >> depth) as u32);
            for index in [0, count - 1] {
                let inside = begin + length * index as u32;
                let found = [inside, inside + (length - 1)].map(|phase| cell.segment(phase));
                assert_eq!(found, [(first + index) % MAX_SEGMENTS; 2]);
            }
        }
    }
}
