//! Aperiodic motion in elementary functions: u, |β| and dt/dv as functions of v, for either support. For a fixed tip also α, with
//! t = v √(2A/(p g (1 - e₁))):
//!
//! ```text
//! α = (√((1+e₁)/2) sech v + i s₊ tanh v) e^{iψ},   b² = (1 - e₁)/2,
//! ψ = s₊ (√(1 - b²)/b v - 2 arctan(√((1-b)/(1+b)) tanh(v/2)))
//! ```

use crate::elliptic::elementary::{ValueAndSlope, WideComplex, angle, cis, real, tanh_sech};
use toytop::scalar::{Extended, Float, Ring};
use toytop::{Complex, Sign};

/// Constants of u(v), |β| and dt/dv.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct AperiodicConstants {
    pub(super) e1: Extended,
    pub(super) one_plus_e1: Extended,
    pub(super) one_minus_e1: Extended,
    pub(super) a_over_p: Extended,
    pub(super) s: Extended,
    pub(super) g: Extended,
}

/// Values at one v.
#[derive(Clone, Copy, Debug)]
pub(super) struct AperiodicValues {
    pub(super) v: Extended,
    pub(super) tanh: Extended,
    pub(super) sech: Extended,
    pub(super) ln_sech: Extended,
    pub(super) one_minus_u: Extended,
    pub(super) one_plus_u: Extended,
    pub(super) dt_dv: Extended,
}

impl AperiodicValues {
    pub(super) fn with_sign_of_v(&self, value: Extended) -> Extended {
        if self.v < Extended::ZERO { -value } else { value }
    }
}

impl AperiodicConstants {
    pub(super) fn at(&self, v: Extended) -> AperiodicValues {
        let (tanh, sech, ln_sech) = tanh_sech(v);
        let one_minus_u = self.one_minus_e1 * sech.squared();
        let one_plus_u = self.one_plus_e1 + self.one_minus_e1 * tanh.squared();
        let dt_dv = self.dt_dv(self.a_over_p + self.s * one_minus_u * one_plus_u);
        AperiodicValues { v, tanh, sech, ln_sech, one_minus_u, one_plus_u, dt_dv }
    }

    /// Derivative dt/dv for a value of D.
    fn dt_dv(&self, d: Extended) -> Extended {
        (d.doubled() / (self.g * self.one_minus_e1)).sqrt()
    }

    /// Bounds on v at a given t, from the bounds on dt/dv.
    pub(super) fn bounds(&self, t: Extended) -> [Extended; 2] {
        let fast = t / self.dt_dv(self.a_over_p);
        let slow = t / self.dt_dv(self.a_over_p + self.s);
        // widened by a margin on either side
        let margin = fast.abs() * Extended::from(1e-13);
        if fast < slow { [fast - margin, slow + margin] } else { [slow - margin, fast + margin] }
    }

    /// β with argument 0, and its time derivative.
    pub(super) fn beta(&self, point: &AperiodicValues) -> ValueAndSlope {
        let value = self.one_minus_e1.halved().sqrt() * point.sech;
        ValueAndSlope { value: real(value), slope: real(-(value * point.tanh / point.dt_dv)) }
    }
}

/// Solution for a fixed tip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct FixedTip {
    /// Moduli √((1 ± e₁)/2) of α and β at the lowest point.
    lowest: [Extended; 2],
    sign: Sign,
}

impl FixedTip {
    pub(super) fn new(constants: &AperiodicConstants, sign: Sign) -> Self {
        Self { lowest: [constants.one_plus_e1, constants.one_minus_e1].map(|x| x.halved().sqrt()), sign }
    }

    fn psi(&self, point: &AperiodicValues) -> Extended {
        let [a, b] = self.lowest;
        // (1 - b)/(1 + b) = a²/(1 + b)²
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
