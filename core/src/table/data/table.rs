//! Table of one motion: the clock, the error bounds, the cells and the segments.

use crate::table::data::Clock;
use crate::table::data::cell::{CELLS, MAX_SEGMENTS, MIN_SEGMENTS};
use crate::table::evaluation::TableScalar;
use core::ops::Deref;

/// Table of one motion, of any capacity. Readers take a `&Table<f32>`.
///
/// The parameter S is the type of the segments: a slice, or the array of a [`SizedTable`].
#[derive(Debug, PartialEq)]
#[repr(C)] // the increments first, in reach of the smallest chip's load instructions
pub struct Table<R: TableScalar, S: ?Sized = [<R as TableScalar>::Segment]> {
    pub(crate) clock: Clock<R::Quantity>,
    pub(crate) error_bound: ErrorBound,
    pub(crate) rate_error_bound: ErrorBound,
    /// Entries of the cells: see [`Cell`](crate::table::data::cell::Cell).
    pub(crate) cells: [u16; CELLS],
    pub(crate) segments: S,
}

/// Table with a capacity of `SEGMENTS` segments, at least 8 and at most 4096.
///
/// It has the methods of [`Table`]. Size: 4 · SEGMENTS ·
/// [`TableScalar::TERMS`] coefficients, and 200 bytes, or 216 in `f64`.
pub type SizedTable<R, const SEGMENTS: usize> = Table<R, [<R as TableScalar>::Segment; SEGMENTS]>;

/// Table in `f32`, 2.2 KB: enough for every motion with (e₃ - e₂)/(e₂ - e₁) >= 0.1 and A/(ps) >= 0.4.
pub type TableF32 = SizedTable<f32, 25>;

/// Table in `f64`, 17 KB, for the motions of [`TableF32`]; where A/(ps) >= 1, `SizedTable<f64, 32>` is enough.
pub type TableF64 = SizedTable<f64, 48>;

/// Table in 32-bit fixed point, 2.3 KB: enough for the README's top; many motions need 64 segments.
#[cfg(feature = "fixed")]
pub type TableQ31 = SizedTable<fixed::types::I2F30, 32>;

/// Table in 16-bit fixed point, 0.6 KB: enough for the README's top; many motions need 32 segments.
#[cfg(feature = "fixed")]
pub type TableQ15 = SizedTable<fixed::types::I2F14, 16>;

/// Stated bound on an error: `constant` plus `per_tick` for each tick from the launch.
///
/// The error of an orientation is 2 √(|Δα|² + |Δβ|²). Proved: the roundings of a tick in `f32` and fixed point.
/// Counted: those of `f64`, of rates and of a set-up. Estimated: truncation errors of series, and the roundings of their steps. See [the error bound](crate::error_bound).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ErrorBound {
    /// Error at the launch, rad (rad/s for rates).
    pub constant: f64,
    /// Growth of the error per tick, rad (rad/s for rates).
    pub per_tick: f64,
}

impl ErrorBound {
    pub(crate) const ZERO: Self = Self { constant: 0.0, per_tick: 0.0 };

    /// Upper bound on the error at this number of ticks after the launch, or before it if negative.
    #[must_use]
    pub fn after(&self, ticks: f64) -> f64 {
        self.constant + self.per_tick * ticks.abs()
    }

    pub(super) const fn numbers(self) -> [f64; 2] {
        [self.constant, self.per_tick]
    }
}

impl<R: TableScalar, const SEGMENTS: usize> SizedTable<R, SEGMENTS> {
    /// Table before set-up. All its bits are 0, so that it takes no flash.
    pub(super) const EMPTY: Self = {
        assert!(SEGMENTS >= MIN_SEGMENTS && SEGMENTS <= MAX_SEGMENTS);
        Self {
            clock: Clock::ZERO,
            error_bound: ErrorBound::ZERO,
            rate_error_bound: ErrorBound::ZERO,
            cells: [0; CELLS],
            segments: [R::ZERO_SEGMENT; SEGMENTS],
        }
    };
}

impl<R: TableScalar, const SEGMENTS: usize> Deref for SizedTable<R, SEGMENTS> {
    type Target = Table<R>;

    #[inline(always)]
    fn deref(&self) -> &Table<R> {
        self
    }
}

impl<R: TableScalar> Table<R> {
    /// Number of segments that there is room for.
    #[must_use]
    pub fn capacity(&self) -> usize {
        self.segments.len()
    }

    /// Clock: phases and rates.
    #[must_use]
    pub fn clock(&self) -> &Clock<R::Quantity> {
        &self.clock
    }

    /// Cells, each a sixteenth of half a period: see [the table format](crate::table_format).
    #[must_use]
    pub fn cells(&self) -> [u16; CELLS] {
        self.cells
    }

    /// Segments in the order of their numbers; unused ones are 0.
    #[must_use]
    pub fn segments(&self) -> &[R::Segment] {
        &self.segments
    }

    /// Upper bound on the orientation error, rad, by ticks from the launch.
    #[must_use]
    pub fn error_bound(&self) -> ErrorBound {
        self.error_bound
    }

    /// Upper bound on the orientation error at a tick, rad.
    #[must_use]
    pub fn error_bound_at(&self, tick: i64) -> f64 {
        self.error_bound.after(self.ticks_from_launch(tick))
    }

    /// Upper bound on |Δω|, |ΔΩ| and |Δu'|, rad/s. The error of the tip's velocity is at most s times as large.
    #[must_use]
    pub fn rate_error_bound(&self) -> ErrorBound {
        self.rate_error_bound
    }

    /// Upper bound on |Δω|, |ΔΩ| and |Δu'| at a tick, rad/s.
    #[must_use]
    pub fn rate_error_bound_at(&self, tick: i64) -> f64 {
        self.rate_error_bound.after(self.ticks_from_launch(tick))
    }

    fn ticks_from_launch(&self, tick: i64) -> f64 {
        tick.abs_diff(self.clock.epoch) as f64
    }
}

#[cfg(feature = "defmt")]
impl<R: TableScalar, const SEGMENTS: usize> defmt::Format for SizedTable<R, SEGMENTS> {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(f, "table of {=usize} segments, {}", SEGMENTS, self.error_bound());
    }
}
