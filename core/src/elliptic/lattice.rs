//! Weierstrass's functions on any rectangular lattice, in extended precision. A lattice wider than tall is rotated by a
//! right angle to a tall lattice.

use crate::complex::Complex;
use crate::elliptic::agm::agm;
use crate::elliptic::elementary::{Wide, quotient};
use crate::elliptic::tall_lattice::{SigmaFactor, TallLattice, roots_from_gaps};
use crate::elliptic::transcendental::half_pi;
use crate::scalar::{Extended, Float, Ring};

/// Lattice of the periods 2ω and 2ω', with ω > 0 and ω' = i|ω'|; ℘ has the values e₁ > e₂ > e₃ at ω, ω + ω', ω'.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Lattice {
    roots: [Extended; 3],
    tall: TallLattice,
    /// Whether `tall` is this lattice rotated by a right angle: z in `tall` is then i z here.
    turned: bool,
}

impl Lattice {
    /// Lattice from the differences of the roots, e₁ - e₂ and e₂ - e₃, both > 0.
    pub(crate) fn of_gaps(upper_gap: Extended, lower_gap: Extended) -> Self {
        let [whole, upper, lower] = [upper_gap + lower_gap, upper_gap, lower_gap].map(Float::sqrt);
        // ω = K(m)/√(e₁ - e₃) = π/2 / agm(√(e₁ - e₃), √(e₁ - e₂)), and |ω'| likewise with e₂ - e₃
        let half_periods = [upper, lower].map(|other| half_pi() / agm(whole, other));
        Self::new(half_periods, roots_from_gaps(upper_gap, lower_gap))
    }

    fn new([real, imaginary]: [Extended; 2], roots: [Extended; 3]) -> Self {
        let turned = real > imaginary;
        let tall = if turned {
            TallLattice::new(imaginary, real, turned_roots(roots))
        } else {
            TallLattice::new(real, imaginary, roots)
        };
        Self { roots, tall, turned }
    }

    pub(crate) fn roots(&self) -> [Extended; 3] {
        self.roots
    }

    /// Half periods ω and |ω'|.
    pub(crate) fn half_periods(&self) -> [Extended; 2] {
        let (width, height) = (self.tall.width(), self.tall.height());
        if self.turned { [height, width] } else { [width, height] }
    }

    /// Quasi-periods ζ(ω) and ζ(ω')/i.
    pub(crate) fn quasi_periods(&self) -> [Extended; 2] {
        let (across, up) = (self.tall.kappa().doubled() * self.tall.width(), self.tall.eta_up());
        if self.turned { [-up, -across] } else { [across, up] }
    }

    /// Argument of the functions on the tall lattice, for the argument z on this one.
    fn inner(&self, z: Wide) -> Wide {
        if self.turned { z.times_i() } else { z }
    }

    pub(crate) fn p(&self, z: Wide) -> Wide {
        let p = self.tall.p(self.inner(z));
        if self.turned { -p } else { p }
    }

    /// ℘ minus each of the three roots, computed without the subtraction.
    pub(crate) fn differences(&self, z: Wide) -> [Wide; 3] {
        let [first, second, third] = self.tall.differences(self.inner(z));
        if self.turned { [-third, -second, -first] } else { [first, second, third] }
    }

    pub(crate) fn p_prime(&self, z: Wide) -> Wide {
        let slope = self.tall.p_prime(self.inner(z));
        if self.turned { -slope.times_i() } else { slope }
    }

    pub(crate) fn zeta(&self, z: Wide) -> Wide {
        let zeta = self.tall.zeta(self.inner(z));
        if self.turned { zeta.times_i() } else { zeta }
    }

    pub(crate) fn sigma(&self, z: Wide) -> Wide {
        let sigma = self.tall.sigma(self.inner(z));
        if self.turned { -sigma.times_i() } else { sigma }
    }

    pub(crate) fn ln_sigma(&self, z: Wide) -> Wide {
        let ln = self.tall.ln_sigma(self.inner(z));
        if self.turned { Complex::new(ln.re, ln.im - half_pi()) } else { ln }
    }

    /// Coefficient κ in σ(z) = e^{κz²} B(z).
    pub(crate) fn kappa(&self) -> Extended {
        if self.turned { -self.tall.kappa() } else { self.tall.kappa() }
    }

    /// Factor B(z) of the sigma function.
    pub(crate) fn sigma_factor(&self, z: Wide) -> SigmaFactor {
        let sigma_factor = self.tall.sigma_factor(self.inner(z));
        if self.turned {
            SigmaFactor {
                exponent_rate: sigma_factor.exponent_rate.times_i(),
                value: -sigma_factor.value.times_i(),
                ..sigma_factor
            }
        } else {
            sigma_factor
        }
    }

    /// B(z)/z, for z in the fundamental cell around 0.
    pub(crate) fn sigma_factor_per_z(&self, z: Wide) -> Wide {
        // the result is 1 + O(z⁴ g₂) + O(κz²); below this |z| the quotient would underflow, and 1 is correct to all
        // digits
        const TINY: f64 = 1e-250;
        if Float::abs(z.re.to_f64()).max(Float::abs(z.im.to_f64())) < TINY {
            return Complex::ONE;
        }
        quotient(self.sigma_factor(z).whole(), z)
    }
}

/// Roots of the lattice multiplied by i.
fn turned_roots([e1, e2, e3]: [Extended; 3]) -> [Extended; 3] {
    [-e3, -e2, -e1]
}
