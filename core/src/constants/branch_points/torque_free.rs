//! Branch points of a body without torque: the limit e₃ → ∞ with p g e₃ = |m|²/2A.
//!
//! The angular momentum m is constant, and the axis turns about it. The reduced equation becomes
//!
//! ```text
//! A² u'² = (|m|² - n²)(1 - u²) - (l - n u)² = |m|² (u - e₁)(e₂ - u)
//! |m|² (1 - e₁)(1 - e₂) = (l - n)²,    |m|² (1 + e₁)(1 + e₂) = (l + n)²
//! ```

use crate::constants::FirstIntegrals;
use crate::constants::branch_points::BranchPoints;
use crate::constants::first_integrals::ReducedPoint;
use crate::error::{ParameterError, require};
use crate::scalar::{Extended, Float, Ring};
use crate::top::{Quantities, Top};

impl BranchPoints<Extended> {
    /// Branch points of the motion through a point; e₁ = e₂ = u for a body at rest.
    #[inline(never)] // the stack frames of a launch must not add up
    pub(super) fn torque_free(
        top: &Top,
        integrals: &FirstIntegrals<Extended>,
        point: &ReducedPoint<Extended>,
    ) -> Self {
        let a = Quantities::<Extended>::of(top).a;
        let FirstIntegrals { n, l_plus_n, l_minus_n, .. } = *integrals;
        let momentum = point.momentum(a, n);
        if momentum == Extended::ZERO {
            return Self::without_weight(point.one_plus_u, point.one_minus_u, Extended::ZERO);
        }
        let products = [l_plus_n, l_minus_n].map(|sum| (sum / momentum).squared());
        // (e₁ - u) + (e₂ - u) = 2 (l n/|m|² - u), and (e₁ - u)(e₂ - u) = -(A u'/|m|)²
        let ReducedPoint { u, one_minus_u, one_plus_u, udot, axis_energy } = *point;
        let l_minus_nu =
            if u > Extended::ZERO { l_minus_n + n * one_minus_u } else { l_plus_n - n * one_plus_u };
        let half_sum = (n * l_minus_nu - u * (a * axis_energy).doubled()) / momentum.squared();
        let half_difference = (half_sum.squared() + (a * udot / momentum).squared()).sqrt();
        Self::of_products(products, half_difference.doubled())
    }

    /// Branch points of given integrals, with |m|² = n² + 2A (h - C ⟨ω, r⟩²/2) and e₂ - e₁ = 2 √((|m|² - l²)(|m|² -
    /// n²))/|m|².
    pub(super) fn torque_free_integrals(
        top: &Top,
        integrals: &FirstIntegrals<Extended>,
    ) -> Result<Self, ParameterError> {
        let Quantities { a, c, .. } = Quantities::<Extended>::of(top);
        let FirstIntegrals { l, n, h, spin, l_plus_n, l_minus_n } = *integrals;
        let across = a * (h.doubled() - c * spin.squared());
        let square = across + n.squared();
        let noise = (a * h.abs() + n.squared() + l.squared()) * Extended::from(1e-15);
        let horizontal = square - l.squared();
        let possible = across >= -noise && horizontal >= -noise && square > Extended::ZERO;
        require(possible, "h", "the energy of some motion with these l and n (it is too low)")?;
        let momentum = square.sqrt();
        let products = [l_plus_n, l_minus_n].map(|sum| (sum / momentum).squared());
        let at_least_0 = |x: Extended| if x > Extended::ZERO { x } else { Extended::ZERO };
        let product = at_least_0(horizontal) * at_least_0(across);
        Ok(Self::of_products(products, (product.sqrt() / square).doubled()))
    }

    /// Branch points from (1 + e₁)(1 + e₂), (1 - e₁)(1 - e₂) and e₂ - e₁.
    fn of_products([above, below]: [Extended; 2], e2_minus_e1: Extended) -> Self {
        // the smaller of two positive numbers with this product and difference
        let smaller = |product: Extended| {
            let sum = (e2_minus_e1.squared() + product.doubled().doubled()).sqrt();
            if product > Extended::ZERO { product.doubled() / (e2_minus_e1 + sum) } else { Extended::ZERO }
        };
        Self::without_weight(smaller(above), smaller(below), e2_minus_e1)
    }

    fn without_weight(one_plus_e1: Extended, one_minus_e2: Extended, e2_minus_e1: Extended) -> Self {
        // larger than every `f64`
        let infinite = Extended::ONE / Extended::ZERO;
        Self {
            e1: one_plus_e1 - Extended::ONE,
            e2: Extended::ONE - one_minus_e2,
            e3: infinite,
            one_plus_e1,
            one_minus_e2,
            e2_minus_e1,
            e3_minus_e2: infinite,
            e3_minus_one: infinite,
        }
    }
}
