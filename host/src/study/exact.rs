//! One motion to thirty digits: time and arguments as integrals over the half phase χ.
//!
//! ```text
//! dt/dχ = √(2 D/(g (e₃ - u))),    D = A/p + s (1 - u²),    u = e₁ cos²χ + e₂ sin²χ
//! arg α' = (l + n)/(2A (1 + u)) + τ/2,    arg β' = (l - n)/(2A (1 - u)) - τ/2,    τ = (1/C - 1/A) n
//! ```
//!
//! |α|² = (1 + u)/2 and |β|² = (1 - u)/2; where e₁ = -1 (e₂ = 1) α (β) changes sign instead of turning.

mod orientation;
mod path;

use super::gauss::Rule;
use super::motions::Numbers;
use super::trigonometry::{cis, quarter_turn};
use super::wide::Launched;
use std::f64::consts::PI;
use toytop::real::{DoubleDouble, Float, Ring};
use toytop::{Complex, Sign};

type Dd = DoubleDouble;

/// The constants of a motion.
#[derive(Clone, Debug)]
pub struct Exact<'a> {
    rule: &'a Rule,
    s: Dd,
    g: Dd,
    one_plus_e1: Dd,
    one_minus_e2: Dd,
    e2_minus_e1: Dd,
    e3_minus_e2: Dd,
    a_over_p: Dd,
    /// (l ± n)/(2A).
    momenta: [Dd; 2],
    half_tau: Dd,
    /// χ at t = 0.
    chi: Dd,
    /// α/|α| and β/|β| at t = 0; of the derivative where the parameter is 0.
    directions: [Complex<Dd>; 2],
    /// How far from χ = 0 and from χ = π/2 (mod π) the nearest singularity is.
    depths: [f64; 2],
}

/// What u does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Course {
    /// Nothing.
    Steady,
    /// It swings.
    Nutating,
    /// It tends to 1.
    Aperiodic,
}

/// A moment on the way: χ, and what has passed since the start.
#[derive(Clone, Copy, Debug)]
pub struct Point {
    /// χ.
    pub chi: Dd,
    /// Time since the start.
    pub t: Dd,
    /// How far arg α and arg β have advanced, the drift ±τt/2 apart.
    turned: [Dd; 2],
}

impl Point {
    /// The same at a time, where nothing but time passes.
    #[must_use]
    pub fn resting_until(self, t: f64) -> Self {
        Self { t: t.into(), ..self }
    }
}

impl<'a> Exact<'a> {
    /// The motion of these numbers.
    #[must_use]
    pub fn new(numbers: &Numbers, rule: &'a Rule) -> Self {
        let dd = Dd::from;
        let Numbers { a, c, p, g, e: [e1, e2, e3], signs, start, .. } = *numbers;
        let (one_plus_e1, one_minus_e2) = (dd(1.0) + dd(e1), dd(1.0) - dd(e2));
        let (e2_minus_e1, e3_minus_e2) = (dd(e2) - dd(e1), dd(e3) - dd(e2));
        let weight = (dd(a) * dd(p) * dd(g)).doubled();
        let sign = |sign: Sign| dd(if sign == Sign::Plus { 1.0 } else { -1.0 });
        let l_plus_n =
            sign(signs.l_plus_n) * (weight * one_plus_e1 * (dd(1.0) + dd(e2)) * (dd(1.0) + dd(e3))).sqrt();
        let l_minus_n =
            sign(signs.l_minus_n) * (weight * (dd(1.0) - dd(e1)) * one_minus_e2 * (dd(e3) - dd(1.0))).sqrt();
        let n = (l_plus_n - l_minus_n).halved();
        let twice_a = dd(a).doubled();
        Self {
            rule,
            s: dd(numbers.s),
            g: dd(g),
            one_plus_e1,
            one_minus_e2,
            e2_minus_e1,
            e3_minus_e2,
            a_over_p: dd(a) / dd(p),
            momenta: [l_plus_n / twice_a, l_minus_n / twice_a],
            half_tau: ((Dd::ONE / dd(c) - Dd::ONE / dd(a)) * n).halved(),
            // the f64 nearest to π means π
            chi: if start.theta == PI { quarter_turn() } else { dd(0.5 * start.theta) },
            directions: [start.arg_alpha, start.arg_beta].map(|angle| cis(angle.into())),
            depths: [0.0; 2],
        }
        .with_depths()
    }

    /// The motion of a state.
    #[must_use]
    pub fn launched(launched: &Launched, rule: &'a Rule) -> Self {
        let Launched { s, g, one_plus_e1, one_minus_e2, e2_minus_e1, e3_minus_e2, .. } = *launched;
        let Launched { a_over_p, momenta, half_tau, half_phase, directions, .. } = *launched;
        let Complex { re: cosine, im: sine } = half_phase;
        // from 16 digits to 32 by one step of Newton's method
        let guess = Dd::from(sine.to_f64().atan2(cosine.to_f64()));
        let near = cis(guess);
        let chi = guess + sine * near.re - cosine * near.im;
        let depths = [0.0; 2];
        Self {
            rule,
            s,
            g,
            one_plus_e1,
            one_minus_e2,
            e2_minus_e1,
            e3_minus_e2,
            a_over_p,
            momenta,
            half_tau,
            chi,
            directions,
            depths,
        }
        .with_depths()
    }

    fn with_depths(self) -> Self {
        // e₄² - 1 = A/(ps)
        let spread = self.a_over_p.to_f64() / self.s.to_f64();
        let beyond_e4 = spread / ((1.0 + spread).sqrt() + 1.0);
        let depth = |gaps: &[f64]| {
            let least = gaps.iter().copied().filter(|gap| *gap > 0.0).fold(f64::INFINITY, f64::min);
            (least / self.e2_minus_e1.to_f64()).sqrt().min(0.5)
        };
        let (below, above) = (self.one_plus_e1.to_f64(), self.one_minus_e2.to_f64());
        // an aperiodic motion has its pole right at χ = π/2, which it never reaches
        let depths = [
            depth(&[below, below + beyond_e4]),
            if self.e3_minus_e2 == Dd::ZERO {
                0.0
            } else {
                depth(&[above, above + beyond_e4, self.e3_minus_e2.to_f64()])
            },
        ];
        Self { depths, ..self }
    }

    /// What kind of motion it is, by the truth's own numbers.
    #[must_use]
    pub fn course(&self) -> Course {
        let upright = self.chi == quarter_turn() && self.one_minus_e2 == Dd::ZERO;
        if self.e2_minus_e1 == Dd::ZERO || (self.e3_minus_e2 == Dd::ZERO && upright) {
            Course::Steady
        } else if self.e3_minus_e2 == Dd::ZERO {
            Course::Aperiodic
        } else {
            Course::Nutating
        }
    }

    /// The start.
    #[must_use]
    pub fn start(&self) -> Point {
        Point { chi: self.chi, t: Dd::ZERO, turned: [Dd::ZERO; 2] }
    }

    /// 1 + u, 1 - u and dt/dχ.
    fn law(&self, chi: Dd) -> [Dd; 3] {
        let Complex { re: cosine, im: sine } = cis(chi);
        self.law_at(sine, cosine)
    }

    /// The same, from sin χ and cos χ up to their signs.
    fn law_at(&self, sine: Dd, cosine: Dd) -> [Dd; 3] {
        let one_plus_u = self.one_plus_e1 + self.e2_minus_e1 * sine.squared();
        let swing = self.e2_minus_e1 * cosine.squared();
        let one_minus_u = self.one_minus_e2 + swing;
        let d = self.a_over_p + self.s * one_plus_u * one_minus_u;
        let slowness = (d.doubled() / (self.g * (self.e3_minus_e2 + swing))).sqrt();
        [one_plus_u, one_minus_u, slowness]
    }
}

#[cfg(test)]
mod tests;
