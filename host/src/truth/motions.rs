//! Numbers of a motion, and random ones near degenerate cases.

pub use crate::input::scenario::Start;

use crate::input::random::Random;
use std::fmt;
use toytop::{Complex, Motion, Orientation, ParameterError, State, Top, TopParameters};

/// Numbers of a motion, taken as exact.
#[derive(Clone, Copy)]
pub struct Numbers {
    /// Numbers A, C, s, p, g and K of the top. The tip slides if s > 0, and is held if s = 0 and p > 0; for p = 0 the body is free.
    pub top: [f64; 6],
    /// Launch.
    pub start: Start,
}

impl Numbers {
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

/// Random branch points: differences down to `least`, e₃ - 1 up to `most`.
pub fn branch_points(random: &mut Random, least: f64, most: f64) -> [f64; 3] {
    // 1 + e₁, e₂ - e₁ and 1 - e₂ add up to 2: a random one of them follows from the other two
    let parts = [(); 2].map(|()| random.scale(least, 0.999));
    let rotation = random.between(0.0, 3.0) as u32;
    let [below, above] = match rotation {
        0 => [parts[0], parts[1]],
        1 => [parts[0], 2.0 - parts[0] - parts[1]],
        _ => [2.0 - parts[0] - parts[1], parts[1]],
    };
    let e1 = if random.one_in(16) { -1.0 } else { (below - 1.0).clamp(-1.0, 1.0) };
    let e2 = if random.one_in(16) { 1.0 } else { (1.0 - above).clamp(e1, 1.0) };
    let [e1, e2] = match (random.one_in(16), random.one_in(2)) {
        (true, true) => [e1, e1],
        (true, false) => [e2, e2],
        _ => [e1.min(e2), e2],
    };
    let e3 = if random.one_in(16) { 1.0 } else { 1.0 + random.scale(least, most) };
    [e1, e2, e3]
}

impl fmt::Display for Numbers {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [a, c, s, p, g, k] = self.top;
        write!(f, "A={a:?} C={c:?} s={s:?} p={p:?} g={g:?} K={k:?} {:?}", self.start)
    }
}
