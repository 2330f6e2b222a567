//! Input of a motion, taken as exact, and random input near degenerate cases.

pub use crate::input::scenario::Start;

use crate::input::random::Random;
use std::f64::consts::PI;
use toytop::{
    Complex, InitialPhases, Motion, Orientation, ParameterError, Sign, Signs, State, Top, TopParameters,
};

/// Numbers of a top and its launch, taken as exact.
#[derive(Clone, Copy, Debug)]
pub struct ExactInput {
    /// Numbers A, C, s, p, g and K of the top. The tip slides if s > 0, and is held if s = 0 and p > 0; for p = 0 the body is free.
    pub top: [f64; 6],
    /// Launch.
    pub start: Start,
}

impl ExactInput {
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
        let phases = InitialPhases { theta: at_corner.unwrap_or(theta), arg_alpha, arg_beta };
        Self { top: [a, c, s, p, g, 0.0], start: Start::BranchPoints { e: [e1, e2, e3], signs, phases } }
    }

    /// Motion of the core.
    ///
    /// # Errors
    /// The errors of a top, a state and a launch.
    pub fn motion(&self) -> Result<Motion, ParameterError> {
        let [a, c, s, p, g, rotor_momentum] = self.top;
        let parameters = TopParameters {
            transverse_inertia: a,
            axial_inertia: c,
            com_height: s,
            mass_moment: p,
            gravity: g,
            rotor_momentum,
            ..TopParameters::default()
        };
        let top = match (s > 0.0, p > 0.0) {
            (true, _) => Top::sliding(&parameters),
            (false, true) => Top::fixed(&parameters),
            (false, false) => Top::free(&parameters),
        }?;
        match self.start {
            Start::BranchPoints { e, signs, phases } => Motion::from_branch_points(&top, e, signs, &phases),
            Start::State { phi, omega } => {
                let [alpha, beta] = phi.map(|[re, im]| Complex::new(re, im));
                Motion::launch(&top, &State::new(Orientation { alpha, beta }, omega)?)
            }
        }
    }
}
