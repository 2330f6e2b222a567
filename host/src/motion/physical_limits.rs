//! Least and greatest tilt, and motions that the equations allow but a top on a table cannot perform.

use toytop::{Motion, Regime, Support};

/// Least normal force in units of the weight, if it is below 0: the plane would have to pull at the tip.
pub fn pulled(motion: &Motion) -> Option<f64> {
    motion.min_normal_force().filter(|force| *force < 0.0)
}

/// Greatest tilt in degrees, if it exceeds 90: the body would have to pass through the plane. An unstable sleeping top does not leave
/// the vertical, although its e₁ may be below 0.
pub fn fallen(motion: &Motion) -> Option<f64> {
    let [_, greatest] = tilts(motion);
    (motion.top().support() == Support::Sliding && greatest > 90.0).then_some(greatest)
}

/// Whether the axis stays upright by the equations, although any disturbance would make a real top fall.
pub fn unstable(motion: &Motion) -> bool {
    motion.regime() == Regime::SleepingUnstable
}

/// Least and greatest tilt of the axis, degrees.
pub(crate) fn tilts(motion: &Motion) -> [f64; 2] {
    let e = motion.branch_points();
    let tilt =
        |one_plus_e: f64, one_minus_e: f64| 2.0 * one_minus_e.sqrt().atan2(one_plus_e.sqrt()).to_degrees();
    match motion.regime() {
        Regime::Hanging => [180.0; 2],
        regime if regime.is_vertical() => [0.0; 2],
        _ => [tilt(2.0 - e.one_minus_e2, e.one_minus_e2), tilt(e.one_plus_e1, 2.0 - e.one_plus_e1)],
    }
}
