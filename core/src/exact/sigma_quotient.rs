//! Cayley-Klein parameter in an elliptic case: an exponential times a quotient of sigma functions.

use crate::elliptic::elementary::{Wide, exp, modulus, quotient};
use crate::elliptic::lattice::Lattice;
use crate::elliptic::transcendental::angle;
use crate::phase::Phase;
use crate::scalar::{Extended, Ring};

/// Function k e^{lx} σ(x - a)/σ(x - c), with the zero a and the pole c; each period multiplies it by a constant.
///
/// It is stored as k̂ e^{l̂x} B(x - a)/B(x - c) with σ(z) = e^{κz²} B(z). The quotient of the factors e^{κz²} is a
/// constant times e^{2κ(c - a)x}, which cancels the corresponding term of ζ(a - c) in l.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SigmaQuotient {
    scale: Extended,
    rate: Wide,
    zero: Wide,
    pole: Wide,
}

/// Value and derivative of a function.
#[derive(Clone, Copy, Debug)]
pub(super) struct ValueAndSlope {
    pub(super) value: Wide,
    pub(super) slope: Wide,
}

impl ValueAndSlope {
    /// Value and derivative with respect to another variable; `rate` is the derivative of the previous variable with
    /// respect to it.
    pub(super) fn by(self, rate: Wide) -> Self {
        Self { slope: self.slope * rate, ..self }
    }
}

impl SigmaQuotient {
    /// Quotient with l = ζ(a - c) + `rate_offset`, and |k| for the given modulus at x; the argument of k is arbitrary.
    pub(super) fn through(
        lattice: &Lattice,
        [zero, pole]: [Wide; 2],
        rate_offset: Wide,
        (x, size): (Wide, Extended),
    ) -> Self {
        let rate = rate_offset + lattice.sigma_factor(zero - pole).log_slope();
        let unscaled = Self { scale: Extended::ONE, rate, zero, pole };
        let value = unscaled.at(lattice, x).value;
        Self { scale: size / modulus(value), ..unscaled }
    }

    pub(super) fn at(&self, lattice: &Lattice, x: Wide) -> ValueAndSlope {
        let (above, below) = (lattice.sigma_factor(x - self.zero), lattice.sigma_factor(x - self.pole));
        let factor =
            quotient(exp(self.rate * x + above.exponent - below.exponent).scaled(self.scale), below.value);
        let value = factor * above.value;
        // without a division by σ(x - a), so that the derivative is accurate at the zero too
        let rate = self.rate + above.exponent_rate - below.log_slope();
        ValueAndSlope { value, slope: factor * above.slope + rate * value }
    }

    /// Change of the argument from `x` to `x` + `period` in turns, modulo 1; the value must not be 0 there.
    pub(super) fn turns(&self, lattice: &Lattice, x: Wide, period: Wide) -> Phase {
        let [before, after] = [x, x + period].map(|x| self.at(lattice, x).value);
        let turned = after * before.conj();
        angle(turned.im, turned.re).in_turns().to_phase()
    }
}
