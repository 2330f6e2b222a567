//! Segment of a nutation phase, and the place on it.

use crate::table::cell::{Cell, LONGEST_BITS};
use crate::table::data::storage::EphemerisView;
use crate::table::scalar::{EphemerisScalar, SegmentPoint};

/// Segment that contains a phase, and the place on it.
pub(crate) struct LocatedSegment<'a, R: EphemerisScalar> {
    /// Coefficients, lowest power first.
    pub(crate) terms: &'a [[R::Coefficient; 4]],
    /// Index of the segment.
    pub(crate) number: usize,
    pub(crate) point: SegmentPoint,
}

impl<R: EphemerisScalar> EphemerisView<R> {
    /// Segment of a nutation phase, given by its 64 leading bits.
    #[inline(always)]
    pub(crate) fn locate(&self, nutation: u64) -> LocatedSegment<'_, R> {
        let falling = (nutation as i64) >> 63;
        // the fraction of half a period
        let share = (nutation ^ falling as u64) << 1;
        let place = (share >> 32) as u32;
        let cell = Cell(self.cells.get((place >> 28) as usize).copied().unwrap_or_default());
        let (level, number) = (cell.level(), cell.segment(place));
        // no cell refers to a segment beyond the last; the fallback to the first segment avoids a branch for a panic
        let segment = self.segments.get(number).or(self.segments.first());
        // the fraction of a segment of level 0, and its 32 leading bits
        let (share, short) = (share << LONGEST_BITS, (share >> (32 - LONGEST_BITS)) as u32);
        // the range [0, 1) becomes [-1, 1) by flipping the upper bit
        let (x, short_x) = ((share << level) ^ (1 << 63), (short << level) ^ (1 << 31));
        LocatedSegment {
            terms: segment.map_or(&[], |segment| segment.as_ref()),
            number,
            point: SegmentPoint { x: x as i64, short_x: short_x as i32, level, mirrored: falling < 0 },
        }
    }
}
