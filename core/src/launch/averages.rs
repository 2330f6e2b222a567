//! The nutation period, and how far the slow phases turn in one: trapezoid rule in the Jacobi amplitude variable.
//!
//! In v with χ = am(v | m), m = (e₂ - e₁)/(e₃ - e₁), the integrands are smooth and periodic with no layer at the
//! separatrix, so the trapezoid rule converges geometrically. sn and cn come from the descending Landen chain with
//! the *complementary* parameter m₁ = (e₃ - e₂)/(e₃ - e₁) passed in: at its lower end the nodes are equidistant angles,
//! so no inverse function and no library transcendental is needed, and any [`Float`] will do.

use super::BranchPoints;
use crate::exact::jacobi::Jacobi;
use crate::nutation::Nutation;
use crate::real::{DoubleDouble, Float};
use crate::turns::in_turns;

/// What one nutation period does. Angles in turns, whole turns included.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Averages<F = f64> {
    /// T, the time from e₁ over e₂ back to e₁, in the unit of time (s).
    pub period: F,
    /// (arg α(t+T) - arg α(t))/2π; for e₁ = -1, where α passes through 0, of the signed α.
    pub alpha_turns: F,
    /// (arg β(t+T) - arg β(t))/2π; for e₂ = 1, where β passes through 0, of the signed β.
    pub beta_turns: F,
}

impl Averages {
    /// Advance of the tip angle φ per period, rad (signed radius where the curve passes through the centre).
    #[must_use]
    pub fn phi_per_period(&self) -> f64 {
        2.0 * core::f64::consts::PI * (self.alpha_turns + self.beta_turns)
    }
}

impl<F: Float> Averages<F> {
    pub(crate) fn to_f64(self) -> Averages {
        Averages {
            period: self.period.to_f64(),
            alpha_turns: self.alpha_turns.to_f64(),
            beta_turns: self.beta_turns.to_f64(),
        }
    }
}

/// T, ψ_A(T) and ψ_B(T), the angles in rad.
#[derive(Clone, Copy, Debug)]
pub(super) struct Quadrature<F> {
    pub(super) period: F,
    pub(super) psi_alpha: F,
    pub(super) psi_beta: F,
    /// Relative error, judged by the last change.
    pub(super) relative_error: f64,
}

/// Nodes a half period at most: more are needed only where A/(ps) is tiny.
const MOST_NODES: u32 = 1 << 16;
/// A doubling of the nodes that changes less, relatively, is the last. What it leaves is far less still, which 10⁹ periods need:
/// they multiply it by as many.
const SETTLED: f64 = 1e-15;

impl<F: Float> Quadrature<F> {
    /// Over one period of `law`. Relative error: some 1e-30 in double-double, some 1e-15 in `f64`, unless
    /// A/(ps) < 1e-4 and the motion reaches the vertical, where the number of nodes is capped.
    pub(super) fn over_period(law: &Nutation<F>, e: &BranchPoints<F>) -> Self {
        let jacobi = Jacobi::of(e.e2_minus_e1 / e.e3_minus_e1(), e.e3_minus_e2 / e.e3_minus_e1());
        // The ends of the half period, half weight each; then ever finer sets of odd nodes between.
        let mut sums =
            Sums::at(law, &jacobi, F::ZERO, F::ONE).plus(&Sums::at(law, &jacobi, F::ONE, F::ZERO)).halved();
        let mut nodes = 1_u32;
        let (mut step_sine, mut step_cosine) = (F::ONE, F::ZERO); // of π/2 over the number of nodes
        let mut before = f64::INFINITY;
        let relative_error = loop {
            (step_sine, step_cosine) = half_angle(step_sine, step_cosine);
            let odd = Sums::at_odd_nodes(law, &jacobi, nodes, step_sine, step_cosine);
            // trapezoid sums with `nodes` and twice as many
            let difference = odd.plus(&sums.negated());
            sums = sums.plus(&odd);
            nodes *= 2;
            let change = difference.relative_to(&sums).to_f64();
            if nodes >= MOST_NODES {
                break change;
            }
            if nodes >= 8 && change <= SETTLED {
                break left_by(change, before);
            }
            before = change;
        };
        // Both halves of the period alike: 2 K over the number of nodes, twice over half of them.
        let weight = jacobi.quarter_period().doubled() / F::from_f64(f64::from(nodes));
        Self {
            period: sums.time * weight,
            psi_alpha: sums.alpha * weight,
            psi_beta: sums.beta * weight,
            relative_error,
        }
    }
}

/// The error of a trapezoid sum, from what the last two doublings of its nodes changed. Convergence is geometric: each error
/// is the square of the one before over a constant C, or the one before times the square of the last ratio; C may be small,
/// and the ratio not yet settled, so that the sum of both is what holds (random motions: `toytop study`).
fn left_by(change: f64, before: f64) -> f64 {
    // both may be 0: in a slow and small nutation nothing is left to change
    let ratio = change / before.max(change).max(f64::MIN_POSITIVE);
    change * (3.0 * change + 30.0 * ratio * ratio)
}

/// sin and cos of half an angle in the first quadrant.
fn half_angle<F: Float>(sine: F, cosine: F) -> (F, F) {
    let half_cosine = (F::ONE + cosine).halved().sqrt();
    (sine / half_cosine.doubled(), half_cosine)
}

/// Sums of the integrands over nodes.
#[derive(Clone, Copy)]
struct Sums<F> {
    time: F,
    alpha: F,
    beta: F,
}

impl<F: Float> Sums<F> {
    fn at(law: &Nutation<F>, jacobi: &Jacobi<F>, sine: F, cosine: F) -> Self {
        let (sn, cn, _) = jacobi.at_angle(sine, cosine);
        let time = law.time_per_amplitude(sn, cn);
        let rates = law.rates(sn, cn);
        Self { time, alpha: rates.alpha * time, beta: rates.beta * time }
    }

    /// Over the `nodes` angles (2j + 1) δ, given sin δ and cos δ.
    fn at_odd_nodes(law: &Nutation<F>, jacobi: &Jacobi<F>, nodes: u32, sine: F, cosine: F) -> Self {
        let double_sine = (sine * cosine).doubled();
        let double_cosine = (cosine - sine) * (cosine + sine);
        let (mut s, mut c) = (sine, cosine);
        let mut sums = Self::at(law, jacobi, s, c);
        for _ in 1..nodes {
            (s, c) = (s * double_cosine + c * double_sine, c * double_cosine - s * double_sine);
            sums = sums.plus(&Self::at(law, jacobi, s, c));
        }
        sums
    }

    fn plus(&self, other: &Self) -> Self {
        Self { time: self.time + other.time, alpha: self.alpha + other.alpha, beta: self.beta + other.beta }
    }

    fn negated(&self) -> Self {
        Self { time: -self.time, alpha: -self.alpha, beta: -self.beta }
    }

    fn halved(&self) -> Self {
        Self { time: self.time.halved(), alpha: self.alpha.halved(), beta: self.beta.halved() }
    }

    /// The largest change relative to a total; the slow phases are weighed together.
    fn relative_to(&self, total: &Self) -> F {
        let slow = total.alpha.abs() + total.beta.abs();
        let time = self.time.abs() / total.time.abs();
        let slow_change = self.alpha.abs() + self.beta.abs();
        let slow = if slow > F::ZERO { slow_change / slow } else { F::ZERO };
        if time > slow { time } else { slow }
    }
}

/// Turns per period of α and β, from the quadrature: the slow phases, the constant drift ±τT/2, and the half turn that
/// the bracket makes (`winding`, 0 where it passes through 0 instead).
pub(super) fn averages(
    quadrature: &Quadrature<DoubleDouble>,
    half_tau: DoubleDouble,
    winding: [DoubleDouble; 2],
) -> Averages<DoubleDouble> {
    let [alpha_winding, beta_winding] = winding;
    let drift = half_tau * quadrature.period;
    Averages {
        period: quadrature.period,
        alpha_turns: in_turns(quadrature.psi_alpha + drift) + alpha_winding,
        beta_turns: in_turns(quadrature.psi_beta - drift) + beta_winding,
    }
}

#[cfg(test)]
mod tests {
    use super::left_by;

    #[test]
    fn what_is_left_is_a_number_also_where_nothing_changed() {
        assert_eq!(left_by(0.0, 0.0), 0.0);
        assert!(left_by(1e-32, 0.0) < 1e-30);
        // one part in 1e8 from doubling to doubling: as much squared again
        let left = left_by(1e-16, 1e-8);
        assert!(left > 1e-32 && left < 1e-30, "{left:e}");
    }

    /// Errors C q, C q², C q⁴: what the last two doublings changed is the first two, what is left the third.
    #[test]
    fn what_is_left_is_bounded_however_small_the_constant() {
        for constant in [1.0, 1e-3, 1e-6] {
            let [before, change, truth] = [1, 2, 4].map(|power| constant * 0.01_f64.powi(power));
            let bound = left_by(change, before);
            assert!((truth..100.0 * truth).contains(&bound), "{bound:e} of {truth:e}");
        }
    }
}
