//! Division of half a nutation period into cells, and of each cell into segments.

/// Number of cells in half a period; all have the same length.
pub(crate) const CELLS: usize = 1 << CELL_BITS;

/// Base-2 logarithm of [`CELLS`].
pub(crate) const CELL_BITS: u32 = 4;

/// Cell: the index of its first segment, and the number of halvings that divide it into segments of equal length.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Cell(u16);

impl Cell {
    const LEVEL_BITS: u32 = 4;
    /// Largest number of segments of a table.
    pub(crate) const MOST_SEGMENTS: usize = 1 << (u16::BITS - Self::LEVEL_BITS);
    /// Largest number of halvings of a cell; it could then contain all segments.
    pub(crate) const DEEPEST: u32 = Self::MOST_SEGMENTS.ilog2();

    /// Cell with this first segment and number of halvings, both within the limits.
    pub(crate) const fn new(first: usize, level: u32) -> Self {
        Self((first as u16) << Self::LEVEL_BITS | level as u16)
    }

    /// Cell as one number: first · 16 + level.
    pub(crate) const fn to_bits(self) -> u16 {
        self.0
    }

    /// Cell from one number, the inverse of [`Cell::to_bits`].
    pub(crate) const fn from_bits(bits: u16) -> Self {
        Self(bits)
    }

    /// Index of the first segment.
    #[inline(always)]
    pub(crate) const fn first(self) -> usize {
        (self.0 >> Self::LEVEL_BITS) as usize
    }

    /// Number of halvings, below 16: the cell has 2^level segments.
    #[inline(always)]
    pub(crate) const fn level(self) -> u32 {
        (self.0 & ((1 << Self::LEVEL_BITS) - 1)) as u32
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_numbers_come_back_to_the_last() {
        for (first, level) in [(0, 0), (1, 3), (Cell::MOST_SEGMENTS - 1, 0), (2048, Cell::DEEPEST)] {
            let cell = Cell::from_bits(Cell::new(first, level).to_bits());
            assert_eq!((cell.first(), cell.level()), (first, level));
        }
    }
}
