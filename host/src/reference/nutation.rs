//! Integrals over a nutation, in which χ increases by π: time, and the advances of arg α and arg β.
//!
//! ```text
//! dt/dχ = √(2 D/(g (e₃ - u))),    D = A/p + s (1 - u²),    u = e₁ cos²χ + e₂ sin²χ
//! d(arg α)/dt = (l + n)/(2A (1 + u)) + τ/2,    d(arg β)/dt = (l - n)/(2A (1 - u)) - τ/2,    τ = (n - K)/C - n/A
//! ```
//!
//! All singularities of these rates are at negative tan²χ. So panels whose ends have tan χ in the ratio 1 : 2 suffice for every motion.
//! With 26 nodes the relative error is (3 + √8)^-52, 1e-39.

use super::float640::{
    Complex640, Float640, conjugate, from_f64, from_i64, is_zero, norm_squared, square_root, to_f64, to_i64,
};
use std::f64::consts::PI;
use std::sync::LazyLock;

/// Ratio of tan χ at the ends of a panel.
pub const RATIO: f64 = 0.5;
/// Number of nodes of a panel.
const NODE_COUNT: i64 = 26;
/// Least cos χ of an aperiodic motion that is integrated; beyond it |β| < 1e-24, and α turns uniformly.
const MIN_COSINE: f64 = 1e-24;

/// Half phase χ, as a positive multiple of cos χ + i sin χ.
pub type HalfPhase = Complex640;

/// Time, and the advances of arg α and arg β without ±τt/2.
pub type Integrals = [Float640; 3];

/// Constants of a motion.
#[derive(Clone)]
pub struct NutationConstants {
    pub s: Float640,
    pub g: Float640,
    pub a_over_p: Float640,
    /// Linear factors 1 + u, 1 - u and e₃ - u at the ends of a nutation, each at u = e₁ and at u = e₂. Without torque the last factor is 1.
    pub factors_at_ends: [[Float640; 2]; 3],
    /// Rates (l ± n)/(2A).
    pub momentum_rates: [Float640; 2],
}

impl NutationConstants {
    /// Linear factors 1 + u, 1 - u and e₃ - u.
    pub fn linear_factors(&self, half_phase: &HalfPhase) -> [Float640; 3] {
        let square = norm_squared(half_phase);
        let [lower, upper] = half_phase.each_ref().map(|part| part.sqr() / &square);
        self.factors_at_ends.each_ref().map(|[at_e1, at_e2]| at_e1 * &lower + at_e2 * &upper)
    }

    /// Rates of arg α and arg β without ±τ/2; 0 for a parameter that passes through 0.
    pub fn turning_rates(&self, linear_factors: &[Float640; 3]) -> [Float640; 2] {
        [0, 1].map(|i| match &self.momentum_rates[i] {
            momentum if is_zero(momentum) => from_i64(0),
            momentum => momentum / &linear_factors[i],
        })
    }

    /// Derivatives of the integrals with respect to x, at the half phase `from` + x (`to` - `from`).
    fn rates(&self, from: &HalfPhase, to: &HalfPhase, x: &Float640) -> Integrals {
        let half_phase = between(from, to, x);
        let linear_factors = self.linear_factors(&half_phase);
        let [one_plus_u, one_minus_u, e3_minus_u] = &linear_factors;
        let d = &self.a_over_p + &self.s * one_plus_u * one_minus_u;
        let phase_rate = (&from[0] * &to[1] - &from[1] * &to[0]) / norm_squared(&half_phase);
        let slowness = square_root(&(d * 2 / (&self.g * e3_minus_u))) * phase_rate;
        let [alpha, beta] = self.turning_rates(&linear_factors).map(|rate| rate * &slowness);
        [slowness, alpha, beta]
    }

    fn integrals(&self, from: &HalfPhase, to: &HalfPhase) -> Integrals {
        integrate(|x| self.rates(from, to, x))
    }
}

/// Nutation from u = e₂ to u = e₂, or an aperiodic motion from near u = 1 to near u = 1.
pub struct Nutation {
    constants: NutationConstants,
    /// Ends of the panels, with the integrals from the first one.
    panels: Vec<(HalfPhase, Integrals)>,
    /// Integrals over all panels.
    pub total: Integrals,
    pub is_periodic: bool,
}

impl Nutation {
    /// Nutation of a motion in which u changes.
    pub fn new(constants: &NutationConstants, ratio: f64) -> Self {
        let [[one_plus_e1, _], [_, one_minus_e2], [_, e3_minus_e2]] = &constants.factors_at_ends;
        let is_periodic = !is_zero(e3_minus_e2);
        let spread = to_f64(&constants.a_over_p) / to_f64(&constants.s);
        let gaps = [one_plus_e1, one_minus_e2, e3_minus_e2].map(to_f64).into_iter().chain([spread]);
        let least = gaps.filter(|gap| *gap > 0.0).fold(1.0, f64::min);
        let shortest = if is_periodic { 0.25 * least.sqrt() } else { MIN_COSINE };
        let count = (shortest.ln() / ratio.ln()).ceil() as i32;
        let power = |exponent: i32| from_f64(ratio.powi(exponent.max(0)));
        let last = is_periodic.then(|| [from_i64(0), from_i64(1)]);
        let rising: Vec<_> = (-count..=count).map(|k| [power(k), power(-k)]).chain(last).collect();
        let mut panels: Vec<(HalfPhase, Integrals)> = Vec::new();
        let mut total = [Float640::ZERO; 3];
        for half_phase in rising.iter().rev().map(conjugate).chain(rising.iter().cloned()) {
            if let Some((from, _)) = panels.last() {
                total = add_multiple(&total, &constants.integrals(from, &half_phase), 1);
            }
            panels.push((half_phase, total.clone()));
        }
        Self { constants: constants.clone(), panels, total, is_periodic }
    }

    /// Integrals from the beginning to a half phase.
    pub fn integrals_to(&self, [cosine, sine]: &HalfPhase) -> Integrals {
        if *cosine < from_i64(0) {
            let turn = if *sine < from_i64(0) { -1 } else { 1 };
            return add_multiple(&self.integrals_to(&[-cosine, -sine]), &self.total, turn);
        }
        let (from, passed) = &self.panels[self.panel_index(|([x, y], _)| x * sine >= y * cosine)];
        // tan χ is nearly linear between half phases whose greater part is 1
        let size = cosine.clone().max(sine.clone()).max(-sine);
        add_multiple(passed, &self.constants.integrals(from, &[cosine / &size, sine / size]), 1)
    }

    /// Half phase at a time, by Newton's method, and the integrals up to it.
    pub fn at(&self, time: &Float640) -> (HalfPhase, Integrals) {
        const MAX_STEPS: u32 = 20;
        /// Last Newton step, whose square of 1e-36 is the error.
        const NEAR: f64 = 1e-18;
        let [period, _, _] = &self.total;
        let floor = to_i64(&(time / period - from_f64(0.5))).unwrap_or(0);
        let periods = if self.is_periodic { floor } else { 0 };
        let late = time - period * periods;
        let within = late.clone().clamp(from_i64(0), period.clone());
        let index = self.panel_index(|(_, passed)| passed[0] <= within).min(self.panels.len() - 2);
        let [(from, passed), (to, passed_at_end)] = [&self.panels[index], &self.panels[index + 1]];
        let mut x = (&within - &passed[0]) / (&passed_at_end[0] - &passed[0]);
        let mut steps = 0;
        loop {
            let [t, alpha, beta] =
                add_multiple(passed, &self.constants.integrals(from, &between(from, to, &x)), 1);
            let [slowness, alpha_rate, beta_rate] = self.constants.rates(from, to, &x);
            let step = (&within - t) / slowness;
            x += &step;
            steps += 1;
            // the integrals are linear on so short a step
            if to_f64(&step).abs() <= NEAR || steps == MAX_STEPS {
                // χ increases by π in a period
                let sign = if periods % 2 == 0 { 1 } else { -1 };
                // before and after an aperiodic motion, α turns at a constant rate
                let turned_upright = (&late - within) * &self.constants.momentum_rates[0] / from_i64(2);
                let integrals = [late, alpha + alpha_rate * &step + turned_upright, beta + beta_rate * step];
                return (
                    between(from, to, &x).map(|part| part * sign),
                    add_multiple(&integrals, &self.total, periods),
                );
            }
            x = x.clamp(from_i64(0), from_i64(1));
        }
    }

    /// Index of the last panel for which the condition on its beginning holds.
    fn panel_index(&self, is_before: impl Fn(&(HalfPhase, Integrals)) -> bool) -> usize {
        self.panels.partition_point(is_before).saturating_sub(1)
    }
}

fn between(from: &HalfPhase, to: &HalfPhase, x: &Float640) -> HalfPhase {
    [0, 1].map(|i| &from[i] + (&to[i] - &from[i]) * x)
}

/// Sum of a and a multiple of b.
pub fn add_multiple(a: &Integrals, b: &Integrals, times: i64) -> Integrals {
    [0, 1, 2].map(|i| &a[i] + &b[i] * times)
}

/// Gauss-Legendre nodes in \[0, 1\] with their weights, by Newton's method on the Legendre polynomial.
static NODES: LazyLock<Vec<(Float640, Float640)>> = LazyLock::new(|| {
    let node = |i: i64| {
        let mut x = from_f64(-(PI * (i as f64 + 0.75) / (NODE_COUNT as f64 + 0.5)).cos());
        for _ in 0..7 {
            let [before, last] = legendre(&x);
            x -= (from_i64(1) - x.sqr()) * &last / ((before - &x * last) * NODE_COUNT);
        }
        let [before, _] = legendre(&x);
        let weight = (from_i64(1) - x.sqr()) / (before * NODE_COUNT).sqr();
        ((x + 1) * from_f64(0.5), weight)
    };
    (0..NODE_COUNT).map(node).collect()
});

/// Legendre polynomials of the degrees [`NODE_COUNT`] - 1 and [`NODE_COUNT`].
fn legendre(x: &Float640) -> [Float640; 2] {
    (2..=NODE_COUNT).fold([from_i64(1), x.clone()], |[before, last], k| {
        let next = (x * &last * (2 * k - 1) - before * (k - 1)) / from_i64(k);
        [last, next]
    })
}

/// Integrals of `f` from 0 to 1.
fn integrate<const N: usize>(f: impl Fn(&Float640) -> [Float640; N]) -> [Float640; N] {
    let mut sums = [Float640::ZERO; N];
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
        let power = |x: &Float640, n: usize| (0..n).fold(from_f64(1.0), |product, _| product * x);
        for n in [0, 1, 2, 17, 50, 51] {
            let [integral] = integrate(|x| [power(&(x + 1), n)]);
            let exact = (power(&from_f64(2.0), n + 1) - from_f64(1.0)) / from_i64(n as i64 + 1);
            let error = to_f64(&((integral - &exact) / exact)).abs();
            assert!(error < 1e-54, "{n}: {error:e}");
        }
    }
}
