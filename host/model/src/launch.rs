//! Launch of a motion, from the numbers of a scenario.

use crate::parameters::release_from_degrees;
use toytop::{Complex, InitialAngles, Motion, Orientation, ParameterError, Release, Sign, Signs, State, Top};

/// Kinds of motion by their names, in the order of their numbers on a page.
pub const KINDS: [&str; 3] = ["release", "state", "branch_points"];

/// Launch of a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Launch {
    /// Branch points e₁, e₂ and e₃.
    BranchPoints {
        /// Branch points.
        e: [f64; 3],
        /// Signs of l + n and l - n.
        signs: Signs,
        /// Phases at t = 0.
        phases: InitialAngles,
    },
    /// Orientation and angular velocity.
    State {
        /// Orientation. Its norm is 1 to within 1e-6, and it stands for the normalised one.
        orientation: Orientation<f64>,
        /// Angular velocity ω in the fixed frame.
        omega: [f64; 3],
    },
}

impl From<&State> for Launch {
    fn from(state: &State) -> Self {
        Self::State { orientation: state.orientation(), omega: state.omega() }
    }
}

impl Launch {
    /// Launch of one of the [`KINDS`] from numbers in the order of its keys; those that it does not need are ignored.
    ///
    /// # Errors
    /// The errors of [`State::from_release`] and [`State::new`]; a tilt is in degrees.
    pub fn new(kind: &str, numbers: [f64; 8]) -> Result<Self, ParameterError> {
        let [a, b, c, d, e, f, g, h] = numbers;
        let state = match kind {
            "release" if !(0.0..=180.0).contains(&a) => {
                let allowed = "between 0 and 180 degrees";
                return Err(ParameterError::OutOfRange { parameter: "tilt", allowed });
            }
            "release" => {
                let degrees = Release { tilt: a, spin: b, precession: c, nutation: d, azimuth: e, roll: f };
                State::from_release(&release_from_degrees(degrees))
            }
            "state" => {
                let orientation = Orientation { alpha: Complex::new(a, b), beta: Complex::new(c, d) };
                State::new(orientation, [e, f, g])
            }
            _ => {
                let signs = Signs { l_plus_n: Sign::new(d), l_minus_n: Sign::new(e) };
                let phases = InitialAngles { theta: f, arg_alpha: g, arg_beta: h };
                return Ok(Self::BranchPoints { e: [a, b, c], signs, phases });
            }
        };
        Ok(Self::from(&state?))
    }

    /// Motion of a top.
    ///
    /// # Errors
    /// The errors of [`State::new`], [`Motion::launch`] and [`Motion::from_branch_points`].
    pub fn motion(&self, top: &Top) -> Result<Motion, ParameterError> {
        match self {
            Self::BranchPoints { e, signs, phases } => Motion::from_branch_points(top, *e, *signs, phases),
            Self::State { orientation, omega } => Motion::launch(top, &State::new(*orientation, *omega)?),
        }
    }
}
