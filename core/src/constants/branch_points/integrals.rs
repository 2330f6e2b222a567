//! Branch points from first integrals, and the inverse.

use super::BranchPoints;
use crate::body::{ParameterError, Top, check_finite};
use crate::constants::{FirstIntegrals, ReducedPoint, Signs};
use crate::scalar::{Extended, Float, Ring};

impl BranchPoints {
    /// Branch points of given l, n and h. Near a degenerate case these are ill-conditioned: take [`Motion::branch_points`](crate::Motion::branch_points) of a state.
    ///
    /// # Errors
    /// `h`: too low for any motion with these l and n; `l`, `n`, `h`: not finite, or e₃ above 1e14.
    pub fn from_integrals(top: &Top, l: f64, n: f64, h: f64) -> Result<Self, ParameterError> {
        let [l, n, h] =
            [check_finite("l", l)?, check_finite("n", n)?, check_finite("h", h)?].map(Extended::from);
        let integrals = FirstIntegrals { l, n, h, spin: top.spin(n), l_plus_n: l + n, l_minus_n: l - n };
        let point = fastest_point(top, &integrals).ok_or(ParameterError::OutOfRange {
            parameter: "h",
            allowed: "the energy of some motion with these l and n (it is too low)",
        })?;
        let refused = |_| ParameterError::OutOfRange { parameter: "h", allowed: "such that e3 <= 1e14" };
        Ok(BranchPoints::from_reduced_point(top, &integrals, &point, &mut || {})
            .map_err(refused)?
            .map(Float::to_f64))
    }

    /// First integrals of branch points and signs (equation (3.6)). Without torque they are not determined, and l = n = 0.
    pub fn integrals(&self, top: &Top, signs: Signs) -> FirstIntegrals {
        self.map(Extended::from).unrounded_integrals(top, signs).map(Float::to_f64)
    }
}

impl BranchPoints<Extended> {
    /// First integrals in extended precision.
    pub(crate) fn unrounded_integrals(&self, top: &Top, signs: Signs) -> FirstIntegrals<Extended> {
        let Top { a, c, p, g, .. } = *top;
        let scale = (a * p * g).doubled();
        let plus = (scale * self.one_plus_e1 * self.one_plus_e2() * self.one_plus_e3()).sqrt();
        let minus = (scale * self.one_minus_e1() * self.one_minus_e2 * self.e3_minus_one).sqrt();
        let l_plus_n = signs.l_plus_n.times(plus);
        let l_minus_n = signs.l_minus_n.times(minus);
        let n = (l_plus_n - l_minus_n).halved();
        let spin = top.spin(n);
        // h = p g (e₁ + e₂ + e₃) + (C ⟨ω, r⟩² - n²/A)/2
        let h = p * g * (self.e1 + self.e2 + self.e3) + (c * spin.squared() - n.squared() / a).halved();
        FirstIntegrals { l: (l_plus_n + l_minus_n).halved(), n, h, spin, l_plus_n, l_minus_n }
    }
}

/// Point at which (e₄² - u²) u'² is greatest; `None` where no motion has these integrals.
fn fastest_point(top: &Top, integrals: &FirstIntegrals<Extended>) -> Option<ReducedPoint> {
    /// Relative tolerance for the `f64` roundings of l, n and h.
    const INTEGRAL_ROUNDING: f64 = 1e-15;
    let zero = Extended::ZERO;
    let one = Extended::ONE;
    let noise = Extended::from(INTEGRAL_ROUNDING);
    let point = |u: Extended, udot: Extended, axis_energy: Extended| {
        let one_minus_u = one - u;
        let one_plus_u = one + u;
        ReducedPoint { u, one_minus_u, one_plus_u, udot, axis_energy }
    };
    let Top { a, c, g, .. } = *top;
    let FirstIntegrals { l, n, h, spin, .. } = *integrals;
    let axis_and_height = h - (c * spin.squared()).halved();
    if top.is_torque_free() {
        let transverse = (a * axis_and_height).doubled();
        let square = transverse + n.squared();
        let horizontal = square - l.squared();
        let least = -(a * h.abs() + n.squared() + l.squared()) * noise;
        if transverse < least || horizontal < least || square <= zero {
            return None;
        }
        let udot = (horizontal.larger_or_nan(zero) * transverse.larger_or_nan(zero) / square).sqrt() / a;
        return Some(point(l * n / square, udot, axis_and_height));
    }
    // f(u) = u³ - b u² + c₁ u + c₀
    let energy_factor = top.energy_factor();
    let energy = axis_and_height / top.weight_or_one();
    let b = energy + energy_factor * n.squared();
    let c1 = (energy_factor * l * n).doubled() - one;
    let c0 = energy - energy_factor * l.squared();
    let root = (b.squared() - Extended::from(3.0) * c1).sqrt();
    let u = if b > zero { c1 / (b + root) } else { (b - root) / 3.0.into() };
    // f(u) again, without cancellation where the axis is nearly upright
    let found = point(u, zero, energy - u);
    let sine_squared = found.one_minus_u * found.one_plus_u;
    let peak = found.axis_energy * sine_squared - energy_factor * found.l_minus_nu(integrals).squared();
    let noise = (b.abs() + c1.abs() + c0.abs() + one) * noise;
    if u.abs() > one + noise.sqrt() || peak < -noise || found.axis_energy < -noise.sqrt() {
        return None;
    }
    let u = if u.abs() <= one {
        u
    } else if u > zero {
        one
    } else {
        -one
    };
    let found = point(u, zero, (energy - u).larger_or_nan(zero));
    let d = top.length_d(found.one_minus_u * found.one_plus_u);
    Some(ReducedPoint { udot: (g.doubled() * peak.larger_or_nan(zero) / d).sqrt(), ..found })
}
