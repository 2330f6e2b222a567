//! Weierstrass functions on a rectangular lattice at least as tall as it is wide: there the nome is at most e^{-π}.

use super::elementary::{exp, ln, quotient};
use super::theta::{Theta, Values};
use crate::complex::Complex;
use core::f64::consts::{FRAC_PI_2, PI};

/// The lattice of 2W and 2iV, W <= V, and what of it does not depend on z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct TallLattice {
    /// W.
    width: f64,
    /// V.
    height: f64,
    /// The roots at W, W + iV, iV: largest, middle, smallest.
    roots: [f64; 3],
    theta: Theta,
    /// ϑ₁'(0)/ϑ₂(0), ϑ₁'(0)/ϑ₃(0), ϑ₁'(0)/ϑ₄(0) for the functions as [`Values`] has them.
    constants: [f64; 3],
    /// ϑ₁'(0)/(2 q^{1/4}).
    origin_slope: f64,
    /// κ = ζ(W)/2W.
    kappa: f64,
}

/// B(z) = σ(z) e^{-κz²}, the sigma function without its Gaussian: e^`exponent` times `value`.
///
/// Quotients of sigmas need no more than this, and lose no digits to Gaussians that cancel.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bare {
    pub(super) exponent: Complex<f64>,
    /// d exponent/dz.
    pub(super) exponent_rate: Complex<f64>,
    pub(super) value: Complex<f64>,
    /// d value/dz.
    pub(super) slope: Complex<f64>,
}

impl Bare {
    /// B'/B.
    pub(super) fn log_slope(&self) -> Complex<f64> {
        self.exponent_rate + quotient(self.slope, self.value)
    }

    /// B itself.
    pub(super) fn whole(&self) -> Complex<f64> {
        self.value * exp(self.exponent)
    }
}

/// z within a cell around 0, and the periods taken off.
struct Reduced {
    z: Complex<f64>,
    across: f64,
    up: f64,
}

impl TallLattice {
    /// From W and V and the roots, W <= V.
    pub(super) fn new(width: f64, height: f64, roots: [f64; 3]) -> Self {
        let theta = Theta::new(libm::exp(-PI * height / width));
        let Values { one_slope, two, three, four, .. } = theta.at(Complex::ZERO);
        let constants = [two, three, four].map(|value| one_slope.re / value.re);
        let kappa = PI * PI / 24.0 * theta.eisenstein() / (width * width);
        Self { width, height, roots, theta, constants, origin_slope: one_slope.re, kappa }
    }

    /// The roots of the lattice of these half periods.
    pub(super) fn roots_of(width: f64, height: f64) -> [f64; 3] {
        let nome = libm::exp(-PI * height / width);
        let Values { two, four, .. } = Theta::new(nome).at(Complex::ZERO);
        let fourth = |x: f64| x * x * x * x;
        let unit = FRAC_PI_2 / width;
        // e₁ - e₂ = (π/2W)² ϑ₄⁴, e₂ - e₃ = (π/2W)² ϑ₂⁴
        let (upper, lower) = (unit * unit * fourth(four.re), 16.0 * nome * unit * unit * fourth(two.re));
        roots_from_gaps(upper, lower)
    }

    pub(super) fn kappa(&self) -> f64 {
        self.kappa
    }

    pub(super) fn width(&self) -> f64 {
        self.width
    }

    pub(super) fn height(&self) -> f64 {
        self.height
    }

    /// ζ(iV)/i = 2κV - π/2W (Legendre's relation).
    pub(super) fn eta_up(&self) -> f64 {
        2.0 * self.kappa * self.height - FRAC_PI_2 / self.width
    }

    fn reduced(&self, z: Complex<f64>) -> Reduced {
        let (width, height) = (2.0 * self.width, 2.0 * self.height);
        let (across, up) = (libm::round(z.re / width), libm::round(z.im / height));
        Reduced { z: Complex::new(z.re - across * width, z.im - up * height), across, up }
    }

    fn theta_at(&self, z: Complex<f64>) -> Values {
        self.theta.at(z.scaled(FRAC_PI_2 / self.width))
    }

    /// ℘ less each of the three roots: squares of theta quotients.
    pub(super) fn differences(&self, z: Complex<f64>) -> [Complex<f64>; 3] {
        let Values { one, two, three, four, .. } = self.theta_at(self.reduced(z).z);
        let unit = FRAC_PI_2 / self.width;
        let [c2, c3, c4] = self.constants;
        [(two, c2), (three, c3), (four, c4)].map(|(value, constant)| {
            let root = quotient(value, one).scaled(constant * unit);
            root * root
        })
    }

    /// ℘, from the root closest to 0.
    pub(super) fn p(&self, z: Complex<f64>) -> Complex<f64> {
        let [_, from_middle, _] = self.differences(z);
        let [_, middle, _] = self.roots;
        from_middle + Complex::new(middle, 0.0)
    }

    /// ℘' = -2 √((℘ - e₁)(℘ - e₂)(℘ - e₃)), the sign in the theta quotients.
    pub(super) fn p_prime(&self, z: Complex<f64>) -> Complex<f64> {
        let Values { one, two, three, four, .. } = self.theta_at(self.reduced(z).z);
        let unit = FRAC_PI_2 / self.width;
        let [c2, c3, c4] = self.constants;
        let product = quotient(two, one).scaled(unit * c2)
            * quotient(three, one).scaled(unit * c3)
            * quotient(four, one).scaled(unit * c4);
        product.scaled(-2.0)
    }

    /// ζ.
    pub(super) fn zeta(&self, z: Complex<f64>) -> Complex<f64> {
        z.scaled(2.0 * self.kappa) + self.bare(z).log_slope()
    }

    /// One value of ln σ.
    pub(super) fn ln_sigma(&self, z: Complex<f64>) -> Complex<f64> {
        let bare = self.bare(z);
        (z * z).scaled(self.kappa) + bare.exponent + ln(bare.value)
    }

    /// σ.
    pub(super) fn sigma(&self, z: Complex<f64>) -> Complex<f64> {
        let bare = self.bare(z);
        bare.value * exp((z * z).scaled(self.kappa) + bare.exponent)
    }

    /// B, which the period 2W only changes in sign.
    pub(super) fn bare(&self, z: Complex<f64>) -> Bare {
        let Reduced { z, across, up } = self.reduced(z);
        let Values { one, one_slope, .. } = self.theta_at(z);
        let per_slope = 1.0 / self.origin_slope;
        // ϑ₁(v + nπ + mπiV/W) = (-1)^{n+m} e^{πVm²/W - 2imv} ϑ₁(v), v = πz/2W
        let rate = Complex::new(0.0, -PI * up / self.width);
        let constant = Complex::new(PI * self.height / self.width * up * up, PI * odd(across + up));
        Bare {
            exponent: rate * z + constant,
            exponent_rate: rate,
            value: one.scaled(per_slope / (FRAC_PI_2 / self.width)),
            slope: one_slope.scaled(per_slope),
        }
    }
}

/// The three roots with sum 0, from e₁ - e₂ and e₂ - e₃.
pub(super) fn roots_from_gaps(upper: f64, lower: f64) -> [f64; 3] {
    [(2.0 * upper + lower) / 3.0, (lower - upper) / 3.0, -(upper + 2.0 * lower) / 3.0]
}

/// 1 for an odd whole number, 0 for an even one.
fn odd(n: f64) -> f64 {
    n - 2.0 * libm::floor(0.5 * n)
}
