//! Trapezoid rule over a nutation period, in the variable of Jacobi's amplitude.
//!
//! With χ = am(v | m), m = (e₂ - e₁)/(e₃ - e₁), the integrands are smooth periodic functions of v without a boundary
//! layer near the separatrix, so the trapezoid rule converges geometrically. sn and cn come from the descending
//! Landen transformation, with the *complementary* parameter m₁ = (e₃ - e₂)/(e₃ - e₁) as an argument. At its lower
//! end the nodes are equidistant angles, so no inverse function and no transcendental function is needed, and any
//! [`Float`] can be used.

use crate::constants::BranchPoints;
use crate::elliptic::jacobi::Landen;
use crate::law::Law;
use crate::scalar::Float;

/// Integrals over one period: T, and ψ_A(T) and ψ_B(T) in rad.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Quadrature<F> {
    pub(crate) period: F,
    pub(crate) psi_alpha: F,
    pub(crate) psi_beta: F,
    /// Error of the trapezoid rule, estimated from its last change: relative to the period, and relative to |ψ_A| +
    /// |ψ_B|.
    pub(crate) relative_error: f64,
    /// Number of nodes on half a period.
    pub(crate) nodes: u32,
}

/// Largest number of nodes on half a period. Only a very small A/(ps) needs more.
const MOST_NODES: u32 = 1 << 16;
/// Relative change at which the doubling of the nodes stops. The error after it is far smaller than the change,
/// because 10⁹ periods multiply it by 10⁹.
const SETTLED: f64 = 1e-15;

impl<F: Float> Quadrature<F> {
    /// Integrals of `law` over one period. Relative error: about 1e-30 in extended precision, about 1e-15 in `f64`, unless
    /// A/(ps) < 1e-4 and the motion reaches the vertical, where the number of nodes is limited.
    pub(crate) fn over_period(law: &Law<F>, e: &BranchPoints<F>) -> Self {
        let jacobi = Landen::of(e.e2_minus_e1 / e.e3_minus_e1(), e.e3_minus_e2 / e.e3_minus_e1());
        // The sums begin with the two ends of the half period, with half weight each; then the odd nodes between are
        // added, with twice as many at each step.
        let mut sums =
            Sums::at(law, &jacobi, F::ZERO, F::ONE).plus(&Sums::at(law, &jacobi, F::ONE, F::ZERO)).halved();
        let mut nodes = 1_u32;
        let (mut step_sine, mut step_cosine) = (F::ONE, F::ZERO); // of π/2 over the number of nodes
        let mut before = f64::INFINITY;
        let relative_error = loop {
            (step_sine, step_cosine) = half_angle(step_sine, step_cosine);
            let odd = Sums::at_odd_nodes(law, &jacobi, nodes, step_sine, step_cosine);
            // difference of the trapezoid sums with `nodes` and with twice as many nodes
            let difference = odd.plus(&sums.negated());
            sums = sums.plus(&odd);
            nodes *= 2;
            let change = difference.relative_to(&sums).to_f64();
            if nodes >= MOST_NODES {
                break change;
            }
            if nodes >= 8 && change <= SETTLED {
                break remaining_error(change, before);
            }
            before = change;
        };
        // The two halves of the period are equal: 2 K over the number of nodes is twice the weight of half a period.
        let weight = jacobi.quarter_period().doubled() / F::from_f64(f64::from(nodes));
        Self {
            period: sums.time * weight,
            psi_alpha: sums.alpha * weight,
            psi_beta: sums.beta * weight,
            relative_error,
            nodes,
        }
    }
}

/// Estimated error of a trapezoid sum, from the changes of the last two doublings of its nodes. Convergence is
/// geometric. Each error is either the square of the previous one divided by a constant C, or the previous one times
/// the square of the last ratio. C may be small and the ratio may not have settled yet, so the sum of both estimates
/// is used (`toytop-lab study` checks it on random motions).
fn remaining_error(change: f64, before: f64) -> f64 {
    // both changes may be 0: a slow and small nutation may change no sum
    let ratio = change / before.max(change).max(f64::MIN_POSITIVE);
    change * (3.0 * change + 30.0 * ratio * ratio)
}

/// sin and cos of half an angle in the first quadrant.
fn half_angle<F: Float>(sine: F, cosine: F) -> (F, F) {
    let half_cosine = (F::ONE + cosine).halved().sqrt();
    (sine / half_cosine.doubled(), half_cosine)
}

/// Sums of the integrands over a set of nodes.
#[derive(Clone, Copy)]
struct Sums<F> {
    time: F,
    alpha: F,
    beta: F,
}

impl<F: Float> Sums<F> {
    fn at(law: &Law<F>, jacobi: &Landen<F>, sine: F, cosine: F) -> Self {
        let (sn, cn, _) = jacobi.at_angle(sine, cosine);
        let time = law.time_per_amplitude(sn, cn);
        let rates = law.rates(sn, cn);
        Self { time, alpha: rates.alpha * time, beta: rates.beta * time }
    }

    /// Sums over the `nodes` angles (2j + 1) δ, given sin δ and cos δ.
    fn at_odd_nodes(law: &Law<F>, jacobi: &Landen<F>, nodes: u32, sine: F, cosine: F) -> Self {
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

    /// Largest change relative to a total. The slow phases are compared with the sum of their totals.
    fn relative_to(&self, total: &Self) -> F {
        let slow = total.alpha.abs() + total.beta.abs();
        let time = self.time.abs() / total.time.abs();
        let slow_change = self.alpha.abs() + self.beta.abs();
        let slow = if slow > F::ZERO { slow_change / slow } else { F::ZERO };
        if time > slow { time } else { slow }
    }
}

#[cfg(test)]
mod tests {
    use super::remaining_error;

    #[test]
    fn what_is_left_is_a_number_also_where_nothing_changed() {
        assert_eq!(remaining_error(0.0, 0.0), 0.0);
        assert!(remaining_error(1e-32, 0.0) < 1e-30);
        // the changes were 1e-8 and 1e-16 of the total: the next error is the square of the last
        let left = remaining_error(1e-16, 1e-8);
        assert!(left > 1e-32 && left < 1e-30, "{left:e}");
    }

    /// Errors C q, C q², C q⁴: the last two changes are the first two of them, and the remaining error is the third.
    #[test]
    fn what_is_left_is_bounded_however_small_the_constant() {
        for constant in [1.0, 1e-3, 1e-6] {
            let [before, change, truth] = [1, 2, 4].map(|power| constant * 0.01_f64.powi(power));
            let bound = remaining_error(change, before);
            assert!((truth..100.0 * truth).contains(&bound), "{bound:e} of {truth:e}");
        }
    }
}
