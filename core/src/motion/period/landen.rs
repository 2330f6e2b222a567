//! Descending Landen transformation: Jacobi's functions sn, cn and dn without a transcendental function.

use crate::integer::exponent;
use crate::scalar::{Extended, Float};

/// Fractions before division: sn² = sn_squared/(sn_squared + cn_squared), cn² likewise, and dn = dn_numerator/dn_denominator.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct JacobiFractions<F> {
    pub(super) sn_squared: F,
    pub(super) cn_squared: F,
    pub(super) dn_numerator: F,
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
    /// Complementary modulus k' = √m₁ of the parameter.
    complementary_modulus: F,
}

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
        Self {
            steps: [step; LANDEN_STEPS],
            scale: F::ONE,
            steps_with_large_modulus: 0,
            complementary_modulus: F::ONE,
        }
    };

    /// Fills an empty sequence for m and m₁ = 1 - m, each given with full relative precision. It is filled in place, because a sequence that
    /// is returned takes a kilobyte more of stack.
    #[inline(never)]
    pub(super) fn fill(&mut self, [m, m1]: [F; 2], pause: &mut dyn FnMut()) {
        // k₁ = (1 - k')/(1 + k') = k²/(1 + k')²,  k₁' = 2 √k'/(1 + k')
        let mut modulus_squared = m;
        self.complementary_modulus = m1.sqrt();
        let mut conjugate = self.complementary_modulus;
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

    /// Number N of intervals on half a period for a trapezoid rule with an error below one rounding.
    ///
    /// The error of the period and of ψ_α and ψ_β, relative to the period and to |ψ_α| + |ψ_β| + π, was at most 300 q^2N in 40 000 launches of the
    /// corner study, with the nome q. 1024 q^2N is counted.
    pub(super) fn intervals(&self) -> u32 {
        const LEAST: u32 = 2;
        let is_used = |step: &&LandenStep<F>| step.scaled_modulus > F::ZERO;
        let Some((number, last)) = (1..).zip(self.steps.iter().take_while(is_used)).last() else {
            return LEAST;
        };
        // q^2N = (k/4)^(4N/2^number) with the last modulus k, which is small; numbers of bits before the leading one
        let bits_of_modulus = 2 - exponent(last.scaled_modulus.to_f64());
        let bits = 1024_u32.ilog2() as i32 + 1 - exponent(F::OPERATION_ERROR);
        ((bits << number) as u32).div_ceil(4 * bits_of_modulus.max(1) as u32).max(LEAST)
    }

    /// Quarter period K = π/2 ∏ (1 + k).
    pub(super) fn quarter_period(&self) -> F {
        F::from_extended(Extended::TWO_PI).halved().halved() * self.scale.sqrt()
    }

    /// Squares sn² = x/(x + y) and cn² = y/(x + y) at the argument 2 K φ/π, from sin φ and cos φ.
    #[inline(never)]
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
            // w - kx without cancellation where k is near 1
            difference =
                if number < self.steps_with_large_modulus { y + complement * (w - y) } else { w - kx };
            y = y * (difference + complement * kx);
            x = x * w;
            w = sum.squared();
        }
        JacobiFractions {
            sn_squared: self.scale * x,
            cn_squared: y,
            dn_numerator: difference,
            dn_denominator: sum,
        }
    }

    /// Functions at K - v from those at v: sn² : cn² becomes cn² : m₁ sn², and dn becomes k'/dn.
    pub(super) fn at_complement(&self, fractions: &JacobiFractions<F>) -> JacobiFractions<F> {
        let JacobiFractions { sn_squared, cn_squared, dn_numerator, dn_denominator } = *fractions;
        JacobiFractions {
            sn_squared: cn_squared,
            cn_squared: self.complementary_modulus.squared() * sn_squared,
            dn_numerator: self.complementary_modulus * dn_denominator,
            dn_denominator: dn_numerator,
        }
    }
}
