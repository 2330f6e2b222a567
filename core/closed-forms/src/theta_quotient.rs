//! Cayley-Klein parameters of the elliptic cases, as quotients of theta functions, their zeros, and the elliptic integral of χ.

use crate::elliptic::carlson::{carlson_rf, first_kind};
use crate::elliptic::elementary::{ValueAndSlope, WideComplex, angle, complex_exp, quotient};
use crate::elliptic::lattice::{Lattice, LatticeHalfPeriod};
use toytop::internal::exact_sine_cosine;
use toytop::scalar::{Extended, Float, Ring};
use toytop::{BranchPoints, Phase, Signs};

/// Cayley-Klein parameter in an elliptic case: k e^{lx} σ(x - a - h)/σ(x - c), where h and c are half periods. Each period multiplies it
/// by a constant.
///
/// It is stored as k̂ e^{λx} ϑ(x - a)/ϑ(x) with the theta functions that are 0 at h and at c. The constants of the sigma functions
/// cancel. If l = ζ(a + h - c) + `rate_offset`, then λ = `rate_offset` + ϑ'(a)/ϑ(a), where this ϑ is 0 at h + c.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ThetaQuotient {
    pub(crate) lattice: Lattice,
    scale: Extended,
    pub(crate) rate: WideComplex,
    pub(crate) zero: WideComplex,
    half_periods: [LatticeHalfPeriod; 2],
}

impl ThetaQuotient {
    /// Quotient with the zero a + h and the pole c, and the given modulus at x; the argument of k is arbitrary.
    pub(crate) fn through(
        lattice: &Lattice,
        half_periods: [LatticeHalfPeriod; 2],
        zero: WideComplex,
        rate_offset: WideComplex,
        (x, size): (WideComplex, Extended),
    ) -> Self {
        let [h, c] = half_periods;
        let rate = rate_offset + lattice.log_slope(h.plus(c), zero);
        let unscaled = Self { lattice: *lattice, scale: Extended::ONE, rate, zero, half_periods };
        Self { scale: size / unscaled.at(x).value.modulus(), ..unscaled }
    }

    pub(crate) fn at(&self, x: WideComplex) -> ValueAndSlope {
        let [h, c] = self.half_periods;
        let above = self.lattice.theta(h, x - self.zero);
        let below = self.lattice.theta(c, x);
        let factor = quotient(complex_exp(self.rate * x).scaled(self.scale), below.value);
        let rate = self.rate - below.log_slope();
        ValueAndSlope { value: factor * above.value, slope: factor * (above.slope + rate * above.value) }
    }

    /// Change of the argument from `x` to `x` + `period`, without whole turns. The value must not be 0 at `x`.
    pub(crate) fn rotation(&self, x: WideComplex, period: WideComplex) -> Phase {
        let ratio = self.at(x + period).value * self.at(x).value.conj();
        angle(ratio.im, ratio.re).radians_to_turns().to_phase()
    }
}

/// Elliptic integral x of an angle, up to a right angle: its sine is sn(√`length` x), where `length` = `swing` + `gap` and the modulus is
/// √(`swing`/`length`).
pub(crate) fn elliptic_integral(angle: Phase, [length, swing, gap]: [Extended; 3]) -> Extended {
    let (sine, cosine) = exact_sine_cosine(angle);
    let squared = cosine.squared();
    sine * carlson_rf(length * squared, gap + swing * squared, length)
}

/// Distances of u = -1 from u = e₁ and of u = 1 from u = e₂ in the argument of ℘, with the signs of l + n and l - n: α and β are 0 there.
///
/// * `third`: third factor of w²/4 beside u - e₁ and u - e₂, at u = -1, e₁, e₂ and 1
pub(crate) fn zeros(e: &BranchPoints<Extended>, signs: Signs, third: [Extended; 4]) -> [Extended; 2] {
    let [at_minus_one, at_e1, at_e2, at_one] = third;
    let zero = Extended::ZERO;
    let lower = [e.one_plus_e1, e.one_plus_e2(), at_minus_one];
    let below = first_kind(e.one_plus_e1, [zero, e.e2_minus_e1, at_e1], lower);
    let upper = [e.one_minus_e1(), e.one_minus_e2, at_one];
    let above = first_kind(e.one_minus_e2, upper, [e.e2_minus_e1, zero, at_e2]);
    [signs.l_plus_n.times(below.halved()), signs.l_minus_n.times(above.halved())]
}
