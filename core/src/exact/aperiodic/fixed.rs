//! Aperiodic motion of the Lagrange top, in elementary functions: t = v √(2A/(p g (1 - e₁))), and
//!
//! ```text
//! α = (√((1+e₁)/2) sech v + i s₊ tanh v) e^{iψ},   b² = (1 - e₁)/2,
//! ψ = s₊ (√(1 - b²)/b v - 2 arctan(√((1-b)/(1+b)) tanh(v/2)))
//! ```

use crate::complex::Complex;
use crate::constants::Sign;
use crate::elliptic::elementary::{Wide, cis};
use crate::elliptic::transcendental::angle;
use crate::elliptic::transcendental::tanh_sech;
use crate::exact::aperiodic::{Rise, RiseValues};
use crate::exact::sigma_quotient::ValueAndSlope;
use crate::scalar::{Extended, Float, Ring};

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

    pub(super) fn alpha(&self, point: &RiseValues) -> ValueAndSlope {
        let [a, b] = self.lowest;
        let RiseValues { v, tanh, sech, dt_dv, .. } = *point;
        // (1 - b)/(1 + b) = a²/(1 + b)²
        let (half, ..) = tanh_sech(v.halved());
        let one = Extended::ONE;
        let psi = self.sign.times(a / b * v - angle(a * half, one + b).doubled());
        // dψ/dv = s₊ a/b / (1 + b sech v)
        let turning = self.sign.times(a / b / (one + b * sech));
        let bracket: Wide = Complex::new(a * sech, self.sign.times(tanh));
        let along: Wide = Complex::new(-(a * sech * tanh), self.sign.times(sech.squared()));
        let factor = cis(psi);
        let slope = (along + bracket.times_i().scaled(turning)) * factor;
        ValueAndSlope { value: bracket * factor, slope: slope.scaled(one / dt_dv) }
    }
}
