//! Half phase χ at t = 0.

use crate::body::Top;
use crate::constants::{BranchPoints, ReducedPoint, Regime};
use crate::phase::Phase;
use crate::scalar::{Extended, Float, Ring};

/// Whether u is constant to the last bit, as in a steady motion. A regular precession may nutate by 2^-49 rad.
pub(super) fn has_constant_tilt(e: &BranchPoints<Extended>, regime: Regime) -> bool {
    e.e2_minus_e1 == Extended::ZERO || regime == Regime::SleepingUnstable
}

/// Half phase at a point of the reduced curve; `None` for a steady motion.
///
/// √(e₂ - e₁) sin χ = √(u - e₁), and √(e₂ - e₁) cos χ = ±√(e₂ - u) with the sign of u'. In an aperiodic motion sin χ has that sign
/// instead. The smaller difference comes from (u - e₁)(e₂ - u) = g₀/(e₃ - u).
#[inline(never)]
pub(super) fn half_phase_at(
    top: &Top,
    e: &BranchPoints<Extended>,
    regime: Regime,
    torque_free_rate: Extended,
    point: &ReducedPoint,
) -> Option<Phase> {
    if has_constant_tilt(e, regime) {
        return None;
    }
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
    Some(match regime {
        _ if udot >= Extended::ZERO => rising,
        Regime::Aperiodic => -rising,
        _ => Phase::HALF - rising,
    })
}

/// Angle of a point with x >= 0 and y >= 0, relatively exact near 0 and near a quarter turn.
fn angle_to([x, y]: [f64; 2]) -> Phase {
    let angle = |y: f64, x: f64| Phase::from_radians(libm::atan2(y, x));
    if x < y { Phase::QUARTER - angle(x, y) } else { angle(y, x) }
}

/// Half phase χ = θ/2.
pub(super) fn half_phase_of_angle(theta: f64) -> Phase {
    let nearest = libm::round(theta * core::f64::consts::FRAC_1_PI);
    let multiple = Extended::TWO_PI.halved() * nearest.into();
    if nearest != 0.0 && multiple.to_f64() == theta {
        return Phase::from_turns(0.25 * nearest);
    }
    (Extended::from(theta).radians_to_turns() * Extended::from(0.5)).to_phase()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `f64` nearest to k π, computed in integers: π to 100 fraction bits, and the leading 53 bits of the product.
    fn nearest_to_multiple(k: u32) -> f64 {
        const PI: u128 = 0x32_43f6_a888_5a30_8d31_3198_a2e0;
        let product = PI * u128::from(k);
        let dropped = product.ilog2() - 52;
        let remainder = product & ((1 << dropped) - 1);
        let half = 1 << (dropped - 1);
        // the product is smaller than k π, by less than k units
        assert!(remainder.abs_diff(half) > u128::from(k), "{k}");
        let mantissa = (product >> dropped) + u128::from(remainder > half);
        libm::ldexp(mantissa as f64, dropped as i32 - 100)
    }

    #[test]
    fn the_nearest_number_to_any_multiple_of_pi_is_that_multiple() {
        let most = if cfg!(miri) { 300 } else { 400_000 };
        for k in 1..=most {
            let theta = nearest_to_multiple(k);
            let turns = Phase::from_bits(i128::from(k) * (Phase::QUARTER.to_bits()));
            assert_eq!(
                [half_phase_of_angle(theta), half_phase_of_angle(-theta)],
                [turns, -turns],
                "{k}: {theta:e}"
            );
            // a neighbouring number is a different, close angle
            for near in [theta.next_up(), theta.next_down()] {
                let off = half_phase_of_angle(near) - turns;
                let unit = (near - theta).abs() * 0.25 * core::f64::consts::FRAC_1_PI;
                let relative = off.to_turns().abs() / unit;
                assert!((0.49..1.51).contains(&relative), "{k}: {relative}");
                assert!((half_phase_of_angle(-near) + half_phase_of_angle(near)).to_bits().abs() <= 1, "{k}");
            }
        }
        assert_eq!(half_phase_of_angle(0.0), Phase::ZERO);
    }
}
