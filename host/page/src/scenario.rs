//! A top and its motion from numbers in the order of a scenario's keys.

use toytop::{
    Complex, InitialAngles, Motion, Orientation, ParameterError, Release, Sign, Signs, State, Support, Top,
    TopParameters,
};
use toytop_model::angles::{angle, tilt};
use toytop_model::support::{self, SUPPORTS};

/// Numbers of a top: the place of its support in [`SUPPORTS`], then A, C, s, M, p, g and K, with 0 for what is not given.
pub type TopNumbers = [f64; 8];

/// Numbers of a motion by its kind; what a kind does not need is ignored.
///
/// 0, release: tilt (degrees), spin, precession, nutation, azimuth and roll (degrees). 1, state: α and β as real and imaginary parts, and
/// ω. 2, branch points: e₁, e₂, e₃, the signs of l + n and l - n, and the phases at t = 0.
pub type MotionNumbers = [f64; 8];

/// Top from its numbers.
///
/// # Errors
/// The errors of [`Top::sliding`], [`Top::fixed`] and [`Top::free`].
pub fn top(numbers: &TopNumbers) -> Result<Top, ParameterError> {
    let [support, transverse_inertia, axial_inertia, com_height, mass, mass_moment, gravity, rotor_momentum] =
        *numbers;
    let parameters = TopParameters {
        transverse_inertia,
        axial_inertia,
        com_height,
        mass,
        mass_moment,
        gravity,
        rotor_momentum,
    };
    let support = SUPPORTS.get(support as usize).map_or(Support::Sliding, |(_, support)| *support);
    support::top(support, &parameters)
}

/// Motion from its numbers.
///
/// # Errors
/// The errors of [`State::from_release`], [`State::new`], [`Motion::launch`] and [`Motion::from_branch_points`].
pub fn motion(top: &Top, kind: u32, numbers: &MotionNumbers) -> Result<Motion, ParameterError> {
    let [a, b, c, d, e, f, g, h] = *numbers;
    match kind {
        0 => {
            let (tilt, azimuth, roll) = (tilt(a), angle(e), angle(f));
            let release = Release { tilt, azimuth, roll, spin: b, precession: c, nutation: d };
            Motion::launch(top, &State::from_release(&release)?)
        }
        1 => {
            let phi = Orientation { alpha: Complex::new(a, b), beta: Complex::new(c, d) };
            Motion::launch(top, &State::new(phi, [e, f, g])?)
        }
        _ => {
            let signs = Signs { l_plus_n: Sign::new(d), l_minus_n: Sign::new(e) };
            let start = InitialAngles { theta: f, arg_alpha: g, arg_beta: h };
            Motion::from_branch_points(top, [a, b, c], signs, &start)
        }
    }
}
