//! Branch points of the motion through a point (u, u') of the reduced curve, without cancellation:
//!
//! * With torque, e₁ - u <= 0 <= e₂ - u, so that their difference has no cancellation; likewise 1 - e₂ and 1 - e₃.
//! * With torque and an upright axis at rest, 1 is a double root, and the third root decides whether the top sleeps.
//! * Without torque e₃ is infinite, and the axis turns about the constant angular momentum m:
//!
//! ```text
//! A² u'² = (|m|² - n²)(1 - u²) - (l - n u)² = |m|² (u - e₁)(e₂ - u)
//! |m|² (1 - e₁)(1 - e₂) = (l - n)²,    |m|² (1 + e₁)(1 + e₂) = (l + n)²
//! ```

use super::{BranchPoints, MAX_E3};
use crate::body::{ParameterError, Top, check};
use crate::constants::cubic::Cubic;
use crate::constants::{FirstIntegrals, ReducedPoint};
use crate::scalar::{Extended, Float, Ring};

impl BranchPoints<Extended> {
    pub(crate) fn from_reduced_point(
        top: &Top,
        integrals: &FirstIntegrals<Extended>,
        point: &ReducedPoint,
        pause: &mut dyn FnMut(),
    ) -> Result<Self, ParameterError> {
        if top.is_torque_free() {
            return Ok(Self::torque_free(top, integrals, point));
        }
        let e = if point.is_sleeping() {
            Self::upright(top, integrals.n)
        } else {
            let energy_factor = top.energy_factor();
            let lower = LowerBranchPoints::new(top, energy_factor, integrals, point, pause);
            pause();
            Self::from_lower(&lower, energy_factor, integrals, point)
        };
        check(
            e.e3_minus_one <= MAX_E3.into(),
            "omega",
            "slow enough for e3 <= 1e14 (faster, a body feels no torque: Top::free is then exact)",
        )?;
        Ok(e)
    }

    /// Branch points from their differences.
    fn from_differences(
        one_plus_e1: Extended,
        one_minus_e2: Extended,
        e2_minus_e1: Extended,
        [e3_minus_e2, e3_minus_one]: [Extended; 2],
    ) -> Self {
        let one = Extended::ONE;
        Self {
            e1: one_plus_e1 - one,
            e2: one - one_minus_e2,
            e3: one + e3_minus_one,
            one_plus_e1,
            one_minus_e2,
            e2_minus_e1,
            e3_minus_e2,
            e3_minus_one,
        }
    }

    /// Branch points without torque; e₁ = e₂ = u for a body at rest.
    #[inline(never)]
    fn torque_free(top: &Top, integrals: &FirstIntegrals<Extended>, point: &ReducedPoint) -> Self {
        let a = top.a;
        let zero = Extended::ZERO;
        let FirstIntegrals { n, l_plus_n, l_minus_n, .. } = *integrals;
        // larger than every `f64`
        let infinite = [Extended::ONE / zero; 2];
        let momentum = point.momentum(a, n);
        if momentum == zero {
            return Self::from_differences(point.one_plus_u, point.one_minus_u, zero, infinite);
        }
        // (e₁ - u) + (e₂ - u) = 2 (l n/|m|² - u), and (e₁ - u)(e₂ - u) = -(A u'/|m|)²
        let half_sum = (n * integrals.l_minus_nu(point) - point.u * (a * point.scaled_axis_energy).doubled())
            / momentum.squared();
        let half_difference = (half_sum.squared() + (a * point.udot / momentum).squared()).sqrt();
        let e2_minus_e1 = half_difference.doubled();
        let [one_plus_e1, one_minus_e2] =
            [l_plus_n, l_minus_n].map(|sum| smaller_factor((sum / momentum).squared(), e2_minus_e1));
        Self::from_differences(one_plus_e1, one_minus_e2, e2_minus_e1, infinite)
    }

    /// Branch points of an upright axis at rest. The third root n²/(2 A p g) - 1 is at least 1 for a sleeping top.
    #[inline(never)]
    fn upright(&Top { a, p, g, .. }: &Top, n: Extended) -> Self {
        let zero = Extended::ZERO;
        let two = Extended::ONE.doubled();
        let scale = (a * p * g).doubled();
        // n² - 4 A p g is rounded once, so that it is exactly 0 on the border
        let third_minus_one =
            Extended::difference_of_products([n, n], [(a * g).doubled().doubled(), p]) / scale;
        if third_minus_one >= zero {
            Self::from_differences(two, zero, zero, [third_minus_one; 2])
        } else {
            Self::from_differences(n.squared() / scale, zero, -third_minus_one, [zero; 2])
        }
    }

    /// All branch points from the lower two.
    #[inline(never)]
    fn from_lower(
        lower: &LowerBranchPoints,
        energy_factor: Extended,
        integrals: &FirstIntegrals<Extended>,
        point: &ReducedPoint,
    ) -> Self {
        let LowerBranchPoints { one_minus_e1, e2_minus_e1, e2_is_nearer_e1 } = *lower;
        let FirstIntegrals { n, l_plus_n, l_minus_n, .. } = *integrals;
        let ReducedPoint { one_minus_u, scaled_axis_energy, .. } = *point;
        let zero = Extended::ZERO;
        let one = Extended::ONE;
        // product and sum of 1 - e₂ and 1 - e₃
        let product = -energy_factor * l_minus_n.squared() / one_minus_e1;
        let sum = (-(scaled_axis_energy - one_minus_u - energy_factor * l_minus_n * n).doubled() - product)
            / one_minus_e1;
        let e3_minus_e2 = (sum.squared() - product.doubled().doubled()).sqrt();
        let (one_minus_e2, e3_minus_one) = if sum > zero {
            let one_minus_e2 = (sum + e3_minus_e2).halved();
            (one_minus_e2, -product / one_minus_e2)
        } else {
            let e3_minus_one = (e3_minus_e2 - sum).halved();
            (if e3_minus_one > zero { -product / e3_minus_one } else { zero }, e3_minus_one)
        };
        let e2_minus_e1 = if e2_is_nearer_e1 { e2_minus_e1 } else { one_minus_e1 - one_minus_e2 };
        let one_minus_e1 = one_minus_e2 + e2_minus_e1;
        let one_plus_e1 = if one_minus_e1 < one {
            one.doubled() - one_minus_e1
        } else {
            // (1 + e₁)(1 + e₂) = (l+n)²/(2 A p g (1 + e₃))
            smaller_factor(energy_factor * l_plus_n.squared() / (one.doubled() + e3_minus_one), e2_minus_e1)
        };
        Self::from_differences(one_plus_e1, one_minus_e2, e2_minus_e1, [e3_minus_e2, e3_minus_one])
    }
}

/// Smaller of two numbers, from their product and their difference.
fn smaller_factor(product: Extended, difference: Extended) -> Extended {
    let sum = (difference.squared() + product.doubled().doubled()).sqrt();
    if product > Extended::ZERO { product.doubled() / (difference + sum) } else { Extended::ZERO }
}

/// First two branch points, from the cubic in e - u.
struct LowerBranchPoints {
    one_minus_e1: Extended,
    e2_minus_e1: Extended,
    /// Whether e₂ - e₁ <= e₃ - e₂.
    e2_is_nearer_e1: bool,
}

impl LowerBranchPoints {
    #[inline(never)]
    fn new(
        top: &Top,
        energy_factor: Extended,
        integrals: &FirstIntegrals<Extended>,
        point: &ReducedPoint,
        pause: &mut dyn FnMut(),
    ) -> Self {
        let zero = Extended::ZERO;
        let n = integrals.n;
        let ReducedPoint { u, one_minus_u, one_plus_u, udot, scaled_axis_energy } = *point;
        let sine_squared = one_minus_u * one_plus_u;
        let g0 = top.length_d(sine_squared) * udot.squared() / top.g.doubled();
        let g1 = -(u * scaled_axis_energy).doubled() - sine_squared
            + (energy_factor * n * integrals.l_minus_nu(point)).doubled();
        let g2 = u.doubled() - scaled_axis_energy - energy_factor * n.squared();
        let cubic = Cubic { g0, g1, g2 };
        pause();
        let e3_minus_u = cubic.largest_root(pause);
        pause();
        // of e₁ - u and e₂ - u
        let (product, sum) = if e3_minus_u > zero {
            (-g0 / e3_minus_u, (g1 + g0 / e3_minus_u) / e3_minus_u)
        } else {
            (zero, -g2)
        };
        let e2_minus_e1 = (sum.squared() - product.doubled().doubled()).sqrt();
        let e2_minus_u = (sum + e2_minus_e1).halved();
        let e2_is_nearer_e1 = e2_minus_e1 <= e3_minus_u - e2_minus_u;
        let e1_minus_u = (sum - e2_minus_e1).halved();
        let e1_minus_u = if !e2_is_nearer_e1 {
            cubic.refined(e1_minus_u)
        } else if sum > zero && e2_minus_u > zero {
            product / e2_minus_u
        } else {
            e1_minus_u
        };
        let e1_minus_u = if e1_minus_u < zero { e1_minus_u } else { zero };
        Self { one_minus_e1: one_minus_u - e1_minus_u, e2_minus_e1, e2_is_nearer_e1 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Support;

    /// The sign and the size of a difference far below the rounding of its two terms.
    #[test]
    fn the_border_is_sharp() {
        let (factor, third) = (Extended::from(1.0 + f64::EPSILON), Extended::ONE / 3.0.into());
        let p = Extended::from(1.0 + f64::EPSILON) * 0.1.into();
        let (a, g) = (factor * 0.25.into(), 0.1.into());
        let top = Top { support: Support::Sliding, a, c: third, s: third, p, g, k: Extended::ZERO };
        let (n, scale) = (factor * Extended::from(0.1), (a * p * g).doubled());
        let third_minus_one = |n| {
            let e = BranchPoints::upright(&top, n);
            e.e3_minus_e2 - e.e2_minus_e1
        };
        assert_eq!(third_minus_one(n), Extended::ZERO);
        let least = Extended::from(1e-36);
        for (n, sign) in [(n + least, 1.0), (n - least, -1.0)] {
            let excess = third_minus_one(n) * scale / (n * least).doubled();
            assert!((excess.to_f64() - sign).abs() < 0.1, "{excess:?}");
        }
    }
}
