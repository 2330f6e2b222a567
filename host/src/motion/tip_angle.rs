//! Tip angle for methods without one: arg(αβ), with whole turns from the table.

use crate::motion::Scalar;
use crate::motion::evaluator::MotionEvaluator;
use crate::motion::sample::MotionSample;
use std::f64::consts::PI;
use toytop::{Complex, Orientation, TipClass};
use toytop_model::equations::Rates;
use toytop_model::motion_with_period::MotionWithPeriod;

/// Least |αβ| from which the tip angle is computed: an error of 1e-14 in α and β changes its argument by 1e-5 rad.
const MIN_PRODUCT: f64 = 1e-9;

/// Tip angle of a motion at any time, to a few roundings of `f64`.
pub struct TipAngle {
    /// Evaluator of the motion; `None` where the axis is vertical at all times, or no table is large enough.
    evaluator: Option<MotionEvaluator>,
    motion: MotionWithPeriod,
}

impl TipAngle {
    /// Tip angle of a motion. Samples have none where there is no evaluator.
    pub fn new(motion: &MotionWithPeriod) -> Self {
        let evaluator =
            MotionEvaluator::new(motion, Scalar::F64).ok().filter(|_| !motion.regime().is_vertical());
        Self { evaluator, motion: *motion }
    }

    /// Sample at a time, from the orientation and the rates there.
    pub fn sample(&self, t: f64, orientation: Orientation<f64>, rates: Rates) -> MotionSample {
        let tip = orientation.tip_over_s().scaled(self.motion.top().tip_scale());
        let u = orientation.u().clamp(-1.0, 1.0);
        let tip_angle = self.continued(t, orientation.alpha * orientation.beta);
        MotionSample { t, orientation, u, tip, rates, tip_angle, error_bound: None }
    }

    /// Argument of αβ, rad, in the turn of the evaluator's tip angle at t. Where |αβ| is too small, it is the evaluator's angle itself.
    fn continued(&self, t: f64, product: Complex<f64>) -> Option<f64> {
        let guide = self.evaluator.as_ref()?.at(t).tip_angle?;
        if product.modulus() < MIN_PRODUCT {
            return Some(guide);
        }
        // αβ of a curve through the centre changes its sign there
        let through_centre = matches!(self.motion.tip_class(), TipClass::ThroughOrigin | TipClass::Spiral);
        let period = if through_centre { PI } else { 2.0 * PI };
        let ahead = product.im.atan2(product.re) - guide;
        Some(guide + (ahead - period * (ahead / period).round()))
    }
}
