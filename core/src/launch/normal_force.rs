//! The force of the plane: N = 1 + s u''/g in units of the weight, and its least value over a motion.
//!
//! Nothing in the equations stops N < 0; a real top would then leave the plane. With f = (u - e₁)(u - e₂)(u - e₃)
//! and u'²/2 = g f/D, u'' = g d(f/D)/du is a rational function of u, so its minimum needs no sampling: the ends of
//! [e₁, e₂] and the zeros of a quartic between them.

use super::BranchPoints;
use crate::real::Float;

/// The least N over u in [e₁, e₂]. `a_over_p` = A/p and s in m.
pub(super) fn minimum(e: &BranchPoints, a_over_p: f64, s: f64) -> f64 {
    // About e₁, y = u - e₁ in [0, e₂ - e₁]: f = y (y - y₂)(y - y₃), D = d₀ - 2 s e₁ y - s y²
    let (y2, y3) = (e.e2_minus_e1, e.e3_minus_e2 + e.e2_minus_e1);
    let f = [0.0, y2 * y3, -(y2 + y3), 1.0];
    let one_minus_e1 = e.one_minus_e2 + e.e2_minus_e1;
    let d = [a_over_p + s * one_minus_e1 * e.one_plus_e1, -2.0 * s * e.e1, -s];
    let force = |y: f64| {
        let (value, slope) = (horner(&d, y), 2.0 * d[2] * y + d[1]);
        let f_slope = (3.0 * y + 2.0 * f[2]) * y + f[1];
        1.0 + s * (f_slope * value - horner(&f, y) * slope) / (value * value)
    };
    let stationary = stationary_points(&f, &d);
    let mut roots = [0.0; 4];
    let count = roots_between(&stationary, y2, &mut roots);
    roots.iter().take(count).fold(force(0.0).min(force(y2)), |least, &y| least.min(force(y)))
}

/// Coefficients (lowest first) of the numerator of d²(f/D)/du²: f″D² - 2f′D′D - fD″D + 2fD′². The fifth power cancels.
fn stationary_points(f: &[f64; 4], d: &[f64; 3]) -> [f64; 5] {
    let [_, f1, f2, f3] = *f;
    let [d0, d1, d2] = *d;
    let slope_f = [f1, 2.0 * f2, 3.0 * f3];
    let curve_f = [2.0 * f2, 6.0 * f3];
    let slope_d = [d1, 2.0 * d2];
    let value_d = [d0, d1, d2];
    let mut sum = [0.0; 8];
    add_product(&mut sum, 1.0, &curve_f, &value_d, &value_d);
    add_product(&mut sum, -2.0, &slope_f, &slope_d, &value_d);
    add_product(&mut sum, -2.0 * d2, f, &value_d, &[1.0]);
    add_product(&mut sum, 2.0, f, &slope_d, &slope_d);
    let [c0, c1, c2, c3, c4, ..] = sum;
    [c0, c1, c2, c3, c4]
}

/// sum += factor a b c, for polynomials with lowest coefficients first.
fn add_product(sum: &mut [f64; 8], factor: f64, a: &[f64], b: &[f64], c: &[f64]) {
    for (i, &x) in a.iter().enumerate() {
        for (j, &y) in b.iter().enumerate() {
            for (k, &z) in c.iter().enumerate() {
                if let Some(entry) = sum.get_mut(i + j + k) {
                    *entry += factor * x * y * z;
                }
            }
        }
    }
}

fn horner(polynomial: &[f64], x: f64) -> f64 {
    polynomial.iter().rev().fold(0.0, |value, &c| value * x + c)
}

/// The sign changes of a quartic in (0, end), found between those of its derivatives, one degree after the other; a
/// bisection of 60 halvings each. Returns how many.
fn roots_between(quartic: &[f64; 5], end: f64, roots: &mut [f64; 4]) -> usize {
    let mut count = 0;
    for degree in 1..=4 {
        // the (4 - degree)-th derivative
        let mut polynomial = *quartic;
        let mut length = 5;
        for _ in degree..4 {
            length -= 1;
            for power in 0..length {
                let next = polynomial.get(power + 1).copied().unwrap_or(0.0) * (power + 1) as f64;
                if let Some(entry) = polynomial.get_mut(power) {
                    *entry = next;
                }
            }
        }
        let polynomial = polynomial.get(..length).unwrap_or(&[]);
        let previous = *roots;
        let knots = previous.iter().copied().take(count).chain([end]);
        let mut left = 0.0;
        count = 0;
        for right in knots {
            let rising = horner(polynomial, left) < 0.0;
            if rising != (horner(polynomial, right) < 0.0)
                && let Some(root) = roots.get_mut(count)
            {
                *root = bisect(polynomial, left, right, rising);
                count += 1;
            }
            left = right;
        }
    }
    count
}

fn bisect(polynomial: &[f64], mut left: f64, mut right: f64, rising: bool) -> f64 {
    for _ in 0..60 {
        let middle = (left + right).halved();
        if (horner(polynomial, middle) < 0.0) == rising {
            left = middle;
        } else {
            right = middle;
        }
    }
    (left + right).halved()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_roots_of_a_quartic_are_found() {
        // (y - 0.1)(y - 0.2)(y - 0.5)(y - 0.9)
        let mut roots = [0.0; 4];
        assert_eq!(roots_between(&[0.009, -0.163, 0.89, -1.7, 1.0], 1.0, &mut roots), 4);
        let worst = roots
            .iter()
            .zip([0.1, 0.2, 0.5, 0.9])
            .fold(0.0_f64, |worst, (y, truth)| worst.max((y - truth).abs()));
        assert!(worst < 1e-14, "{roots:?}");
        assert_eq!(roots_between(&[0.009, -0.163, 0.89, -1.7, 1.0], 0.8, &mut roots), 3);
    }

    #[test]
    fn the_quartic_is_the_second_derivative() {
        let (f, d) = ([0.0, 0.7, -1.9, 1.0], [0.6, -0.8, -0.5]);
        let ratio = |y: f64| horner(&f, y) / horner(&d, y);
        let step = 1e-4;
        for y in [0.0, 0.1, 0.2, 0.3, 0.4] {
            let second = (ratio(y + step) - 2.0 * ratio(y) + ratio(y - step)) / (step * step);
            let ours = horner(&stationary_points(&f, &d), y);
            assert!((second * horner(&d, y).powi(3) - ours).abs() < 1e-5, "{y}: {ours}");
        }
    }

    /// Against a fine scan of the same rational function by central differences of f/D; where it is least at an end of the
    /// interval, and where between.
    #[test]
    fn the_minimum_is_not_undercut_by_a_scan() {
        for ([e1, e2, e3], a_over_p, s, is_between) in [
            ([0.7, 0.9, 100.0], 1.0, 1.0, false),
            ([-0.9, 0.95, 1.2], 0.05, 1.0, false),
            ([-0.5, 0.5, 3.0], 2.0, 0.3, false),
            ([-0.4, 0.86, 1.005], 0.13, 1.0, true),
            ([-0.95, 0.93, 1.01], 3.7, 1.0, true),
            ([0.5, 0.97, 1.002], 0.01, 0.5, true),
        ] {
            let e = BranchPoints::new(e1, e2, e3).unwrap();
            let least = minimum(&e, a_over_p, s);
            let ratio = |u: f64| (u - e1) * (u - e2) * (u - e3) / (a_over_p + s * (1.0 - u * u));
            let force = |i: u32| {
                let u = e1 + (e2 - e1) * f64::from(i) / 20_000.0;
                1.0 + s * (ratio(u + 1e-6) - ratio(u - 1e-6)) / 2e-6
            };
            let scan = (0..=20_000).map(force).fold(f64::INFINITY, f64::min);
            assert!(least <= scan + 1e-8 && least > scan - 1e-6, "{least} against {scan}");
            let ends = force(0).min(force(20_000));
            assert_eq!(scan < ends - 1e-3, is_between, "{scan}, at the ends {ends}");
        }
    }
}
