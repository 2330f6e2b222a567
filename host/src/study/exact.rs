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
use std::f64::consts::{FRAC_PI_2, PI};
use toytop::real::{DoubleDouble, Float, Ring};
use toytop::{Complex, Phi, Sign};

type Dd = DoubleDouble;

/// The constants of a motion.
#[derive(Clone, Debug)]
pub struct Exact<'a> {
    rule: &'a Rule,
    numbers: Numbers,
    one_plus_e1: Dd,
    one_minus_e2: Dd,
    e2_minus_e1: Dd,
    e3_minus_e2: Dd,
    a_over_p: Dd,
    /// (l ± n)/(2A).
    momenta: [Dd; 2],
    half_tau: Dd,
    /// How far from χ = 0 and from χ = π/2 (mod π) the nearest singularity is.
    depths: [f64; 2],
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

impl<'a> Exact<'a> {
    /// The motion of these numbers.
    #[must_use]
    pub fn new(numbers: &Numbers, rule: &'a Rule) -> Self {
        let dd = Dd::from;
        let Numbers { a, c, s, p, g, e: [e1, e2, e3], signs, .. } = *numbers;
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
        let a_over_p = dd(a) / dd(p);
        let e4 = (1.0 + a / (p * s)).sqrt();
        let beyond_e4 = (e4 * e4 - 1.0) / (e4 + 1.0);
        let depth = |gaps: &[f64]| {
            let least = gaps.iter().copied().filter(|gap| *gap > 0.0).fold(f64::INFINITY, f64::min);
            (least / e2_minus_e1.to_f64()).sqrt().min(0.5)
        };
        let (below, above) = (one_plus_e1.to_f64(), one_minus_e2.to_f64());
        // an aperiodic motion has its pole right at χ = π/2, which it never reaches
        let depths = [
            depth(&[below, below + beyond_e4]),
            if e3_minus_e2 == Dd::ZERO {
                0.0
            } else {
                depth(&[above, above + beyond_e4, e3_minus_e2.to_f64()])
            },
        ];
        Self {
            rule,
            numbers: *numbers,
            one_plus_e1,
            one_minus_e2,
            e2_minus_e1,
            e3_minus_e2,
            a_over_p,
            momenta: [l_plus_n / twice_a, l_minus_n / twice_a],
            half_tau: ((Dd::ONE / dd(c) - Dd::ONE / dd(a)) * n).halved(),
            depths,
        }
    }

    /// The start.
    #[must_use]
    pub fn start(&self) -> Point {
        let theta = self.numbers.start.theta;
        // the f64 nearest to π means π
        let chi = if theta == PI { quarter_turn() } else { Dd::from(0.5 * theta) };
        Point { chi, t: Dd::ZERO, turned: [Dd::ZERO; 2] }
    }

    /// 1 + u, 1 - u and dt/dχ.
    fn law(&self, chi: Dd) -> [Dd; 3] {
        let Complex { re: cosine, im: sine } = cis(chi);
        let one_plus_u = self.one_plus_e1 + self.e2_minus_e1 * sine.squared();
        let swing = self.e2_minus_e1 * cosine.squared();
        let one_minus_u = self.one_minus_e2 + swing;
        let d = self.a_over_p + Dd::from(self.numbers.s) * one_plus_u * one_minus_u;
        let slowness = (d.doubled() / (Dd::from(self.numbers.g) * (self.e3_minus_e2 + swing))).sqrt();
        [one_plus_u, one_minus_u, slowness]
    }

    /// d(t, arg α, arg β)/dχ without the drift.
    fn integrand(&self, chi: Dd) -> [Dd; 3] {
        let [one_plus_u, one_minus_u, slowness] = self.law(chi);
        let turning = |momentum: Dd, complement: Dd| {
            if momentum == Dd::ZERO { Dd::ZERO } else { momentum / complement * slowness }
        };
        let [alpha, beta] = self.momenta;
        [slowness, turning(alpha, one_plus_u), turning(beta, one_minus_u)]
    }

    /// From a point on to a larger, or back to a smaller, χ.
    #[must_use]
    pub fn go(&self, from: &Point, chi: Dd) -> Point {
        let (low, high, sense) =
            if chi < from.chi { (chi, from.chi, -Dd::ONE) } else { (from.chi, chi, Dd::ONE) };
        let mut sums = [Dd::ZERO; 3];
        let mut at = low;
        while at < high {
            let next = self.panel_end(at.to_f64());
            let next = if Dd::from(next) > at && Dd::from(next) < high { next.into() } else { high };
            let panel = self.rule.integrate([at, next], |chi| self.integrand(chi));
            sums.iter_mut().zip(panel).for_each(|(sum, part)| *sum = *sum + part);
            at = next;
        }
        let [t, alpha, beta] = sums.map(|sum| sense * sum);
        let [turned_alpha, turned_beta] = from.turned;
        Point { chi, t: from.t + t, turned: [turned_alpha + alpha, turned_beta + beta] }
    }

    /// A panel is no longer than what lies between it and the nearest turning point, or than the depth there.
    fn panel_end(&self, at: f64) -> f64 {
        // halfway, to rounding, counts as the one ahead
        let quarter = (at / FRAC_PI_2 + (0.5 + 1e-9)).floor();
        let [bottom, top] = self.depths;
        let depth = if quarter.rem_euclid(2.0) == 0.0 { bottom } else { top };
        let centre = quarter * FRAC_PI_2;
        let distance = at - centre;
        if distance >= 0.0 {
            centre + (2.0 * distance).max(depth).min(0.5 * FRAC_PI_2)
        } else if -distance <= depth * (1.0 + 1e-9) {
            centre
        } else {
            centre + (0.5 * distance).min(-depth)
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

    /// Φ at a time so close to the point that what is between is linear.
    #[must_use]
    pub fn phi(&self, point: &Point, t: f64) -> Phi<Dd> {
        let ahead = Dd::from(t) - point.t;
        let Complex { re: cosine, im: sine } = cis(point.chi);
        let [one_plus_u, one_minus_u, slowness] = self.law(point.chi);
        let chi_step = ahead / slowness;
        let rise = self.e2_minus_e1 * sine * cosine * chi_step; // half of what u rises
        let place = |complement: Dd, rise: Dd, turned: Dd, momentum: Dd, drift: Dd, argument: f64| {
            let modulus = complement.halved().sqrt();
            // where it vanishes so does its momentum, and the other parameter's change is all there is
            let (grown, turning) = if complement > Dd::ZERO {
                (modulus + modulus * rise / complement, momentum / complement)
            } else {
                (modulus, Dd::ZERO)
            };
            let angle = turned + turning * ahead + drift * Dd::from(t) + argument.into();
            let cis = cis(angle);
            Complex::new(cis.re * grown, cis.im * grown)
        };
        let start = &self.numbers.start;
        let ([alpha, beta], [alpha_turned, beta_turned]) = (self.momenta, point.turned);
        let alpha = place(one_plus_u, rise, alpha_turned, alpha, self.half_tau, start.arg_alpha);
        let beta = place(one_minus_u, -rise, beta_turned, beta, -self.half_tau, start.arg_beta);
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
        let start = &self.numbers.start;
        let place = |complement: Dd, momentum: Dd, drift: Dd, argument: f64| {
            if complement == Dd::ZERO {
                return Complex::ZERO;
            }
            let modulus = complement.halved().sqrt();
            let cis = cis((momentum / complement + drift) * Dd::from(t) + argument.into());
            Complex::new(cis.re * modulus, cis.im * modulus)
        };
        let [alpha, beta] = self.momenta;
        Phi {
            alpha: place(one_plus_u, alpha, self.half_tau, start.arg_alpha),
            beta: place(one_minus_u, beta, -self.half_tau, start.arg_beta),
        }
    }

    /// 1 + u and 1 - u of a motion in which u is e₂.
    #[must_use]
    pub fn at_e2(&self) -> [Dd; 2] {
        [self.one_plus_e1 + self.e2_minus_e1, self.one_minus_e2]
    }
}

#[cfg(test)]
mod tests;
