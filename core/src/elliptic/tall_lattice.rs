//! Weierstrass's functions on a rectangular lattice at least as tall as wide, whose nome is at most e^{-π}.

use super::transcendental::{exp as real_exp, half_pi};
use crate::complex::Complex;
use crate::elliptic::elementary::{Wide, exp, imaginary, ln, quotient, real};
use crate::elliptic::theta::{Theta, Values};
use crate::scalar::{Extended, Float, Ring};

/// Lattice of the periods 2W and 2iV with W <= V, and the quantities that do not depend on z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct TallLattice {
    /// Half width W.
    width: Extended,
    /// Half height V.
    height: Extended,
    /// Roots at W, W + iV and iV: largest, middle, smallest.
    roots: [Extended; 3],
    theta: Theta,
    /// Quotients ϑ₁'(0)/ϑ₂(0), ϑ₁'(0)/ϑ₃(0), ϑ₁'(0)/ϑ₄(0), for theta functions normalised as in [`Values`].
    constants: [Extended; 3],
    /// Normalised slope ϑ₁'(0)/(2 q^{1/4}).
    origin_slope: Extended,
    /// Coefficient κ = ζ(W)/2W.
    kappa: Extended,
}

/// Factor B(z) = σ(z) e^{-κz²} of the sigma function, as e^`exponent` times `value`.
///
/// Quotients of sigma functions need only these factors; the factors e^{κz²} would cancel and lose digits.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SigmaFactor {
    pub(crate) exponent: Wide,
    /// Derivative of `exponent` with respect to z.
    pub(crate) exponent_rate: Wide,
    pub(crate) value: Wide,
    /// Derivative of `value` with respect to z.
    pub(crate) slope: Wide,
}

impl SigmaFactor {
    /// Logarithmic derivative B'/B.
    pub(crate) fn log_slope(&self) -> Wide {
        self.exponent_rate + quotient(self.slope, self.value)
    }

    /// Value of B.
    pub(crate) fn whole(&self) -> Wide {
        self.value * exp(self.exponent)
    }
}

/// Argument reduced to the fundamental cell around 0, and the numbers of periods subtracted.
struct Reduced {
    z: Wide,
    across: f64,
    up: f64,
}

impl TallLattice {
    /// Lattice from the half width W, the half height V >= W and the roots.
    pub(crate) fn new(width: Extended, height: Extended, roots: [Extended; 3]) -> Self {
        let theta = Theta::new(nome(width, height));
        let Values { one_slope, two, three, four, .. } = theta.at(Complex::ZERO);
        let constants = [two, three, four].map(|value| one_slope.re / value.re);
        // ϑ₁'''(0)/ϑ₁'(0) gives κ = π²/24W² E₂
        let unit = half_pi() / width;
        let kappa = unit.squared() * theta.eisenstein() / 6.0.into();
        Self { width, height, roots, theta, constants, origin_slope: one_slope.re, kappa }
    }

    pub(crate) fn kappa(&self) -> Extended {
        self.kappa
    }

    pub(crate) fn width(&self) -> Extended {
        self.width
    }

    pub(crate) fn height(&self) -> Extended {
        self.height
    }

    /// Quasi-period ζ(iV)/i = 2κV - π/2W (Legendre's relation).
    pub(crate) fn eta_up(&self) -> Extended {
        self.kappa.doubled() * self.height - half_pi() / self.width
    }

    fn reduced(&self, z: Wide) -> Reduced {
        let (width, height) = (self.width.doubled(), self.height.doubled());
        let (across, up) = (libm::round((z.re / width).to_f64()), libm::round((z.im / height).to_f64()));
        let z = Complex::new(z.re - width * across.into(), z.im - height * up.into());
        Reduced { z, across, up }
    }

    fn theta_at(&self, z: Wide) -> Values {
        self.theta.at(z.scaled(half_pi() / self.width))
    }

    /// ℘ minus each of the three roots, as squares of quotients of theta functions.
    pub(crate) fn differences(&self, z: Wide) -> [Wide; 3] {
        let Values { one, two, three, four, .. } = self.theta_at(self.reduced(z).z);
        let unit = half_pi() / self.width;
        let [c2, c3, c4] = self.constants;
        [(two, c2), (three, c3), (four, c4)].map(|(value, constant)| {
            let root = quotient(value, one).scaled(constant * unit);
            root * root
        })
    }

    /// ℘(z), from the root of least magnitude.
    pub(crate) fn p(&self, z: Wide) -> Wide {
        let [_, from_middle, _] = self.differences(z);
        let [_, middle, _] = self.roots;
        from_middle + real(middle)
    }

    /// ℘'(z) = -2 √((℘ - e₁)(℘ - e₂)(℘ - e₃)); the quotients of theta functions determine the sign.
    pub(crate) fn p_prime(&self, z: Wide) -> Wide {
        let Values { one, two, three, four, .. } = self.theta_at(self.reduced(z).z);
        let unit = half_pi() / self.width;
        let [c2, c3, c4] = self.constants;
        let product = quotient(two, one).scaled(unit * c2)
            * quotient(three, one).scaled(unit * c3)
            * quotient(four, one).scaled(unit * c4);
        -(product + product)
    }

    /// ζ(z).
    pub(crate) fn zeta(&self, z: Wide) -> Wide {
        z.scaled(self.kappa.doubled()) + self.sigma_factor(z).log_slope()
    }

    /// A logarithm of σ(z).
    pub(crate) fn ln_sigma(&self, z: Wide) -> Wide {
        let sigma_factor = self.sigma_factor(z);
        (z * z).scaled(self.kappa) + sigma_factor.exponent + ln(sigma_factor.value)
    }

    /// σ(z).
    pub(crate) fn sigma(&self, z: Wide) -> Wide {
        let sigma_factor = self.sigma_factor(z);
        sigma_factor.value * exp((z * z).scaled(self.kappa) + sigma_factor.exponent)
    }

    /// B(z). The period 2W changes only its sign.
    pub(crate) fn sigma_factor(&self, z: Wide) -> SigmaFactor {
        let Reduced { z, across, up } = self.reduced(z);
        let Values { one, one_slope, .. } = self.theta_at(z);
        let per_slope = Extended::ONE / self.origin_slope;
        // ϑ₁(v + nπ + mπiV/W) = (-1)^{n+m} e^{πVm²/W - 2imv} ϑ₁(v), with v = πz/2W
        let (unit, up) = (half_pi() / self.width, Extended::from(up));
        let rate = imaginary(-(unit * up).doubled());
        let growth = (unit * self.height * up.squared()).doubled();
        let constant = Complex::new(growth, half_pi() * (2.0 * odd(across + up.to_f64())).into());
        SigmaFactor {
            exponent: rate * z + constant,
            exponent_rate: rate,
            value: one.scaled(per_slope / unit),
            slope: one_slope.scaled(per_slope),
        }
    }
}

/// Nome q = e^{-πV/W}.
fn nome(width: Extended, height: Extended) -> Extended {
    real_exp(-(half_pi().doubled() * height / width))
}

/// Three roots with sum 0, from e₁ - e₂ and e₂ - e₃.
pub(crate) fn roots_from_gaps(upper: Extended, lower: Extended) -> [Extended; 3] {
    let third = |x: Extended| x / 3.0.into();
    [third(upper.doubled() + lower), third(lower - upper), -third(upper + lower.doubled())]
}

/// 1 for an odd whole number, 0 for an even one.
fn odd(n: f64) -> f64 {
    n - 2.0 * libm::floor(0.5 * n)
}
