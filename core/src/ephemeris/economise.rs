//! Reduction of a polynomial's degree (economisation): multiples of Chebyshev polynomials are subtracted, the highest
//! degree first.

use crate::ephemeris::polynomial::Polynomial;
use crate::law::series::{Split, TERMS};
use crate::scalar::Float;

/// Number of coefficients of a Chebyshev polynomial of degree 15 that are not 0.
const HALF: usize = TERMS / 2;

/// Coefficients of T_n/2^{n-1} for every degree n, of x^n, x^{n-2}, ..., in units of 2^-14. All are exact.
#[allow(clippy::indexing_slicing)] // evaluated by the compiler, which would refuse an index out of range
static CHEBYSHEV: [[i32; HALF]; TERMS] = {
    let mut table = [[0; HALF]; TERMS];
    let mut degree = 1;
    while degree < TERMS {
        // Σ (-1)^j n/(n-j) C(n-j, j)/4^j x^{n-2j}, each coefficient from the one before
        let (mut coefficient, mut j) = (1 << SCALE, 0);
        while j < HALF && 2 * j <= degree {
            table[degree][j] = coefficient;
            let power = (degree - 2 * j) as i32;
            let falling = power * (power - 1);
            if falling > 0 {
                coefficient = -coefficient * falling / (4 * (j + 1) * (degree - j - 1)) as i32;
            }
            j += 1;
        }
        degree += 1;
    }
    table
};

/// Fraction bits of [`CHEBYSHEV`].
const SCALE: u32 = 14;

/// Reduces a polynomial to `terms` coefficients, at least one, by subtracting multiples of Chebyshev polynomials. Returns upper bounds on
/// the changes of |α|, or |β|, and of its derivative on [-1, 1]: the change of each part is at most the sum of the multiples, and that of
/// its derivative the sum of their products with the degree squared. They are in units of 2^-62.
pub(crate) fn economise(polynomial: &mut Polynomial, terms: usize) -> [f32; 2] {
    let degrees = terms.max(1)..polynomial.terms;
    polynomial.terms = polynomial.terms.min(terms);
    let [re, im] = polynomial.parts.each_mut().map(|part| {
        let (mut dropped, mut dropped_slopes) = (0, 0);
        for (degree, chebyshev) in CHEBYSHEV.iter().enumerate().take(degrees.end).skip(degrees.start).rev() {
            let Some((leading, lower)) = part.get_mut(..=degree).and_then(|part| part.split_last_mut())
            else {
                continue;
            };
            if *leading == 0 {
                continue;
            }
            let (size, parts) = (leading.abs(), Split::of(*leading));
            *leading = 0;
            // from x^{n-2} on
            for (entry, coefficient) in
                lower.iter_mut().rev().skip(1).step_by(2).zip(chebyshev.iter().skip(1))
            {
                *entry -= parts.times::<SCALE>(*coefficient);
            }
            // rounded up
            let squared = (degree * degree) as i64;
            dropped += (size >> (degree - 1)) + 1;
            dropped_slopes += (size.saturating_mul(squared) >> (degree - 1)) + 1;
        }
        [dropped, dropped_slopes].map(|sum| sum as f32)
    });
    let ([re, re_slope], [im, im_slope]) = (re, im);
    [[re, im], [re_slope, im_slope]].map(|[re, im]| Float::sqrt(re * re + im * im))
}

/// Estimated sum of the omitted terms of a series, in units of 2^-62: its last four terms are continued as a geometric series.
/// The result is infinite where these terms do not decrease.
pub(crate) fn omitted_terms(part: &[i64; TERMS]) -> f32 {
    /// Magnitude below which terms are rounding errors and need not decrease: 3e-17 in units of 2^-62.
    const NEGLIGIBLE: i64 = 138;
    let [.., c12, c13, c14, c15] = part.map(i64::abs);
    // in pairs, because a series may be even or odd
    let (before, last) = (c12 + c13, c14 + c15);
    if last <= NEGLIGIBLE {
        return 0.0;
    }
    let (before, last) = (before as f32, last as f32);
    let ratio = last / before;
    if ratio < 1.0 { last * ratio / (1.0 - ratio) } else { f32::INFINITY }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::law::series::UNIT;

    #[test]
    fn economising_stays_within_what_it_says() {
        let mut exact = [0; TERMS];
        exact
            .iter_mut()
            .enumerate()
            .for_each(|(k, c)| *c = (0.2 * 0.3_f64.powi(k as i32) * (1.0 + (k as f64).sin()) / UNIT) as i64);
        for terms in 1..TERMS {
            let mut polynomial = Polynomial::of([exact, [0; TERMS]]);
            let [bound, slope_bound] = economise(&mut polynomial, terms).map(|bound| UNIT * f64::from(bound));
            let [short, nothing] = polynomial.parts;
            assert_eq!((nothing, polynomial.terms), ([0; TERMS], terms));
            assert!(short[terms..].iter().all(|c| *c == 0));
            let number = |c: &i64| *c as f64 * UNIT;
            let value = |p: &[i64; TERMS], x: f64| p.iter().rev().fold(0.0, |sum, c| sum * x + number(c));
            let points = if cfg!(miri) { 40 } else { 1000 };
            let slope = |p: &[i64; TERMS], x: f64| {
                p.iter().enumerate().skip(1).rev().fold(0.0, |sum, (k, c)| sum * x + k as f64 * number(c))
            };
            let greatest = |of: &dyn Fn(&[i64; TERMS], f64) -> f64| {
                (0..=points).fold(0.0_f64, |worst, i| {
                    let x = 2.0 * f64::from(i) / f64::from(points) - 1.0;
                    worst.max((of(&short, x) - of(&exact, x)).abs())
                })
            };
            for (worst, bound) in [(greatest(&value), bound), (greatest(&slope), slope_bound)] {
                assert!(
                    worst <= bound * 1.000_001 + 1e-15 && worst > 0.3 * bound,
                    "{terms}: {worst:e} {bound:e}"
                );
            }
        }
    }
}
