//! Top and launch of a motion, taken as exact.

use toytop::{ParameterError, Support, TopParameters};
use toytop_model::launch::Launch;
use toytop_model::parameters;
use toytop_model::timed_motion::TimedMotion;

/// Numbers of a top and of its launch, taken as exact.
#[derive(Clone, Copy, Debug)]
pub struct MotionInput {
    /// Support of the tip.
    pub support: Support,
    /// Numbers of the top.
    pub top: TopParameters,
    /// Launch.
    pub launch: Launch,
}

impl MotionInput {
    /// Motion with its period.
    ///
    /// # Errors
    /// The errors of a top, a state and a launch.
    pub fn motion(&self) -> Result<TimedMotion, ParameterError> {
        let top = parameters::top(self.support, &self.top)?;
        self.launch.motion(&top).map(TimedMotion::new)
    }
}
