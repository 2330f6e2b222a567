//! The top that most programs spin. How to launch one is shown in `bin/spin.rs` and `bin/launch.rs`.

use toytop::{Heaviness, LaunchError, Motion, Release, State, Top};

/// A 50 g top with its centre of mass 30 mm above the tip, let go at 20 degrees with 150 rad/s.
///
/// # Errors
/// None: it is possible.
pub fn toy_top() -> Result<Motion, LaunchError> {
    let top = Top::sliding(3.0e-5, 2.0e-5, 0.03, Heaviness::Mass(0.05), 9.81)?;
    let release = Release { tilt: 20.0_f64.to_radians(), spin: 150.0, ..Release::default() };
    Motion::launch(&top, &State::release(&release)?)
}
