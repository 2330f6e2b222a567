//! Samples on the half of a nutation period in which u rises, and bisection.

use crate::table::{Instant, Phases, Sample, Table, TableScalar};

/// Leading 64 bits of the last nutation phase while u rises.
pub(super) const LAST_RISING: u64 = u64::MAX >> 1;

/// Sample at the 64 leading bits of a nutation phase, with mean phases 0.
pub(super) fn at_phase<R: TableScalar>(table: &Table<R>, nutation: u64) -> Sample<'_, R> {
    Sample::new(table, Phases { nutation, alpha: 0, beta: 0 }, Instant::ZERO)
}

/// Least number up to [`LAST_RISING`] for which a condition holds, if it then holds for all greater ones. Cost: 63 evaluations.
pub(super) fn bisect(holds: impl Fn(u64) -> bool) -> u64 {
    let mut low = 0;
    let mut high = LAST_RISING;
    while high - low > 1 {
        let middle = low + (high - low) / 2;
        if holds(middle) { high = middle } else { low = middle }
    }
    high
}
