//! Branch points e₁ <= e₂ <= 1 <= e₃ of the hyperelliptic curve, and their small differences (section 3.2 of the
//! paper).
//!
//! On the motion, (s/2)(e₄² - u²) u'² = g (u - e₁)(u - e₂)(u - e₃). The differences that can become small determine
//! the period and the phases. Each is stored as a number of its own; it is computed without cancellation and never by
//! subtracting stored branch points.

mod cubic;
mod integrals;
mod lower_pair;
mod torque_free;
mod upright;

use crate::constants::FirstIntegrals;
use crate::constants::first_integrals::{MovingAxis, ReducedPoint};
use crate::error::{ParameterError, finite, require};
use crate::scalar::{Extended, Float};
use crate::state::State;
use crate::top::Top;
pub(crate) use lower_pair::{LowerPair, LowerPairSearch};

/// Branch points and their differences; none has a unit.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BranchPoints<F = f64> {
    /// Least u of the motion, e₁ >= -1.
    pub e1: F,
    /// Greatest u of the motion, e₂ <= 1.
    pub e2: F,
    /// Third branch point, e₃ >= 1; infinite without torque, like its differences.
    pub e3: F,
    /// 1 + e₁ >= 0.
    pub one_plus_e1: F,
    /// 1 - e₂ >= 0.
    pub one_minus_e2: F,
    /// e₂ - e₁ >= 0.
    pub e2_minus_e1: F,
    /// e₃ - e₂ >= 0.
    pub e3_minus_e2: F,
    /// e₃ - 1 >= 0.
    pub e3_minus_one: F,
}

/// Largest e₃ that is accepted. Beyond it the torque changes the motion by less than the rounding of a state, and `f32`
/// would overflow.
pub(crate) const LARGEST_E3: f64 = 1e14;

/// Allowed range in the error message for a body that turns too fast for [`LARGEST_E3`].
pub(crate) const TOO_FAST: &str = "slow enough for e3 <= 1e14 (faster, a body feels no torque: support = \"free\", Top::free, is then exact)";

impl BranchPoints {
    /// Branch points from three given numbers, which count as exact.
    ///
    /// # Errors
    /// `e1`, `e2`, `e3`: not finite, or not -1 <= e1 <= e2 <= 1 <= e3 <= 1e14.
    pub fn new(e1: f64, e2: f64, e3: f64) -> Result<Self, ParameterError> {
        Ok(BranchPoints::<Extended>::exact(e1, e2, e3)?.to_f64())
    }

    /// Branch points of a state. Every field, differences included, has the relative error of one `f64` rounding.
    ///
    /// # Errors
    /// `omega`: so large that e₃ would exceed 1e14.
    pub fn of(top: &Top, state: &State) -> Result<Self, ParameterError> {
        let (integrals, point) = FirstIntegrals::<Extended>::with_point(top, &MovingAxis::of(state));
        Ok(BranchPoints::of_point(top, &integrals, &point)?.to_f64())
    }

    /// Greatest sine of the tilt between u = e₁ and u = e₂.
    pub(crate) fn greatest_sine(&self) -> f64 {
        // sin² = (1 - u)(1 + u)
        let squared = if self.e1 > 0.0 {
            self.one_plus_e1 * (self.one_minus_e2 + self.e2_minus_e1)
        } else if self.e2 < 0.0 {
            self.one_minus_e2 * (self.one_plus_e1 + self.e2_minus_e1)
        } else {
            1.0
        };
        Float::sqrt(squared)
    }
}

impl BranchPoints<Extended> {
    /// Branch points of the motion through a point of the reduced curve.
    pub(crate) fn of_point(
        top: &Top,
        integrals: &FirstIntegrals<Extended>,
        point: &ReducedPoint<Extended>,
    ) -> Result<Self, ParameterError> {
        match Self::begin(top, integrals, point)? {
            Roots::All(e) => Ok(e),
            Roots::LowerPair(search) => Self::completed(search, integrals, point),
        }
    }

    /// First step of [`BranchPoints::of_point`]; [`BranchPoints::complete`] is the last.
    pub(crate) fn begin(
        top: &Top,
        integrals: &FirstIntegrals<Extended>,
        point: &ReducedPoint<Extended>,
    ) -> Result<Roots<Extended>, ParameterError> {
        if top.is_torque_free() {
            Ok(Roots::All(Self::torque_free(top, integrals, point)))
        } else if point.rests_upright() {
            Self::upright(top, integrals.n).map(Roots::All)
        } else {
            LowerPairSearch::new(top, integrals, point).map(Roots::LowerPair)
        }
    }
}

/// All branch points where they are known at once, otherwise the search for the first two.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Roots<F> {
    All(BranchPoints<F>),
    LowerPair(LowerPairSearch<F>),
}

impl<F: Float> BranchPoints<F> {
    /// Branch points of the motion through a point where gravity acts and the axis does not rest upright.
    pub(crate) fn with_torque(
        top: &Top,
        integrals: &FirstIntegrals<F>,
        point: &ReducedPoint<F>,
    ) -> Result<Self, ParameterError> {
        Self::completed(LowerPairSearch::new(top, integrals, point)?, integrals, point)
    }

    fn completed(
        mut search: LowerPairSearch<F>,
        integrals: &FirstIntegrals<F>,
        point: &ReducedPoint<F>,
    ) -> Result<Self, ParameterError> {
        loop {
            if let Some(pair) = search.proceed() {
                return Self::complete(&pair, integrals, point);
            }
        }
    }

    pub(crate) fn exact(e1: f64, e2: f64, e3: f64) -> Result<Self, ParameterError> {
        for (name, e) in [("e1", e1), ("e2", e2), ("e3", e3)] {
            finite(name, e)?;
        }
        require((-1.0..=1.0).contains(&e1), "e1", "in [-1, e2]")?;
        require((e1..=1.0).contains(&e2), "e2", "in [e1, 1]")?;
        require((1.0..=LARGEST_E3).contains(&e3), "e3", "in [1, 1e14]")?;
        let [e1, e2, e3] = [e1, e2, e3].map(F::from_f64);
        Ok(Self {
            e1,
            e2,
            e3,
            one_plus_e1: F::ONE + e1,
            one_minus_e2: F::ONE - e2,
            e2_minus_e1: e2 - e1,
            e3_minus_e2: e3 - e2,
            e3_minus_one: e3 - F::ONE,
        })
    }

    /// Branch points, computed from a point (u, u') of the motion.
    ///
    /// Two forms of the cubic avoid all cancellation. In the variable e - u the roots e₁ - u and e₂ - u have opposite
    /// signs, which gives e₂ - e₁ ([`LowerPairSearch`]); in the variable 1 - e the roots 1 - e₂ and 1 - e₃ have opposite signs,
    /// which gives e₃ - e₂, 1 - e₂ and e₃ - 1.
    pub(crate) fn complete(
        pair: &LowerPair<F>,
        integrals: &FirstIntegrals<F>,
        point: &ReducedPoint<F>,
    ) -> Result<Self, ParameterError> {
        let LowerPair { kappa, x1, e2_minus_e1, is_closer } = *pair;
        let FirstIntegrals { n, l_plus_n, l_minus_n, .. } = *integrals;
        let ReducedPoint { one_minus_u, axis_energy, .. } = *point;
        // sum x₂ + x₃ and product x₂ x₃ of the two upper roots, with x = 1 - e
        let x_product = -kappa * l_minus_n.squared() / x1;
        let x_sum = (-(axis_energy - one_minus_u - kappa * l_minus_n * n).doubled() - x_product) / x1;
        let e3_minus_e2 = (x_sum.squared() - x_product.doubled().doubled()).sqrt();
        let (one_minus_e2, e3_minus_one) = if x_sum > F::ZERO {
            let x2 = (x_sum + e3_minus_e2).halved();
            (x2, -x_product / x2)
        } else {
            let x3 = (e3_minus_e2 - x_sum).halved();
            (if x3 > F::ZERO { -x_product / x3 } else { F::ZERO }, x3)
        };
        let e2_minus_e1 = if is_closer { e2_minus_e1 } else { x1 - one_minus_e2 };
        let two = F::from_f64(2.0);
        let one_minus_e1 = one_minus_e2 + e2_minus_e1;
        let one_plus_e1 = if one_minus_e1 < F::ONE {
            two - one_minus_e1
        } else {
            // (1 + e₁)(1 + e₂) = κ (l+n)²/(1 + e₃), with e₂ - e₁ already known
            let quotient = kappa * l_plus_n.squared() / (two + e3_minus_one);
            let root = (e2_minus_e1.squared() + quotient.doubled().doubled()).sqrt();
            if quotient > F::ZERO { quotient.doubled() / (e2_minus_e1 + root) } else { F::ZERO }
        };
        require(e3_minus_one <= F::from_f64(LARGEST_E3), "omega", TOO_FAST)?;
        Ok(Self {
            e1: one_plus_e1 - F::ONE,
            e2: F::ONE - one_minus_e2,
            e3: F::ONE + e3_minus_one,
            one_plus_e1,
            one_minus_e2,
            e2_minus_e1,
            e3_minus_e2,
            e3_minus_one,
        })
    }

    /// Difference 1 - e₁.
    pub(crate) fn one_minus_e1(&self) -> F {
        self.one_minus_e2 + self.e2_minus_e1
    }

    /// Sum 1 + e₂.
    pub(crate) fn one_plus_e2(&self) -> F {
        self.one_plus_e1 + self.e2_minus_e1
    }

    /// Sum 1 + e₃.
    pub(crate) fn one_plus_e3(&self) -> F {
        F::from_f64(2.0) + self.e3_minus_one
    }

    /// Difference e₃ - e₁.
    pub(crate) fn e3_minus_e1(&self) -> F {
        self.e3_minus_e2 + self.e2_minus_e1
    }

    pub(crate) fn to_f64(self) -> BranchPoints {
        self.map(F::to_f64)
    }

    /// Branch points in another number type.
    pub(crate) fn map<G>(self, convert: impl Fn(F) -> G) -> BranchPoints<G> {
        BranchPoints {
            e1: convert(self.e1),
            e2: convert(self.e2),
            e3: convert(self.e3),
            one_plus_e1: convert(self.one_plus_e1),
            one_minus_e2: convert(self.one_minus_e2),
            e2_minus_e1: convert(self.e2_minus_e1),
            e3_minus_e2: convert(self.e3_minus_e2),
            e3_minus_one: convert(self.e3_minus_one),
        }
    }
}
