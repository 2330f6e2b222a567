//! Motion to more than thirty digits at any time: time and arguments as integrals over the half phase χ.
//!
//! ```text
//! dt/dχ = √(2 D/(g (e₃ - u))),    D = A/p + s (1 - u²),    u = e₁ cos²χ + e₂ sin²χ
//! arg α' = (l + n)/(2A (1 + u)) + τ/2,    arg β' = (l - n)/(2A (1 - u)) - τ/2,    τ = (1/C - 1/A) n
//! ```
//!
//! |α|² = (1 + u)/2 and |β|² = (1 - u)/2; where e₁ = -1 (e₂ = 1) α (β) changes sign instead of turning.
//!
//! A place is given by the nearest turning point and the sine of the difference of χ from it. In this sine the integrands are
//! algebraic, so that no trigonometry is needed and no digits are lost where the nearest singularity is at a distance of a millionth.

mod fastest;
mod orientation;
mod rates;
mod side;
mod time;

pub use orientation::PreciseOrientation;

use super::law::{End, Law, LawInF64};
use super::motions::Numbers;
use super::precise::{Precise, cis, is_positive, is_zero, precise, root};
use super::state_constants::Launched;
use side::{Passed, Side};
use std::f64::consts::PI;
use toytop::Sign;

/// Motion with its integrals from turning point to turning point.
#[derive(Clone, Debug)]
pub struct Exact {
    law: Law,
    coarse: LawInF64,
    half_tau: Precise,
    /// Directions α/|α| and β/|β| at t = 0, or those of the derivative where the parameter is 0.
    directions: [[Precise; 2]; 2],
    /// Place at t = 0.
    start: Place,
    passage: Option<Passage>,
}

/// Integrals of a motion in which u is not constant.
#[derive(Clone, Debug)]
struct Passage {
    /// Integrals near u = e₁ and near u = e₂.
    sides: [Side; 2],
    /// Integrals from one turning point to the next; for an aperiodic motion, from u = e₁ to halfway.
    half: Passed,
    /// Integrals from χ = 0 to the start.
    start: Passed,
}

/// Value of the half phase χ.
#[derive(Clone, Debug)]
struct Place {
    /// Number of quarter turns.
    quarter: i64,
    /// Sine of the difference of χ from them, within ±√½.
    beyond: Precise,
}

/// Behaviour of u.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Course {
    /// Constant u.
    Steady,
    /// Oscillation of u between e₁ and e₂.
    Nutating,
    /// Convergence of u to 1.
    Aperiodic,
}

impl Exact {
    /// Motion of these numbers.
    #[must_use]
    pub fn new(numbers: &Numbers) -> Self {
        Self::with_mass_moment(numbers, &precise(numbers.p))
    }

    /// Motion of these numbers with another mass moment, which as a product of mass and height need not be an `f64`.
    #[must_use]
    pub fn with_mass_moment(numbers: &Numbers, p: &Precise) -> Self {
        let Numbers { a, c, g, e, signs, start, .. } = *numbers;
        let [e1, e2, e3] = e.map(precise);
        let [a, c, g, one] = [a, c, g, 1.0].map(precise);
        let sign = |sign: Sign| precise(if sign == Sign::Plus { 1.0 } else { -1.0 });
        let (one_plus_e1, one_minus_e2) = (&one + &e1, &one - &e2);
        let weight = (&a * p * &g) << 1;
        let plus = &weight * &one_plus_e1 * (&one + &e2) * (&one + &e3);
        let minus = &weight * (&one - &e1) * &one_minus_e2 * (&e3 - &one);
        let l_plus_n = sign(signs.l_plus_n) * root(&plus);
        let l_minus_n = sign(signs.l_minus_n) * root(&minus);
        let n = (&l_plus_n - &l_minus_n) >> 1;
        let twice_a = a.clone() << 1;
        let law = Law {
            s: precise(numbers.s),
            one_plus_e1,
            one_minus_e2,
            e2_minus_e1: &e2 - &e1,
            e3_minus_e2: &e3 - &e2,
            torque: true,
            a_over_p: &a / p,
            momenta: [l_plus_n / &twice_a, l_minus_n / &twice_a],
            g,
        };
        let half_tau = ((&one / &c - &one / &a) * n) >> 1;
        let half_phase = if start.theta.abs() == PI {
            // the f64 nearest to π stands for π
            [precise(0.0), precise(start.theta.signum())]
        } else {
            cis(&(precise(start.theta) >> 1))
        };
        let directions = [start.arg_alpha, start.arg_beta].map(|angle| cis(&precise(angle)));
        Self::with(law, half_tau, directions, half_phase)
    }

    /// Motion of a state.
    #[must_use]
    pub fn launched(launched: &Launched) -> Self {
        let Launched { law, half_tau, half_phase, directions } = launched.clone();
        let [cosine, sine] = half_phase;
        // an aperiodic motion that falls begins at χ = -π/2, not at π/2
        let falls = is_zero(&law.e3_minus_e2) && is_positive(&-&cosine);
        let half_phase = if falls { [-cosine, -sine] } else { [cosine, sine] };
        Self::with(law, half_tau, directions, half_phase)
    }

    fn with(law: Law, half_tau: Precise, directions: [[Precise; 2]; 2], half_phase: [Precise; 2]) -> Self {
        Self { coarse: law.in_f64(), law, half_tau, directions, start: Place::of(half_phase), passage: None }
            .with_passage(0)
    }

    /// Motion with its integrals; the panels at the turning points are shorter by the factor 4 to the power `finer`.
    fn with_passage(mut self, finer: usize) -> Self {
        self.passage = None;
        if self.course() == Course::Steady {
            return self;
        }
        let ends = [End::Lower, End::Upper];
        let sides = ends.map(|end| Side::new(&self.law, end, self.coarse.depth(end), finer));
        let half = side::sum(sides[0].whole(), sides[1].whole());
        let zero = || precise(0.0);
        let mut passage = Passage { sides, half, start: [zero(), zero(), zero()] };
        passage.start = passage.passed(&self.law, &self.start);
        self.passage = Some(passage);
        self
    }

    /// Kind of motion, by the branch points of the truth.
    #[must_use]
    pub fn course(&self) -> Course {
        let Law { one_minus_e2, e2_minus_e1, e3_minus_e2, .. } = &self.law;
        let Place { quarter, beyond } = &self.start;
        let upright = quarter % 2 != 0 && is_zero(beyond) && is_zero(one_minus_e2);
        if is_zero(e2_minus_e1) || (is_zero(e3_minus_e2) && upright) {
            Course::Steady
        } else if is_zero(e3_minus_e2) {
            Course::Aperiodic
        } else {
            Course::Nutating
        }
    }
}

impl Place {
    /// Place with this cos χ and sin χ.
    fn of([cosine, sine]: [Precise; 2]) -> Self {
        let negative = |x: &Precise| is_positive(&-x);
        if cosine.sqr() >= sine.sqr() {
            if negative(&cosine) {
                Self { quarter: 2, beyond: -sine }
            } else {
                Self { quarter: 0, beyond: sine }
            }
        } else if negative(&sine) {
            Self { quarter: -1, beyond: cosine }
        } else {
            Self { quarter: 1, beyond: -cosine }
        }
    }

    /// Place of a half phase, rad, to the rounding of `f64`.
    fn near(half_phase: f64) -> Self {
        let quarter = (half_phase / (0.5 * PI)).round();
        Self { quarter: quarter as i64, beyond: precise((half_phase - 0.5 * PI * quarter).sin()) }
    }

    /// Values of sin χ and cos χ, each up to a positive factor.
    fn signs(&self) -> [f64; 2] {
        let beyond = if is_zero(&self.beyond) {
            0.0
        } else if is_positive(&self.beyond) {
            1.0
        } else {
            -1.0
        };
        match self.quarter.rem_euclid(4) {
            0 => [beyond, 1.0],
            1 => [1.0, -beyond],
            2 => [-beyond, -1.0],
            _ => [-1.0, beyond],
        }
    }
}

#[cfg(test)]
mod tests;
