//! Branch points of given first integrals.

use super::BranchPoints;
use crate::body::{ParameterError, Top, check_finite};
use crate::constants::{FirstIntegrals, ReducedPoint};
use crate::scalar::{Extended, Float, Ring};

impl BranchPoints {
    /// Branch points of given l, n and h. Near a degenerate case these are ill-conditioned: take
    /// [`Motion::branch_points`](crate::Motion::branch_points) of a state.
    ///
    /// # Errors
    /// `h`: too low for any motion with these l and n; `l`, `n`, `h`: not finite, or e₃ above 1e14.
    pub fn from_integrals(top: &Top, l: f64, n: f64, h: f64) -> Result<Self, ParameterError> {
        let [l, n, h] =
            [check_finite("l", l)?, check_finite("n", n)?, check_finite("h", h)?].map(Extended::from);
        let integrals = FirstIntegrals { l, n, h, spin: top.spin(n), l_plus_n: l + n, l_minus_n: l - n };
        let refused = |allowed| ParameterError::new("h", allowed);
        let point = fastest_point(top, &integrals)
            .ok_or(refused("the energy of some motion with these l and n (it is too low)"))?;
        BranchPoints::from_reduced_point(top, &integrals, &point, &mut || {})
            .map(|e| e.map(Float::to_f64))
            .map_err(|_| refused("such that e3 <= 1e14"))
    }
}

/// Point of the reduced curve at which (e₄² - u²) u'² is greatest; `None` where no motion has these integrals.
fn fastest_point(top: &Top, integrals: &FirstIntegrals<Extended>) -> Option<ReducedPoint> {
    /// Relative tolerance for the `f64` roundings of l, n and h.
    const INTEGRAL_ROUNDING: f64 = 1e-15;
    let zero = Extended::ZERO;
    let one = Extended::ONE;
    let noise = Extended::from(INTEGRAL_ROUNDING);
    let Top { a, c, g, .. } = *top;
    let FirstIntegrals { l, n, h, spin, .. } = *integrals;
    let point = |u, udot, scaled_axis_energy| ReducedPoint {
        u,
        one_minus_u: one - u,
        one_plus_u: one + u,
        udot,
        scaled_axis_energy,
    };
    // energy without that of the rotation about the axis, over its unit
    let energy = (h - (c * spin.squared()).halved()) / top.energy_unit();
    if top.is_torque_free() {
        let transverse = (a * energy).doubled();
        let square = transverse + n.squared();
        let horizontal = square - l.squared();
        let least = -(a * h.abs() + n.squared() + l.squared()) * noise;
        if transverse < least || horizontal < least || square <= zero {
            return None;
        }
        let udot = (horizontal.larger_or_nan(zero) * transverse.larger_or_nan(zero) / square).sqrt() / a;
        return Some(point(l * n / square, udot, energy));
    }
    // f(u) = u³ - b u² + c₁ u + c₀
    let energy_factor = top.energy_factor();
    let b = energy + energy_factor * n.squared();
    let c1 = (energy_factor * l * n).doubled() - one;
    let c0 = energy - energy_factor * l.squared();
    let root = (b.squared() - Extended::from(3.0) * c1).sqrt();
    let u = if b > zero { c1 / (b + root) } else { (b - root) / 3.0.into() };
    // f(u) again, without cancellation where the axis is nearly upright
    let extremum = point(u, zero, energy - u);
    let ReducedPoint { one_minus_u, one_plus_u, scaled_axis_energy, .. } = extremum;
    let peak = scaled_axis_energy * one_minus_u * one_plus_u
        - energy_factor * integrals.l_minus_nu(&extremum).squared();
    let noise = (b.abs() + c1.abs() + c0.abs() + one) * noise;
    if u.abs() > one + noise.sqrt() || peak < -noise || scaled_axis_energy < -noise.sqrt() {
        return None;
    }
    let u = if u > one { one } else { u.larger_or_nan(-one) };
    let udot = (g.doubled() * peak.larger_or_nan(zero) / top.length_d((one - u) * (one + u))).sqrt();
    Some(point(u, udot, (energy - u).larger_or_nan(zero)))
}
