//! Top and motion from the numbers of a scenario.

use core::f64::consts::PI;
use toytop::{
    Complex, InitialAngles, Motion, Orientation, ParameterError, Release, Sign, Signs, State, Support, Top,
    TopParameters,
};

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

/// Motion from the numbers of a page, in the order of the keys of a scenario; those that a motion does not need are ignored.
///
/// * `kind`: place of the kind among release, state and branch points
///
/// # Errors
/// The errors of [`State::from_release`], [`State::new`], [`Motion::launch`] and [`Motion::from_branch_points`].
pub fn motion(top: &Top, kind: u32, numbers: [f64; 8]) -> Result<Motion, ParameterError> {
    let [a, b, c, d, e, f, g, h] = numbers;
    let state = match kind {
        0 => {
            let degrees = Release { tilt: a, spin: b, precession: c, nutation: d, azimuth: e, roll: f };
            State::from_release(&release_from_degrees(degrees))
        }
        1 => {
            let orientation = Orientation { alpha: Complex::new(a, b), beta: Complex::new(c, d) };
            State::new(orientation, [e, f, g])
        }
        _ => {
            let signs = Signs { l_plus_n: Sign::new(d), l_minus_n: Sign::new(e) };
            let phases = InitialAngles { theta: f, arg_alpha: g, arg_beta: h };
            return Motion::from_branch_points(top, [a, b, c], signs, &phases);
        }
    };
    Motion::launch(top, &state?)
}

/// Release from one with angles in degrees.
pub fn release_from_degrees(release: Release) -> Release {
    let [azimuth, roll] = [release.azimuth, release.roll].map(angle_from_degrees);
    Release { tilt: tilt_from_degrees(release.tilt), azimuth, roll, ..release }
}

/// Tilt in rad. Exactly 180 degrees become π, which means exactly downward, and no other number does.
pub fn tilt_from_degrees(degrees: f64) -> f64 {
    if degrees < 180.0 {
        degrees.to_radians().min(PI.next_down())
    } else if degrees == 180.0 {
        PI
    } else {
        degrees.to_radians()
    }
}

/// Azimuth or roll in rad, without multiples of two turns. They do not change a state, which contains half angles.
fn angle_from_degrees(degrees: f64) -> f64 {
    (degrees % 720.0).to_radians()
}
