//! Numbers of a scenario, in the order of its keys.

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

/// Motion by the place of its kind among release, state and branch points, from the numbers of that kind; those that it does not need
/// are ignored. A state has α and β as real and imaginary parts, then ω.
///
/// # Errors
/// The errors of [`State::from_release`], [`State::new`], [`Motion::launch`] and [`Motion::from_branch_points`].
pub fn motion(top: &Top, kind: u32, numbers: [f64; 8]) -> Result<Motion, ParameterError> {
    let [a, b, c, d, e, f, g, _] = numbers;
    let state = match kind {
        0 => State::from_release(&release([a, b, c, d, e, f])),
        1 => {
            let orientation = Orientation { alpha: Complex::new(a, b), beta: Complex::new(c, d) };
            State::new(orientation, [e, f, g])
        }
        _ => {
            let (e, signs, phases) = branch_points(numbers);
            return Motion::from_branch_points(top, e, signs, &phases);
        }
    };
    Motion::launch(top, &state?)
}

/// Release: tilt (degrees), spin, precession, nutation, azimuth and roll (degrees).
pub fn release([tilt, spin, precession, nutation, azimuth, roll]: [f64; 6]) -> Release {
    let [azimuth, roll] = [azimuth, roll].map(angle_from_degrees);
    Release { tilt: tilt_from_degrees(tilt), azimuth, roll, spin, precession, nutation }
}

/// Branch points, signs of l + n and l - n, and phases at t = 0.
pub fn branch_points(numbers: [f64; 8]) -> ([f64; 3], Signs, InitialAngles) {
    let [e1, e2, e3, plus, minus, theta, arg_alpha, arg_beta] = numbers;
    let signs = Signs { l_plus_n: Sign::new(plus), l_minus_n: Sign::new(minus) };
    ([e1, e2, e3], signs, InitialAngles { theta, arg_alpha, arg_beta })
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
