//! Tip angle of methods that compute only orientations: the argument of the tip, continued by means of the ephemeris.

use crate::Failure;
use crate::motion::Scalar;
use crate::motion::ephemeris::{AnyScalar, smallest};
use std::f64::consts::PI;
use toytop::{Complex, Motion, TipClass};

/// Tip angle of a motion at any time, to a few roundings of `f64`.
pub struct TipAngle {
    /// Ephemeris of the motion; `None` where the axis is vertical at all times.
    ephemeris: Option<Box<dyn AnyScalar>>,
    /// Angle by multiples of which the argument of αβ is ambiguous, rad: half a turn where the curve reaches the centre, because the radius
    /// then has a sign.
    unit: f64,
}

impl TipAngle {
    /// Tip angle of a motion.
    ///
    /// # Errors
    /// [`Failure::Method`]: no ephemeris is large enough.
    pub fn of(motion: &Motion) -> Result<Self, Failure> {
        let vertical = motion.regime().is_vertical();
        let ephemeris = if vertical { None } else { Some(smallest(Scalar::F64, motion)?) };
        let signed = matches!(motion.tip_class(), TipClass::ThroughOrigin | TipClass::Spiral);
        Ok(Self { ephemeris, unit: if signed { PI } else { 2.0 * PI } })
    }

    /// Argument of αβ closest to the motion's tip angle at t, rad; the motion's tip angle itself where |αβ| is below `noise`.
    #[must_use]
    pub fn continued(&self, t: f64, product: Complex<f64>, noise: f64) -> Option<f64> {
        let guide = self.ephemeris.as_ref()?.at(t).sample.phi?;
        if product.norm_squared() < noise * noise {
            return Some(guide);
        }
        Some(guide + remainder(product.im.atan2(product.re) - guide, self.unit))
    }
}

/// Difference of x and the nearest multiple of `unit`.
fn remainder(x: f64, unit: f64) -> f64 {
    x - unit * (x / unit).round()
}
