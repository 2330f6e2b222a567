//! Branch points of given first integrals.

use toytop::internal::{branch_points_through, check_finite};
use toytop::scalar::{Extended, Float, Ring};
use toytop::{BranchPoints, ParameterError, Top};

/// Branch points of given l, n and h. Near a degenerate case these are ill-conditioned: take
/// [`Motion::branch_points`](toytop::Motion::branch_points) of a state.
///
/// # Errors
/// `h`: too low for any motion with these l and n; `l`, `n`, `h`: not finite, or e₃ above 1e14.
pub fn branch_points_from_integrals(
    top: &Top,
    l: f64,
    n: f64,
    h: f64,
) -> Result<BranchPoints, ParameterError> {
    let integrals = [check_finite("l", l)?, check_finite("n", n)?, check_finite("h", h)?].map(Extended::from);
    let refused = |allowed| ParameterError::new("h", allowed);
    let point = fastest_point(top, integrals)
        .ok_or(refused("the energy of some motion with these l and n (it is too low)"))?;
    branch_points_through(top, integrals, point).map_err(|_| refused("such that e3 <= 1e14"))
}

/// Point u, u' and energy of the axis at which (e₄² - u²) u'² is greatest; `None` where no motion has these integrals.
fn fastest_point(top: &Top, [l, n, h]: [Extended; 3]) -> Option<[Extended; 3]> {
    /// Relative tolerance for the `f64` roundings of l, n and h.
    const INTEGRAL_ROUNDING: f64 = 1e-15;
    let zero = Extended::ZERO;
    let one = Extended::ONE;
    let noise = Extended::from(INTEGRAL_ROUNDING);
    let [a, c, s, p, g, k] = [
        top.transverse_inertia(),
        top.axial_inertia(),
        top.com_height(),
        top.mass_moment(),
        top.gravity(),
        top.rotor_momentum(),
    ]
    .map(Extended::from);
    let spin_energy = if c > zero { ((n - k).squared() / c).halved() } else { zero };
    let axis_and_height = h - spin_energy;
    let weight = p * g;
    if top.is_torque_free() {
        let transverse = (a * axis_and_height).doubled();
        let square = transverse + n.squared();
        let horizontal = square - l.squared();
        let least = -(a * h.abs() + n.squared() + l.squared()) * noise;
        if transverse < least || horizontal < least || square <= zero {
            return None;
        }
        let udot = (horizontal.larger_or_nan(zero) * transverse.larger_or_nan(zero) / square).sqrt() / a;
        return Some([l * n / square, udot, axis_and_height]);
    }
    // f(u) = u³ - b u² + c₁ u + c₀
    let energy_factor = one / (a * weight).doubled();
    let energy = axis_and_height / weight;
    let b = energy + energy_factor * n.squared();
    let c1 = (energy_factor * l * n).doubled() - one;
    let c0 = energy - energy_factor * l.squared();
    let root = (b.squared() - Extended::from(3.0) * c1).sqrt();
    let u = if b > zero { c1 / (b + root) } else { (b - root) / 3.0.into() };
    // f(u) again, without cancellation where the axis is nearly upright
    let [one_minus_u, one_plus_u] = [one - u, one + u];
    let l_minus_nu = if u > zero { l - n + n * one_minus_u } else { l + n - n * one_plus_u };
    let scaled_axis_energy = energy - u;
    let peak = scaled_axis_energy * one_minus_u * one_plus_u - energy_factor * l_minus_nu.squared();
    let noise = (b.abs() + c1.abs() + c0.abs() + one) * noise;
    if u.abs() > one + noise.sqrt() || peak < -noise || scaled_axis_energy < -noise.sqrt() {
        return None;
    }
    let u = if u.abs() <= one {
        u
    } else if u > zero {
        one
    } else {
        -one
    };
    let d = a / p + s * ((one - u) * (one + u));
    let udot = (g.doubled() * peak.larger_or_nan(zero) / d).sqrt();
    Some([u, udot, (energy - u).larger_or_nan(zero)])
}
