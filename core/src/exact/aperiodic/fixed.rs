//! The Lagrange top's aperiodic motion, all elementary: t = v √(2A/(p g (1 - e₁))), and
//!
//! ```text
//! α = (√((1+e₁)/2) sech v + i s₊ tanh v) e^{iψ},   b² = (1 - e₁)/2,
//! ψ = s₊ (√(1 - b²)/b v - 2 arctan(√((1-b)/(1+b)) tanh(v/2)))
//! ```

use super::{Point, Rise};
use crate::complex::Complex;
use crate::exact::elementary::cis;
use crate::exact::sigma_quotient::Germ;
use crate::launch::Sign;
use crate::real::Float;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Fixed {
    /// √((1 ± e₁)/2): |α| and |β| at the lowest point.
    lowest: [f64; 2],
    sign: Sign,
}

impl Fixed {
    pub(super) fn new(rise: &Rise, sign: Sign) -> Self {
        Self { lowest: [rise.one_plus_e1, rise.one_minus_e1].map(|x| Float::sqrt(0.5 * x)), sign }
    }

    pub(super) fn alpha(&self, point: &Point) -> Germ {
        let [a, b] = self.lowest;
        let Point { v, tanh, sech, slowness, .. } = *point;
        // (1 - b)/(1 + b) = a²/(1 + b)²
        let half = libm::tanh(0.5 * v);
        let psi = self.sign.times(a / b * v - 2.0 * libm::atan(a / (1.0 + b) * half));
        // dψ/dv = s₊ a/b / (1 + b sech v)
        let turning = self.sign.times(a / b / (1.0 + b * sech));
        let bracket = Complex::new(a * sech, self.sign.times(tanh));
        let along = Complex::new(-a * sech * tanh, self.sign.times(sech * sech));
        let factor = cis(psi);
        Germ {
            value: bracket * factor,
            slope: ((along + bracket.times_i().scaled(turning)) * factor).scaled(1.0 / slowness),
        }
    }
}
