//! Spans of half a nutation period: the parts on each of which one expansion of the law is used.
//!
//! A series of sixteen terms is accurate on a longer interval than the short polynomials of a table, so that one span can
//! contain several segments. Their series follow from that of the span without another expansion.

use crate::ephemeris::cell::{Cell, PAIR_BITS};
use crate::ephemeris::chebyshev::{Chebyshev, Wanted};
use crate::phase::Phase;

/// One of the 2^depth parts of equal length into which half a period is divided.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Span {
    depth: u32,
    number: usize,
}

/// Half a period in units of the shortest segment.
pub(crate) const HALF_PERIOD: usize = 1 << Span::DEEPEST;

impl Span {
    /// Base-2 logarithm of the number of spans in half a period, at least.
    const SHALLOWEST: u32 = 2;
    /// Base-2 logarithm of the number of spans in half a period, at most: a span has at least one segment.
    const DEEPEST: u32 = PAIR_BITS + Cell::DEEPEST;

    /// Longest span from u = e₁ on.
    pub(crate) const FIRST: Self = Self { depth: Self::SHALLOWEST, number: 0 };

    /// Base-2 logarithm of the number of spans of this length in half a period.
    pub(crate) fn depth(self) -> u32 {
        self.depth
    }

    /// Beginning in units of the shortest segment.
    pub(crate) fn begin(self) -> usize {
        self.number << (Self::DEEPEST - self.depth)
    }

    /// End in units of the shortest segment.
    pub(crate) fn end(self) -> usize {
        Self { number: self.number + 1, ..self }.begin()
    }

    /// Span of the same length that begins at this position.
    pub(crate) fn at(self, position: usize) -> Self {
        Self { number: position >> (Self::DEEPEST - self.depth), ..self }
    }

    /// First of the halves; `None` where they would be shorter than the shortest segment.
    pub(crate) fn first_half(self) -> Option<Self> {
        (self.depth < Self::DEEPEST).then_some(Self { depth: self.depth + 1, number: 2 * self.number })
    }

    /// Span of the same length after this one.
    pub(crate) fn next(self) -> Self {
        Self { number: self.number + 1, ..self }
    }

    /// Span of twice the length with the same beginning, where the division has one.
    pub(crate) fn doubled(self) -> Option<Self> {
        let exists = self.depth > Self::SHALLOWEST && self.number.is_multiple_of(2);
        exists.then_some(Self { depth: self.depth - 1, number: self.number / 2 })
    }

    /// Least number of halvings of a pair of cells whose segments are not longer than the span.
    pub(crate) fn least_level(self) -> u32 {
        self.depth.saturating_sub(PAIR_BITS)
    }

    /// Number of halvings of the span that make its segments, if pairs are halved `level` times.
    pub(crate) fn halvings(self, level: u32) -> u32 {
        (PAIR_BITS + level).saturating_sub(self.depth)
    }

    /// Nutation phase at x ∈ [-1, 1] of the span.
    pub(crate) fn phase(self, x: f64) -> Phase {
        // the half period is half a turn, and the span is twice as long as the unit of x
        let halvings = 2 + self.depth;
        let centre = 2 * self.number as i128 + 1;
        Phase::from_bits(centre * (Phase::ONE.to_bits() >> halvings))
            + Phase::new(x / (1_u64 << halvings) as f64)
    }
}

/// Series on the upper half of a part of a span. It is computed together with that on the lower half, and kept for the next segment.
#[derive(Clone, Copy, Debug)]
pub(crate) struct UpperHalf {
    /// Number of the part, and base-2 logarithm of the number of parts; `None` where no series is kept.
    part: Option<[usize; 2]>,
    series: Chebyshev,
}

impl UpperHalf {
    /// No series.
    pub(crate) const NONE: Self = Self { part: None, series: Chebyshev::ZERO };

    /// Series on one of 2^halvings parts of the span, from that on the span. Last terms that add up to at most `least` are left out.
    ///
    /// * `lower`: memory for the series on a lower half
    pub(crate) fn restrict<'a>(
        &'a mut self,
        span: &'a mut Chebyshev,
        [part, halvings]: [usize; 2],
        least: i64,
        lower: &'a mut Chebyshev,
    ) -> &'a Chebyshev {
        let Some(last) = halvings.checked_sub(1) else { return span };
        let (both, is_upper) = (Some([part / 2, last]), part & 1 == 1);
        // the memory of a lower half may have been used for another series
        if self.part != both || !is_upper {
            self.part = both;
            span.leave_out(least);
            lower.copy(span);
            for halving in (1..halvings).rev() {
                lower.halve(if part >> halving & 1 == 1 { Wanted::Upper } else { Wanted::Lower });
                lower.leave_out(least);
            }
            lower.halve(Wanted::Both(&mut self.series));
        }
        if is_upper { &self.series } else { lower }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spans_divide_the_half_period() {
        let mut span = Span::FIRST.first_half().unwrap();
        let (mut reached, mut count) = (0, 0);
        while span.begin() < HALF_PERIOD {
            assert_eq!((span.begin(), span.at(reached)), (reached, span));
            reached = span.end();
            count += 1;
            let next = span.next();
            span = match count % 3 {
                0 => next.first_half().unwrap(),
                1 => next,
                _ => next.doubled().unwrap_or(next),
            };
        }
        assert_eq!(reached, HALF_PERIOD);
        assert!(count > 5, "{count}");
        let shortest = (0..14).fold(Span::FIRST, |span, _| span.first_half().unwrap());
        assert_eq!((shortest.end(), shortest.first_half()), (1, None));
        assert_eq!(Span::FIRST.next().phase(1.0), Phase::QUARTER);
        assert_eq!(Span::FIRST.at(HALF_PERIOD - 1).phase(1.0), Phase::HALF);
    }
}
