//! Trapezoid sums of the three integrands.

use crate::scalar::Float;

/// Sums of the integrands over a set of nodes: of t, ψ_A and ψ_B, without their constant factors.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sums<N>(pub(super) [N; 3]);

impl<N: Float> Sums<N> {
    pub(super) const ZERO: Self = Self([N::ZERO; 3]);

    pub(super) fn plus(&self, other: &Self) -> Self {
        let (Self([time, alpha, beta]), Self(others)) = (*self, *other);
        let [other_time, other_alpha, other_beta] = others;
        Self([time + other_time, alpha + other_alpha, beta + other_beta])
    }

    pub(super) fn negated(&self) -> Self {
        Self(self.0.map(|sum| -sum))
    }

    pub(super) fn halved(&self) -> Self {
        Self(self.0.map(|sum| sum.halved()))
    }

    /// Changes relative to a total: of the time, and of the slow phases, which are compared with the sum of their totals.
    ///
    /// * `scales`: factors of ψ_A and of ψ_B, up to a common one
    pub(super) fn relative_to(&self, total: &Self, scales: [f64; 2]) -> [f64; 2] {
        let [alpha_scale, beta_scale] = scales.map(Float::abs);
        let magnitudes = |Self(sums): &Self| {
            let [time, alpha, beta] = sums.map(|sum| Float::abs(sum.to_f64()));
            [time, alpha * alpha_scale + beta * beta_scale]
        };
        let ([time_change, slow_change], [time, slow]) = (magnitudes(self), magnitudes(total));
        [time_change / time, if slow > 0.0 { slow_change / slow } else { 0.0 }]
    }
}
