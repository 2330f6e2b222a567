//! Weierstrass's ℘, ℘', ζ, σ and ln σ of a complex argument, on rectangular lattices, whose three roots are real.

use crate::elliptic::elementary::{WideComplex, rounded, widened};
use crate::elliptic::lattice::Lattice;
use toytop::internal::{check, check_finite};
use toytop::scalar::{Extended, Float, Ring};
use toytop::{Complex, ParameterError};

/// Weierstrass's functions of one lattice: half periods ω > 0 and ω' = i|ω'|, roots e₁ > e₂ > e₃ with sum 0, where
/// ℘(ω) = e₁, ℘(ω + ω') = e₂, ℘(ω') = e₃ and ℘'² = 4 (℘ - e₁)(℘ - e₂)(℘ - e₃).
///
/// They are computed from theta series in extended precision. A lattice wider than tall is rotated by a right angle first,
/// so that the nome is at most e^{-π} and seven terms are enough. Any argument z is allowed; it is reduced to the
/// fundamental cell around 0. At a lattice point the functions with a pole are not finite.
///
/// Root differences and z count as exact. Error of ℘, ℘' and ζ, against 300 digits on 239 lattices with
/// quotients of the root differences down to 1e-28: below 1.2e-16 (|f| + 1e-13 |z f'|), from the rounding of the
/// result and the arithmetic in extended precision on z. Error of σ (relative) and ln σ (absolute): below 4e-16 (1 + |ln σ| +
/// |z ζ|). Cost of one call: the sines and cosines of a complex angle in extended precision, and seven terms of four series.
///
/// ```
/// use toytop::Complex;
/// use toytop_closed_forms::elliptic::Weierstrass;
/// let lattice = Weierstrass::from_roots([1.0, 0.0, -1.0])?; // the square lattice: ω = 1.3110287771460599
/// let z = Complex::new(0.3, 0.4);
/// let (p, slope) = (lattice.p(z), lattice.p_prime(z));
/// let defect = slope * slope - (p * p * p - p).scaled(4.0);
/// assert!(defect.norm_squared() < 1e-24);
/// assert!((lattice.half_periods()[0] - 1.311_028_777_146_06).abs() < 1e-15);
/// # Ok::<(), toytop::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Weierstrass {
    lattice: Lattice,
}

const ALLOWED: &str = "between 1e-200 and 1e90, and at least 1e-290 times the other";

impl Weierstrass {
    /// Lattice from e₁ - e₂ and e₂ - e₃, both > 0. Each is given with full relative precision: a nearly degenerate
    /// lattice depends on the digits of the smaller one.
    ///
    /// # Errors
    /// `upper_gap`, `lower_gap`: not finite, not between 1e-200 and 1e90, or one below 1e-290 times the other.
    pub fn from_gaps(upper_gap: f64, lower_gap: f64) -> Result<Self, ParameterError> {
        check_finite("upper_gap", upper_gap)?;
        check_finite("lower_gap", lower_gap)?;
        Self::from_exact_gaps(upper_gap.into(), lower_gap.into())
    }

    fn from_exact_gaps(upper_gap: Extended, lower_gap: Extended) -> Result<Self, ParameterError> {
        let upper = upper_gap.to_f64();
        let lower = lower_gap.to_f64();
        for (name, gap, other) in [("upper_gap", upper, lower), ("lower_gap", lower, upper)] {
            check((1e-200..=1e90).contains(&gap) && gap / other >= 1e-290, name, ALLOWED)?;
        }
        Ok(Self { lattice: Lattice::from_gaps(upper_gap, lower_gap) })
    }

    /// Lattice from e₁ > e₂ > e₃. Only their differences are used: the roots are shifted to the sum 0.
    ///
    /// # Errors
    /// `roots`: not finite; and the errors of [`Weierstrass::from_gaps`].
    pub fn from_roots(roots: [f64; 3]) -> Result<Self, ParameterError> {
        for root in roots {
            check_finite("roots", root)?;
        }
        let [e1, e2, e3] = roots.map(Extended::from);
        Self::from_exact_gaps(e1 - e2, e2 - e3)
    }

    /// Roots e₁, e₂, e₃, with sum 0.
    #[must_use]
    pub fn roots(&self) -> [f64; 3] {
        self.lattice.roots.map(Float::to_f64)
    }

    /// Half periods ω and |ω'|.
    #[must_use]
    pub fn half_periods(&self) -> [f64; 2] {
        self.lattice.half_periods.map(Float::to_f64)
    }

    /// Quasi-periods ζ(ω) and ζ(ω')/i; Legendre's relation is ζ(ω) ω' - ζ(ω') ω = iπ/2.
    #[must_use]
    pub fn quasi_periods(&self) -> [f64; 2] {
        self.lattice.quasi_periods().map(Float::to_f64)
    }

    /// Invariants g₂ and g₃ of ℘'² = 4℘³ - g₂℘ - g₃.
    #[must_use]
    pub fn invariants(&self) -> [f64; 2] {
        let [e1, e2, e3] = self.lattice.roots;
        let second = (e1.squared() + e2.squared() + e3.squared()).doubled();
        [second, e1 * e2 * e3 * Extended::from(4.0)].map(Float::to_f64)
    }

    /// Value of a function at z, rounded to `f64`.
    fn value(&self, function: fn(&Lattice, WideComplex) -> WideComplex, z: Complex<f64>) -> Complex<f64> {
        rounded(function(&self.lattice, widened(z)))
    }

    /// ℘(z).
    #[must_use]
    pub fn p(&self, z: Complex<f64>) -> Complex<f64> {
        self.value(Lattice::p, z)
    }

    /// ℘(z) - e₁, ℘(z) - e₂, ℘(z) - e₃, each without the cancellation of the subtraction.
    #[must_use]
    pub fn differences(&self, z: Complex<f64>) -> [Complex<f64>; 3] {
        self.lattice.differences(widened(z)).map(rounded)
    }

    /// ℘'(z).
    #[must_use]
    pub fn p_prime(&self, z: Complex<f64>) -> Complex<f64> {
        self.value(Lattice::p_prime, z)
    }

    /// ζ(z), with ζ' = -℘.
    #[must_use]
    pub fn zeta(&self, z: Complex<f64>) -> Complex<f64> {
        self.value(Lattice::zeta, z)
    }

    /// σ(z), with σ'/σ = ζ. It grows like the exponential of a square: beyond the range of `f64`, near e^709, it is infinite;
    /// [`Weierstrass::ln_sigma`] has no such limit.
    #[must_use]
    pub fn sigma(&self, z: Complex<f64>) -> Complex<f64> {
        self.value(Lattice::sigma, z)
    }

    /// Logarithm of σ(z); its imaginary part is determined modulo 2π.
    #[must_use]
    pub fn ln_sigma(&self, z: Complex<f64>) -> Complex<f64> {
        self.value(Lattice::ln_sigma, z)
    }
}
