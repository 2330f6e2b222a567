//! Top and launch of a motion, taken as exact, and random ones near degenerate cases.

use crate::input::random::Random;
use crate::input::scenario::Launch;
use std::f64::consts::PI;
use toytop::{InitialAngles, Motion, ParameterError, Sign, Signs, State, Support, TopParameters};
use toytop_model::scenario;

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
    /// Random motion of a toy top, log-uniform near the degenerate cases: A/(ps) in \[1e-3, 1e6\], C/A in \[1e-3, 2\], 1 + e₁, e₂ - e₁, 1 - e₂
    /// and e₃ - 1 down to 1e-12, and one in sixteen at 0.
    pub fn random(random: &mut Random) -> Self {
        let [s, p, g] = [(); 3].map(|()| random.log_uniform(0.1, 10.0));
        let a = random.log_uniform(1e-3, 1e6) * p * s;
        let c = a * random.log_uniform(1e-3, 2.0);
        // 1 + e₁, e₂ - e₁ and 1 - e₂ add up to 2
        let mut gap = || if random.one_in(16) { 0.0 } else { random.log_uniform(1e-12, 1.0) };
        let [below, swing, above] = [gap(), gap(), gap()];
        let unit = 0.5 * (below + swing + above).max(1e-12);
        let e1 = below / unit - 1.0;
        let e2 = if swing == 0.0 { e1 } else { (1.0 - above / unit).max(e1) };
        let e3 = if random.one_in(16) { 1.0 } else { 1.0 + random.log_uniform(1e-12, 1e12) };
        let mut sign = || if random.one_in(2) { Sign::Plus } else { Sign::Minus };
        let signs = Signs { l_plus_n: sign(), l_minus_n: sign() };
        let [theta, arg_alpha, arg_beta] = [(); 3].map(|()| random.between(-PI, PI));
        let at_corner = [0.0, PI].into_iter().find(|_| random.one_in(16));
        let phases = InitialAngles { theta: at_corner.unwrap_or(theta), arg_alpha, arg_beta };
        let top = TopParameters {
            transverse_inertia: a,
            axial_inertia: c,
            com_height: s,
            mass_moment: p,
            gravity: g,
            ..TopParameters::default()
        };
        let launch = Launch::BranchPoints { e: [e1, e2, e3], signs, phases };
        Self { support: Support::Sliding, top, launch }
    }

    /// Motion of the core.
    ///
    /// # Errors
    /// The errors of a top, a state and a launch.
    pub fn motion(&self) -> Result<Motion, ParameterError> {
        let top = scenario::top(self.support, &self.top)?;
        match self.launch {
            Launch::BranchPoints { e, signs, phases } => Motion::from_branch_points(&top, e, signs, &phases),
            Launch::State { orientation, omega } => Motion::launch(&top, &State::new(orientation, omega)?),
        }
    }
}
