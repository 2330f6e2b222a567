//! Series of α and of β in Chebyshev polynomials T_k, on a span of the half period and on its parts.
//!
//! A sum of Chebyshev polynomials is reduced to a lower degree by leaving out its last terms, and each of them changes
//! the value by at most its magnitude, because |T_k| <= 1. The halves of the interval have such series too: see [`Chebyshev::halve`].

mod maps;

use crate::ephemeris::polynomial::Polynomial;
use crate::law::series::TERMS;
use crate::product::long_product;
use crate::scalar::{Float, Ring, short_float};

/// Series of α or of β on an interval, whose coordinate x is in [-1, 1].
#[derive(Clone, Copy, Debug)]
pub(crate) struct Chebyshev {
    /// Coefficients of the real and of the imaginary part.
    parts: [[Coefficient; TERMS]; 2],
    /// Number of terms.
    terms: usize,
    /// Upper bounds on the changes of the value and of its derivative by the terms left out, in units of 2^-61.
    left_out: [i64; 2],
}

/// Coefficient in units of 2^-61, as upper · 2^31 + lower with lower in [0, 2^31): the coefficients of a function of at most 1 are below 2.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Coefficient {
    upper: i32,
    lower: i32,
}

impl Coefficient {
    const LOW_BITS: u32 = 31;
    const ZERO: Self = Self { upper: 0, lower: 0 };

    #[inline(always)]
    fn of(value: i64) -> Self {
        Self { upper: (value >> Self::LOW_BITS) as i32, lower: value as i32 & i32::MAX }
    }

    #[inline(always)]
    fn value(self) -> i64 {
        (i64::from(self.upper) << Self::LOW_BITS) + i64::from(self.lower)
    }
}

/// Half of an interval of which the series is wanted.
pub(crate) enum Wanted<'a> {
    Lower,
    Upper,
    /// Both halves, with the memory for the series on the upper one.
    Both(&'a mut Chebyshev),
}

impl Chebyshev {
    /// Series of 0.
    pub(crate) const ZERO: Self = Self { parts: [[Coefficient::ZERO; TERMS]; 2], terms: 0, left_out: [0; 2] };

    /// Replaces the series by another one.
    pub(crate) fn copy(&mut self, other: &Self) {
        for (part, other_part) in self.parts.iter_mut().zip(&other.parts) {
            part.iter_mut().zip(other_part).take(other.terms).for_each(|(c, other)| *c = *other);
        }
        (self.terms, self.left_out) = (other.terms, other.left_out);
    }

    /// Computes the polynomial of the terms below a degree, in powers of x.
    #[inline(never)] // one copy for all scalars
    pub(crate) fn powers(&self, terms: usize, polynomial: &mut Polynomial) {
        let terms = terms.min(self.terms);
        for (part, series) in polynomial.iter_mut().zip(&self.parts) {
            part.iter_mut().zip(series).take(terms).for_each(|(power, c)| *power = c.value());
            // T_k = 2 x T_{k-1} - T_{k-2}: the constant, and the series of the quotient by x, one power after the other
            for first in 2..terms {
                for k in (first..terms).rev() {
                    if let Some([lower, _, c]) = part.get_mut(k - 2..=k) {
                        (*lower, *c) = (*lower - *c, 2 * *c);
                    }
                }
            }
            part.iter_mut().take(terms).for_each(|c| *c *= 2);
        }
    }

    /// Leaves out last terms, as long as the magnitudes of all terms left out so far add up to at most `most`, in units of 2^-61.
    pub(crate) fn leave_out(&mut self, most: i64) {
        let [value, slope] = &mut self.left_out;
        let mut rest = most - *value;
        while let Some(degree) = self.terms.checked_sub(1) {
            let size: i64 =
                self.parts.iter().map(|part| part.get(degree).map_or(0, |c| c.value().abs())).sum();
            rest -= size;
            if rest < 0 {
                break;
            }
            *value += size;
            *slope += size * (degree * degree) as i64;
            self.terms = degree;
        }
    }

    /// Upper bounds for the terms below a degree, and for the others if they are left out.
    #[inline(never)] // one copy for all scalars
    pub(crate) fn bounds(&self, terms: usize) -> SeriesBounds {
        let [value_before, slope_before] = self.left_out.map(|sum| short_float(sum.unsigned_abs()));
        let [mut changes, mut slopes, mut curvatures] = [0.0; 3];
        let mut slope_change = slope_before;
        for part in &self.parts {
            let part = part.get(..self.terms).unwrap_or(part);
            let (kept, others) = part.split_at_checked(terms).unwrap_or((part, &[]));
            let (mut slope, mut curvature) = (0, 0);
            for (c, degree) in kept.iter().zip(0_u32..) {
                let (size, square) = (c.upper.unsigned_abs() + 1, degree * degree);
                slope += long_product(size, square);
                curvature += long_product(size, square * square.saturating_sub(1) / 3);
            }
            let (mut change, mut upper_words, mut lower_words) = (0, 0, 0);
            for (c, degree) in others.iter().zip(terms as u32..) {
                let size = c.value().unsigned_abs();
                change += size;
                upper_words += long_product((size >> 32) as u32, degree * degree);
                lower_words += long_product(size as u32, degree * degree);
            }
            slope_change += short_float(upper_words) * WORD + short_float(lower_words);
            changes += Ring::squared(short_float(change));
            slopes += Ring::squared(short_float(slope) * UPPER_UNIT);
            curvatures += Ring::squared(short_float(curvature) * UPPER_UNIT);
        }
        SeriesBounds {
            change: 2.0 * (Float::sqrt(changes) + value_before),
            slope_change: 2.0 * slope_change,
            slope_squares: slopes,
            curvature_squares: curvatures,
        }
    }
}

/// Upper bounds on [-1, 1] that follow from a series of α or β, as multiples of 2^-62. A derivative of T_k is at most k², a second one
/// k² (k² - 1)/3.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SeriesBounds {
    /// Changes of |α| and of its derivative by the terms left out.
    pub(crate) change: f32,
    pub(crate) slope_change: f32,
    /// Squares of the first and of the second derivative.
    pub(crate) slope_squares: f32,
    pub(crate) curvature_squares: f32,
}

/// Unit of the upper part of a coefficient as a multiple of 2^-62.
const UPPER_UNIT: f32 = (1_u64 << (Coefficient::LOW_BITS + 1)) as f32;

/// Unit of an upper word, in units of the lower one.
const WORD: f32 = (1_u64 << 32) as f32;

/// Half of a number, rounded to the nearest.
fn half(c: i64) -> i64 {
    (c + 1) >> 1
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::law::series::UNIT;

    /// Series of a function of at most 1 whose terms decrease by a factor, in one part or in the other.
    fn polynomial(ratio: f64, sense: f64) -> Polynomial {
        let mut part = [0; TERMS];
        for (power, c) in part.iter_mut().enumerate() {
            let sign = if power % 2 == 1 { sense } else { 1.0 };
            *c = (sign * (1.0 - ratio) * ratio.powi(power as i32) / UNIT) as i64;
        }
        let half = part.map(|c| c / 2);
        if sense > 0.0 { [part, half] } else { [half, part] }
    }

    fn values(polynomial: &Polynomial, x: f64) -> [f64; 2] {
        polynomial.map(|part| UNIT * part.iter().rev().fold(0.0, |sum, c| sum * x + *c as f64))
    }

    fn slopes(polynomial: &Polynomial, x: f64) -> [f64; 2] {
        let slope = |part: &[i64; TERMS]| {
            part.iter().enumerate().skip(1).rev().fold(0.0, |sum, (k, c)| sum * x + k as f64 * *c as f64)
        };
        polynomial.each_ref().map(|part| UNIT * slope(part))
    }

    fn curvatures(polynomial: &Polynomial, x: f64) -> [f64; 2] {
        polynomial.map(|part| {
            let terms = part.iter().zip(0..).skip(2);
            UNIT * terms.map(|(c, k)| f64::from(k * (k - 1)) * *c as f64 * x.powi(k - 2)).sum::<f64>()
        })
    }

    fn series_of(polynomial: &Polynomial) -> Chebyshev {
        let mut series = Chebyshev::ZERO;
        series.set(polynomial, TERMS);
        series
    }

    fn powers(series: &Chebyshev, terms: usize) -> Polynomial {
        let mut polynomial = [[0; TERMS]; 2];
        series.powers(terms, &mut polynomial);
        polynomial
    }

    const POINTS: [f64; 6] = [-1.0, -0.6, -0.3, 0.0, 0.7, 1.0];

    fn norm([re, im]: [f64; 2]) -> f64 {
        re.hypot(im)
    }

    #[test]
    fn a_series_has_the_values_of_its_polynomial() {
        for (ratio, sense) in [(0.5, 1.0), (0.3, -1.0), (0.05, 1.0)] {
            let polynomial = polynomial(ratio, sense);
            let again = powers(&series_of(&polynomial), TERMS);
            for x in POINTS {
                let ([re, im], [again_re, again_im]) = (values(&polynomial, x), values(&again, x));
                let error = norm([again_re - re, again_im - im]);
                assert!(error < 2.5e-16, "{ratio} {x}: {error:e}");
            }
        }
    }

    /// The series of every part of an interval has the values of the whole.
    #[test]
    fn a_half_has_the_values_of_the_whole() {
        for (ratio, sense) in [(0.5, 1.0), (0.3, -1.0), (0.05, 1.0)] {
            let whole = polynomial(ratio, sense);
            for halvings in 0..5 {
                let parts = 1 << halvings;
                for part in 0..parts {
                    let mut series = series_of(&whole);
                    for halving in (1..halvings).rev() {
                        let is_upper = part >> halving & 1 == 1;
                        series.halve(if is_upper { Wanted::Upper } else { Wanted::Lower });
                    }
                    let mut upper = Chebyshev::ZERO;
                    if halvings > 0 {
                        series.halve(Wanted::Both(&mut upper));
                    }
                    let series = if part & 1 == 1 { &upper } else { &series };
                    let own = powers(series, TERMS);
                    for x in POINTS {
                        let place = (x + f64::from(2 * part + 1)) / f64::from(parts) - 1.0;
                        let ([re, im], [own_re, own_im]) = (values(&whole, place), values(&own, x));
                        let error = norm([own_re - re, own_im - im]);
                        assert!(error < 2.5e-16, "{ratio} {part}/{parts} {x}: {error:e}");
                    }
                }
            }
        }
    }

    /// The bounds are above the changes and derivatives, but not by much.
    #[test]
    fn fewer_terms_change_no_more_than_the_bounds_say() {
        let exact = polynomial(0.3, 1.0);
        let points = if cfg!(miri) { 40 } else { 1000 };
        for terms in 1..TERMS {
            let mut series = series_of(&exact);
            let bounds = series.bounds(terms);
            let short = powers(&series, terms);
            assert!(short.iter().all(|part| part[terms..].iter().all(|c| *c == 0)));
            let greatest = |of: &dyn Fn(f64) -> [f64; 2]| {
                let at = |i| norm(of(2.0 * f64::from(i) / f64::from(points) - 1.0));
                (0..=points).map(at).fold(0.0, f64::max)
            };
            let change = |of: fn(&Polynomial, f64) -> [f64; 2]| {
                greatest(&|x| {
                    let ([re, im], [short_re, short_im]) = (of(&exact, x), of(&short, x));
                    [short_re - re, short_im - im]
                })
            };
            for (worst, bound, most) in [
                (change(values), bounds.change, 1.5),
                (change(slopes), bounds.slope_change, 2.5),
                (greatest(&|x| slopes(&short, x)), bounds.slope_squares.sqrt(), 1.5),
                (greatest(&|x| curvatures(&short, x)), bounds.curvature_squares.sqrt(), 1.5),
            ] {
                let bound = UNIT * f64::from(bound);
                assert!(worst <= bound * 1.000_001 + 3e-16, "{terms}: {worst:e} {bound:e}");
                assert!(bound <= most * worst + 1e-8, "{terms}: {worst:e} {bound:e}");
            }
            // the same terms, left out before
            let [before, allowed] = [bounds.change, 0.500_001 * bounds.change];
            series.leave_out((2.0 * allowed) as i64);
            assert!(series.terms <= terms, "{terms}");
            let after = series.bounds(terms).change;
            assert!((0.99..=1.5).contains(&(after / before)), "{terms}: {before:e} {after:e}");
        }
    }

    /// The halves of a series whose only coefficient is one unit have at most one coefficient that is not 0. If sums were rounded down, half
    /// of the coefficients would be -1, and the derivative would have the errors of many terms.
    #[test]
    fn coefficients_are_rounded_to_the_nearest() {
        for unit in [1, -1] {
            let mut lower = Chebyshev { terms: TERMS, ..Chebyshev::ZERO };
            lower.parts[0][15] = Coefficient::of(unit);
            let mut upper = Chebyshev::ZERO;
            lower.halve(Wanted::Both(&mut upper));
            for half in [lower, upper] {
                let left = half.parts.iter().flatten().filter(|c| **c != Coefficient::ZERO).count();
                assert!(left <= 1, "{unit}: {half:?}");
            }
            let mut polynomial = [[0; TERMS]; 2];
            polynomial[0][15] = 2 * unit;
            let series = series_of(&polynomial);
            assert!(series.parts.iter().flatten().all(|c| *c == Coefficient::ZERO), "{unit}: {series:?}");
        }
    }

    #[test]
    fn terms_are_left_out_up_to_a_sum() {
        let mut series = series_of(&polynomial(0.3, 1.0));
        let size = |series: &Chebyshev, degree: usize| -> i64 {
            series.parts.iter().map(|part| part[degree].value().abs()).sum()
        };
        let [last, before, third] = [15, 14, 13].map(|degree| size(&series, degree));
        series.leave_out(last + before - 1);
        assert_eq!((series.terms, series.left_out), (15, [last, 225 * last]));
        // what was left out before counts
        series.leave_out(before + third);
        assert_eq!(series.terms, 14);
        series.halve(Wanted::Lower);
        assert_eq!(series.left_out, [last + before, (225 * last + 196 * before + 1) / 2]);
    }
}
