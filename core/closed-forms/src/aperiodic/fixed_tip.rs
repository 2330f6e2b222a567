//! Aperiodic motion with a fixed tip in elementary functions, with t = v √(2A/(p g (1 - e₁))):
//!
//! ```text
//! α = (a sech v + i s₊ tanh v) e^{iψ},   a² = (1 + e₁)/2,   b² = (1 - e₁)/2
//! ψ = s₊ (a v/b - 2 arctan(a/(1 + b) tanh(v/2)))
//! ```

use crate::aperiodic::constants::{AperiodicConstants, AperiodicValues};
use crate::elliptic::elementary::{ValueAndSlope, WideComplex, angle, cis, tanh_sech};
use toytop::scalar::{Extended, Float, Ring};
use toytop::{Complex, Sign};

/// Solution for a fixed tip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct FixedTip {
    /// Moduli a and b of α and β at the lowest point.
    lowest: [Extended; 2],
    /// Sign s₊ of l + n.
    sign: Sign,
}

impl FixedTip {
    pub(super) fn new(constants: &AperiodicConstants, sign: Sign) -> Self {
        Self { lowest: [constants.one_plus_e1, constants.one_minus_e1].map(|x| x.halved().sqrt()), sign }
    }

    fn psi(&self, point: &AperiodicValues) -> Extended {
        let [a, b] = self.lowest;
        let (half, ..) = tanh_sech(point.v.halved());
        self.sign.times(a / b * point.v - angle(a * half, Extended::ONE + b).doubled())
    }

    /// Argument of α minus that at u = e₁; 0 for e₁ = -1.
    pub(super) fn argument(&self, point: &AperiodicValues) -> Extended {
        let [a, _] = self.lowest;
        self.psi(point) + angle(a * self.sign.times(point.tanh), a * a * point.sech)
    }

    pub(super) fn alpha(&self, point: &AperiodicValues) -> ValueAndSlope {
        let [a, b] = self.lowest;
        let AperiodicValues { tanh, sech, dt_dv, .. } = *point;
        let one = Extended::ONE;
        // dψ/dv = s₊ a/b / (1 + b sech v)
        let psi_slope = self.sign.times(a / b / (one + b * sech));
        let ellipse: WideComplex = Complex::new(a * sech, self.sign.times(tanh));
        let ellipse_slope = Complex::new(-(a * sech * tanh), self.sign.times(sech.squared()));
        let factor = cis(self.psi(point));
        let slope = (ellipse_slope + ellipse.times_i().scaled(psi_slope)) * factor;
        ValueAndSlope { value: ellipse * factor, slope: slope.scaled(one / dt_dv) }
    }
}
