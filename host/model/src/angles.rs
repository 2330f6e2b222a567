//! Angles of a scenario, from degrees to radians.

use core::f64::consts::PI;

/// Tilt in rad from degrees. 180, and no other number, becomes the π that means exactly downward.
pub fn tilt(degrees: f64) -> f64 {
    if degrees < 180.0 {
        degrees.to_radians().min(PI.next_down())
    } else if degrees == 180.0 {
        PI
    } else {
        degrees.to_radians()
    }
}

/// Azimuth or roll in rad from degrees. Only half of either enters a state, so that two whole turns, dropped exactly,
/// change nothing.
pub fn angle(degrees: f64) -> f64 {
    (degrees % 720.0).to_radians()
}
