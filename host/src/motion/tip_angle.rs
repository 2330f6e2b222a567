//! Samples of methods that compute orientations and rates only: their tip angle is the argument of αβ, continued by the ephemeris.

use crate::Failure;
use crate::motion::Scalar;
use crate::motion::ephemeris::{AnyEphemeris, smallest_ephemeris};
use crate::motion::propagate::Sample;
use std::f64::consts::PI;
use toytop::{Complex, Motion, Orientation, TipClass};

/// Tip angle of a motion at any time, to a few roundings of `f64`.
pub struct TipAngle {
    /// Ephemeris of the motion; `None` where the axis is vertical at all times.
    ephemeris: Option<Box<dyn AnyEphemeris>>,
    /// Scale of the tip's curve, m.
    scale: f64,
    /// Least |αβ| whose argument is known.
    noise: f64,
    /// Angle by multiples of which the argument of αβ is ambiguous, rad: half a turn where the curve reaches the centre, because the radius
    /// then has a sign.
    unit: f64,
}

impl TipAngle {
    /// Least |αβ| at which the rounding of α and β to `f64` changes the argument of αβ by less than 1e-5 rad.
    pub const NOISE: f64 = 1e-11;

    /// Tip angle of a motion.
    ///
    /// * `noise`: least |αβ| whose argument is known, such as [`TipAngle::NOISE`]
    ///
    /// # Errors
    /// [`Failure::Method`]: no ephemeris is large enough.
    pub fn new(motion: &Motion, noise: f64) -> Result<Self, Failure> {
        let vertical = motion.regime().is_vertical();
        let ephemeris = if vertical { None } else { Some(smallest_ephemeris(Scalar::F64, motion)?) };
        let signed = matches!(motion.tip_class(), TipClass::ThroughOrigin | TipClass::Spiral);
        let scale = motion.top().tip_scale();
        Ok(Self { ephemeris, scale, noise, unit: if signed { PI } else { 2.0 * PI } })
    }

    /// Sample at a time, from the orientation and the rates ω and u' there.
    pub fn sample(&self, t: f64, phi: Orientation<f64>, omega: [f64; 3], udot: f64) -> Sample {
        let Orientation { alpha, beta } = phi;
        Sample {
            t,
            u: phi.clamped_u(),
            udot,
            alpha,
            beta,
            omega,
            tip: phi.tip_over_s().scaled(self.scale),
            tip_angle: self.continued(t, alpha * beta),
            error_bound: None,
        }
    }

    /// Argument of αβ closest to the motion's tip angle at t, rad; the motion's tip angle itself where |αβ| is below the noise.
    fn continued(&self, t: f64, product: Complex<f64>) -> Option<f64> {
        let guide = self.ephemeris.as_ref()?.at(t).sample.tip_angle?;
        if product.norm_squared() < self.noise * self.noise {
            return Some(guide);
        }
        let ahead = product.im.atan2(product.re) - guide;
        Some(guide + (ahead - self.unit * (ahead / self.unit).round()))
    }
}
