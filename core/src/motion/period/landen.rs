//! Descending Landen transformation: Jacobi's functions sn, cn and dn without a transcendental function.

use crate::scalar::{Float, Ring, Wide};

/// Squares sn² u and cn² u, and dn u, as fractions that are not divided yet. The denominator of both squares is their sum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SquaresOfWhole<F> {
    /// Numerator of sn².
    pub(super) sn: F,
    /// Numerator of cn².
    pub(super) cn: F,
    /// Numerator of dn.
    pub(super) dn: F,
    /// Denominator of dn.
    pub(super) whole_of_dn: F,
}

/// Sequence of Landen transformations of one parameter.
pub(super) struct Landen<const WORDS: usize> {
    /// Transformations in order of decreasing modulus. Those that would change nothing have the modulus 0.
    steps: [LandenStep<Wide<WORDS>>; LANDEN_STEPS],
    /// Product of (1 + k)² over all steps.
    scale: Wide<WORDS>,
    /// Number of steps, from the first, with 1 - k <= 1/8.
    near_one: usize,
}

/// Transformation to a modulus k.
#[derive(Clone, Copy)]
struct LandenStep<F> {
    modulus: F,
    /// Difference 1 - k.
    rest: F,
    /// Modulus times the product of (1 + k)² over the steps to smaller moduli.
    scaled_modulus: F,
}

/// Greatest number of Landen transformations. Each squares a small modulus: m₁ = 1/2 needs five, 1e-15 nine, 1e-300 twelve.
const LANDEN_STEPS: usize = 12;

impl<const WORDS: usize> Landen<WORDS> {
    /// Modulus of a transformation that changes the period by less than the other errors.
    const LEAST_MODULUS: f64 = if WORDS == 1 { 2e-20 } else { 1e-33 };

    /// Sequence for m = 0.
    pub(super) const NONE: Self = Self {
        steps: [LandenStep { modulus: Wide::ZERO, rest: Wide::ONE, scaled_modulus: Wide::ZERO };
            LANDEN_STEPS],
        scale: Wide::ONE,
        near_one: 0,
    };

    /// Fills the sequence for m and m₁ = 1 - m, each given with full relative precision.
    #[inline(never)]
    pub(super) fn fill(&mut self, [m, m1]: [Wide<WORDS>; 2], between: &mut dyn FnMut()) {
        // k₁ = (1 - k')/(1 + k') = k²/(1 + k')²,  k₁' = 2 √k'/(1 + k')
        let (mut modulus_squared, mut complement) = (m, m1.sqrt());
        for step in &mut self.steps {
            let per_sum = Wide::ONE / (Wide::ONE + complement);
            let modulus = modulus_squared * per_sum.squared();
            if modulus.to_f64() <= Self::LEAST_MODULUS {
                break;
            }
            let rest = complement.doubled() * per_sum;
            *step = LandenStep { modulus, rest, scaled_modulus: modulus };
            self.near_one += usize::from(rest.to_f64() <= 0.125);
            complement = complement.sqrt().doubled() * per_sum;
            modulus_squared = modulus.squared();
            between();
        }
        for step in self.steps.iter_mut().rev().filter(|step| step.modulus > Wide::ZERO) {
            step.scaled_modulus = step.modulus * self.scale;
            self.scale = self.scale * (Wide::ONE + step.modulus).squared();
        }
    }

    fn changing(&self) -> impl Iterator<Item = &LandenStep<Wide<WORDS>>> {
        self.steps.iter().filter(|step| step.modulus > Wide::ZERO)
    }

    /// Quarter period K = π/2 ∏ (1 + k).
    pub(super) fn quarter_period(&self) -> Wide<WORDS> {
        // π/2 to 32 digits
        let half_pi = Wide::sum(core::f64::consts::FRAC_PI_2, 6.123233995736766e-17);
        self.changing().fold(half_pi, |product, step| product * (Wide::ONE + step.modulus))
    }

    /// Number of bits by which each node on K decreases the error of the trapezoid rule: -2 log₂ q for the nome q = e^{-πK'/K}, to a
    /// few percent; at least 64 where no transformation is needed.
    pub(super) fn bits_per_node(&self) -> f64 {
        // the modulus after n transformations is nearly 4 q^(2^(n-1)); its exponent is its logarithm to a percent
        let last = self.changing().fold((1.0, 64.0), |(weight, _), step| {
            let exponent = 1023 - (step.modulus.to_f64().to_bits() >> 52) as i32;
            (0.5 * weight, weight * f64::from(2 + exponent))
        });
        2.0 * last.1
    }

    /// Squares at u = 2 K φ/π, from sin φ and cos φ, without a division: sn² and cn² are kept as fractions X/W and Y/W.
    #[inline(never)]
    pub(super) fn squares_at_angle(&self, [sine, cosine]: [Wide<WORDS>; 2]) -> SquaresOfWhole<Wide<WORDS>> {
        // X without its constant factors (1 + k)²
        let (mut x, mut y, mut w) = (sine.squared(), cosine.squared(), Wide::ONE);
        let (mut sum, mut difference) = (Wide::ONE, Wide::ONE);
        for (number, step) in self.steps.iter().enumerate().rev() {
            let LandenStep { modulus, rest, scaled_modulus } = *step;
            if modulus == Wide::ZERO {
                continue;
            }
            let kx = scaled_modulus * x;
            sum = w + kx;
            // W - k X = (1 - k) W + k Y, in the form with the smaller rounding error, which is the second where k is near 1
            difference = if number < self.near_one { rest * w + modulus * y } else { w - kx };
            y = y * (difference + rest * kx);
            x = x * w;
            w = sum.squared();
        }
        SquaresOfWhole { sn: self.scale * x, cn: y, dn: difference, whole_of_dn: sum }
    }
}
