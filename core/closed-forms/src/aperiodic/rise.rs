//! ScaledTop of an aperiodic motion that depend on u alone, as functions of v.

use crate::elliptic::elementary::{real, tanh_sech};
use crate::elliptic::theta::ValueAndSlope;
use toytop::scalar::{Extended, Float, Ring};

/// Constants of u(v), |β| and dt/dv.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Rise {
    pub(super) e1: Extended,
    pub(super) one_plus_e1: Extended,
    pub(super) one_minus_e1: Extended,
    pub(super) a_over_p: Extended,
    pub(super) s: Extended,
    pub(super) g: Extended,
}

/// Values at one v.
#[derive(Clone, Copy, Debug)]
pub(super) struct RiseValues {
    pub(super) v: Extended,
    pub(super) tanh: Extended,
    pub(super) sech: Extended,
    pub(super) ln_sech: Extended,
    /// Difference 1 - u.
    pub(super) below: Extended,
    /// Sum 1 + u.
    pub(super) above: Extended,
    pub(super) dt_dv: Extended,
}

impl RiseValues {
    pub(super) fn with_sign_of_v(&self, value: Extended) -> Extended {
        if self.v < Extended::ZERO { -value } else { value }
    }
}

impl Rise {
    pub(super) fn at(&self, v: Extended) -> RiseValues {
        let (tanh, sech, ln_sech) = tanh_sech(v);
        let below = self.one_minus_e1 * sech.squared();
        let above = self.one_plus_e1 + self.one_minus_e1 * tanh.squared();
        let dt_dv = self.dt_dv(self.a_over_p + self.s * below * above);
        RiseValues { v, tanh, sech, ln_sech, below, above, dt_dv }
    }

    /// Derivative dt/dv for a value of D.
    fn dt_dv(&self, d: Extended) -> Extended {
        (d.doubled() / (self.g * self.one_minus_e1)).sqrt()
    }

    /// Bounds on v at a given t, from the bounds on dt/dv.
    pub(super) fn bounds(&self, t: Extended) -> [Extended; 2] {
        let (fast, slow) = (t / self.dt_dv(self.a_over_p), t / self.dt_dv(self.a_over_p + self.s));
        // widened by a margin on either side
        let margin = fast.abs() * Extended::from(1e-13);
        if fast < slow { [fast - margin, slow + margin] } else { [slow - margin, fast + margin] }
    }

    /// β with argument 0, and its time derivative.
    pub(super) fn beta(&self, point: &RiseValues) -> ValueAndSlope {
        let value = self.one_minus_e1.halved().sqrt() * point.sech;
        ValueAndSlope { value: real(value), slope: real(-(value * point.tanh / point.dt_dv)) }
    }
}
