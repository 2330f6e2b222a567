//! Top and release from the numbers of a scenario.

use core::f64::consts::PI;
use toytop::{ParameterError, Release, Support, Top, TopParameters};

/// Supports of the tip by their names, in the order of their numbers on a page.
pub const SUPPORTS: [(&str, Support); 3] =
    [("sliding", Support::Sliding), ("fixed", Support::Fixed), ("free", Support::Free)];

/// Name of a support.
pub fn support_name(support: Support) -> &'static str {
    SUPPORTS[support as usize].0
}

/// Support of this name.
pub fn support_named(name: &str) -> Option<Support> {
    SUPPORTS.iter().find(|(known, _)| *known == name).map(|(_, support)| *support)
}

/// Parameters of a top: A, C, s, M, p, g and K, with 0 for a number that is not given.
pub fn top_parameters(numbers: [f64; 7]) -> TopParameters {
    let [transverse_inertia, axial_inertia, com_height, mass, mass_moment, gravity, rotor_momentum] = numbers;
    TopParameters {
        transverse_inertia,
        axial_inertia,
        com_height,
        mass,
        mass_moment,
        gravity,
        rotor_momentum,
    }
}

/// Top with this support.
///
/// # Errors
/// The errors of [`Top::sliding`], [`Top::fixed`] and [`Top::free`].
pub fn top(support: Support, parameters: &TopParameters) -> Result<Top, ParameterError> {
    match support {
        Support::Sliding => Top::sliding(parameters),
        Support::Fixed => Top::fixed(parameters),
        Support::Free => Top::free(parameters),
    }
}

/// Release from one with angles in degrees.
pub fn release_from_degrees(release: Release) -> Release {
    let [azimuth, roll] = [release.azimuth, release.roll].map(angle_from_degrees);
    Release { tilt: tilt_from_degrees(release.tilt), azimuth, roll, ..release }
}

/// Tilt in rad. Exactly 180 degrees become π, which means exactly downward, and no other number does.
pub fn tilt_from_degrees(degrees: f64) -> f64 {
    let tilt = degrees.to_radians();
    if degrees < 180.0 {
        tilt.min(PI.next_down())
    } else if degrees == 180.0 {
        PI
    } else {
        tilt
    }
}

/// Azimuth or roll in rad, without multiples of two turns. They do not change a state, which contains half angles.
fn angle_from_degrees(degrees: f64) -> f64 {
    (degrees % 720.0).to_radians()
}
