//! One motion to thirty digits: time and arguments as integrals over the half phase χ.
//!
//! ```text
//! dt/dχ = √(2 D/(g (e₃ - u))),    D = A/p + s (1 - u²),    u = e₁ cos²χ + e₂ sin²χ
//! arg α' = (l + n)/(2A (1 + u)) + τ/2,    arg β' = (l - n)/(2A (1 - u)) - τ/2,    τ = (1/C - 1/A) n
//! ```
//!
//! |α|² = (1 + u)/2 and |β|² = (1 - u)/2; where e₁ = -1 (e₂ = 1) α (β) changes sign instead of turning.

use super::gauss::Rule;
use super::motions::Numbers;
use super::trigonometry::{cis, quarter_turn};
use super::wide::Launched;
use std::f64::consts::{FRAC_PI_2, PI};
use toytop::real::{DoubleDouble, Float, Ring};
use toytop::{Complex, Phi, Sign};

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

    /// d(t, arg α, arg β)/dχ without the drift, at so much beyond so many quarter turns.
    fn integrand(&self, quarter: f64, beyond: Dd) -> [Dd; 3] {
        let Complex { re, im } = cis(beyond);
        let (sine, cosine) = if is_even(quarter) { (im, re) } else { (re, im) };
        let [one_plus_u, one_minus_u, slowness] = self.law_at(sine, cosine);
        let turning = |momentum: Dd, complement: Dd| {
            if momentum == Dd::ZERO { Dd::ZERO } else { momentum / complement * slowness }
        };
        let [alpha, beta] = self.momenta;
        [slowness, turning(alpha, one_plus_u), turning(beta, one_minus_u)]
    }

    /// From a point on to a larger, or back to a smaller, χ.
    ///
    /// Places are told by how far they are beyond the nearest turning point: the depth there may be far less than what
    /// double-double tells apart beside π/2.
    #[must_use]
    pub fn go(&self, from: &Point, chi: Dd) -> Point {
        let (low, high, sense) =
            if chi < from.chi { (chi, from.chi, -Dd::ONE) } else { (from.chi, chi, Dd::ONE) };
        let mut sums = [Dd::ZERO; 3];
        // halfway, to rounding, counts as the one ahead
        let mut quarter = (low.to_f64() / FRAC_PI_2 + (0.5 + 1e-9)).floor();
        let mut beyond = low - quarter_turn() * quarter.into();
        loop {
            let last = high - quarter_turn() * quarter.into();
            if beyond >= last {
                break;
            }
            let next = Dd::from(self.panel_end(quarter, beyond.to_f64()));
            let next = if next > beyond && next < last { next } else { last };
            let panel = self.rule.integrate([beyond, next], |beyond| self.integrand(quarter, beyond));
            sums.iter_mut().zip(panel).for_each(|(sum, part)| *sum = *sum + part);
            beyond = next;
            if beyond.to_f64() >= (0.5 - 1e-9) * FRAC_PI_2 {
                quarter += 1.0;
                beyond = beyond - quarter_turn();
            }
        }
        let [t, alpha, beta] = sums.map(|sum| sense * sum);
        let [turned_alpha, turned_beta] = from.turned;
        Point { chi, t: from.t + t, turned: [turned_alpha + alpha, turned_beta + beta] }
    }

    /// A panel is no longer than what lies between it and the nearest turning point, or than the depth there.
    fn panel_end(&self, quarter: f64, beyond: f64) -> f64 {
        let [bottom, top] = self.depths;
        let depth = if is_even(quarter) { bottom } else { top };
        if beyond >= 0.0 {
            (2.0 * beyond).max(depth).min(0.5 * FRAC_PI_2)
        } else if -beyond <= depth * (1.0 + 1e-9) {
            0.0
        } else {
            (0.5 * beyond).min(-depth)
        }
    }

    /// One nutation period after the start; of no meaning for an aperiodic motion.
    #[must_use]
    pub fn period(&self) -> Point {
        let start = Point { chi: Dd::ZERO, ..self.start() };
        let half = self.go(&start, quarter_turn());
        let [alpha, beta] = half.turned;
        Point {
            chi: quarter_turn().doubled(),
            t: half.t.doubled(),
            turned: [alpha.doubled(), beta.doubled()],
        }
    }

    /// So many periods after a point.
    #[must_use]
    pub fn later(&self, point: &Point, period: &Point, periods: f64) -> Point {
        let on = |now: Dd, step: Dd| now + step * periods.into();
        let ([alpha, beta], [alpha_step, beta_step]) = (point.turned, period.turned);
        Point {
            chi: on(point.chi, period.chi),
            t: on(point.t, period.t),
            turned: [on(alpha, alpha_step), on(beta, beta_step)],
        }
    }

    /// The point at a time close to that of a point; `place` is the same place in the first period.
    #[must_use]
    pub fn at_time(&self, point: &Point, place: Dd, t: f64) -> Point {
        const NEWTON_STEPS: u32 = 4;
        let here = Point { chi: place, t: point.t, turned: point.turned };
        let mut moved = here;
        for _ in 0..NEWTON_STEPS {
            let [_, _, slowness] = self.law(moved.chi);
            moved = self.go(&here, moved.chi + (Dd::from(t) - moved.t) / slowness);
        }
        Point { chi: point.chi + (moved.chi - place), ..moved }
    }

    /// The point of a time, found from a point before or after it: Newton's steps, halved where they leave the bracket of χ.
    #[must_use]
    pub fn seek(&self, from: &Point, t: f64, [low, high]: [f64; 2]) -> Point {
        const STEPS: u32 = 200;
        let (mut low, mut high) = (low, high);
        let mut point = *from;
        for _ in 0..STEPS {
            let behind = Dd::from(t) - point.t;
            let chi = point.chi.to_f64();
            if behind < Dd::ZERO {
                high = high.min(chi)
            } else {
                low = low.max(chi)
            }
            let [_, _, slowness] = self.law(point.chi);
            let step = behind / slowness;
            let there = (point.chi + step).to_f64();
            if step.to_f64().abs() < 1e-15 {
                break;
            }
            let next =
                if low < there && there < high { point.chi + step } else { (0.5 * (low + high)).into() };
            point = self.go(&point, next);
        }
        point
    }

    /// Φ at a time so close to the point that what is between is linear.
    #[must_use]
    pub fn phi(&self, point: &Point, t: f64) -> Phi<Dd> {
        let ahead = Dd::from(t) - point.t;
        let Complex { re: cosine, im: sine } = cis(point.chi);
        let [one_plus_u, one_minus_u, slowness] = self.law(point.chi);
        let chi_step = ahead / slowness;
        let rise = self.e2_minus_e1 * sine * cosine * chi_step; // half of what u rises
        let place = |complement: Dd, rise: Dd, turned: Dd, momentum: Dd, drift: Dd| {
            let modulus = complement.halved().sqrt();
            // where it vanishes so does its momentum, and the other parameter's change is all there is
            let (grown, turning) = if complement > Dd::ZERO {
                (modulus + modulus * rise / complement, momentum / complement)
            } else {
                (modulus, Dd::ZERO)
            };
            cis(turned + turning * ahead + drift * Dd::from(t)).scaled(grown)
        };
        let ([alpha, beta], [alpha_turned, beta_turned]) = (self.momenta, point.turned);
        let [alpha_from, beta_from] = self.directions;
        let alpha = alpha_from * place(one_plus_u, rise, alpha_turned, alpha, self.half_tau);
        let beta = beta_from * place(one_minus_u, -rise, beta_turned, beta, -self.half_tau);
        let [alpha_sign, beta_sign] = self.signs(sine, cosine);
        Phi { alpha: alpha.scaled(alpha_sign), beta: beta.scaled(beta_sign) }
    }

    /// -1 for a parameter that has passed through 0 an odd number of times.
    fn signs(&self, sine: Dd, cosine: Dd) -> [Dd; 2] {
        let sign = |x: Dd| Dd::from(if x < Dd::ZERO { -1.0 } else { 1.0 });
        let from = cis(self.start().chi);
        let small = |x: Dd| x.abs() < Dd::from(1e-15);
        // a parameter that is 0 at the start has its direction from its derivative
        let alpha = if small(from.im) { from.re } else { from.im };
        let beta = if small(from.re) { -from.im } else { from.re };
        let passes = |passes: bool, now: Dd, then: Dd| if passes { sign(now) * sign(then) } else { Dd::ONE };
        [
            passes(self.one_plus_e1 == Dd::ZERO, sine, alpha),
            passes(self.one_minus_e2 == Dd::ZERO, cosine, beta),
        ]
    }

    /// Φ of a motion in which u is constant.
    #[must_use]
    pub fn steady_phi(&self, t: f64, one_plus_u: Dd, one_minus_u: Dd) -> Phi<Dd> {
        let place = |complement: Dd, momentum: Dd, drift: Dd| {
            if complement == Dd::ZERO {
                return Complex::ZERO;
            }
            cis((momentum / complement + drift) * Dd::from(t)).scaled(complement.halved().sqrt())
        };
        let ([alpha, beta], [alpha_from, beta_from]) = (self.momenta, self.directions);
        Phi {
            alpha: alpha_from * place(one_plus_u, alpha, self.half_tau),
            beta: beta_from * place(one_minus_u, beta, -self.half_tau),
        }
    }

    /// 1 + u and 1 - u of a motion in which u is e₂.
    #[must_use]
    pub fn at_e2(&self) -> [Dd; 2] {
        [self.one_plus_e1 + self.e2_minus_e1, self.one_minus_e2]
    }
}

/// χ is a multiple of a half turn: u is e₁ there.
fn is_even(quarter: f64) -> bool {
    quarter.rem_euclid(2.0) == 0.0
}

#[cfg(test)]
mod tests;
