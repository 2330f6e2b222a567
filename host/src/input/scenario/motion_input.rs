//! Top and launch of a motion, taken as exact.

use super::motion::Launch;
use toytop::{Motion, ParameterError, State, Support, TopParameters};
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
        let motion = match self.launch {
            Launch::BranchPoints { e, signs, phases } => Motion::from_branch_points(&top, e, signs, &phases),
            Launch::State { orientation, omega } => Motion::launch(&top, &State::new(orientation, omega)?),
        };
        motion.map(TimedMotion::new)
    }
}
