//! Motion over a span of time, for pictures.

use crate::Failure;
use crate::motion::Scalar;
use crate::motion::ephemeris::{AnyScalar, furthest_time, smallest};
use crate::motion::propagate::Sample;
use crate::pictures::plot::Curve;
use toytop::Motion;

/// Motion between two times.
pub(crate) struct Span {
    table: Box<dyn AnyScalar>,
    ends: [f64; 2],
}

impl Span {
    /// Span between two times, s; without them, the time of [`Curve::of`](crate::pictures::plot::Curve::of).
    ///
    /// # Errors
    /// [`Failure::Input`]: times beyond the reach of the ephemeris. [`Failure::Method`]: no ephemeris is large enough.
    pub(crate) fn new(motion: &Motion, ends: Option<[f64; 2]>) -> Result<Self, Failure> {
        let ends = match ends {
            Some(ends) => ends,
            None => [0.0, Curve::of(motion)?.time],
        };
        let furthest = furthest_time(motion);
        if let Some(t) = ends.iter().find(|t| t.abs() > furthest) {
            return Err(Failure::Input(format!("--times: {t:e} must be within ±{furthest:.1e} s")));
        }
        Ok(Self { table: smallest(Scalar::F64, motion)?, ends })
    }

    /// First and last time, s.
    #[must_use]
    pub(crate) fn ends(&self) -> [f64; 2] {
        self.ends
    }

    /// Sample at a time.
    #[must_use]
    pub(crate) fn at(&self, t: f64) -> Sample {
        self.table.at(t).sample
    }

    /// Times of this number, evenly spread, both ends included.
    pub(crate) fn times(&self, count: u64) -> impl Iterator<Item = f64> {
        let [from, until] = self.ends;
        (0..count).map(move |i| from + (until - from) * i as f64 / (count.max(2) - 1) as f64)
    }
}
