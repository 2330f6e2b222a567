//! Jacobi's elliptic functions sn, cn, dn and the amplitude am, by the descending Landen transformation.
//!
//! The complementary parameter m₁ = 1 - m is a separate argument. Near the separatrix of a top the functions depend
//! on the digits of m₁, which a floating-point subtraction 1 - m would lose.

use crate::elliptic::transcendental::angle;
use crate::elliptic::transcendental::{half_pi, sine_cosine};
use crate::error::{ParameterError, finite, require};
use crate::scalar::{Extended, Float, RateNumber, Ring};

/// Jacobi's functions sn, cn, dn and am of one parameter m.
///
/// ```
/// use toytop::elliptic::Jacobi;
/// let jacobi = Jacobi::new(1.0, 1e-20)?; // m rounds to 1, but its complement is not 0
/// assert!((jacobi.quarter_period() - 24.412_145_291_060_35).abs() < 1e-13);
/// # Ok::<(), toytop::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jacobi {
    landen: Landen<Extended>,
}

/// Values sn u, cn u, dn u and am u.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JacobiValues {
    /// Sine of the amplitude, sn u = sin am u.
    pub sn: f64,
    /// Cosine of the amplitude, cn u = cos am u.
    pub cn: f64,
    /// Delta amplitude, dn u = √(1 - m sn² u).
    pub dn: f64,
    /// Amplitude am u in rad, continuous in u.
    pub am: f64,
}

impl Jacobi {
    /// Functions of the parameter m = k² in \[0, 1\] and its complement m₁ = 1 - m > 0. The smaller of the two counts
    /// as exact; the other is replaced by 1 minus the smaller.
    ///
    /// # Errors
    /// `m`, `m1`: not finite, negative, m₁ below 1e-300, or their sum more than 1e-12 from 1.
    pub fn new(m: f64, m1: f64) -> Result<Self, ParameterError> {
        finite("m", m)?;
        finite("m1", m1)?;
        require((0.0..=1.0).contains(&m), "m", "in [0, 1]")?;
        require((1e-300..=1.0).contains(&m1), "m1", "in [1e-300, 1]")?;
        require(Float::abs(m + m1 - 1.0) <= 1e-12, "m1", "1 - m")?;
        let [exact, complement] = [m, m1].map(Extended::from);
        let one = Extended::ONE;
        let landen =
            if m < m1 { Landen::of(exact, one - exact) } else { Landen::of(one - complement, complement) };
        Ok(Self { landen })
    }

    /// Quarter period K. Relative error: below 1.2e-16, the rounding of the result.
    #[must_use]
    pub fn quarter_period(&self) -> f64 {
        self.landen.quarter_period().to_f64()
    }

    /// Values of the functions at a real u.
    ///
    /// Error of each value f: below 1.2e-16 (|f| + 1e-13 |u f'|), from the rounding of the result and the
    /// arithmetic in extended precision on u. Cost: two sines and cosines, one arctangent and at most twelve steps with one
    /// division each, in extended precision.
    #[must_use]
    pub fn at(&self, u: f64) -> JacobiValues {
        let (u, quarter) = (Extended::from(u), self.landen.quarter_period());
        let halves = libm::round((u / quarter.doubled()).to_f64());
        let rest = u - quarter.doubled() * halves.into();
        let phase = |v: Extended| sine_cosine(v / quarter * half_pi());
        // sine and cosine of the angle, reduced so that the smaller one comes from a small angle
        let (sine, cosine) = if rest.abs() <= quarter.halved() {
            phase(rest)
        } else {
            let (cosine, sine) = phase(quarter - rest.abs());
            (if rest < Extended::ZERO { -sine } else { sine }, cosine)
        };
        let (sn, cn, dn) = self.landen.at_angle(sine, cosine);
        let am = half_pi().doubled() * halves.into() + angle(sn, cn);
        let odd = halves - 2.0 * libm::floor(0.5 * halves) != 0.0;
        let sign = if odd { -1.0 } else { 1.0 };
        JacobiValues { sn: sign * sn.to_f64(), cn: sign * cn.to_f64(), dn: dn.to_f64(), am: am.to_f64() }
    }
}

/// Squares sn² u and cn² u, and dn u, as fractions that are not divided yet. The denominator of sn² and cn² is the sum
/// of their numerators, because the squares add up to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct SquaresOfWhole<F> {
    /// Numerators of sn² and cn².
    pub(crate) sn: F,
    pub(crate) cn: F,
    /// Numerator and denominator of dn.
    pub(crate) dn: F,
    pub(crate) whole_of_dn: F,
}

/// Sequence of Landen transformations of one parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Landen<F> {
    /// Transformations in order of decreasing modulus. Those that would change nothing have the modulus 0.
    steps: [LandenStep<F>; LANDEN_STEPS],
    /// Product of (1 + k)² over all steps.
    scale: F,
    /// Number of steps, from the first, with 1 - k <= 1/8.
    near_one: usize,
}

/// Transformation to a modulus k.
#[derive(Clone, Copy, Debug, PartialEq)]
struct LandenStep<F> {
    modulus: F,
    /// Difference 1 - k.
    rest: F,
    /// Modulus times the product of (1 + k)² over the steps to smaller moduli.
    scaled_modulus: F,
}

impl<F: Float> LandenStep<F> {
    /// Step that changes nothing.
    const NONE: Self = Self { modulus: F::ZERO, rest: F::ONE, scaled_modulus: F::ZERO };
}

/// Greatest number of Landen transformations. Each squares a small modulus: m₁ = 1/2 needs five, 1e-15 nine, 1e-300 twelve.
const LANDEN_STEPS: usize = 12;

/// Incomplete sequence of transformations.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LandenSteps<F> {
    landen: Landen<F>,
    complement: F,
    modulus_squared: F,
    /// Greatest modulus that changes nothing.
    least: F,
    /// Number of transformations so far.
    next: usize,
}

impl<F: Float> LandenSteps<F> {
    /// Sequence before [`LandenSteps::begin`].
    pub(crate) const NONE: Self = Self {
        landen: Landen { steps: [LandenStep::NONE; LANDEN_STEPS], scale: F::ONE, near_one: 0 },
        complement: F::ONE,
        modulus_squared: F::ZERO,
        least: F::ZERO,
        next: 0,
    };

    /// Begins the sequence for m and m₁ = 1 - m, each given with full relative precision. A modulus of at most `least` is below the
    /// resolution: it changes nothing, nor do those after it.
    pub(crate) fn begin(&mut self, [m, m1]: [F; 2], least: f64) {
        self.landen.steps.fill(LandenStep::NONE);
        (self.landen.scale, self.landen.near_one) = (F::ONE, 0);
        (self.modulus_squared, self.complement) = (m, m1.sqrt());
        (self.least, self.next) = (F::from_f64(least), 0);
    }

    /// Adds a transformation. Returns whether there may be another; if not, the sequence is complete.
    pub(crate) fn proceed(&mut self) -> bool {
        let is_complete = !self.add();
        if is_complete {
            self.landen.complete();
        }
        !is_complete
    }

    /// Adds a transformation, unless it would change nothing. Returns whether there may be another.
    fn add(&mut self) -> bool {
        let Some(step) = self.landen.steps.get_mut(self.next) else { return false };
        // k₁ = (1 - k')/(1 + k') = k²/(1 + k')²,  k₁' = 2 √k'/(1 + k')
        let per_sum = F::ONE / (F::ONE + self.complement);
        let modulus = self.modulus_squared * per_sum.squared();
        if modulus <= self.least {
            return false;
        }
        let rest = self.complement.doubled() * per_sum;
        *step = LandenStep { modulus, rest, scaled_modulus: modulus };
        self.landen.near_one += usize::from(rest.doubled().doubled().doubled() <= F::ONE);
        self.complement = self.complement.sqrt().doubled() * per_sum;
        self.modulus_squared = modulus.squared();
        self.next += 1;
        true
    }

    /// Sequence so far.
    pub(crate) fn landen(&self) -> &Landen<F> {
        &self.landen
    }
}

impl<F: Float> Landen<F> {
    /// Sequence for m and m₁ = 1 - m, each given with full relative precision.
    pub(crate) fn of(m: F, m1: F) -> Self {
        let mut steps = LandenSteps::NONE;
        // the least of all number types
        steps.begin([m, m1], Extended::LEAST_MODULUS);
        while steps.proceed() {}
        steps.landen
    }

    /// Quarter period K = π/2 ∏ (1 + k). Error: a few roundings of the number type.
    pub(crate) fn quarter_period(&self) -> F {
        // π/2 to 32 digits in extended precision; in smaller types the second term has no effect
        let half_pi = F::from_f64(core::f64::consts::FRAC_PI_2) + F::from_f64(6.123233995736766e-17);
        self.changing().fold(half_pi, |product, step| product * (F::ONE + step.modulus))
    }

    /// Steps with a modulus above 0, in order of decreasing modulus.
    fn changing(&self) -> impl Iterator<Item = &LandenStep<F>> {
        self.steps.iter().take_while(|step| step.modulus > F::ZERO)
    }

    /// Computes the factors that do not depend on the angle.
    fn complete(&mut self) {
        self.scale = F::ONE;
        for step in self.steps.iter_mut().rev().filter(|step| step.modulus > F::ZERO) {
            step.scaled_modulus = step.modulus * self.scale;
            self.scale = self.scale * (F::ONE + step.modulus).squared();
        }
    }

    /// Number of bits by which an error of the trapezoid rule for a function of period 2K that is analytic for |Im u| < K'
    /// decreases with each node on K: -2 log₂ q for the nome q = e^{-πK'/K}. It is accurate to a few percent, and at least
    /// 64 where no transformation is needed.
    pub(crate) fn bits_per_node(&self) -> f64 {
        // the modulus after n transformations is nearly 4 q^(2^(n-1)); its exponent is its logarithm to a percent
        let last = self.changing().fold((1.0, 64.0), |(weight, _), step| {
            let exponent = 1023 - (step.modulus.to_f64().to_bits() >> 52) as i32;
            (0.5 * weight, weight * f64::from(2 + exponent))
        });
        2.0 * last.1
    }

    /// Squares at u = 2 K φ/π, from sin φ and cos φ, without a division: sn² and cn² are kept as fractions X/W and Y/W.
    pub(crate) fn squares_at_angle(&self, sine: F, cosine: F) -> SquaresOfWhole<F> {
        // X without its constant factors (1 + k)²
        let (mut x, mut y, mut w) = (sine.squared(), cosine.squared(), F::ONE);
        let (mut sum, mut difference) = (F::ONE, F::ONE);
        for (number, step) in self.steps.iter().enumerate().rev() {
            let LandenStep { modulus, rest, scaled_modulus } = *step;
            if modulus == F::ZERO {
                continue;
            }
            let share = scaled_modulus * x;
            sum = w + share;
            // W - k X = (1 - k) W + k Y, in the form with the smaller rounding error, which is the second where k is near 1
            difference = if number < self.near_one { rest * w + modulus * y } else { w - share };
            y = y * (difference + rest * share);
            x = x * w;
            w = sum.squared();
        }
        SquaresOfWhole { sn: self.scale * x, cn: y, dn: difference, whole_of_dn: sum }
    }

    /// (sn u, cn u, dn u) at u = 2 K φ/π, from sin φ and cos φ. No transcendental function is needed, so any
    /// [`Float`] can be used.
    pub(crate) fn at_angle(&self, sine: F, cosine: F) -> (F, F, F) {
        let (mut sn, mut cn, mut dn) = (sine, cosine, F::ONE);
        for &LandenStep { modulus, rest, .. } in self.steps.iter().rev() {
            if modulus == F::ZERO {
                continue;
            }
            let sn_squared = sn.squared();
            let per_sum = F::ONE / (F::ONE + modulus * sn_squared);
            // 1 - k sn² = (1 - k) + k cn², in the form with the smaller rounding error
            let numerator = if sn_squared < F::from_f64(0.25) {
                F::ONE - modulus * sn_squared
            } else {
                rest + modulus * cn.squared()
            };
            let next_dn = numerator * per_sum;
            cn = cn * dn * per_sum;
            sn = (F::ONE + modulus) * sn * per_sum;
            dn = next_dn;
        }
        (sn, cn, dn)
    }
}
