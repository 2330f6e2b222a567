//! Branch points from the first integrals, and first integrals from the branch points.

use crate::constants::first_integrals::ReducedPoint;
use crate::constants::{BranchPoints, FirstIntegrals, Signs};
use crate::error::{ParameterError, finite, require};
use crate::scalar::{Extended, Float, Ring};
use crate::top::{Quantities, Top, Units};

impl BranchPoints {
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
        self.map(Extended::from).integrals_in(top, signs).as_given(top)
    }
}

impl<F: Float> BranchPoints<F> {
    /// First integrals in the number type and the units of set-up.
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
