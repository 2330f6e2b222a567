//! What a Cayley-Klein parameter is in an elliptic case: an exponential times a quotient of sigma functions.

use super::elementary::{exp, quotient};
use super::weierstrass::Weierstrass;
use crate::complex::Complex;
use crate::turns::Turns;

/// k e^{lx} σ(x - a)/σ(x - c), a function with the zero a and the pole c that every period only multiplies.
///
/// Held as k̂ e^{l̂x} B(x - a)/B(x - c) with σ(z) = e^{κz²} B(z): the Gaussians leave a constant and e^{2κ(c - a)x}, which
/// cancels the like term of ζ(a - c) in l.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SigmaQuotient {
    scale: f64,
    rate: Complex<f64>,
    zero: Complex<f64>,
    pole: Complex<f64>,
}

/// A function's value and derivative.
#[derive(Clone, Copy, Debug)]
pub(super) struct Germ {
    pub(super) value: Complex<f64>,
    pub(super) slope: Complex<f64>,
}

impl Germ {
    /// The same as a function of something else: `rate` is the derivative of the old variable by the new one.
    pub(super) fn by(self, rate: Complex<f64>) -> Self {
        Self { slope: self.slope * rate, ..self }
    }
}

impl SigmaQuotient {
    /// With l = ζ(a - c) + `excess`, and |k| such that the modulus at x is the one given; the argument of k is left open.
    pub(super) fn through(
        lattice: &Weierstrass,
        [zero, pole]: [Complex<f64>; 2],
        excess: Complex<f64>,
        (x, modulus): (Complex<f64>, f64),
    ) -> Self {
        let rate = excess + lattice.bare(zero - pole).log_slope();
        let unscaled = Self { scale: 1.0, rate, zero, pole };
        let value = unscaled.at(lattice, x).value;
        Self { scale: modulus / libm::hypot(value.re, value.im), ..unscaled }
    }

    pub(super) fn at(&self, lattice: &Weierstrass, x: Complex<f64>) -> Germ {
        let (above, below) = (lattice.bare(x - self.zero), lattice.bare(x - self.pole));
        let factor =
            quotient(exp(self.rate * x + above.exponent - below.exponent).scaled(self.scale), below.value);
        let value = factor * above.value;
        // without a division by σ(x - a), so that the derivative is good at the zero too
        let rate = self.rate + above.exponent_rate - below.log_slope();
        Germ { value, slope: factor * above.slope + rate * value }
    }

    /// The turns of the argument from `x` to `x` + `period`, up to whole ones; the value must not vanish there.
    pub(super) fn turns(&self, lattice: &Weierstrass, x: Complex<f64>, period: Complex<f64>) -> Turns {
        let [before, after] = [x, x + period].map(|x| self.at(lattice, x).value);
        Turns::from_radians((after * before.conj()).arg())
    }
}
