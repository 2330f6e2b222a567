//! Reduction of a polynomial's degree (economisation): multiples of Chebyshev polynomials are subtracted, the highest
//! degree first.

use crate::law::series::{PER_POWER, TERMS};
use crate::scalar::Float;

/// Coefficients of α or of β as a polynomial in x ∈ [-1, 1] on one segment, lowest power first: real and imaginary
/// parts.
pub(crate) type Polynomial<'a> = [&'a mut [f64; TERMS]; 2];

/// Reduces both parts to `terms` coefficients by subtracting multiples of Chebyshev polynomials. Returns an upper
/// bounds on the changes of |α|, or |β|, and of its derivative on [-1, 1]: the change of each part is at most the sum of
/// the multiples, and that of its derivative the sum of their products with the degree squared.
pub(crate) fn economise([re, im]: Polynomial<'_>, terms: usize) -> [f64; 2] {
    let inverse = |k: usize| PER_POWER.get(k.wrapping_sub(1)).copied().unwrap_or(1.0);
    let (mut dropped, mut dropped_slopes) = ([0.0; 2], [0.0; 2]);
    for degree in (terms.max(1)..TERMS).rev() {
        let leading = [&*re, &*im].map(|part| part.get(degree).copied().unwrap_or(0.0));
        if leading == [0.0; 2] {
            continue;
        }
        // T_n/2^{n-1} = Σ (-1)^j n/(n-j) C(n-j, j)/4^j x^{n-2j}, each coefficient from the one before
        let mut coefficient = 1.0;
        for j in 0..=degree / 2 {
            let power = degree - 2 * j;
            for (part, leading) in [&mut *re, &mut *im].into_iter().zip(leading) {
                if let Some(entry) = part.get_mut(power) {
                    *entry -= leading * coefficient;
                }
            }
            let falling = (power * power.saturating_sub(1)) as f64;
            coefficient *= -0.25 * falling * inverse(j + 1) * inverse(degree - j - 1);
        }
        let scale = 1.0 / (1_u64 << (degree - 1)) as f64;
        let squared = (degree * degree) as f64;
        for ((sum, slopes), leading) in dropped.iter_mut().zip(&mut dropped_slopes).zip(leading) {
            let multiple = Float::abs(leading) * scale;
            *sum += multiple;
            *slopes += multiple * squared;
        }
    }
    [dropped, dropped_slopes].map(|[re, im]| Float::sqrt(re * re + im * im))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn economising_stays_within_what_it_says() {
        let mut exact = [0.0; TERMS];
        exact
            .iter_mut()
            .enumerate()
            .for_each(|(k, c)| *c = 0.3_f64.powi(k as i32) * (1.0 + (k as f64).sin()));
        for terms in 1..TERMS {
            let (mut short, mut nothing) = (exact, [0.0; TERMS]);
            let [bound, slope_bound] = economise([&mut short, &mut nothing], terms);
            assert_eq!(nothing, [0.0; TERMS]);
            assert!(short[terms..].iter().all(|c| c.abs() < 1e-16));
            let value = |p: &[f64; TERMS], x: f64| p.iter().rev().fold(0.0, |sum, c| sum * x + c);
            let points = if cfg!(miri) { 40 } else { 1000 };
            let slope = |p: &[f64; TERMS], x: f64| {
                p.iter().enumerate().skip(1).rev().fold(0.0, |sum, (k, c)| sum * x + k as f64 * c)
            };
            let greatest = |of: &dyn Fn(&[f64; TERMS], f64) -> f64| {
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
