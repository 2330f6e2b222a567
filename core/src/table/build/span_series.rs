//! Power series of α or of β on a span, on its parts, and with fewer terms.
//!
//! The highest term c x^k is left out together with the lower powers that make it c 2^(1-k) T_k(x), at most |c| 2^(1-k).

use super::bound::SegmentErrors;
use super::limits::{Limits, OMITTED};
use crate::product::{long_product, signed_product};
use crate::scalar::{Float, Ring, short_float};
use crate::table::build::series::TERMS;
use crate::table::build::series::expansion::{Expansion, larger_or_nan};

/// Fraction bits of [`FACTORS`].
const FACTOR_BITS: u32 = TERMS as u32 - 2;

/// Coefficients of x^(k-2), x^(k-4), ... in T_k(x) 2^(1-k), for each k.
#[allow(clippy::indexing_slicing)] // evaluated by the compiler, which would refuse an index out of range
static FACTORS: [[i32; TERMS / 2]; TERMS] = {
    let mut factors = [[0; TERMS / 2]; TERMS];
    let mut k = 2;
    while k < TERMS {
        let (mut factor, mut m) = (1_i64 << FACTOR_BITS, 0);
        while 2 * m + 2 <= k {
            factor *= -(((k - 2 * m) * (k - 2 * m - 1)) as i64);
            factor /= (4 * (m + 1) * (k - m - 1)) as i64;
            factors[k][m] = factor as i32;
            m += 1;
        }
        k += 1;
    }
    factors
};

/// Product of a coefficient and a factor, rounded to the nearest.
fn times(c: i64, factor: i32) -> i64 {
    const LOW_BITS: u32 = 30;
    let low = c as i32 & ((1 << LOW_BITS) - 1);
    let half = 1 << (FACTOR_BITS - 1);
    (signed_product((c >> LOW_BITS) as i32, factor) << (LOW_BITS - FACTOR_BITS))
        + ((signed_product(low, factor) + half) >> FACTOR_BITS)
}

/// Real or imaginary part of a series.
#[derive(Clone, Copy, Debug)]
pub(super) struct Part {
    pub(super) coefficients: [i64; TERMS],
    /// Upper bounds on the changes of the value and of the derivative by the terms left out, in units of 2^-62.
    left_out: i64,
    slope_left_out: i64,
}

/// Power series on an interval, in x from -1 to 1.
#[derive(Clone, Copy, Debug)]
pub(super) struct Series {
    pub(super) parts: [Part; 2],
    terms: usize,
}

/// Series of α or of β on a span, and on the part of it that was halved last.
#[derive(Debug)]
pub(super) struct SpanSeries {
    /// Coefficients of e^{iχ} and e^{-iχ} in the ellipse.
    pub(super) exponentials: [f64; 2],
    whole: Series,
    /// Estimate of the terms beyond the last, in units of 2^-62.
    pub(super) omitted: f32,
    halved: Series,
    /// Number of that part and of the halvings.
    part: Option<(usize, u32)>,
}

impl Part {
    const ZERO: Self = Self { coefficients: [0; TERMS], left_out: 0, slope_left_out: 0 };

    /// Leaves out the last term.
    fn leave_out(&mut self, degree: usize) {
        let last = self.coefficients.get_mut(degree).map_or(0, core::mem::take);
        self.left_out += last.abs() >> (degree - 1);
        self.slope_left_out += (last.abs() * (degree * degree) as i64) >> (degree - 1);
        let lower = self.coefficients.iter_mut().take(degree).rev().skip(1).step_by(2);
        let factors = FACTORS.get(degree).into_iter().flatten();
        lower.zip(factors).for_each(|(c, factor)| *c -= times(last, *factor));
    }

    /// Estimate of the terms beyond the last four, which are continued as a geometric series; infinite where they do not decrease.
    fn omitted(&self) -> f32 {
        /// Magnitude of rounding errors, 3e-17 in units of 2^-62.
        const NEGLIGIBLE: i64 = 138;
        let [.., c12, c13, c14, c15] = self.coefficients.map(i64::abs);
        // in pairs, because a series may be even or odd
        let (before, last) = (c12 + c13, c14 + c15);
        if last <= NEGLIGIBLE {
            return 0.0;
        }
        let (before, last) = (before as f32, last as f32);
        let ratio = last / before;
        if ratio < 1.0 { last * ratio / (1.0 - ratio) } else { f32::INFINITY }
    }
}

impl Series {
    pub(super) const ZERO: Self = Self { parts: [Part::ZERO; 2], terms: 0 };

    /// Leaves out last terms down to `fewest`, as long as the changes add up to at most `most`.
    #[inline(never)] // here and below: the stack frames of set-up must not add up
    pub(super) fn shorten(&mut self, fewest: usize, most: i64) {
        while self.terms > fewest.max(2) {
            let degree = self.terms - 1;
            let last = |part: &Part| part.coefficients.get(degree).map_or(0, |c| c.abs() >> (degree - 1));
            if self.parts.iter().map(|part| part.left_out + last(part)).sum::<i64>() > most {
                break;
            }
            self.parts.iter_mut().for_each(|part| part.leave_out(degree));
            self.terms = degree;
        }
    }

    /// Replaces the series by that on half of the interval, by Horner's rule for x = (y ± 1)/2. Errors do not grow, as |x| <= 1; all
    /// roundings together stay below 2^-57.
    #[inline(never)]
    pub(super) fn halve(&mut self, upper: bool) {
        for part in &mut self.parts {
            let mut half = [0; TERMS];
            for (degree, c) in part.coefficients.iter().take(self.terms).rev().enumerate() {
                let mut lower_power = 0;
                for power in half.iter_mut().take(degree + 1) {
                    let moved = if upper { *power } else { -*power };
                    (*power, lower_power) = ((moved + lower_power + 1) >> 1, *power);
                }
                half[0] += c;
            }
            part.coefficients = half;
            part.slope_left_out = (part.slope_left_out + 1) >> 1;
        }
    }

    /// Adds the errors of the value and of the derivative, and the bounds Σ k |c_k| and Σ k (k - 1) |c_k| on the derivatives.
    pub(super) fn add_errors(
        &self,
        sums: &mut SegmentErrors,
        [omitted, slope_omitted]: [f32; 2],
        [stored, slope_stored]: [f32; 2],
    ) {
        const WORD: f32 = (1_u64 << 32) as f32;
        for part in &self.parts {
            let (mut slope, mut curvature) = (0, 0);
            for (c, k) in part.coefficients.iter().zip(0_u32..).take(self.terms) {
                let size = (c.unsigned_abs() >> 32) as u32 + 1;
                slope += long_product(size, k);
                curvature += long_product(size, k * k.saturating_sub(1));
            }
            sums.slope += Ring::squared(short_float(slope) * WORD);
            sums.curvature += Ring::squared(short_float(curvature) * WORD);
        }
        let norm = |of: fn(&Part) -> i64| {
            let [re, im] = self.parts.each_ref().map(|part| short_float(of(part).unsigned_abs()));
            Float::sqrt(re * re + im * im)
        };
        sums.change += Ring::squared(norm(|part| part.left_out) + omitted);
        sums.slope_error += Ring::squared(norm(|part| part.slope_left_out) + slope_omitted + slope_stored);
        sums.stored = larger_or_nan(sums.stored, stored);
    }
}

impl SpanSeries {
    pub(super) const ZERO: Self =
        Self { exponentials: [0.0; 2], whole: Series::ZERO, omitted: 0.0, halved: Series::ZERO, part: None };

    /// Computes the series with this slow phase; `None` where it is not accurate.
    pub(super) fn compute(
        &mut self,
        expansion: &mut Expansion,
        slow: usize,
        limits: &Limits,
        pause: &mut dyn FnMut(),
    ) -> Option<()> {
        let series = &mut self.whole;
        (*series, self.part) = (Series::ZERO, None);
        let parts = series.parts.each_mut().map(|part| &mut part.coefficients);
        series.terms = expansion.parameter_series(slow, self.exponentials, limits.least_term(), parts)?;
        pause();
        let [re, im] = series.parts.each_ref().map(Part::omitted);
        let omitted = 2.0 * larger_or_nan(re, im);
        (2.0 * omitted <= OMITTED * limits.polynomial).then_some(())?;
        series.shorten(0, limits.left_out);
        self.omitted = omitted + limits.least_term() as f32;
        Some(())
    }

    /// Copies the series on one of 2^halvings parts, without last terms whose changes add up to at most `least`.
    pub(super) fn restrict(&mut self, part: usize, halvings: u32, least: i64, to: &mut Series) {
        let Some(last) = halvings.checked_sub(1) else { return to.clone_from(&self.whole) };
        let halved = Some((part / 2, last));
        if self.part != halved {
            (self.part, self.halved) = (halved, self.whole);
            for halving in (1..halvings).rev() {
                self.halved.halve((part >> halving) & 1 == 1);
                self.halved.shorten(0, least);
            }
        }
        to.clone_from(&self.halved);
        to.halve(part & 1 == 1);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::table::scalar::TABLE_UNIT;

    fn series(ratio: f64, sense: f64) -> Series {
        let mut part = [0; TERMS];
        for (power, c) in part.iter_mut().enumerate() {
            *c =
                (sense.powi(power as i32 % 2) * (1.0 - ratio) * ratio.powi(power as i32) / TABLE_UNIT) as i64;
        }
        let half = part.map(|c| c / 2);
        let parts = if sense > 0.0 { [part, half] } else { [half, part] };
        Series { parts: parts.map(|coefficients| Part { coefficients, ..Part::ZERO }), terms: TERMS }
    }

    fn derivative(series: &Series, order: i32, x: f64) -> [f64; 2] {
        series.parts.map(|part| {
            let factor = |k: i32| (0..order).map(|m| f64::from(k - m)).product::<f64>();
            let terms = part.coefficients.iter().zip(0..TERMS as i32).skip(order as usize).rev();
            TABLE_UNIT * terms.fold(0.0, |sum, (c, k)| sum * x + factor(k) * *c as f64)
        })
    }

    fn distance([re, im]: [f64; 2], [other_re, other_im]: [f64; 2]) -> f64 {
        (other_re - re).hypot(other_im - im)
    }

    #[test]
    fn a_part_has_the_values_of_the_whole() {
        for (ratio, sense) in [(0.5, 1.0), (0.3, -1.0), (0.05, 1.0)] {
            let whole = series(ratio, sense);
            for (halvings, part) in
                (0..5).flat_map(|halvings| (0..1 << halvings).map(move |part| (halvings, part)))
            {
                let mut own = Series::ZERO;
                SpanSeries { whole, ..SpanSeries::ZERO }.restrict(part, halvings, 0, &mut own);
                for x in [-1.0, -0.6, -0.3, 0.0, 0.7, 1.0] {
                    let place = (x + (2 * part + 1) as f64) / f64::from(1 << halvings) - 1.0;
                    let error = distance(derivative(&whole, 0, place), derivative(&own, 0, x));
                    assert!(error < 2.5e-16, "{ratio} {part}/{halvings} {x}: {error:e}");
                }
            }
        }
    }

    #[test]
    fn fewer_terms_change_no_more_than_the_bounds_say() {
        let exact = series(0.3, 1.0);
        let points = if cfg!(miri) { 40 } else { 1000 };
        let greatest = |of: &dyn Fn(f64) -> f64| {
            (0..=points).map(|i| of(2.0 * f64::from(i) / f64::from(points) - 1.0)).fold(0.0, f64::max)
        };
        for terms in 2..TERMS {
            let mut short = exact;
            short.shorten(terms, i64::MAX);
            assert!(short.parts.iter().all(|part| part.coefficients[terms..].iter().all(|c| *c == 0)));
            let mut sums = SegmentErrors::default();
            short.add_errors(&mut sums, [0.0; 2], [0.0; 2]);
            let change =
                |order| greatest(&|x| distance(derivative(&exact, order, x), derivative(&short, order, x)));
            let size = |order| greatest(&|x| distance(derivative(&short, order, x), [0.0; 2]));
            for (worst, bound, most) in [
                (change(0), sums.change, 1.5),
                (change(1), sums.slope_error, 2.5),
                (size(1), sums.slope, 1.5),
                (size(2), sums.curvature, 1.5),
            ] {
                let bound = TABLE_UNIT * f64::from(bound.sqrt());
                assert!(worst <= bound * 1.000_001 + 3e-16, "{terms}: {worst:e} {bound:e}");
                assert!(bound <= most * worst + 1e-8, "{terms}: {worst:e} {bound:e}");
            }
        }
    }

    #[test]
    fn terms_are_left_out_up_to_a_sum() {
        let exact = series(0.3, 1.0);
        let size = |series: &Series, degree: usize| -> i64 {
            series.parts.iter().map(|part| part.coefficients[degree].abs() >> (degree - 1)).sum()
        };
        let mut series = exact;
        let last = size(&exact, 15);
        series.shorten(0, last - 1);
        assert_eq!(series.terms, 16);
        series.shorten(0, last);
        assert_eq!((series.terms, series.parts.iter().map(|part| part.left_out).sum::<i64>()), (15, last));
        let before = size(&series, 14);
        series.shorten(0, last + before - 1);
        assert_eq!(series.terms, 15);
        let slopes = |series: &Series| series.parts.map(|part| part.slope_left_out);
        let before = slopes(&series);
        series.halve(false);
        assert_eq!(slopes(&series), before.map(|slope| (slope + 1) / 2));
    }
}
