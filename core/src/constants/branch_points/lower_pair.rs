//! Difference of e₁ and e₂, from the cubic expanded about a point of the motion.

use crate::constants::FirstIntegrals;
use crate::constants::branch_points::cubic::{Cubic, LargestRoot};
use crate::constants::branch_points::{LARGEST_E3, TOO_FAST};
use crate::constants::first_integrals::ReducedPoint;
use crate::error::{ParameterError, require};
use crate::scalar::Float;
use crate::top::{Quantities, Top};

/// First two branch points, as far as the cubic expanded about a point of the motion determines them without cancellation.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LowerPair<F> {
    pub(super) kappa: F,
    /// Difference 1 - e₁.
    pub(super) x1: F,
    pub(super) e2_minus_e1: F,
    /// Whether e₂ - e₁ <= e₃ - e₂.
    pub(super) is_closer: bool,
}

/// Search for the first two branch points. The cubic has the roots y = e - u, where u belongs to the point of the motion.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LowerPairSearch<F> {
    kappa: F,
    one_minus_u: F,
    /// Search for y₃ = e₃ - u, and its result.
    search: LargestRoot<F>,
    y3: Option<F>,
}

impl<F: Float> LowerPairSearch<F> {
    #[inline(never)] // the stack frames of a launch must not add up
    pub(super) fn new(
        top: &Top,
        integrals: &FirstIntegrals<F>,
        point: &ReducedPoint<F>,
    ) -> Result<Self, ParameterError> {
        let quantities = Quantities::<F>::of(top);
        let kappa = quantities.kappa();
        let FirstIntegrals { n, l_plus_n, l_minus_n, .. } = *integrals;
        let ReducedPoint { u, one_minus_u, one_plus_u, udot, axis_energy } = *point;
        let limit = F::from_f64(LARGEST_E3);
        let of_spin = kappa * n.squared();
        require(of_spin < limit && axis_energy < limit, "omega", TOO_FAST)?;

        // l - n u, from the one of l ∓ n that causes no cancellation
        let l_minus_nu = if u > F::ZERO { l_minus_n + n * one_minus_u } else { l_plus_n - n * one_plus_u };
        let sine_squared = one_minus_u * one_plus_u;
        let d_of_u = quantities.a / quantities.p + quantities.s * sine_squared;
        let cubic = Cubic {
            g0: d_of_u * udot.squared() / quantities.g.doubled(),
            g1: -(u * axis_energy).doubled() - sine_squared + (kappa * n * l_minus_nu).doubled(),
            g2: u.doubled() - axis_energy - of_spin,
        };
        Ok(Self { kappa, one_minus_u, search: LargestRoot::new(cubic), y3: None })
    }

    /// Does the next slice of the work. Returns the result once it is complete.
    pub(crate) fn proceed(&mut self) -> Option<LowerPair<F>> {
        match self.y3 {
            Some(y3) => Some(self.pair(y3)),
            None => {
                self.y3 = self.search.proceed();
                None
            }
        }
    }

    #[inline(never)]
    fn pair(&self, y3: F) -> LowerPair<F> {
        let cubic = self.search.cubic();
        let Cubic { g0, g1, g2 } = *cubic;
        let (product, sum) = if y3 > F::ZERO { (-g0 / y3, (g1 + g0 / y3) / y3) } else { (F::ZERO, -g2) };
        let e2_minus_e1 = (sum.squared() - product.doubled().doubled()).sqrt();
        let y2 = (sum + e2_minus_e1).halved();
        let is_closer = e2_minus_e1 <= y3 - y2;
        let y1 = (sum - e2_minus_e1).halved();
        let y1 = if is_closer && sum > F::ZERO && y2 > F::ZERO { product / y2 } else { y1 };
        let y1 = if is_closer { y1 } else { cubic.polished(y1) };
        let y1 = if y1 < F::ZERO { y1 } else { F::ZERO };
        LowerPair { kappa: self.kappa, x1: self.one_minus_u - y1, e2_minus_e1, is_closer }
    }
}
