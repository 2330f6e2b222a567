//! A motion given by its state, as a launch takes it.

use std::fmt;
use toytop::{Complex, Motion, Orientation, ParameterError, State, Top, TopParameters};

/// The numbers of a state and its top, all exact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StateNumbers {
    /// A, C, s, p, g.
    pub top: [f64; 5],
    /// α and β; what they mean is normalised.
    pub phi: [[f64; 2]; 2],
    /// ω in the fixed frame.
    pub omega: [f64; 3],
}

impl StateNumbers {
    /// Truth of a launch from a state.
    #[must_use]
    pub fn of(top: [f64; 5], state: &State) -> Self {
        let Orientation { alpha, beta } = state.orientation();
        Self { top, phi: [alpha, beta].map(|z| [z.re, z.im]), omega: state.omega() }
    }

    /// The motion.
    ///
    /// # Errors
    /// Those of a top, a state and a launch.
    pub fn motion(&self) -> Result<Motion, ParameterError> {
        let [a, c, s, p, g] = self.top;
        let top = Top::sliding(&TopParameters {
            transverse_inertia: a,
            axial_inertia: c,
            com_height: s,
            mass_moment: p,
            gravity: g,
            ..TopParameters::default()
        })?;
        let [alpha, beta] = self.phi.map(|[re, im]| Complex::new(re, im));
        Motion::launch(&top, &State::new(Orientation { alpha, beta }, self.omega)?)
    }
}

impl fmt::Display for StateNumbers {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { top: [a, c, s, p, g], phi: [alpha, beta], omega } = self;
        write!(f, "A={a:?} C={c:?} s={s:?} p={p:?} g={g:?} alpha={alpha:?} beta={beta:?} omega={omega:?}")
    }
}
