//! Branch points of an upright axis at rest: 1 is a double root, and the third root decides whether the top sleeps or
//! falls.

use crate::constants::BranchPoints;
use crate::constants::branch_points::{LARGEST_E3, TOO_FAST};
use crate::error::{ParameterError, require};
use crate::scalar::{Extended, Ring};
use crate::top::{Quantities, Top};

impl BranchPoints<Extended> {
    /// Branch points from n, which counts as exact. The third root is n²/(2 A p g) - 1; the top sleeps if it is at
    /// least 1. The number n² - 4 A p g has a single rounding, so its sign is correct and it is 0 exactly on the
    /// border of stability.
    #[inline(never)] // the stack frames of a launch must not add up
    pub(crate) fn upright(top: &Top, n: Extended) -> Result<Self, ParameterError> {
        let quantities = Quantities::<Extended>::of(top);
        let scale = (quantities.a * quantities.p * quantities.g).doubled();
        let gap = beyond_border(&quantities, n) / scale;
        require(gap < Extended::from(LARGEST_E3), "omega", TOO_FAST)?;
        let (zero, one) = (Extended::ZERO, Extended::ONE);
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

/// Difference n² - 4 A p g from the border of stability. Where its terms cancel, every step is exact: the factors are
/// multiplied by halves, and the leading parts are subtracted first.
fn beyond_border(quantities: &Quantities<Extended>, n: Extended) -> Extended {
    let Quantities { a, p, g, .. } = *quantities;
    let ([n_upper, n_lower], [p_upper, p_lower]) = (n.halves(), p.halves());
    let [ag_upper, ag_lower] = (a * g * Extended::from(4.0)).halves();
    let leading = n_upper.squared() - ag_upper * p_upper;
    let across = (n_upper * n_lower).doubled() - ag_upper * p_lower - ag_lower * p_upper;
    leading + across + (n_lower.squared() - ag_lower * p_lower)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::Float;

    /// The sign and the size of a difference far below the rounding of its two terms.
    #[test]
    fn the_border_is_sharp() {
        let (factor, third) = (Extended::from(1.0 + f64::EPSILON), Extended::ONE / 3.0.into());
        let p = Extended::product(1.0 + f64::EPSILON, 0.1);
        let quantities = |p| Quantities {
            a: factor * 0.25.into(),
            c: third,
            s: third,
            p,
            g: 0.1.into(),
            k: Extended::ZERO,
        };
        let n = factor * Extended::from(0.1);
        assert_eq!(beyond_border(&quantities(p), n), Extended::ZERO);
        let least = Extended::from(1e-36);
        for (n, sign) in [(n + least, 1.0), (n - least, -1.0)] {
            let beyond = beyond_border(&quantities(p), n) / (n * least).doubled();
            assert!((beyond.to_f64() - sign).abs() < 0.1, "{beyond:?}");
        }
    }
}
