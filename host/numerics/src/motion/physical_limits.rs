//! Motions that the equations allow but a top on a table cannot perform.

use toytop::{Motion, Regime, Support};

/// Least normal force in units of the weight, if it is below 0: the plane would have to pull at the tip.
#[must_use]
pub fn pulled(motion: &Motion) -> Option<f64> {
    motion.min_normal_force().filter(|force| *force < 0.0)
}

/// Greatest tilt in degrees, if it exceeds 90: the body would have to pass through the plane. An unstable sleeping top does not leave
/// the vertical, although its e₁ may be below 0.
#[must_use]
pub fn fallen(motion: &Motion) -> Option<f64> {
    let e1 = motion.branch_points().e1;
    (!unstable(motion) && motion.top().support() == Support::Sliding && e1 < 0.0)
        .then(|| e1.acos().to_degrees())
}

/// Whether the axis stays upright by the equations, although any disturbance would make a real top fall.
#[must_use]
pub fn unstable(motion: &Motion) -> bool {
    motion.regime() == Regime::SleepingUnstable
}
