//! A top and its motion from numbers in the order of a scenario's keys.

use toytop::{Complex, Motion, Orientation, ParameterError, State, Support, Top};
use toytop_model::scenario::{self, SUPPORTS, branch_points, release, top_parameters};

/// Numbers of a top: the place of its support in [`SUPPORTS`], then those of [`top_parameters`].
pub type TopNumbers = [f64; 8];

/// Numbers of a motion by its kind; those that a kind does not need are ignored.
///
/// 0: those of [`release`]. 1, state: α and β as real and imaginary parts, and ω. 2: those of [`branch_points`].
pub type MotionNumbers = [f64; 8];

/// Top from its numbers.
///
/// # Errors
/// The errors of [`Top::sliding`], [`Top::fixed`] and [`Top::free`].
pub fn top([support, numbers @ ..]: TopNumbers) -> Result<Top, ParameterError> {
    let support = SUPPORTS.get(support as usize).map_or(Support::Sliding, |(_, support)| *support);
    scenario::top(support, &top_parameters(numbers))
}

/// Motion from its numbers.
///
/// # Errors
/// The errors of [`State::from_release`], [`State::new`], [`Motion::launch`] and [`Motion::from_branch_points`].
pub fn motion(top: &Top, kind: u32, numbers: MotionNumbers) -> Result<Motion, ParameterError> {
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
