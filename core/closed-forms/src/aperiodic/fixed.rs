//! Aperiodic motion of the Lagrange top, in elementary functions: t = v √(2A/(p g (1 - e₁))), and
//!
//! ```text
//! α = (√((1+e₁)/2) sech v + i s₊ tanh v) e^{iψ},   b² = (1 - e₁)/2,
//! ψ = s₊ (√(1 - b²)/b v - 2 arctan(√((1-b)/(1+b)) tanh(v/2)))
//! ```

use crate::aperiodic::rise::{Rise, RiseValues};
use crate::elliptic::elementary::{Wide, angle, cis, tanh_sech};
use crate::elliptic::theta::ValueAndSlope;
use toytop::scalar::{Extended, Float, Ring};
use toytop::{Complex, Sign};

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Fixed {
    /// Moduli √((1 ± e₁)/2) of α and β at the lowest point.
    lowest: [Extended; 2],
    sign: Sign,
}

impl Fixed {
    pub(super) fn new(rise: &Rise, sign: Sign) -> Self {
        Self { lowest: [rise.one_plus_e1, rise.one_minus_e1].map(|x| x.halved().sqrt()), sign }
    }

    fn psi(&self, point: &RiseValues) -> Extended {
        let [a, b] = self.lowest;
        // (1 - b)/(1 + b) = a²/(1 + b)²
        let (half, ..) = tanh_sech(point.v.halved());
        self.sign.times(a / b * point.v - angle(a * half, Extended::ONE + b).doubled())
    }

    /// Argument of α minus that at u = e₁; 0 for e₁ = -1.
    pub(super) fn argument(&self, point: &RiseValues) -> Extended {
        let [a, _] = self.lowest;
        self.psi(point) + angle(a * self.sign.times(point.tanh), a * a * point.sech)
    }

    pub(super) fn alpha(&self, point: &RiseValues) -> ValueAndSlope {
        let [a, b] = self.lowest;
        let RiseValues { tanh, sech, dt_dv, .. } = *point;
        let one = Extended::ONE;
        // dψ/dv = s₊ a/b / (1 + b sech v)
        let turning = self.sign.times(a / b / (one + b * sech));
        let brackets: Wide = Complex::new(a * sech, self.sign.times(tanh));
        let along: Wide = Complex::new(-(a * sech * tanh), self.sign.times(sech.squared()));
        let factor = cis(self.psi(point));
        let slope = (along + brackets.times_i().scaled(turning)) * factor;
        ValueAndSlope { value: brackets * factor, slope: slope.scaled(one / dt_dv) }
    }
}
