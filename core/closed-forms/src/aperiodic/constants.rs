//! Aperiodic motion in elementary functions for either support: u, |β| and dt/dv as functions of v.

use crate::elliptic::elementary::{ValueAndSlope, real, tanh_sech};
use toytop::scalar::{Extended, Float, Ring};

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
