//! Weierstrass's ℘, ℘', ζ, σ and ln σ of a complex argument, on the rectangular lattices of three real roots.

use super::agm::agm;
use super::elementary::quotient;
use super::tall_lattice::{Bare, TallLattice, roots_from_gaps};
use crate::complex::Complex;
use crate::error::{LaunchError, finite, require};
use crate::real::Float;
use core::f64::consts::FRAC_PI_2;

/// The functions of one lattice: half periods ω > 0 and ω' = i|ω'|, roots e₁ > e₂ > e₃ with sum 0, where
/// ℘(ω) = e₁, ℘(ω + ω') = e₂, ℘(ω') = e₃ and ℘'² = 4 (℘ - e₁)(℘ - e₂)(℘ - e₃).
///
/// By theta series, on the lattice turned by a right angle where that makes it taller than wide; so the nome is at most
/// e^{-π}, and five terms do. Any z will do: it is reduced to the cell around 0 first. At a lattice point the poles are
/// not finite.
///
/// Error of ℘, ℘', ζ, σ: below 2e-15 (|f| + |z f'|), as measured against values with 30 digits: relative, but for what
/// a rounding of z does. For ln σ: 2e-15 (1 + |ln σ| + |z ζ|). Cost of one call: the sines and cosines of two complex
/// angles, and five terms of four series.
///
/// ```
/// use toytop::{Complex, exact::Weierstrass};
/// let lattice = Weierstrass::from_roots([1.0, 0.0, -1.0])?; // the square lattice: ω = 1.3110287771460599
/// let z = Complex::new(0.3, 0.4);
/// let (p, slope) = (lattice.p(z), lattice.p_prime(z));
/// let defect = slope * slope - (p * p * p - p).scaled(4.0);
/// assert!(defect.norm_squared() < 1e-24);
/// assert!((lattice.half_periods()[0] - 1.311_028_777_146_06).abs() < 1e-15);
/// # Ok::<(), toytop::LaunchError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Weierstrass {
    roots: [f64; 3],
    tall: TallLattice,
    /// Whether `tall` is this lattice turned by i: z there is i z here.
    turned: bool,
}

const ALLOWED: &str = "between 1e-200 and 1e90, and at least 1e-290 times the other";

impl Weierstrass {
    /// From e₁ - e₂ and e₂ - e₃, both > 0, each with its own digits: a lattice that is nearly degenerate is told by the
    /// smaller one.
    ///
    /// # Errors
    /// `upper_gap`, `lower_gap`: not finite, not between 1e-200 and 1e90, or one below 1e-290 of the other.
    pub fn from_gaps(upper_gap: f64, lower_gap: f64) -> Result<Self, LaunchError> {
        finite("upper_gap", upper_gap)?;
        finite("lower_gap", lower_gap)?;
        for (name, gap, other) in [("upper_gap", upper_gap, lower_gap), ("lower_gap", lower_gap, upper_gap)] {
            require((1e-200..=1e90).contains(&gap) && gap / other >= 1e-290, name, ALLOWED)?;
        }
        Ok(Self::of_gaps(upper_gap, lower_gap))
    }

    /// As [`Weierstrass::from_gaps`], without the checks.
    pub(super) fn of_gaps(upper_gap: f64, lower_gap: f64) -> Self {
        let [whole, upper, lower] = [upper_gap + lower_gap, upper_gap, lower_gap].map(Float::sqrt);
        // ω = K(m)/√(e₁ - e₃) = π/2 / agm(√(e₁ - e₃), √(e₁ - e₂)), and ω' with e₂ - e₃
        Self::new(
            [FRAC_PI_2 / agm(whole, upper), FRAC_PI_2 / agm(whole, lower)],
            roots_from_gaps(upper_gap, lower_gap),
        )
    }

    /// From e₁ > e₂ > e₃. Only their differences enter: the sum of the three counts as 0.
    ///
    /// # Errors
    /// As [`Weierstrass::from_gaps`].
    pub fn from_roots([e1, e2, e3]: [f64; 3]) -> Result<Self, LaunchError> {
        Self::from_gaps(e1 - e2, e2 - e3)
    }

    /// From ω > 0 and |ω'| > 0.
    ///
    /// # Errors
    /// `real_half_period`, `imaginary_half_period`: not between 1e-40 and 1e40, or one more than 200 times the other.
    pub fn from_half_periods(real: f64, imaginary: f64) -> Result<Self, LaunchError> {
        finite("real_half_period", real)?;
        finite("imaginary_half_period", imaginary)?;
        for (name, half, other) in
            [("real_half_period", real, imaginary), ("imaginary_half_period", imaginary, real)]
        {
            require((1e-40..=1e40).contains(&half), name, "between 1e-40 and 1e40")?;
            require(half <= 200.0 * other, name, "at most 200 times the other half period")?;
        }
        let roots = if real <= imaginary {
            TallLattice::roots_of(real, imaginary)
        } else {
            turned_roots(TallLattice::roots_of(imaginary, real))
        };
        Ok(Self::new([real, imaginary], roots))
    }

    fn new([real, imaginary]: [f64; 2], roots: [f64; 3]) -> Self {
        let turned = real > imaginary;
        let tall = if turned {
            TallLattice::new(imaginary, real, turned_roots(roots))
        } else {
            TallLattice::new(real, imaginary, roots)
        };
        Self { roots, tall, turned }
    }

    /// e₁, e₂, e₃, with sum 0.
    #[must_use]
    pub fn roots(&self) -> [f64; 3] {
        self.roots
    }

    /// ω and |ω'|.
    #[must_use]
    pub fn half_periods(&self) -> [f64; 2] {
        let (width, height) = (self.tall.width(), self.tall.height());
        if self.turned { [height, width] } else { [width, height] }
    }

    /// η = ζ(ω) and η'/i, where η' = ζ(ω'); η ω' - η' ω = iπ/2.
    #[must_use]
    pub fn quasi_periods(&self) -> [f64; 2] {
        let (across, up) = (2.0 * self.tall.kappa() * self.tall.width(), self.tall.eta_up());
        if self.turned { [-up, -across] } else { [across, up] }
    }

    /// g₂ and g₃ of ℘'² = 4℘³ - g₂℘ - g₃.
    #[must_use]
    pub fn invariants(&self) -> [f64; 2] {
        let [e1, e2, e3] = self.roots;
        [2.0 * (e1 * e1 + e2 * e2 + e3 * e3), 4.0 * e1 * e2 * e3]
    }

    /// z as the tall lattice has it.
    fn inner(&self, z: Complex<f64>) -> Complex<f64> {
        if self.turned { z.times_i() } else { z }
    }

    /// ℘(z).
    #[must_use]
    pub fn p(&self, z: Complex<f64>) -> Complex<f64> {
        let p = self.tall.p(self.inner(z));
        if self.turned { -p } else { p }
    }

    /// ℘(z) - e₁, ℘(z) - e₂, ℘(z) - e₃, each without the cancellation of the subtraction.
    #[must_use]
    pub fn differences(&self, z: Complex<f64>) -> [Complex<f64>; 3] {
        let [first, second, third] = self.tall.differences(self.inner(z));
        if self.turned { [-third, -second, -first] } else { [first, second, third] }
    }

    /// ℘'(z).
    #[must_use]
    pub fn p_prime(&self, z: Complex<f64>) -> Complex<f64> {
        let slope = self.tall.p_prime(self.inner(z));
        if self.turned { -slope.times_i() } else { slope }
    }

    /// ζ(z), with ζ' = -℘.
    #[must_use]
    pub fn zeta(&self, z: Complex<f64>) -> Complex<f64> {
        let zeta = self.tall.zeta(self.inner(z));
        if self.turned { zeta.times_i() } else { zeta }
    }

    /// σ(z), with σ'/σ = ζ. Grows like a Gaussian: it may overflow where [`Weierstrass::ln_sigma`] does not.
    #[must_use]
    pub fn sigma(&self, z: Complex<f64>) -> Complex<f64> {
        let sigma = self.tall.sigma(self.inner(z));
        if self.turned { -sigma.times_i() } else { sigma }
    }

    /// A logarithm of σ(z), good modulo 2πi.
    #[must_use]
    pub fn ln_sigma(&self, z: Complex<f64>) -> Complex<f64> {
        let ln = self.tall.ln_sigma(self.inner(z));
        if self.turned { Complex::new(ln.re, ln.im - FRAC_PI_2) } else { ln }
    }

    /// κ: σ(z) = e^{κz²} B(z).
    pub(super) fn kappa(&self) -> f64 {
        if self.turned { -self.tall.kappa() } else { self.tall.kappa() }
    }

    /// B(z).
    pub(super) fn bare(&self, z: Complex<f64>) -> Bare {
        let bare = self.tall.bare(self.inner(z));
        if self.turned {
            Bare { exponent_rate: bare.exponent_rate.times_i(), value: -bare.value.times_i(), ..bare }
        } else {
            bare
        }
    }

    /// B(z)/z, for z in the cell around 0.
    pub(super) fn bare_per_z(&self, z: Complex<f64>) -> Complex<f64> {
        // 1 + O(z⁴ g₂) + O(κz²), which for a z so small that 1/z is infinite is all there is to say
        const TINY: f64 = 1e-280;
        if Float::abs(z.re).max(Float::abs(z.im)) < TINY {
            return Complex::ONE;
        }
        quotient(self.bare(z).whole(), z)
    }
}

/// The roots of i times the lattice.
fn turned_roots([e1, e2, e3]: [f64; 3]) -> [f64; 3] {
    [-e3, -e2, -e1]
}
