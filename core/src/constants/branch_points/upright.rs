//! Branch points of an upright axis at rest: 1 is a double root, and the third root decides whether the top sleeps or
//! falls.

use crate::constants::BranchPoints;
use crate::constants::branch_points::LARGEST_E3;
use crate::error::{ParameterError, require};
use crate::scalar::{DoubleDouble, Ring};
use crate::top::{Quantities, Top};

impl BranchPoints<DoubleDouble> {
    /// Branch points from n, which counts as exact. The third root is n²/(2 A p g) - 1; the top sleeps if it is at
    /// least 1. The number n² - 4 A p g has a single rounding, so its sign is correct and it is 0 exactly on the
    /// border of stability.
    pub(crate) fn upright(top: &Top, n: DoubleDouble) -> Result<Self, ParameterError> {
        let quantities = Quantities::<DoubleDouble>::of(top);
        let scale = (quantities.a * quantities.p * quantities.g).doubled();
        let gap = beyond_border(&quantities, n) / scale;
        require(gap < DoubleDouble::from(LARGEST_E3), "omega", "slow enough for e3 <= 1e14")?;
        let (zero, one) = (DoubleDouble::ZERO, DoubleDouble::ONE);
        let upright = Self {
            e1: one,
            e2: one,
            e3: one,
            one_plus_e1: one.doubled(),
            one_minus_e2: zero,
            e2_minus_e1: zero,
            e3_minus_e2: zero,
            e3_minus_one: zero,
        };
        Ok(if gap >= zero {
            Self { e3: one + gap, e3_minus_e2: gap, e3_minus_one: gap, ..upright }
        } else {
            let one_plus_e1 = n.squared() / scale;
            Self { e1: one_plus_e1 - one, one_plus_e1, e2_minus_e1: -gap, ..upright }
        })
    }
}

/// n² - 4 A p g, rounded once to double-double. A and g are `f64`; n and p are double-double.
fn beyond_border(quantities: &Quantities<DoubleDouble>, n: DoubleDouble) -> DoubleDouble {
    let Quantities { a, p, g, .. } = *quantities;
    let ag = DoubleDouble::product(-4.0 * a.hi(), g.hi());
    exact_sum([
        DoubleDouble::product(n.hi(), n.hi()),
        DoubleDouble::product(2.0 * n.hi(), n.lo()),
        DoubleDouble::product(n.lo(), n.lo()),
        DoubleDouble::product(ag.hi(), p.hi()),
        DoubleDouble::product(ag.hi(), p.lo()),
        DoubleDouble::product(ag.lo(), p.hi()),
        DoubleDouble::product(ag.lo(), p.lo()),
    ])
}

/// Number of parts of an exact sum of seven products.
const PARTS: usize = 14;

/// Sum of exact products, rounded to double-double once, at the end (Shewchuk's expansions).
fn exact_sum(products: [DoubleDouble; PARTS / 2]) -> DoubleDouble {
    // the sum of the terms so far as non-overlapping parts, the smallest first
    let mut parts = [0.0; PARTS];
    let terms = products.iter().flat_map(|product| [product.lo(), product.hi()]);
    for (count, term) in terms.enumerate() {
        let mut carry = term;
        for part in parts.iter_mut().take(count) {
            let sum = DoubleDouble::new(carry, *part);
            (carry, *part) = (sum.hi(), sum.lo());
        }
        if let Some(part) = parts.get_mut(count) {
            *part = carry;
        }
    }
    parts.into_iter().fold(DoubleDouble::ZERO, |sum, part| sum + part.into())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The sum is correct also where all leading parts cancel.
    #[test]
    fn a_sum_is_rounded_once() {
        let [large, small] = [1e200, 1e-80].map(|x| DoubleDouble::product(x, 1.0 + f64::EPSILON));
        let zero = DoubleDouble::ZERO;
        assert_eq!(exact_sum([large, small, -large, zero, zero, zero, zero]), small);
        assert_eq!(exact_sum([small, large, zero, -large, -small, zero, zero]), zero);
        let third = DoubleDouble::from(1.0) / DoubleDouble::from(3.0);
        let sum = exact_sum([large, third, small, -large, zero, -small, -third]);
        assert_eq!(sum.hi().to_bits() << 1, 0, "{sum:?}");
    }
}
