//! Division of half a nutation period into cells, and of the cells into segments.
//!
//! Two neighbouring cells form a pair, which has one segment for both cells or separate segments for each. A smooth
//! motion then needs half as many segments as cells, and a motion that is fast in a part of the period has short
//! segments only there.

use core::ops::Range;

/// Number of cells in half a period; all have the same length.
pub(crate) const CELLS: usize = 2 * PAIRS;

/// Number of pairs of cells in half a period.
pub(crate) const PAIRS: usize = 1 << PAIR_BITS;

/// Base-2 logarithm of [`PAIRS`].
pub(crate) const PAIR_BITS: u32 = 3;

/// Segments of a cell, which have equal lengths: the number of halvings of the pair that gives this length, and the index modulo
/// 4096 that the first segment of the pair would have if the whole pair had segments of this length.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Cell(u16);

impl Cell {
    const LEVEL_BITS: u32 = 4;
    /// Largest number of segments of a table.
    pub(crate) const MOST_SEGMENTS: usize = 1 << (u16::BITS - Self::LEVEL_BITS);
    /// Largest number of halvings of a pair; one of its cells could then contain all segments.
    pub(crate) const DEEPEST: u32 = Self::MOST_SEGMENTS.ilog2() + 1;

    /// Cell with this number, first segment and number of halvings of the pair, all within the limits.
    pub(crate) const fn new(number: usize, first: usize, level: u32) -> Self {
        Self((first.wrapping_sub(Self::place(number, level)) as u16) << Self::LEVEL_BITS | level as u16)
    }

    /// Number of segments between the beginning of the pair and this cell, if the whole pair had segments of this length.
    const fn place(number: usize, level: u32) -> usize {
        (number % 2) << level >> 1
    }

    /// Cell as one number of 16 bits.
    pub(crate) const fn to_bits(self) -> u16 {
        self.0
    }

    /// Cell from one number, the inverse of [`Cell::to_bits`].
    pub(crate) const fn from_bits(bits: u16) -> Self {
        Self(bits)
    }

    /// Index of the segment that is `place` segments after the beginning of the pair.
    #[inline(always)]
    pub(crate) const fn segment(self, place: u32) -> usize {
        ((self.0 as u32 >> Self::LEVEL_BITS) + place) as usize % Self::MOST_SEGMENTS
    }

    /// Number of halvings, below 16: the pair would have 2^level segments.
    #[inline(always)]
    pub(crate) const fn level(self) -> u32 {
        (self.0 & ((1 << Self::LEVEL_BITS) - 1)) as u32
    }

    /// Indices of the segments of the cell, whose number is given. Both cells of a pair with one segment have the same
    /// index.
    pub(crate) fn segments(self, number: usize) -> Range<usize> {
        let level = self.level();
        let first = self.segment(Self::place(number, level) as u32);
        first..first + segments_per_cell(level)
    }
}

/// Number of segments of a cell whose pair is halved `level` times; 1 for each cell of a pair that is not halved.
pub(crate) const fn segments_per_cell(level: u32) -> usize {
    if level == 0 { 1 } else { 1 << (level - 1) }
}

/// Number of cells that the segments of a cell cover: two for a pair that is not halved.
pub(crate) const fn cells_covered(level: u32) -> usize {
    if level == 0 { 2 } else { 1 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cell_finds_its_segments() {
        let deepest = Cell::DEEPEST;
        for (number, first, level) in [
            (0, 0, 0),
            (3, 1, 0),
            (2, 5, 1),
            (3, 6, 1),
            (1, 1, 5),
            (15, Cell::MOST_SEGMENTS - 1, 1),
            (1, 0, deepest),
        ] {
            let cell = Cell::from_bits(Cell::new(number, first, level).to_bits());
            let count = [1, 1, 2, 4, 8, 16].get(level as usize).copied().unwrap_or(Cell::MOST_SEGMENTS);
            assert_eq!((cell.segments(number), cell.level()), (first..first + count, level));
            let before = if number % 2 == 0 || level == 0 { 0 } else { count };
            assert_eq!(cell.segment(before as u32), first);
        }
    }
}
