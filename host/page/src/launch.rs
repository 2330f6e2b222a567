//! Launch of a motion from the numbers of the page.

use toytop::{Complex, InitialAngles, Motion, Orientation, ParameterError, Release, Sign, Signs, State, Top};
use toytop_model::parameters::release_from_degrees;

/// Motion from numbers in the order of the keys of a scenario; those that a motion does not need are ignored.
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
