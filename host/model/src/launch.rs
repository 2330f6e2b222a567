//! Launch of a motion, from the numbers of a scenario.

use core::f64::consts::PI;
use toytop::{Complex, InitialAngles, Motion, Orientation, ParameterError, Release, Sign, Signs, State, Top};

/// Kind of a launch.
#[derive(Clone, Copy, PartialEq)]
pub enum Kind {
    /// Angles and rates.
    Release,
    /// Orientation and angular velocity.
    State,
    /// Branch points, signs and phases.
    BranchPoints,
}

/// Kinds of a launch by their names, in the order of their numbers on a page.
pub const KINDS: [(&str, Kind); 3] =
    [("release", Kind::Release), ("state", Kind::State), ("branch_points", Kind::BranchPoints)];

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
    /// Launch from numbers in the order of the keys of its kind, with angles of a release in degrees. Numbers that it does not need are ignored.
    ///
    /// # Errors
    /// The errors of [`State::from_release`] and [`State::new`].
    pub fn new(kind: Kind, numbers: [f64; 8]) -> Result<Self, ParameterError> {
        let [a, b, c, d, e, f, g, h] = numbers;
        let state = match kind {
            Kind::Release if !(0.0..=180.0).contains(&a) => {
                let allowed = "between 0 and 180 degrees";
                return Err(ParameterError::new("tilt", allowed));
            }
            Kind::Release => {
                let [azimuth, roll] = [e, f].map(angle_from_degrees);
                let tilt = tilt_from_degrees(a);
                State::from_release(&Release { tilt, spin: b, precession: c, nutation: d, azimuth, roll })
            }
            Kind::State => {
                let orientation = Orientation { alpha: Complex::new(a, b), beta: Complex::new(c, d) };
                State::new(orientation, [e, f, g])
            }
            Kind::BranchPoints => {
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

/// Tilt in rad. Exactly 180 degrees become π, which means exactly downward, and no other number does.
fn tilt_from_degrees(degrees: f64) -> f64 {
    if degrees == 180.0 { PI } else { degrees.to_radians().min(PI.next_down()) }
}

/// Azimuth or roll in rad, without multiples of two turns. They do not change a state, which contains half angles.
fn angle_from_degrees(degrees: f64) -> f64 {
    (degrees % 720.0).to_radians()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parameters::{self, top_parameters};
    use toytop::Support;

    /// The toy top of the README: A, C, s, M, p, g, K.
    const TOY_TOP: [f64; 7] = [3.0e-5, 2.0e-5, 0.03, 0.05, 0.0, 9.81, 0.0];
    /// Tilt, spin, precession, nutation, azimuth, roll.
    const THROW: [f64; 8] = [20.0, 150.0, 4.0, -3.0, 50.0, 70.0, 0.0, 0.0];

    fn top(support: Support, numbers: [f64; 7]) -> Top {
        parameters::top(support, &top_parameters(numbers)).unwrap()
    }

    fn launched(top: &Top, kind: Kind, numbers: [f64; 8]) -> Motion {
        Launch::new(kind, numbers).unwrap().motion(top).unwrap()
    }

    #[test]
    fn numbers_make_the_motion_that_names_make() {
        let top = top(Support::Sliding, TOY_TOP);
        assert_eq!([top.transverse_inertia(), top.axial_inertia(), top.com_height()], [3.0e-5, 2.0e-5, 0.03]);
        assert_eq!((top.mass_moment(), top.gravity()), (0.05 * 0.03, 9.81));
        let held = self::top(Support::Fixed, [7.5e-5, 2.0e-5, 0.0, 0.0, 0.0015, 9.81, 0.25]);
        assert_eq!((held.mass_moment(), held.rotor_momentum()), (0.0015, 0.25));
        let release = Release {
            tilt: 20_f64.to_radians(),
            spin: 150.0,
            precession: 4.0,
            nutation: -3.0,
            azimuth: 50_f64.to_radians(),
            roll: 70_f64.to_radians(),
        };
        let state = State::from_release(&release).unwrap();
        assert_eq!(launched(&top, Kind::Release, THROW), Motion::launch(&top, &state).unwrap());
        let ([alpha, beta], omega) = ([state.orientation().alpha, state.orientation().beta], state.omega());
        let numbers = [alpha.re, alpha.im, beta.re, beta.im, omega[0], omega[1], omega[2], 0.0];
        assert_eq!(launched(&top, Kind::State, numbers), launched(&top, Kind::Release, THROW));
        let of_roots = launched(&top, Kind::BranchPoints, [0.5, 0.75, 2.0, 1.0, -1.0, 0.0, 0.0, 0.0]);
        let (e, integrals) = (of_roots.branch_points(), of_roots.first_integrals());
        assert_eq!([e.e1, e.e2, e.e3], [0.5, 0.75, 2.0]);
        assert!(integrals.l.abs() < integrals.n.abs());
    }

    #[test]
    fn what_is_no_motion_is_refused_by_its_name() {
        let top = top(Support::Sliding, TOY_TOP);
        let refused = |i: usize, x: f64| {
            let mut numbers = THROW;
            numbers[i] = x;
            Launch::new(Kind::Release, numbers)
                .and_then(|launch| launch.motion(&top))
                .unwrap_err()
                .parameter()
        };
        assert_eq!(
            [refused(0, 180.1), refused(0, -1.0), refused(1, f64::NAN), refused(2, 1e12)],
            ["tilt", "tilt", "spin", "precession"]
        );
        assert_eq!(tilt_from_degrees(180.0), PI);
        assert!(tilt_from_degrees(180_f64.next_down()) < PI);
    }
}
