//! Normal force of the plane, N = 1 + s u''/g in units of the weight.
//!
//! By partial fractions of s u''/g
//!
//! N = (F₊/(e₄ - u)² + F₋/(e₄ + u)²)/2e₄ with F± = (e₄ ∓ e₁)(e₄ ∓ e₂)(e₄ ∓ e₃).
//!
//! If e₃ >= e₄, then F₊ <= 0, and N is least at e₂; it is 0 at (e₄ - u)/(e₄ + u) = √(-F₊/F₋). If e₃ < e₄, then N is convex, with the
//! minimum ((∛F₊ + ∛F₋)/2e₄)³ at (e₄ - u)/(e₄ + u) = ∛(F₊/F₋).

use crate::constants::BranchPoints;
use crate::constants::cubic::Cubic;
use crate::scalar::{Extended, Float, Ring};

/// Partial fractions of N.
struct PartialFractions {
    e4: Extended,
    e4_minus_one: Extended,
    /// Numerators F₊ at u = e₄ and F₋ > 0 at u = -e₄.
    plus: Extended,
    minus: Extended,
}

impl PartialFractions {
    /// Partial fractions from A/(ps) = e₄² - 1.
    fn new(e: &BranchPoints<Extended>, a_over_ps: Extended) -> Self {
        let e4 = (Extended::ONE + a_over_ps).sqrt();
        let e4_minus_one = a_over_ps / (Extended::ONE + e4);
        let plus = (e4_minus_one + e.one_minus_e1())
            * (e4_minus_one + e.one_minus_e2)
            * (e4_minus_one - e.e3_minus_one);
        let minus = (e4_minus_one + e.one_plus_e1)
            * (e4_minus_one + e.one_plus_e2())
            * (e4_minus_one + e.one_plus_e3());
        Self { e4, e4_minus_one, plus, minus }
    }
}

/// Least N over u in [e₁, e₂].
pub(crate) fn minimum(e: &BranchPoints<Extended>, a_over_ps: Extended) -> f64 {
    let PartialFractions { e4, e4_minus_one, plus, minus } = PartialFractions::new(e, a_over_ps);
    if plus > Extended::ZERO {
        let plus = cube_root(plus);
        let minus = cube_root(minus);
        // e₄ - u at the minimum is 2 e₄ ∛F₊/(∛F₊ + ∛F₋)
        if e4.doubled() * plus > (e4_minus_one + e.one_minus_e2) * (plus + minus) {
            let root = (plus + minus) / e4.doubled();
            return (root.squared() * root).to_f64();
        }
    }
    at_e2(e, a_over_ps)
}

/// 1 + u and 1 - u where N is 0; `None` where it is positive for all u.
pub(crate) fn sign_change(e: &BranchPoints<Extended>, a_over_ps: Extended) -> Option<[Extended; 2]> {
    let PartialFractions { e4, e4_minus_one, plus, minus } = PartialFractions::new(e, a_over_ps);
    let one = Extended::ONE;
    (plus < Extended::ZERO).then(|| {
        let q = (-plus / minus).sqrt();
        [(one + e4 - q * e4_minus_one) / (one + q), (q * (one + e4) - e4_minus_one) / (one + q)]
    })
}

/// N at u = e₂, where f' = -(e₂ - e₁)(e₃ - e₂).
fn at_e2(e: &BranchPoints<Extended>, a_over_ps: Extended) -> f64 {
    /// N that counts as 0.
    const FORCE_THAT_IS_ZERO: f64 = 1e-20;
    let d_over_s = a_over_ps + e.one_minus_e2 * e.one_plus_e2();
    let force = (d_over_s - e.e2_minus_e1 * e.e3_minus_e2) / d_over_s;
    if force.abs() > Extended::from(FORCE_THAT_IS_ZERO) { force.to_f64() } else { 0.0 }
}

/// Cube root of x > 0.
fn cube_root(x: Extended) -> Extended {
    Cubic { g0: -x, g1: Extended::ZERO, g2: Extended::ZERO }.largest_root(&mut || {})
}

#[cfg(test)]
mod tests {
    use super::*;

    fn least(e: [f64; 3], a_over_ps: f64) -> f64 {
        minimum(&BranchPoints::from_roots(e).unwrap(), a_over_ps.into())
    }

    /// Comparison with a fine scan of the same rational function, by central differences of f/D. Some cases have the
    /// minimum at e₂, the others between e₁ and e₂.
    #[test]
    fn the_minimum_is_not_undercut_by_a_scan() {
        for ([e1, e2, e3], a_over_ps, is_between) in [
            ([0.7, 0.9, 100.0], 1.0, false),
            ([-0.9, 0.95, 1.2], 0.05, false),
            ([-0.5, 0.5, 3.0], 2.0 / 0.3, false),
            ([-0.4, 0.86, 1.005], 0.13, true),
            ([-0.95, 0.93, 1.01], 3.7, true),
            ([0.5, 0.97, 1.002], 0.02, true),
        ] {
            let least = least([e1, e2, e3], a_over_ps);
            let ratio = |u: f64| (u - e1) * (u - e2) * (u - e3) / (a_over_ps + (1.0 - u * u));
            let force = |i: u32| {
                let u = e1 + (e2 - e1) * f64::from(i) / 20_000.0;
                1.0 + (ratio(u + 1e-6) - ratio(u - 1e-6)) / 2e-6
            };
            let scan = (0..=20_000).map(force).fold(f64::INFINITY, f64::min);
            assert!(least <= scan + 1e-8 && least > scan - 1e-6, "{least} against {scan}");
            let ends = force(0).min(force(20_000));
            assert_eq!(scan < ends - 1e-3, is_between, "{scan}, at the ends {ends}");
        }
    }

    /// Tops with A/(ps) = 2^-40, less than [`crate::Top`] admits; expected values by
    /// `tests/reference/normal_force.py`.
    #[test]
    fn the_minimum_keeps_its_digits_where_differences_are_small() {
        let small = |power: i32| libm::ldexp(1.0, -power);
        for (e, truth) in [
            ([-0.5, 1.0, 1.0 + small(30)], -1535.0),
            ([-0.5, 1.0 - small(38), 1.0 + small(41)], 0.25000000000060635),
            ([-0.5, 1.0 - small(45), 1.0 + small(45)], 0.250000004024345),
            ([-1.0 + small(40), 1.0 - small(20), 1.0 + small(50)], 6.932584669490062e-13),
            ([0.25, 1.0, 1.0 + small(41)], 0.625),
            ([1.0 - small(35), 1.0 - small(40), 1.0 + small(39)], 0.9999999999718057),
            ([-0.75, 0.5, 1.0 + small(20)], 0.1666650772104832),
        ] {
            let force = least(e, small(40));
            assert!((force / truth - 1.0).abs() <= f64::EPSILON, "{e:?}: {force:e} against {truth:e}");
        }
    }

    #[test]
    fn a_cube_root_cubes_back() {
        for x in [2.0, 1e-30, 12345.678, 1e40, 27.0] {
            let x = Extended::from(x);
            let root = cube_root(x);
            assert!(((root.squared() * root - x) / x).abs().to_f64() < 1e-31, "{x:?}");
        }
    }
}
