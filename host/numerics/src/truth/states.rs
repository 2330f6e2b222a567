//! Motion given by a state.

use std::fmt;
use toytop::scalar::Scalar;
use toytop::{Complex, Motion, Orientation, ParameterError, State, Top, TopParameters};

/// Numbers of a state and its top, taken as exact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StateNumbers {
    /// Numbers A, C, s, p, g and K. The tip slides if s > 0, and is held if s = 0 and p > 0; for p = 0 the body is free.
    pub top: [f64; 6],
    /// Parameters α and β, whose norm need not be 1; they stand for the normalised pair.
    pub phi: [[f64; 2]; 2],
    /// Angular velocity ω in the fixed frame.
    pub omega: [f64; 3],
}

impl StateNumbers {
    /// Numbers of a top and a state of the core.
    #[must_use]
    pub fn of(top: [f64; 6], state: &State) -> Self {
        let Orientation { alpha, beta } = state.orientation();
        Self { top, phi: [alpha, beta].map(|z| [z.re, z.im]), omega: state.omega() }
    }

    /// Motion of the core.
    ///
    /// # Errors
    /// The errors of a top, a state and a launch.
    pub fn motion(&self) -> Result<Motion, ParameterError> {
        self.motion_for::<f64>()
    }

    /// Motion of the core, launched for a scalar.
    ///
    /// # Errors
    /// See [`motion`](Self::motion).
    pub fn motion_for<R: Scalar>(&self) -> Result<Motion, ParameterError> {
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
        let [alpha, beta] = self.phi.map(|[re, im]| Complex::new(re, im));
        Motion::launch_for::<R>(&top, &State::new(Orientation { alpha, beta }, self.omega)?)
    }
}

impl fmt::Display for StateNumbers {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { top: [a, c, s, p, g, k], phi: [alpha, beta], omega } = self;
        write!(
            f,
            "A={a:?} C={c:?} s={s:?} p={p:?} g={g:?} K={k:?} alpha={alpha:?} beta={beta:?} omega={omega:?}"
        )
    }
}
