//! Cayley-Klein parameter in an elliptic case: an exponential times a quotient of theta functions.

use crate::elliptic::elementary::{Wide, angle, complex_exp, quotient};
use crate::elliptic::lattice::{Half, Lattice};
use crate::elliptic::theta::ValueAndSlope;
use toytop::Phase;
use toytop::internal::phase_of;
use toytop::scalar::{Extended, Ring};

/// Function k e^{lx} σ(x - a - h)/σ(x - c), where h and c are half periods; each period multiplies it by a constant.
///
/// It is stored as k̂ e^{λx} ϑ(x - a)/ϑ(x) with the theta functions that are 0 at h and at c. All constants of the sigma functions
/// cancel: for l = ζ(a + h - c) + `rate_offset`, λ is `rate_offset` plus the logarithmic derivative at a of the theta function that is 0 at h + c.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ThetaQuotient {
    scale: Extended,
    pub(crate) rate: Wide,
    pub(crate) zero: Wide,
    halves: [Half; 2],
}

impl ThetaQuotient {
    /// Quotient with the zero a + h and the pole c, and the given modulus at x; the argument of k is arbitrary.
    pub(crate) fn through(
        lattice: &Lattice,
        halves: [Half; 2],
        zero: Wide,
        rate_offset: Wide,
        (x, size): (Wide, Extended),
    ) -> Self {
        let [h, c] = halves;
        let rate = rate_offset + lattice.theta(h ^ c, zero).log_slope();
        let unscaled = Self { scale: Extended::ONE, rate, zero, halves };
        Self { scale: size / unscaled.at(lattice, x).value.modulus(), ..unscaled }
    }

    pub(crate) fn at(&self, lattice: &Lattice, x: Wide) -> ValueAndSlope {
        let [h, c] = self.halves;
        let (above, below) = (lattice.theta(h, x - self.zero), lattice.theta(c, x));
        let factor = quotient(complex_exp(self.rate * x).scaled(self.scale), below.value);
        let rate = self.rate - below.log_slope();
        ValueAndSlope { value: factor * above.value, slope: factor * (above.slope + rate * above.value) }
    }

    /// Change of the argument from `x` to `x` + `period` in turns, modulo 1; the value must not be 0 there.
    pub(crate) fn turns(&self, lattice: &Lattice, x: Wide, period: Wide) -> Phase {
        let [before, after] = [x, x + period].map(|x| self.at(lattice, x).value);
        let turned = after * before.conj();
        phase_of(angle(turned.im, turned.re))
    }
}
