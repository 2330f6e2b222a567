//! Branch points e₁ <= e₂ <= 1 <= e₃ of the hyperelliptic curve, and their small differences (section 3.2 of the
//! paper).
//!
//! On the motion, (s/2)(e₄² - u²) u'² = g (u - e₁)(u - e₂)(u - e₃). The differences that can become small determine
//! the period and the phases. Each is stored as a number of its own; it is computed without cancellation and never by
//! subtracting stored branch points.

mod cubic;
mod torque_free;
mod upright;

use crate::constants::first_integrals::ReducedPoint;
use crate::constants::{FirstIntegrals, Signs};
use crate::error::{ParameterError, finite, require};
use crate::scalar::{Extended, Float, Ring};
use crate::state::State;
use crate::top::{Quantities, Top, Units};
use cubic::{largest_root, polished};

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

/// Allowed range in the refusal of a body that turns too fast for [`LARGEST_E3`].
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
        let (integrals, point) = FirstIntegrals::<Extended>::with_point(top, state);
        Ok(BranchPoints::of_point(top, &integrals, &point)?.to_f64())
    }

    /// Branch points of given l, n and h: the roots of the right-hand side of the reduced equation. Near a degenerate
    /// case they are ill-conditioned functions of l, n and h; where the state is known, use [`BranchPoints::of`].
    ///
    /// # Errors
    /// `h`: no motion has these integrals, because the energy is too low; `l`, `n`, `h`: not finite, or e₃ above
    /// 1e14.
    pub fn from_integrals(top: &Top, l: f64, n: f64, h: f64) -> Result<Self, ParameterError> {
        let unit = Units::of(top).inertia;
        let [l, n, h] = [finite("l", l)?, finite("n", n)?, finite("h", h)?].map(|number| number / unit);
        let integrals = exact_integrals(top, l, n, h);
        if top.is_torque_free() {
            return Ok(BranchPoints::torque_free_integrals(top, &integrals)?.to_f64());
        }
        let point = highest_point(top, &integrals)?;
        let refused = |_| ParameterError::OutOfRange { parameter: "h", allowed: "such that e3 <= 1e14" };
        Ok(BranchPoints::of_point(top, &integrals, &point).map_err(refused)?.to_f64())
    }

    /// First integrals of the motion with these branch points and signs (equation (3.6) of the paper). The four
    /// choices of signs have different integrals; where A and C differ, changing the sign of l - n also changes h.
    ///
    /// Without torque the branch points determine neither a rate nor the integrals, and the result has l = n = 0.
    #[must_use]
    pub fn integrals(&self, top: &Top, signs: Signs) -> FirstIntegrals {
        let lifted = self.lifted();
        lifted.integrals_in(top, signs).as_given(top)
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

    fn lifted(&self) -> BranchPoints<Extended> {
        let Self { e1, e2, e3, one_plus_e1, one_minus_e2, e2_minus_e1, e3_minus_e2, e3_minus_one } = *self;
        BranchPoints {
            e1: e1.into(),
            e2: e2.into(),
            e3: e3.into(),
            one_plus_e1: one_plus_e1.into(),
            one_minus_e2: one_minus_e2.into(),
            e2_minus_e1: e2_minus_e1.into(),
            e3_minus_e2: e3_minus_e2.into(),
            e3_minus_one: e3_minus_one.into(),
        }
    }
}

impl BranchPoints<Extended> {
    /// Branch points of the motion through a point of the reduced curve.
    pub(crate) fn of_point(
        top: &Top,
        integrals: &FirstIntegrals<Extended>,
        point: &ReducedPoint<Extended>,
    ) -> Result<Self, ParameterError> {
        if top.is_torque_free() {
            Ok(Self::torque_free(top, integrals, point))
        } else if point.rests_upright() {
            Self::upright(top, integrals.n)
        } else {
            Self::about(top, integrals, point)
        }
    }
}

impl<F: Float> BranchPoints<F> {
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
    /// signs, which gives e₂ - e₁; in the variable 1 - e the roots 1 - e₂ and 1 - e₃ have opposite signs, which gives
    /// e₃ - e₂, 1 - e₂ and e₃ - 1.
    fn about(
        top: &Top,
        integrals: &FirstIntegrals<F>,
        point: &ReducedPoint<F>,
    ) -> Result<Self, ParameterError> {
        let quantities = Quantities::<F>::of(top);
        let kappa = quantities.kappa();
        let FirstIntegrals { n, l_plus_n, l_minus_n, .. } = *integrals;
        let ReducedPoint { u, one_minus_u, one_plus_u, udot, axis_energy } = *point;
        let limit = F::from_f64(LARGEST_E3);
        require(kappa * n.squared() < limit && axis_energy < limit, "omega", TOO_FAST)?;

        // l - n u, from the one of l ∓ n that causes no cancellation
        let l_minus_nu = if u > F::ZERO { l_minus_n + n * one_minus_u } else { l_plus_n - n * one_plus_u };
        // y³ + g₂ y² + g₁ y + g₀ = (y - y₁)(y - y₂)(y - y₃) with y = e - u
        let d_of_u = quantities.a / quantities.p + quantities.s * one_minus_u * one_plus_u;
        let g0 = d_of_u * udot.squared() / quantities.g.doubled();
        let g1 = -(u * axis_energy).doubled() - one_minus_u * one_plus_u + (kappa * n * l_minus_nu).doubled();
        let g2 = u.doubled() - axis_energy - kappa * n.squared();
        let y3 = largest_root(g0, g1, g2);
        let (product, sum) = if y3 > F::ZERO { (-g0 / y3, (g1 + g0 / y3) / y3) } else { (F::ZERO, -g2) };
        let e2_minus_e1 = (sum.squared() - product.doubled().doubled()).sqrt();
        let y2 = (sum + e2_minus_e1).halved();
        let lower_pair_is_closer = e2_minus_e1 <= y3 - y2;
        let y1 = (sum - e2_minus_e1).halved();
        let y1 = if lower_pair_is_closer && sum > F::ZERO && y2 > F::ZERO { product / y2 } else { y1 };
        let y1 = if lower_pair_is_closer { y1 } else { polished(y1, g0, g1, g2) };
        let y1 = if y1 < F::ZERO { y1 } else { F::ZERO };

        // sum x₂ + x₃ and product x₂ x₃ of the two upper roots, with x = 1 - e
        let x1 = one_minus_u - y1;
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
        let e2_minus_e1 = if lower_pair_is_closer { e2_minus_e1 } else { x1 - one_minus_e2 };
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
        require(e3_minus_one <= limit, "omega", TOO_FAST)?;
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

    pub(crate) fn integrals_in(&self, top: &Top, signs: Signs) -> FirstIntegrals<F> {
        let quantities = Quantities::<F>::of(top);
        let Quantities { a, c, p, g, .. } = quantities;
        let scale = (a * p * g).doubled();
        let plus = (scale * self.one_plus_e1 * self.one_plus_e2() * self.one_plus_e3()).sqrt();
        let minus = (scale * self.one_minus_e1() * self.one_minus_e2 * self.e3_minus_one).sqrt();
        let (l_plus_n, l_minus_n) = (signs.l_plus_n.times(plus), signs.l_minus_n.times(minus));
        let n = (l_plus_n - l_minus_n).halved();
        let spin = quantities.spin(n);
        // h = p g (e₁ + e₂ + e₃) + (C ⟨ω, r⟩² - n²/A)/2
        let h = p * g * (self.e1 + self.e2 + self.e3) + (c * spin.squared() - n.squared() / a).halved();
        FirstIntegrals { l: (l_plus_n + l_minus_n).halved(), n, h, spin, l_plus_n, l_minus_n }
    }

    pub(crate) fn to_f64(self) -> BranchPoints {
        BranchPoints {
            e1: self.e1.to_f64(),
            e2: self.e2.to_f64(),
            e3: self.e3.to_f64(),
            one_plus_e1: self.one_plus_e1.to_f64(),
            one_minus_e2: self.one_minus_e2.to_f64(),
            e2_minus_e1: self.e2_minus_e1.to_f64(),
            e3_minus_e2: self.e3_minus_e2.to_f64(),
            e3_minus_one: self.e3_minus_one.to_f64(),
        }
    }
}

fn exact_integrals(top: &Top, l: f64, n: f64, h: f64) -> FirstIntegrals<Extended> {
    let [l, n, h] = [l, n, h].map(Extended::from);
    let spin = Quantities::of(top).spin(n);
    FirstIntegrals { l, n, h, spin, l_plus_n: l + n, l_minus_n: l - n }
}

/// Point of the reduced curve at which (e₄² - u²) u'² is greatest. The integrals alone determine it.
fn highest_point(
    top: &Top,
    integrals: &FirstIntegrals<Extended>,
) -> Result<ReducedPoint<Extended>, ParameterError> {
    let Quantities { a, c, s, p, g, .. } = Quantities::<Extended>::of(top);
    let kappa = Quantities::<Extended>::of(top).kappa();
    let FirstIntegrals { l, n, h, spin, .. } = *integrals;
    let one = Extended::ONE;
    // f(u) = u³ - b u² + c₁ u + c₀
    let energy = (h - (c * spin.squared()).halved()) / (p * g);
    let b = energy + kappa * n.squared();
    let c1 = (kappa * l * n).doubled() - one;
    let c0 = energy - kappa * l.squared();
    let three = Extended::from(3.0);
    let root = (b.squared() - three * c1).sqrt();
    let u = if b > Extended::ZERO { c1 / (b + root) } else { (b - root) / three };
    // f(u) again, without cancellation where the axis is nearly upright
    let l_minus_nu = if u > Extended::ZERO { (l - n) + n * (one - u) } else { l - n * u };
    let peak = (energy - u) * (one - u) * (one + u) - kappa * l_minus_nu.squared();
    // largest effect of one `f64` rounding of l, n and h on f(u)
    let noise = (b.abs() + c1.abs() + c0.abs() + one) * Extended::from(1e-15);
    let possible = u.abs() <= one + noise.sqrt() && peak >= -noise && energy - u >= -noise.sqrt();
    require(possible, "h", "the energy of some motion with these l and n (it is too low)")?;
    let u = if u > one { one } else { u };
    let u = if u < -one { -one } else { u };
    let (one_minus_u, one_plus_u) = (one - u, one + u);
    let peak = if peak > Extended::ZERO { peak } else { Extended::ZERO };
    let udot = (g.doubled() * peak / (a / p + s * one_minus_u * one_plus_u)).sqrt();
    Ok(ReducedPoint {
        u,
        one_minus_u,
        one_plus_u,
        udot,
        axis_energy: if energy > u { energy - u } else { Extended::ZERO },
    })
}
