//! Half phase χ at t = 0.

use crate::body::Top;
use crate::constants::{BranchPoints, ReducedPoint, Regime};
use crate::phase::Phase;
use crate::scalar::{Extended, Float, Ring};

/// Half phase at a point of the reduced curve, for a motion that is not steady.
///
/// √(e₂ - e₁) sin χ = √(u - e₁), and √(e₂ - e₁) cos χ = ±√(e₂ - u) with the sign of u'. In an aperiodic motion cos χ >= 0, and
/// sin χ has the sign of u'. The smaller difference comes from (u - e₁)(e₂ - u) = g₀/(e₃ - u).
#[inline(never)]
pub(super) fn half_phase_at(
    top: &Top,
    e: &BranchPoints<Extended>,
    regime: Regime,
    torque_free_rate: Extended,
    point: &ReducedPoint,
) -> Phase {
    let ReducedPoint { one_minus_u, one_plus_u, udot, .. } = *point;
    let (g0, below_e3) = if top.is_torque_free() {
        ((udot / torque_free_rate.doubled()).squared(), Extended::ONE)
    } else {
        let d = top.length_d(one_minus_u * one_plus_u);
        (d * udot.squared() / top.g.doubled(), one_minus_u + e.e3_minus_one)
    };
    let above_e1 = one_plus_u - e.one_plus_e1;
    let below_e2 = one_minus_u - e.one_minus_e2;
    let (above_e1, below_e2) = if below_e2 < above_e1 {
        (above_e1, g0 / (below_e3 * above_e1))
    } else {
        (g0 / (below_e3 * below_e2), below_e2)
    };
    let rising = angle_to([below_e2, above_e1].map(|square| square.sqrt().to_f64()));
    match regime {
        _ if udot >= Extended::ZERO => rising,
        Regime::Aperiodic => -rising,
        _ => Phase::HALF - rising,
    }
}

/// Angle of a point with x >= 0 and y >= 0, relatively exact near 0 and near a quarter turn.
fn angle_to([x, y]: [f64; 2]) -> Phase {
    let angle = |y: f64, x: f64| Phase::from_radians(libm::atan2(y, x));
    if x < y { Phase::QUARTER - angle(x, y) } else { angle(y, x) }
}
