//! Polynomials of a and b: on a span, on its parts, and with fewer terms.
//!
//! The last term c x^k is dropped by subtracting c 2^(1-k) T_k(x), at most |c| 2^(1-k) in value.

use super::series::MAX_TERMS;
use crate::integer::{Limbs, product_u32, u64_to_f32};
use crate::scalar::{Float, Ring};
use crate::table::build::error_budget::ErrorBudget;
use crate::table::evaluation::TABLE_UNIT;

/// Fraction bits of the coefficients of [`CHEBYSHEV`].
const CHEBYSHEV_BITS: u32 = MAX_TERMS as u32 - 2;

/// Coefficients of x^(k-2), x^(k-4), ... in T_k(x) 2^(1-k), for each k.
#[allow(clippy::indexing_slicing)] // in a constant, an index out of range does not compile
static CHEBYSHEV: [[i32; MAX_TERMS / 2]; MAX_TERMS] = {
    let mut coefficients = [[0; MAX_TERMS / 2]; MAX_TERMS];
    let mut k = 2;
    while k < MAX_TERMS {
        let mut coefficient = 1_i64 << CHEBYSHEV_BITS;
        let mut m = 0;
        while 2 * m + 2 <= k {
            coefficient *= -(((k - 2 * m) * (k - 2 * m - 1)) as i64);
            coefficient /= (4 * (m + 1) * (k - m - 1)) as i64;
            coefficients[k][m] = coefficient as i32;
            m += 1;
        }
        k += 1;
    }
    coefficients
};

/// Real or imaginary part of a polynomial. The unit is 2^-62.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RealPolynomial {
    pub(crate) coefficients: [i64; MAX_TERMS],
    /// Upper bound on the change of the value by the dropped terms.
    dropped: i64,
}

impl RealPolynomial {
    const ZERO: Self = Self { coefficients: [0; MAX_TERMS], dropped: 0 };

    fn drop_last(&mut self, degree: usize) {
        let last = self.coefficients.get_mut(degree).map_or(0, core::mem::take);
        self.dropped += last.abs() >> (degree - 1);
        let lower = self.coefficients.iter_mut().take(degree).rev().skip(1).step_by(2);
        let factors = CHEBYSHEV.get(degree).into_iter().flatten();
        lower
            .zip(factors)
            .for_each(|(c, factor)| *c -= Limbs::new(last).times_word::<CHEBYSHEV_BITS>(*factor));
    }

    /// Estimate of the terms beyond the sixteenth from the last four, as a geometric series; infinite where they do not decrease.
    fn tail(&self) -> f32 {
        /// Magnitude of rounding errors, 3e-17.
        const NEGLIGIBLE: i64 = 138;
        let [.., c12, c13, c14, c15] = self.coefficients.map(i64::abs);
        // in pairs, because a series may be even or odd
        let before = c12 + c13;
        let last = c14 + c15;
        if last <= NEGLIGIBLE {
            return 0.0;
        }
        let before = before as f32;
        let last = last as f32;
        let ratio = last / before;
        if ratio < 1.0 { last * ratio / (1.0 - ratio) } else { f32::INFINITY }
    }
}

/// Polynomial of a or of b in x from -1 to 1.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Polynomial {
    pub(crate) parts: [RealPolynomial; 2],
    terms: usize,
    /// Estimate of the terms that are not computed, in units of 2^-62.
    tail: f32,
}

impl Polynomial {
    pub(crate) const ZERO: Self = Self { parts: [RealPolynomial::ZERO; 2], terms: 0, tail: 0.0 };

    /// Polynomial with the same value everywhere.
    pub(crate) fn constant(value: f64) -> Self {
        let mut polynomial = Self::ZERO;
        let [RealPolynomial { coefficients: [constant, ..], .. }, _] = &mut polynomial.parts;
        *constant = libm::round(value / TABLE_UNIT) as i64;
        polynomial
    }

    /// Estimates the terms beyond the sixteenth and drops negligible ones; `None` if the polynomial is not accurate.
    ///
    /// * `terms`: number of terms that are computed
    pub(crate) fn drop_negligible_terms(&mut self, terms: usize, budget: &ErrorBudget) -> Option<()> {
        self.terms = terms;
        let [re, im] = self.parts.each_ref().map(RealPolynomial::tail);
        let tail = 2.0 * re.larger_or_nan(im);
        let most = budget.dropped_q62;
        if !budget.is_negligible_tail(tail) {
            return None;
        }
        self.drop_last_terms(0, most);
        self.tail = tail + most as f32;
        Some(())
    }

    /// Drops last terms while more than `fewest` remain and the total change is at most `most`.
    pub(crate) fn drop_last_terms(&mut self, fewest: usize, most: i64) {
        while self.terms > fewest.max(2) {
            let degree = self.terms - 1;
            let last =
                |part: &RealPolynomial| part.coefficients.get(degree).map_or(0, |c| c.abs() >> (degree - 1));
            if self.parts.iter().map(|part| part.dropped + last(part)).sum::<i64>() > most {
                break;
            }
            self.parts.iter_mut().for_each(|part| part.drop_last(degree));
            self.terms = degree;
        }
    }

    /// Restricts the polynomial to half of its interval, by Horner's rule for x = (y ± 1)/2. All roundings together stay below 2^-57.
    fn halve(&mut self, upper: bool) {
        for part in &mut self.parts {
            let mut half = [0; MAX_TERMS];
            for (degree, c) in part.coefficients.iter().take(self.terms).rev().enumerate() {
                let mut lower_power = 0;
                for power in half.iter_mut().take(degree + 1) {
                    let moved = if upper { *power } else { -*power };
                    (*power, lower_power) = ((moved + lower_power + 1) >> 1, *power);
                }
                half[0] += c;
            }
            part.coefficients = half;
        }
    }

    /// Restricts the polynomial `whole` of a span to one of its 2^halvings equal parts.
    ///
    /// * `part`: number of the part
    pub(crate) fn restrict(&mut self, whole: &Self, part: usize, halvings: u32) {
        self.clone_from(whole);
        for halving in (0..halvings).rev() {
            self.halve((part >> halving) & 1 == 1);
        }
    }

    /// Truncation error, in units of 2^-62.
    pub(crate) fn truncation(&self) -> f32 {
        let [re, im] = self.parts.each_ref().map(|part| u64_to_f32(part.dropped.unsigned_abs()));
        Float::sqrt(re * re + im * im) + self.tail
    }

    /// Square of the bound Σ k |c_k| on the derivative, in units of 2^-62.
    pub(crate) fn slope_squared(&self) -> f32 {
        const WORD: f32 = (1_u64 << 32) as f32;
        let squared = |part: &RealPolynomial| {
            let terms = part.coefficients.iter().zip(0_u32..).take(self.terms);
            let slope: u64 = terms.map(|(c, k)| product_u32((c.unsigned_abs() >> 32) as u32 + 1, k)).sum();
            Ring::squared(u64_to_f32(slope) * WORD)
        };
        let [re, im] = self.parts.each_ref().map(squared);
        re + im
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polynomial(ratio: f64, sense: f64) -> Polynomial {
        let mut part = [0; MAX_TERMS];
        for (power, c) in part.iter_mut().enumerate() {
            *c =
                (sense.powi(power as i32 % 2) * (1.0 - ratio) * ratio.powi(power as i32) / TABLE_UNIT) as i64;
        }
        let half = part.map(|c| c / 2);
        let parts = if sense > 0.0 { [part, half] } else { [half, part] };
        Polynomial {
            parts: parts.map(|coefficients| RealPolynomial { coefficients, ..RealPolynomial::ZERO }),
            terms: MAX_TERMS,
            tail: 0.0,
        }
    }

    fn derivative(series: &Polynomial, order: i32, x: f64) -> [f64; 2] {
        series.parts.map(|part| {
            let factor = |k: i32| (0..order).map(|m| f64::from(k - m)).product::<f64>();
            let terms = part.coefficients.iter().zip(0..MAX_TERMS as i32).skip(order as usize).rev();
            TABLE_UNIT * terms.fold(0.0, |sum, (c, k)| sum * x + factor(k) * *c as f64)
        })
    }

    fn distance([re, im]: [f64; 2], [other_re, other_im]: [f64; 2]) -> f64 {
        (other_re - re).hypot(other_im - im)
    }

    #[test]
    fn a_part_has_the_values_of_the_whole() {
        for (ratio, sense) in [(0.5, 1.0), (0.3, -1.0), (0.05, 1.0)] {
            let whole = polynomial(ratio, sense);
            for (halvings, part) in
                (0..5).flat_map(|halvings| (0..1 << halvings).map(move |part| (halvings, part)))
            {
                let mut restricted = Polynomial::ZERO;
                restricted.restrict(&whole, part, halvings);
                for x in [-1.0, -0.6, -0.3, 0.0, 0.7, 1.0] {
                    let at = (x + (2 * part + 1) as f64) / f64::from(1 << halvings) - 1.0;
                    let error = distance(derivative(&whole, 0, at), derivative(&restricted, 0, x));
                    assert!(error < 2.5e-16, "{ratio} {part}/{halvings} {x}: {error:e}");
                }
            }
        }
    }

    #[test]
    fn fewer_terms_change_no_more_than_the_bounds_say() {
        let exact = polynomial(0.3, 1.0);
        let points = if cfg!(miri) { 40 } else { 1000 };
        let greatest = |of: &dyn Fn(f64) -> f64| {
            (0..=points).map(|i| of(2.0 * f64::from(i) / f64::from(points) - 1.0)).fold(0.0, f64::max)
        };
        for terms in 2..MAX_TERMS {
            let mut short = exact;
            short.drop_last_terms(terms, i64::MAX);
            assert!(short.parts.iter().all(|part| part.coefficients[terms..].iter().all(|c| *c == 0)));
            let change = greatest(&|x| distance(derivative(&exact, 0, x), derivative(&short, 0, x)));
            let slope = greatest(&|x| distance(derivative(&short, 1, x), [0.0; 2]));
            for (worst, bound) in [(change, short.truncation()), (slope, short.slope_squared().sqrt())] {
                let bound = TABLE_UNIT * f64::from(bound);
                assert!(worst <= bound * 1.000_001 + 3e-16, "{terms}: {worst:e} {bound:e}");
                assert!(bound <= 1.5 * worst + 1e-8, "{terms}: {worst:e} {bound:e}");
            }
        }
    }

    #[test]
    fn terms_are_dropped_up_to_a_sum() {
        let exact = polynomial(0.3, 1.0);
        let size = |series: &Polynomial, degree: usize| -> i64 {
            series.parts.iter().map(|part| part.coefficients[degree].abs() >> (degree - 1)).sum()
        };
        let mut series = exact;
        let last = size(&exact, 15);
        series.drop_last_terms(0, last - 1);
        assert_eq!(series.terms, 16);
        series.drop_last_terms(0, last);
        assert_eq!((series.terms, series.parts.iter().map(|part| part.dropped).sum::<i64>()), (15, last));
        let before = size(&series, 14);
        series.drop_last_terms(0, last + before - 1);
        assert_eq!(series.terms, 15);
    }
}
