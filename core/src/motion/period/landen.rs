//! Descending Landen transformation: Jacobi's functions sn, cn and dn without a transcendental function.

use crate::scalar::{Extended, Float};

/// Fractions before division: sn² = sn_squared/(sn_squared + cn_squared), cn² likewise, and dn = dn/dn_denominator.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct JacobiFractions<F> {
    pub(super) sn_squared: F,
    pub(super) cn_squared: F,
    pub(super) dn: F,
    pub(super) dn_denominator: F,
}

/// Sequence of Landen transformations of one parameter.
pub(super) struct Landen<F> {
    /// Transformations of decreasing modulus; 0 where nothing changes.
    steps: [LandenStep<F>; LANDEN_STEPS],
    /// Product of (1 + k)² over all steps.
    scale: F,
    /// Number of steps, from the first, with 1 - k <= 1/8.
    steps_with_large_modulus: usize,
}

/// Largest number of nodes on half a period. A motion with m₁ = 1e-300 needs 2560.
pub(super) const MAX_NODES: u32 = 1 << 13;

/// Transformation to a modulus k.
#[derive(Clone, Copy)]
struct LandenStep<F> {
    /// Difference 1 - k.
    complement: F,
    /// Modulus times the product of (1 + k)² over the steps to smaller moduli.
    scaled_modulus: F,
}

/// Greatest number of transformations: m₁ = 1/2 needs five, 1e-15 nine, 1e-300 twelve.
const LANDEN_STEPS: usize = 12;

impl<F: Float> Landen<F> {
    /// Modulus whose transformation is negligible.
    const MIN_MODULUS: f64 = 0.3 * F::OPERATION_ERROR;

    /// Sequence without steps.
    pub(super) const EMPTY: Self = {
        let step = LandenStep { complement: F::ZERO, scaled_modulus: F::ZERO };
        Self { steps: [step; LANDEN_STEPS], scale: F::ONE, steps_with_large_modulus: 0 }
    };

    /// Fills an empty sequence for m and m₁ = 1 - m, each given with full relative precision. It is filled in place, because a sequence that
    /// is returned takes a kilobyte more of stack.
    #[inline(never)]
    pub(super) fn fill(&mut self, [m, m1]: [F; 2], pause: &mut dyn FnMut()) {
        // k₁ = (1 - k')/(1 + k') = k²/(1 + k')²,  k₁' = 2 √k'/(1 + k')
        let mut modulus_squared = m;
        let mut conjugate = m1.sqrt();
        for step in &mut self.steps {
            let inverse_sum = F::ONE / (F::ONE + conjugate);
            let modulus = modulus_squared * inverse_sum.squared();
            if modulus.to_f64() <= Self::MIN_MODULUS {
                break;
            }
            let complement = conjugate.doubled() * inverse_sum;
            *step = LandenStep { complement, scaled_modulus: modulus };
            self.steps_with_large_modulus += usize::from(complement.to_f64() <= 0.125);
            conjugate = conjugate.sqrt().doubled() * inverse_sum;
            modulus_squared = modulus.squared();
            pause();
        }
        for step in self.steps.iter_mut().rev().filter(|step| step.scaled_modulus > F::ZERO) {
            let modulus = step.scaled_modulus;
            step.scaled_modulus = modulus * self.scale;
            self.scale = self.scale * (F::ONE + modulus).squared();
        }
    }

    /// Quarter period K = π/2 ∏ (1 + k).
    pub(super) fn quarter_period(&self) -> F {
        F::from_extended(Extended::TWO_PI).halved().halved() * self.scale.sqrt()
    }

    /// Number of nodes to begin with (1, 3 or 5), and number needed for these bits: 4, 8, 16, ... times the first.
    pub(super) fn node_counts(&self, bits: f64) -> (u32, u32) {
        let nodes = bits / self.bits_per_node();
        let doubled = |division: u32| {
            let mut count = 4 * division;
            while f64::from(count) < nodes && count < MAX_NODES {
                count *= 2;
            }
            (division, count)
        };
        [3, 5]
            .map(doubled)
            .into_iter()
            .fold(doubled(1), |least, next| if next.1 < least.1 { next } else { least })
    }

    /// Bits of accuracy by each node: -2 log₂ q for the nome q = e^{-πK'/K}, to a few percent.
    fn bits_per_node(&self) -> f64 {
        // the modulus after n transformations is nearly 4 q^(2^(n-1)); its exponent is its logarithm to a percent
        let mut bits = 128.0;
        let mut share = 2.0;
        for step in self.steps.iter().take_while(|step| step.scaled_modulus > F::ZERO) {
            let exponent = 1023 - (step.scaled_modulus.to_f64().to_bits() >> 52) as i32;
            bits = share * f64::from(2 + exponent);
            share *= 0.5;
        }
        bits
    }

    /// Squares at u = 2 K φ/π, from sin φ and cos φ, with sn² = X/W and cn² = Y/W.
    pub(super) fn fractions_at_angle(&self, [sine, cosine]: [F; 2]) -> JacobiFractions<F> {
        // X without its constant factors (1 + k)²
        let mut x = sine.squared();
        let mut y = cosine.squared();
        let mut w = F::ONE;
        let mut sum = F::ONE;
        let mut difference = F::ONE;
        for (number, step) in self.steps.iter().enumerate().rev() {
            let LandenStep { complement, scaled_modulus } = *step;
            if scaled_modulus == F::ZERO {
                continue;
            }
            let kx = scaled_modulus * x;
            sum = w + kx;
            // W - k X = Y + (1 - k) (W - Y), whose rounding error is smaller where k is near 1
            difference =
                if number < self.steps_with_large_modulus { y + complement * (w - y) } else { w - kx };
            y = y * (difference + complement * kx);
            x = x * w;
            w = sum.squared();
        }
        JacobiFractions { sn_squared: self.scale * x, cn_squared: y, dn: difference, dn_denominator: sum }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::Ring;

    /// K'/K is 1 for m = 1/2, so that the error decreases by 2π/ln 2 bits a node; K grows with the logarithm of m₁.
    #[test]
    fn the_number_of_nodes_is_known_beforehand() {
        let [half, small, least] = [0.5, 1e-15, 1e-300].map(|m1| {
            let m1 = Extended::from(m1);
            let mut landen = Landen::EMPTY;
            landen.fill([Extended::ONE - m1, m1], &mut || {});
            landen
        });
        let (bits, expected) = (half.bits_per_node(), 2.0 * core::f64::consts::PI / core::f64::consts::LN_2);
        assert!((bits / expected - 1.0).abs() < 0.02, "{bits}");
        assert_eq!([half, small, least].map(|landen| landen.node_counts(105.0).1), [12, 160, 2560]);
    }
}
