//! Angles of a scenario, from degrees to radians.

use core::f64::consts::PI;

/// Tilt in rad from degrees. Exactly 180 becomes π, which means exactly downward, and no other number does.
pub fn tilt(degrees: f64) -> f64 {
    if degrees < 180.0 {
        degrees.to_radians().min(PI.next_down())
    } else if degrees == 180.0 {
        PI
    } else {
        degrees.to_radians()
    }
}

/// Azimuth or roll in rad from degrees, without multiples of two turns. They do not change a state, which contains half angles.
pub fn angle(degrees: f64) -> f64 {
    (degrees % 720.0).to_radians()
}
