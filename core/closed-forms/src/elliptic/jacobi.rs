//! Jacobi's elliptic functions sn, cn, dn and the amplitude am, as quotients of theta functions.
//!
//! The complementary parameter m₁ = 1 - m is a separate argument. Near the separatrix of a top the functions depend
//! on the digits of m₁, which a floating-point subtraction 1 - m would lose.

use crate::elliptic::elementary::{angle, half_pi, real};
use crate::elliptic::lattice::Lattice;
use toytop::ParameterError;
use toytop::internal::check;
use toytop::scalar::{Extended, Float, Ring};

/// Jacobi's functions sn, cn, dn and am of one parameter m.
///
/// ```
/// use toytop_closed_forms::elliptic::Jacobi;
/// let jacobi = Jacobi::new(1.0, 1e-20)?; // m rounds to 1, but its complement is not 0
/// assert!((jacobi.quarter_period() - 24.412_145_291_060_35).abs() < 1e-13);
/// # Ok::<(), toytop::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jacobi {
    /// Lattice with e₁ - e₂ = m₁ and e₂ - e₃ = m, whose half period ω is K.
    lattice: Lattice,
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
    /// `m`, `m1`: out of these ranges, m₁ below 1e-300, or their sum more than 1e-12 from 1.
    pub fn new(m: f64, m1: f64) -> Result<Self, ParameterError> {
        check((0.0..=1.0).contains(&m), "m", "in [0, 1]")?;
        check((1e-300..=1.0).contains(&m1), "m1", "in [1e-300, 1]")?;
        check(Float::abs(m + m1 - 1.0) <= 1e-12, "m1", "1 - m")?;
        let [exact, complement] = [m, m1].map(Extended::from);
        let one = Extended::ONE;
        let (m, m1) = if m < m1 { (exact, one - exact) } else { (one - complement, complement) };
        Ok(Self { lattice: Lattice::from_gaps(m1, m) })
    }

    /// Quarter period K. Relative error: below 1.2e-16, the rounding of the result.
    #[must_use]
    pub fn quarter_period(&self) -> f64 {
        self.lattice.half_periods[0].to_f64()
    }

    /// Values of the functions at a real u.
    ///
    /// Error of each value f: below 1.2e-16 (|f| + 1e-13 |u f'|), from the rounding of the result and the
    /// arithmetic in extended precision on u. Cost: four theta functions and one arctangent in extended precision.
    #[must_use]
    pub fn at(&self, u: f64) -> JacobiValues {
        let [quarter, _] = self.lattice.half_periods;
        let half_periods = libm::round(u / quarter.doubled().to_f64());
        let remainder = Extended::from(u) - quarter.doubled() * half_periods.into();
        let [origin, omega, omega_prime, sum] =
            self.lattice.scaled_thetas(real(remainder)).map(|theta| theta.re);
        let [sn, cn, dn] = [origin, omega, sum].map(|theta| theta / omega_prime);
        let am = half_pi().doubled() * half_periods.into() + angle(sn, cn);
        let sign = if libm::fmod(half_periods, 2.0) == 0.0 { 1.0 } else { -1.0 };
        JacobiValues { sn: sign * sn.to_f64(), cn: sign * cn.to_f64(), dn: dn.to_f64(), am: am.to_f64() }
    }
}
