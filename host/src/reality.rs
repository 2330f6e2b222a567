//! What the equations allow and a top on a table does not do.

use toytop::{Motion, Support};

/// The least normal force in units of the weight, if it is below 0: the plane would have to pull at the tip.
#[must_use]
pub fn pulled(motion: &Motion) -> Option<f64> {
    motion.min_normal_force().filter(|force| *force < 0.0)
}

/// The greatest tilt in degrees, if the axis comes below the level: the body would have to go through the plane.
#[must_use]
pub fn fallen(motion: &Motion) -> Option<f64> {
    let e1 = motion.branch_points().e1;
    (motion.top().support() == Support::Sliding && e1 < 0.0).then(|| e1.acos().to_degrees())
}
