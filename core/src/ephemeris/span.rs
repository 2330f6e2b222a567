//! Spans of half a nutation period: the parts on each of which one expansion of the law is used.
//!
//! A series of sixteen terms is accurate on a longer interval than the short polynomials of a table, so that one span can
//! contain several segments. Their series follow from that of the span without another expansion.

use crate::ephemeris::cell::{Cell, PAIR_BITS};
use crate::law::series::{TERMS, over_power};
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

/// Series of α or of β on a part of a span, its real and its imaginary part. It is kept for the two segments of the part, because
/// restricting series takes a fifth of the set-up of a table with many segments.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PartOfSpan {
    /// Number of the part, and base-2 logarithm of the number of parts; `None` where no series is kept.
    part: Option<[usize; 2]>,
    series: [[i64; TERMS]; 2],
    /// Sum of the magnitudes of the terms removed.
    removed: i64,
}

impl PartOfSpan {
    /// No series.
    pub(crate) const NONE: Self = Self { part: None, series: [[0; TERMS]; 2], removed: 0 };

    /// Replaces `series` by those on one of 2^halvings parts of the span, from those on the span. The result is the sum of the
    /// magnitudes of the terms removed: see [`restrict`].
    pub(crate) fn restrict(
        &mut self,
        span: &[[i64; TERMS]; 2],
        [part, halvings]: [usize; 2],
        least: i64,
        series: &mut [[i64; TERMS]; 2],
    ) -> i64 {
        let restricted = |series: &mut [[i64; TERMS]; 2], part: usize, halvings: usize| {
            series.iter_mut().map(|own| restrict(own, part, halvings, least)).sum::<i64>()
        };
        // the part that contains this one and its neighbour
        let (both, fewer) = (part / 2, halvings.saturating_sub(1));
        if fewer == 0 {
            *series = *span;
            return restricted(series, part, halvings);
        }
        if self.part != Some([both, fewer]) {
            self.series = *span;
            self.removed = restricted(&mut self.series, both, fewer);
            self.part = Some([both, fewer]);
        }
        *series = self.series;
        self.removed + restricted(series, part, 1)
    }
}

/// Replaces a series on [-1, 1] by that on one of 2^halvings equal parts of the interval, whose own coordinate is in [-1, 1].
/// The lowest bits of `part` are its number. Last terms of at most `least` are removed; the result is the sum of their
/// magnitudes. Rounding error: about one unit of the coefficients for each halving.
#[inline(never)] // a call: it is made for each part of α and of β
pub(crate) fn restrict(series: &mut [i64; TERMS], part: usize, halvings: usize, least: i64) -> i64 {
    let mut removed = 0;
    let mut terms = TERMS;
    for halving in (0..halvings).rev() {
        let lower = part >> halving & 1 == 0;
        if lower {
            mirror(series);
        }
        while let Some(last) = terms.checked_sub(1).and_then(|last| series.get_mut(last)) {
            if last.abs() > least {
                break;
            }
            removed += last.abs();
            (*last, terms) = (0, terms - 1);
        }
        halve(series.get_mut(..terms).unwrap_or_default());
        if lower {
            mirror(series);
        }
    }
    removed
}

/// Replaces a series in x by that in x', where x = (x' + 1)/2.
fn halve(coefficients: &mut [i64]) {
    // in x - 1/2: one coefficient after the other is complete
    for first in 0..coefficients.len() {
        let rest = coefficients.get_mut(first..).unwrap_or_default();
        rest.iter_mut().rev().fold(0_i64, |above, c| {
            *c += (above + 1) >> 1;
            *c
        });
    }
    for (c, power) in coefficients.iter_mut().zip(0..).skip(1) {
        let twice = if power == 1 { *c } else { over_power(*c, power - 1) };
        *c = (twice + 1) >> 1;
    }
}

/// Replaces a series by that of -x.
fn mirror(coefficients: &mut [i64; TERMS]) {
    coefficients.iter_mut().skip(1).step_by(2).for_each(|c| *c = -*c);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::law::series::UNIT;

    /// The series of every part has the values of the whole, also where it fills the range of the integers.
    #[test]
    fn a_part_has_the_values_of_the_whole() {
        for (ratio, sense) in [(0.3_f64, 1.0), (0.24, -1.0), (0.05, 1.0)] {
            let mut whole = [0; TERMS];
            for (power, c) in whole.iter_mut().enumerate() {
                let sign = if power % 2 == 1 { sense } else { 1.0 };
                *c = (sign * (1.0 - ratio) * ratio.powi(power as i32) / UNIT) as i64;
            }
            let value = |series: &[i64; TERMS], x: f64| {
                UNIT * series.iter().rev().fold(0.0, |sum, c| sum * x + *c as f64)
            };
            for halvings in 0..5 {
                let parts = 1 << halvings;
                for part in 0..parts {
                    let mut own = whole;
                    assert_eq!(restrict(&mut own, part, halvings, 0), 0);
                    for x in [-1.0, -0.3, 0.0, 0.7, 1.0] {
                        let place = (x + (2 * part + 1) as f64) / parts as f64 - 1.0;
                        let error = value(&own, x) - value(&whole, place);
                        assert!(error.abs() < 4e-16, "{ratio} {part}/{parts} {x}: {error:e}");
                    }
                    // the last bits, which f64 does not show
                    let centre = whole.iter().rev().fold(0_i128, |sum, c| {
                        sum * (2 * part as i128 + 1 - parts as i128) / parts as i128 + i128::from(*c)
                    });
                    let error = i128::from(own[0]) - centre;
                    assert!(error.abs() <= 3 * halvings as i128 + 3, "{part}/{parts}: {error}");
                }
            }
        }
    }

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
