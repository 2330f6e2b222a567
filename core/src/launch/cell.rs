//! How half a nutation period is cut: into cells, and each of them into segments as short as the motion there asks.

/// Half a period has so many cells of equal length, fewer where a table has fewer segments.
pub(crate) const CELLS: usize = 16;

/// A cell: the number of its first segment, and by how many halvings its segments, all as long, come out of it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Cell(u16);

impl Cell {
    const LEVEL_BITS: u32 = 4;
    /// A table has no more segments than this.
    pub(crate) const MOST_SEGMENTS: usize = 1 << (u16::BITS - Self::LEVEL_BITS);
    /// A cell has no more than all of them.
    pub(crate) const DEEPEST: u32 = Self::MOST_SEGMENTS.ilog2();

    /// Of two numbers within those limits.
    pub(crate) const fn new(first: usize, level: u32) -> Self {
        Self((first as u16) << Self::LEVEL_BITS | level as u16)
    }

    /// Both in one: first · 16 + level.
    pub(crate) const fn to_bits(self) -> u16 {
        self.0
    }

    /// The reverse of [`Cell::to_bits`].
    pub(crate) const fn from_bits(bits: u16) -> Self {
        Self(bits)
    }

    /// The number of its first segment.
    #[inline(always)]
    pub(crate) const fn first(self) -> usize {
        (self.0 >> Self::LEVEL_BITS) as usize
    }

    /// It has 2^level segments; below 16.
    #[inline(always)]
    pub(crate) const fn level(self) -> u32 {
        (self.0 & ((1 << Self::LEVEL_BITS) - 1)) as u32
    }

    /// The cells of a table of so many segments, as a power of two.
    pub(crate) const fn bits_for(segments: usize) -> u32 {
        if segments < CELLS { segments.ilog2() } else { CELLS.ilog2() }
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

    #[test]
    fn every_cell_has_a_segment() {
        for segments in 1..=Cell::MOST_SEGMENTS {
            let cells = 1_usize << Cell::bits_for(segments);
            assert!(cells <= segments.min(CELLS) && 2 * cells > segments.min(CELLS), "{cells} of {segments}");
        }
    }
}
