//! Top of most programs. `bin/spin.rs` and `bin/launch.rs` show how to launch one.

use toytop::{Motion, ParameterError, Release, State, Top, TopParameters};

/// Motion of a 50 g top with its centre of mass 30 mm above the tip, released at 20 degrees with 150 rad/s.
///
/// # Errors
/// None: it is possible.
pub fn toy_top() -> Result<Motion, ParameterError> {
    released(&Release { tilt: 20.0_f64.to_radians(), spin: 150.0, ..Release::default() })
}

/// Motion of this top after another release.
///
/// # Errors
/// See [`State::from_release`].
pub fn released(release: &Release) -> Result<Motion, ParameterError> {
    Motion::launch(&Top::sliding(&TopParameters::TOY)?, &State::from_release(release)?)
}
