//! Workspace of a set-up.

use crate::table::build::half_period::HalfPeriod;
use crate::table::build::path::SpanMemory;

/// Workspace of a set-up, 3.4 KiB, with its truncation error.
///
/// A program with a small stack keeps it in a static: see "In firmware" on [the first page](crate).
#[derive(Debug)]
pub struct Workspace {
    /// Truncation error, rad; `None` for that of the scalar.
    pub(super) truncation: Option<f64>,
    pub(super) half_period: HalfPeriod,
    pub(super) span: SpanMemory,
}

impl Default for Workspace {
    fn default() -> Self {
        Self::new()
    }
}

impl Workspace {
    /// Workspace for [`EphemerisScalar::TRUNCATION`](crate::EphemerisScalar::TRUNCATION). A static of it takes no flash.
    #[must_use]
    pub const fn new() -> Self {
        Self { truncation: None, half_period: HalfPeriod::ZERO, span: SpanMemory::ZERO }
    }

    /// Workspace for another truncation error > 0, rad: a smaller table for a larger error.
    #[must_use]
    pub const fn with_truncation(truncation: f64) -> Self {
        Self { truncation: Some(truncation), ..Self::new() }
    }
}
