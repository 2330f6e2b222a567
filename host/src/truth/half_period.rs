//! Integrals along the half period in which u rises from e₁ to e₂: time, and the advances of arg α and arg β.
//!
//! ```text
//! dt/dχ = √(2 D/(g (e₃ - u))),    D = A/p + s (1 - u²),    u = e₁ cos²χ + e₂ sin²χ
//! d(arg α)/dt = (l + n)/(2A (1 + u)) + τ/2,    d(arg β)/dt = (l - n)/(2A (1 - u)) - τ/2
//! ```
//!
//! All singularities of these rates are at negative tan²χ. So panels whose ends have tan χ in the ratio 1 : 2 suffice for every motion,
//! down to the smallest singularity; 26 nodes give a relative error of (3 + √8)^-52, 1e-39.

use super::precise::{
    ComplexPrecise, Precise, is_zero, norm_squared, precise, root, to_f64, to_nearest, whole,
};
use std::f64::consts::PI;
use std::sync::LazyLock;

/// Ratio of tan χ at the ends of a panel.
pub const RATIO: f64 = 0.5;
/// Number of nodes of a panel.
const NODE_COUNT: i64 = 26;
/// Least cos χ of an aperiodic motion that is integrated: there |β| is below 1e-24, and α turns at a constant rate.
const LEAST_COSINE: f64 = 1e-24;

/// Half phase χ, as a positive multiple of cos χ + i sin χ.
pub type HalfPhase = ComplexPrecise;

/// Time, and the advances of arg α and arg β without ±τt/2.
pub type Integrals = [Precise; 3];

/// Constants of a motion.
#[derive(Clone)]
pub struct Constants {
    pub s: Precise,
    pub g: Precise,
    pub a_over_p: Precise,
    /// Values of 1 + u, 1 - u and e₃ - u, each at u = e₁ and at u = e₂. Without torque, the integrals are those with e₃ - u = 1.
    pub ends: [[Precise; 2]; 3],
    /// Rates (l ± n)/(2A).
    pub momenta: [Precise; 2],
}

impl Constants {
    /// Values of 1 + u, 1 - u and e₃ - u.
    pub fn heights(&self, place: &HalfPhase) -> [Precise; 3] {
        let square = norm_squared(place);
        let [lower, upper] = place.each_ref().map(|part| part.sqr() / &square);
        self.ends.each_ref().map(|[at_e1, at_e2]| at_e1 * &lower + at_e2 * &upper)
    }

    /// Derivatives of the integrals with respect to χ.
    fn rates(&self, place: &HalfPhase) -> Integrals {
        let [one_plus_u, one_minus_u, below_e3] = self.heights(place);
        let d = &self.a_over_p + &self.s * &one_plus_u * &one_minus_u;
        let slowness = root(&(d * 2 / (&self.g * below_e3)));
        let turning = |momentum: &Precise, height: Precise| match is_zero(momentum) {
            true => whole(0),
            false => momentum / height * &slowness,
        };
        let [alpha, beta] = &self.momenta;
        let (alpha, beta) = (turning(alpha, one_plus_u), turning(beta, one_minus_u));
        [slowness, alpha, beta]
    }

    /// Derivatives of the integrals with respect to x, at the place from + x (to - from).
    fn rates_between(&self, from: &HalfPhase, to: &HalfPhase, x: &Precise) -> Integrals {
        let place = between(from, to, x);
        let rate = (&from[0] * &to[1] - &from[1] * &to[0]) / norm_squared(&place);
        self.rates(&place).map(|derivative| derivative * &rate)
    }

    fn integrals(&self, from: &HalfPhase, to: &HalfPhase) -> Integrals {
        integrate(|x| self.rates_between(from, to, x))
    }
}

/// Half period with the integrals from its beginning to the ends of the panels.
pub struct HalfPeriod {
    constants: Constants,
    panels: Vec<(HalfPhase, Integrals)>,
    /// Whether u = e₂ is reached, which it is not in an aperiodic motion.
    pub arrives: bool,
    /// Integrals over the half period.
    pub whole: Integrals,
}

impl HalfPeriod {
    /// Half period of a motion in which u changes.
    pub fn new(constants: &Constants, ratio: f64) -> Self {
        let [[one_plus_e1, _], [_, one_minus_e2], [_, e3_minus_e2]] = &constants.ends;
        let arrives = !is_zero(e3_minus_e2);
        let spread = to_f64(&constants.a_over_p) / to_f64(&constants.s);
        let gaps = [one_plus_e1, one_minus_e2, e3_minus_e2].map(to_f64).into_iter().chain([spread]);
        let least = gaps.filter(|gap| *gap > 0.0).fold(1.0, f64::min);
        let shortest = if arrives { 0.25 * least.sqrt() } else { LEAST_COSINE };
        let count = (shortest.ln() / ratio.ln()).ceil() as usize;
        let powers = std::iter::successors(Some(whole(1)), |power| Some(power * precise(ratio)));
        let tangents: Vec<_> = powers.take(count + 1).collect();
        let rising = tangents.iter().rev().map(|tangent| [whole(1), tangent.clone()]);
        let falling = tangents.iter().skip(1).map(|cotangent| [cotangent.clone(), whole(1)]);
        let last = arrives.then(|| [whole(0), whole(1)]);
        let (mut panels, mut from, mut passed) =
            (Vec::new(), [whole(1), whole(0)], [(); 3].map(|()| whole(0)));
        for to in rising.chain(falling).chain(last) {
            let next = add(&passed, &constants.integrals(&from, &to), 1);
            panels.push((from, passed));
            (from, passed) = (to, next);
        }
        panels.push((from, passed.clone()));
        Self { constants: constants.clone(), panels, arrives, whole: passed }
    }

    /// Integrals from χ = 0 to a place.
    pub fn passed(&self, [cosine, sine]: &HalfPhase) -> Integrals {
        let zero = whole(0);
        if *cosine < zero {
            let half_turn = if *sine < zero { -2 } else { 2 };
            add(&self.passed(&[-cosine, -sine]), &self.whole, half_turn)
        } else if *sine < zero {
            self.passed(&[cosine.clone(), -sine]).map(|integral| -integral)
        } else {
            let (from, passed) = &self.panels[self.panel(|([x, y], _)| x * sine < y * cosine)];
            add(passed, &self.constants.integrals(from, &[cosine.clone(), sine.clone()]), 1)
        }
    }

    /// Place at a time after χ = 0, and the integrals from there.
    pub fn at(&self, time: &Precise) -> (HalfPhase, Integrals) {
        // times are less than 2^63 ticks, and a period contains many ticks
        let period = &self.whole[0] * 2;
        let periods = if self.arrives { to_nearest(&(time / &period)).unwrap_or(i64::MAX / 2) } else { 0 };
        let late = time - period * periods;
        let sense = if late < whole(0) { -1 } else { 1 };
        let ([cosine, sine], there) = self.within(late * sense);
        // χ increases by π in a period
        let half_turn = if periods % 2 == 0 { 1 } else { -1 };
        let there = there.map(|integral| integral * sense);
        ([cosine * half_turn, sine * (sense * half_turn)], add(&there, &self.whole, 2 * periods))
    }

    /// Place at a time in the half period, by Newton's method, and the integrals from its beginning.
    fn within(&self, time: Precise) -> (HalfPhase, Integrals) {
        const MOST_STEPS: u32 = 20;
        /// Step whose square is far below the errors that the truth is compared with, also in differences of neighbouring launches.
        const NEAR: f64 = 1e-18;
        if time >= self.whole[0] {
            let resting = &time - &self.whole[0];
            let alpha = &self.whole[1] + &self.constants.momenta[0] * (resting >> 1);
            let (place, _) = &self.panels[self.panels.len() - 1];
            return (place.clone(), [time, alpha, self.whole[2].clone()]);
        }
        let panel = self.panel(|(_, passed)| passed[0] > time);
        let [(from, passed), (to, passed_then)] = [&self.panels[panel], &self.panels[panel + 1]];
        let mut x = (&time - &passed[0]) / (&passed_then[0] - &passed[0]);
        let mut steps = 0;
        loop {
            let there = add(passed, &self.constants.integrals(from, &between(from, to, &x)), 1);
            let [slowness, alpha_rate, beta_rate] = self.constants.rates_between(from, to, &x);
            let step = (&time - &there[0]) / slowness;
            x += &step;
            steps += 1;
            // the step is so short that the integrals are linear on it
            if to_f64(&step).abs() <= NEAR || steps == MOST_STEPS {
                let [_, alpha, beta] = there;
                return (between(from, to, &x), [time, alpha + alpha_rate * &step, beta + beta_rate * step]);
            }
            x = x.clamp(whole(0), whole(1));
        }
    }

    /// Time after χ = 0, at the end of a panel, at which Φ without its mean rotation changes fastest.
    pub fn fastest(&self) -> Precise {
        let fastest = self.panels.iter().max_by(|(x, _), (y, _)| self.speed(x).total_cmp(&self.speed(y)));
        fastest.map_or(whole(0), |(_, passed)| passed[0].clone())
    }

    /// Square of the rate of Φ without its mean rotation: |α|'² + |β|'² plus |α|² and |β|² times the squared deviations of the rates of arg α
    /// and arg β from their mean rates.
    fn speed(&self, place: &HalfPhase) -> f64 {
        let [time, alpha_mean, beta_mean] = self.whole.each_ref().map(to_f64);
        let [slowness, alpha, beta] = self.constants.rates(place).map(|rate| to_f64(&rate));
        let [one_plus_u, one_minus_u, _] = self.constants.heights(place).map(|height| to_f64(&height));
        let [at_e1, at_e2] = &self.constants.ends[0];
        let rise = to_f64(&((at_e2 - at_e1) * &place[0] * &place[1] / norm_squared(place))) / slowness;
        // 0/0 where α or β is 0
        let tilting = (rise * rise / (one_plus_u * one_minus_u)).max(0.0);
        let turning =
            |rate: f64, mean: f64, height: f64| 0.5 * height * (rate / slowness - mean / time).powi(2);
        tilting + turning(alpha, alpha_mean, one_plus_u) + turning(beta, beta_mean, one_minus_u)
    }

    /// Number of the last panel before the first one that begins beyond a place.
    fn panel(&self, beyond: impl Fn(&(HalfPhase, Integrals)) -> bool) -> usize {
        self.panels.partition_point(|panel| !beyond(panel)).saturating_sub(1)
    }
}

fn between(from: &HalfPhase, to: &HalfPhase, x: &Precise) -> HalfPhase {
    [0, 1].map(|i| &from[i] + (&to[i] - &from[i]) * x)
}

/// Sum of a and a multiple of b.
pub fn add(a: &Integrals, b: &Integrals, times: i64) -> Integrals {
    [0, 1, 2].map(|i| &a[i] + &b[i] * times)
}

/// Gauss-Legendre nodes in \[0, 1\] with their weights, by Newton's method on the Legendre polynomial.
static NODES: LazyLock<Vec<(Precise, Precise)>> = LazyLock::new(|| {
    let node = |i: i64| {
        let mut x = precise(-(PI * (i as f64 + 0.75) / (NODE_COUNT as f64 + 0.5)).cos());
        for _ in 0..7 {
            let (value, slope) = legendre(&x);
            x -= value / slope;
        }
        let (_, slope) = legendre(&x);
        let weight = whole(1) / ((whole(1) - x.sqr()) * slope.sqr());
        ((x + 1) * precise(0.5), weight)
    };
    (0..NODE_COUNT).map(node).collect()
});

/// Legendre polynomial of the degree [`NODE_COUNT`] and its derivative.
fn legendre(x: &Precise) -> (Precise, Precise) {
    let (mut before, mut last) = (whole(1), x.clone());
    for k in 2..=NODE_COUNT {
        let next = (x * &last * (2 * k - 1) - before * (k - 1)) / whole(k);
        (before, last) = (last, next);
    }
    let slope = (before - x * &last) * NODE_COUNT / (whole(1) - x.sqr());
    (last, slope)
}

/// Integrals of `f` from 0 to 1.
fn integrate<const N: usize>(f: impl Fn(&Precise) -> [Precise; N]) -> [Precise; N] {
    let mut sums = [(); N].map(|()| whole(0));
    for (x, weight) in NODES.iter() {
        for (sum, value) in sums.iter_mut().zip(f(x)) {
            *sum += weight * value;
        }
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_of_degree_51_are_exact() {
        let power = |x: &Precise, n: usize| (0..n).fold(precise(1.0), |product, _| product * x);
        for n in [0, 1, 2, 17, 50, 51] {
            let [integral] = integrate(|x| [power(&(x + 1), n)]);
            let exact = (power(&precise(2.0), n + 1) - precise(1.0)) / whole(n as i64 + 1);
            let error = to_f64(&((integral - &exact) / exact)).abs();
            assert!(error < 1e-54, "{n}: {error:e}");
        }
    }
}
