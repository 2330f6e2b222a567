//! Short polynomials out of long ones: multiples of Chebyshev polynomials are taken off from the top.

use crate::nutation::series::TERMS;
use crate::real::Float;

/// The coefficients, lowest first, of Re α, Im α, Re β and Im β as polynomials in x ∈ [-1, 1] on one segment.
pub(crate) type Polynomials = [[f64; TERMS]; 4];

/// Shortens all four to `terms` coefficients by taking off multiples of Chebyshev polynomials from the top; returns a bound
/// of the change on [-1, 1], as an orientation error: the sum of the multiples bounds that of each.
pub(super) fn economise(polynomials: &mut Polynomials, terms: usize) -> f64 {
    let mut dropped = [0.0; 4];
    for degree in (terms.max(1)..TERMS).rev() {
        let leading = polynomials.each_ref().map(|polynomial| polynomial.get(degree).copied().unwrap_or(0.0));
        if leading == [0.0; 4] {
            continue;
        }
        // T_n/2^{n-1} = Σ (-1)^j n/(n-j) C(n-j, j)/4^j x^{n-2j}, each term from the one before
        let n = degree as f64;
        let mut coefficient = 1.0;
        for j in 0..=degree / 2 {
            for (polynomial, leading) in polynomials.iter_mut().zip(leading) {
                if let Some(entry) = polynomial.get_mut(degree - 2 * j) {
                    *entry -= leading * coefficient;
                }
            }
            let (j, power) = (j as f64, n - 2.0 * j as f64);
            coefficient *= -power * (power - 1.0) / (4.0 * (j + 1.0) * (n - j - 1.0).max(1.0));
        }
        let scale = 1.0 / (1_u64 << (degree - 1)) as f64;
        dropped.iter_mut().zip(leading).for_each(|(sum, leading)| *sum += Float::abs(leading) * scale);
    }
    2.0 * Float::sqrt(dropped.into_iter().fold(0.0, |sum, dropped| sum + dropped * dropped))
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
            let mut four = [exact, [0.0; TERMS], [0.0; TERMS], [0.0; TERMS]];
            let bound = 0.5 * economise(&mut four, terms);
            let [short, ..] = four;
            assert!(short[terms..].iter().all(|c| c.abs() < 1e-16));
            let value = |p: &[f64; TERMS], x: f64| p.iter().rev().fold(0.0, |sum, c| sum * x + c);
            let worst = (0..=1000).fold(0.0_f64, |worst, i| {
                let x = f64::from(i) / 500.0 - 1.0;
                worst.max((value(&short, x) - value(&exact, x)).abs())
            });
            assert!(
                worst <= bound * 1.000_001 + 1e-15 && worst > 0.3 * bound,
                "{terms}: {worst:e} {bound:e}"
            );
        }
    }
}
