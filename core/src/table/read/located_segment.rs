//! Search for the segment of a nutation phase.

use crate::table::data::Table;
use crate::table::data::cell::{Cell, MIN_DEPTH};
use crate::table::evaluation::{SegmentPoint, TableScalar};

/// Segment of a nutation phase, and the point of it.
pub(super) struct LocatedSegment<'a, R: TableScalar> {
    pub(super) rows: &'a [[R::Coefficient; 4]],
    pub(super) number: usize,
    pub(super) point: SegmentPoint,
}

impl<R: TableScalar> Table<R> {
    /// Segment of a nutation phase, given by its 64 leading bits.
    #[inline(always)]
    pub(super) fn segment_at(&self, nutation: u64) -> LocatedSegment<'_, R> {
        let falling = (nutation as i64) >> 63;
        // the fraction of half a period, and its 32 leading bits
        let half = (nutation ^ falling as u64) << 1;
        let leading = (half >> 32) as u32;
        let cell = Cell(self.cells.get((leading >> 28) as usize).copied().unwrap_or_default());
        let depth = cell.depth();
        let number = cell.segment(leading);
        // a cell refers to a segment of the table, which has one: the fallbacks only avoid a panic
        let segment = self.segments.get(number).or(self.segments.first());
        // 32 leading bits of the fraction of an eighth
        let eighth = (half >> (32 - MIN_DEPTH)) as u32;
        // the range [0, 1) becomes [-1, 1) by flipping the upper bit
        let halvings = depth - MIN_DEPTH;
        let x_q63 = (half << depth) ^ (1 << 63);
        let x_q31 = (eighth << halvings) ^ (1 << 31);
        LocatedSegment {
            rows: segment.map_or(&[], |segment| segment.as_ref()),
            number,
            point: SegmentPoint {
                x_q63: x_q63 as i64,
                x_q31: x_q31 as i32,
                halvings,
                is_falling: falling < 0,
            },
        }
    }
}
