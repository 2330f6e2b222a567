//! Point of the reduced curve.

use crate::scalar::{Extended, Float, Ring};

/// Point (u, u') of the reduced curve.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ReducedPoint {
    pub(crate) u: Extended,
    pub(crate) one_minus_u: Extended,
    pub(crate) one_plus_u: Extended,
    pub(crate) udot: Extended,
    /// Kinetic energy of the axis, (A |ω × r|² + p s u'²)/2, in units of [`energy_unit`](crate::Top::energy_unit).
    pub(crate) scaled_axis_energy: Extended,
}

impl ReducedPoint {
    /// Whether the axis is upright and does not move.
    pub(crate) fn is_sleeping(&self) -> bool {
        self.one_minus_u == Extended::ZERO && self.scaled_axis_energy == Extended::ZERO
    }

    /// Angular momentum |m| without torque: |m|² = n² + A²|ω × r|².
    pub(crate) fn momentum(&self, a: Extended, n: Extended) -> Extended {
        ((a * self.scaled_axis_energy).doubled() + n.squared()).sqrt()
    }
}
