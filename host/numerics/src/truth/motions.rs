//! Random motions of every regime, also near degenerate cases.

use crate::input::random::Random;
use std::f64::consts::PI;
use std::fmt;
use toytop::{Motion, ParameterError, Sign, Signs, Start, Top, TopParameters};

/// Numbers of a motion, taken as exact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Numbers {
    /// Transverse moment of inertia.
    pub a: f64,
    /// Axial moment of inertia.
    pub c: f64,
    /// Distance from the tip to the centre of mass.
    pub s: f64,
    /// Mass moment.
    pub p: f64,
    /// Gravity.
    pub g: f64,
    /// Branch points.
    pub e: [f64; 3],
    /// Signs of l + n and l - n.
    pub signs: Signs,
    /// Phases at t = 0.
    pub start: Start,
}

/// Least difference of branch points that is not 0.
const LEAST: f64 = 1e-9;

impl Numbers {
    /// Random motion, log-uniform: A/(ps) in \[1e-2, 1e3\], C/A in \[0.02, 2\], differences of the branch points down to 1e-9, and e₃ up to
    /// 1e4. Each of e₁ = -1, e₂ = 1, e₃ = 1 and e₁ = e₂ is exact in one of sixteen motions, so that aperiodic, sleeping and hanging motions
    /// occur.
    #[must_use]
    pub fn random(random: &mut Random) -> Self {
        let (s, p, g) = (random.scale(0.1, 10.0), random.scale(0.1, 10.0), random.scale(0.1, 10.0));
        let a = random.scale(1e-2, 1e3) * p * s;
        let c = a * random.scale(0.02, 2.0);
        let e = branch_points(random, LEAST, 1e4);
        let sign = |random: &mut Random| if random.one_in(2) { Sign::Plus } else { Sign::Minus };
        let signs = Signs { l_plus_n: sign(random), l_minus_n: sign(random) };
        let mut angle = || random.between(-PI, PI);
        let start = Start { theta: angle(), arg_alpha: angle(), arg_beta: angle() };
        let at_corner = [0.0, PI].into_iter().find(|_| random.one_in(16));
        let start = Start { theta: at_corner.unwrap_or(start.theta), ..start };
        Self { a, c, s, p, g, e, signs, start }
    }

    /// Motion of the core.
    ///
    /// # Errors
    /// None is expected.
    pub fn motion(&self) -> Result<Motion, ParameterError> {
        let top = Top::sliding(&TopParameters {
            transverse_inertia: self.a,
            axial_inertia: self.c,
            com_height: self.s,
            mass_moment: self.p,
            gravity: self.g,
            ..TopParameters::default()
        })?;
        Motion::from_branch_points(&top, self.e, self.signs, &self.start)
    }
}

/// Random branch points: differences down to `least`, e₃ - 1 up to `most`.
#[must_use]
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
        let Self { a, c, s, p, g, e: [e1, e2, e3], signs, start } = self;
        let sign = |sign: Sign| if sign == Sign::Plus { '+' } else { '-' };
        let Start { theta, arg_alpha, arg_beta } = start;
        write!(
            f,
            "A={a:?} C={c:?} s={s:?} p={p:?} g={g:?} e={e1:?},{e2:?},{e3:?} signs={}{} theta={theta:?} args={arg_alpha:?},{arg_beta:?}",
            sign(signs.l_plus_n),
            sign(signs.l_minus_n),
        )
    }
}
