//! Jacobi's elliptic functions sn, cn, dn and the amplitude am, by the descending Landen chain.
//!
//! The complementary parameter m₁ = 1 - m is an input of its own: near the separatrix of a top it is the number that
//! matters, and 1 - m recomputed in floating point would have lost it.

use crate::error::{LaunchError, finite, require};
use crate::real::Float;

/// sn, cn, dn and am of one parameter.
///
/// ```
/// use toytop::exact::Jacobi;
/// let jacobi = Jacobi::new(1.0, 1e-20)?; // m rounds to 1, its complement does not to 0
/// assert!((jacobi.quarter_period() - 24.412_145_291_060_35).abs() < 1e-13);
/// # Ok::<(), toytop::LaunchError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jacobi<F = f64> {
    /// (k, 1 - k) of the transformed moduli, largest first.
    steps: [(F, F); LANDEN_STEPS],
}

/// sn u, cn u, dn u and am u.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JacobiValues {
    /// sn u = sin am u.
    pub sn: f64,
    /// cn u = cos am u.
    pub cn: f64,
    /// dn u = √(1 - m sn² u).
    pub dn: f64,
    /// am u in rad, continuous in u.
    pub am: f64,
}

/// Landen steps: each squares the smallness of the modulus; from m₁ = 1e-300 it takes nine.
const LANDEN_STEPS: usize = 12;

impl Jacobi {
    /// From the parameter m = k² in \[0, 1\] and its complement m₁ = 1 - m > 0, each with its own digits.
    ///
    /// # Errors
    /// `m`, `m1`: not finite, negative, m₁ below 1e-300, or their sum more than 1e-12 from 1.
    pub fn new(m: f64, m1: f64) -> Result<Self, LaunchError> {
        finite("m", m)?;
        finite("m1", m1)?;
        require((0.0..=1.0).contains(&m), "m", "in [0, 1]")?;
        require((1e-300..=1.0).contains(&m1), "m1", "in [1e-300, 1]")?;
        require(Float::abs(m + m1 - 1.0) <= 1e-12, "m1", "1 - m")?;
        Ok(Self::of(m, m1))
    }

    /// The functions of a real u.
    ///
    /// Error of each: below 1e-15 (|f| + |u f'|), so relative near their zeros but for what a rounding of u does. Cost:
    /// one sine and cosine, one arctangent, and at most twelve steps of one division.
    #[must_use]
    pub fn at(&self, u: f64) -> JacobiValues {
        let quarter = self.quarter_period();
        let halves = libm::round(u / (2.0 * quarter));
        let rest = u - halves * (2.0 * quarter);
        let angle = |v: f64| v / quarter * core::f64::consts::FRAC_PI_2;
        // sine and cosine of the angle, the smaller one from a small angle
        let (sine, cosine) = if Float::abs(rest) <= 0.5 * quarter {
            libm::sincos(angle(rest))
        } else {
            let (cosine, sine) = libm::sincos(angle(quarter - Float::abs(rest)));
            (libm::copysign(sine, rest), cosine)
        };
        let (sn, cn, dn) = self.at_angle(sine, cosine);
        let am = halves * core::f64::consts::PI + libm::atan2(sn, cn);
        let odd = halves - 2.0 * libm::floor(0.5 * halves) != 0.0;
        let sign = if odd { -1.0 } else { 1.0 };
        JacobiValues { sn: sign * sn, cn: sign * cn, dn, am }
    }
}

impl<F: Float> Jacobi<F> {
    /// As [`Jacobi::new`], without the checks.
    pub(crate) fn of(m: F, m1: F) -> Self {
        let mut complement = m1.sqrt();
        let mut modulus_squared = m;
        let steps = core::array::from_fn(|_| {
            // k₁ = (1 - k')/(1 + k') = k²/(1 + k')²,  k₁' = 2 √k'/(1 + k')
            let per_sum = F::ONE / (F::ONE + complement);
            let modulus = modulus_squared * per_sum.squared();
            // below the last digit of any type the step changes nothing, and is left out
            let modulus = if modulus > F::from_f64(1e-33) { modulus } else { F::ZERO };
            let rest = complement.doubled() * per_sum;
            complement = complement.sqrt().doubled() * per_sum;
            modulus_squared = modulus.squared();
            (modulus, rest)
        });
        Self { steps }
    }

    /// K = π/2 ∏ (1 + k), the quarter period. Error: a few roundings of the type.
    #[must_use]
    pub fn quarter_period(&self) -> F {
        // π/2 to 32 digits, for double-double; one number for the smaller types
        let half_pi = F::from_f64(core::f64::consts::FRAC_PI_2) + F::from_f64(6.123233995736766e-17);
        self.steps.iter().fold(half_pi, |product, &(modulus, _)| product * (F::ONE + modulus))
    }

    /// (sn u, cn u, dn u) at u = 2 K φ/π, from sin φ and cos φ: no transcendental is needed, so any [`Float`] will do.
    #[must_use]
    pub fn at_angle(&self, sine: F, cosine: F) -> (F, F, F) {
        let (mut sn, mut cn, mut dn) = (sine, cosine, F::ONE);
        for &(modulus, rest) in self.steps.iter().rev() {
            if modulus == F::ZERO {
                continue;
            }
            let sn_squared = sn.squared();
            let per_sum = F::ONE / (F::ONE + modulus * sn_squared);
            // 1 - k sn² = (1 - k) + k cn², whichever adds less rounding
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
