//! Trapezoid rule over a nutation period, in the variable of Jacobi's amplitude.
//!
//! With χ = am(v | m), m = (e₂ - e₁)/(e₃ - e₁), the integrands are smooth periodic functions of v without a boundary
//! layer near the separatrix, so the trapezoid rule converges geometrically. sn and cn come from the descending
//! Landen transformation, with the *complementary* parameter m₁ = (e₃ - e₂)/(e₃ - e₁) as an argument. At its lower
//! end the nodes are equidistant angles, so no inverse function and no transcendental function is needed.

use crate::constants::BranchPoints;
use crate::elliptic::jacobi::Landen;
use crate::law::Law;
use crate::law::amplitude::AmplitudeLaw;
use crate::scalar::{Extended, Float, Ring};

/// Integrals over one period: T, and ψ_A(T) and ψ_B(T) in rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Integrals {
    pub(crate) period: Extended,
    pub(crate) psi_alpha: Extended,
    pub(crate) psi_beta: Extended,
    /// Error of the trapezoid rule, estimated from its last change: relative to the period, and relative to |ψ_A| +
    /// |ψ_B|.
    pub(crate) relative_error: f64,
    /// Number of nodes on half a period.
    pub(crate) nodes: u32,
}

impl Integrals {
    /// Integrals of a uniform rotation.
    pub(crate) fn uniform(period: Extended) -> Self {
        Self { period, psi_alpha: Extended::ZERO, psi_beta: Extended::ZERO, relative_error: 0.0, nodes: 1 }
    }
}

/// Largest number of nodes on half a period. Only a very small A/(ps) needs more.
const MOST_NODES: u32 = 1 << 16;
/// Relative change at which the doubling of the nodes stops. The error after it is far smaller than the change,
/// because 10⁹ periods multiply it by 10⁹.
const SETTLED: f64 = 1e-15;

/// Trapezoid sums over half a period, to which one node is added at a time.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Quadrature {
    law: AmplitudeLaw<Extended>,
    jacobi: Landen<Extended>,
    /// Sums over `nodes` nodes; the ends of the half period have half weight, and are the first two nodes.
    sums: Sums,
    nodes: u32,
    /// Whether the sums have both ends.
    has_ends: bool,
    /// Sums over the first `odd_nodes` nodes between them.
    odd: Sums,
    odd_nodes: u32,
    /// Sine and cosine of the angle between two nodes, of half of it, and of the next node's angle.
    step: [Extended; 2],
    half_step: [Extended; 2],
    angle: [Extended; 2],
    /// Relative change by the doubling before the last one.
    before: f64,
}

impl Quadrature {
    /// Quadrature without a node.
    pub(crate) fn new(law: &Law<Extended>, e: &BranchPoints<Extended>) -> Self {
        let (zero, one) = (Extended::ZERO, Extended::ONE);
        Self {
            law: AmplitudeLaw::new(law),
            jacobi: Landen::of(e.e2_minus_e1 / e.e3_minus_e1(), e.e3_minus_e2 / e.e3_minus_e1()),
            sums: Sums::ZERO,
            nodes: 0,
            has_ends: false,
            odd: Sums::ZERO,
            odd_nodes: 0,
            step: [zero, -one],
            half_step: [one, zero],
            angle: [zero, one],
            before: f64::INFINITY,
        }
    }

    /// Adds a node. Returns the integrals once the sums have settled. Relative error: about 1e-30, unless A/(ps) < 1e-4 and
    /// the motion reaches the vertical, where the number of nodes is limited.
    pub(crate) fn proceed(&mut self) -> Option<Integrals> {
        if !self.has_ends {
            self.add_end();
            return None;
        }
        let ([s, c], [step_sine, step_cosine]) = (self.angle, self.step);
        self.odd = self.odd.plus(&self.at([s, c]));
        self.odd_nodes += 1;
        if self.odd_nodes < self.nodes {
            self.angle = [s * step_cosine + c * step_sine, c * step_cosine - s * step_sine];
            return None;
        }
        // difference of the trapezoid sums with `nodes` and with twice as many nodes
        let difference = self.odd.plus(&self.sums.negated());
        self.sums = self.sums.plus(&self.odd);
        self.nodes *= 2;
        let change = difference.relative_to(&self.sums, &self.law.factors()).to_f64();
        if self.nodes >= MOST_NODES {
            return Some(self.integrals(change));
        }
        if self.nodes >= 8 && change <= SETTLED {
            return Some(self.integrals(remaining_error(change, self.before)));
        }
        self.before = change;
        self.begin_odd_nodes();
        None
    }

    fn add_end(&mut self) {
        self.sums = self.sums.plus(&self.at(self.angle).halved());
        if self.nodes == 0 {
            self.nodes = 1;
            self.angle = self.half_step;
        } else {
            self.has_ends = true;
            self.begin_odd_nodes();
        }
    }

    fn begin_odd_nodes(&mut self) {
        let [sine, cosine] = self.half_step;
        let half_cosine = (Extended::ONE + cosine).halved().sqrt();
        self.step = self.half_step;
        self.half_step = [sine / half_cosine.doubled(), half_cosine];
        self.angle = self.half_step;
        (self.odd, self.odd_nodes) = (Sums::ZERO, 0);
    }

    /// Integrands at a node, of which sine and cosine are given.
    #[inline(never)]
    fn at(&self, [sine, cosine]: [Extended; 2]) -> Sums {
        Sums(self.law.at(&self.jacobi.squares_at_angle(sine, cosine)))
    }

    fn integrals(&self, relative_error: f64) -> Integrals {
        // The two halves of the period are equal: 2 K over the number of nodes is twice the weight of half a period.
        let weight = self.jacobi.quarter_period().doubled() / Extended::from(f64::from(self.nodes));
        let (Sums([time, alpha, beta]), [of_time, of_alpha, of_beta]) = (self.sums, self.law.factors());
        Integrals {
            period: time * of_time * weight,
            psi_alpha: alpha * of_alpha * weight,
            psi_beta: beta * of_beta * weight,
            relative_error,
            nodes: self.nodes,
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

/// Sums of the integrands over a set of nodes: of t, ψ_A and ψ_B, without their constant factors.
#[derive(Clone, Copy, Debug)]
struct Sums([Extended; 3]);

impl Sums {
    const ZERO: Self = Self([Extended::ZERO; 3]);

    fn plus(&self, other: &Self) -> Self {
        let (Self([time, alpha, beta]), Self(others)) = (*self, *other);
        let [other_time, other_alpha, other_beta] = others;
        Self([time + other_time, alpha + other_alpha, beta + other_beta])
    }

    fn negated(&self) -> Self {
        Self(self.0.map(|sum| -sum))
    }

    fn halved(&self) -> Self {
        Self(self.0.map(|sum| sum.halved()))
    }

    /// Largest change relative to a total. The slow phases are compared with the sum of their totals.
    fn relative_to(&self, total: &Self, [_, of_alpha, of_beta]: &[Extended; 3]) -> Extended {
        let magnitudes = |Self([time, alpha, beta]): &Self| {
            (time.abs(), (*alpha * *of_alpha).abs() + (*beta * *of_beta).abs())
        };
        let ((time_change, slow_change), (time, slow)) = (magnitudes(self), magnitudes(total));
        let time = time_change / time;
        let slow = if slow > Extended::ZERO { slow_change / slow } else { Extended::ZERO };
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
