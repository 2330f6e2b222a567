//! Events of a motion: kinds, conditions and times.

use crate::motion::sample::MotionSample;
use toytop::{AttitudeState, Level, Motion, Orientation, ParameterError, Phase};

/// Kind of an event.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum EventKind {
    /// Turning point of u.
    Turning,
    /// Tilt, rad.
    Tilt(f64),
    /// Tip angle modulo whole turns.
    TipAngle(Phase),
    /// Distance of the tip from the centre, m.
    Circle(f64),
    /// Normal force 0.
    LiftOff,
}

impl EventKind {
    /// Conditions for an event of this kind. A circle has two levels of u. A top that stays on the plane has no lift-off.
    pub fn conditions(self, motion: &Motion) -> Result<Vec<Condition>, ParameterError> {
        let levels = match self {
            Self::Turning => return Ok(vec![Condition::Turning]),
            Self::TipAngle(angle) => return Ok(vec![Condition::TipAngle(angle)]),
            Self::Tilt(tilt) => vec![Level::from_tilt(tilt)?],
            Self::Circle(radius) => Level::from_circle(motion.top(), radius)?.to_vec(),
            Self::LiftOff => Level::lift_off(motion).into_iter().collect(),
        };
        Ok(levels.into_iter().map(Condition::Crossing).collect())
    }
}

/// Condition for an event.
#[derive(Clone, Copy, PartialEq)]
pub enum Condition {
    /// u is at a turning point.
    Turning,
    /// u is at a level.
    Crossing(Level),
    /// The tip angle has this value, modulo whole turns.
    TipAngle(Phase),
}

/// Events to find.
#[derive(Clone, Copy)]
pub struct EventQuery {
    /// Kind.
    pub kind: EventKind,
    /// Time of the earliest event.
    pub from: f64,
    /// Whether only upward (`true`) or only downward (`false`) events count; `None` for both.
    pub upward: Option<bool>,
    /// Greatest number of events.
    pub count: usize,
}

impl EventQuery {
    /// Whether an event counts.
    pub fn includes(&self, t: f64, upward: bool) -> bool {
        t >= self.from && self.upward.is_none_or(|wanted| wanted == upward)
    }
}

/// Event with the motion there.
pub struct MotionEvent {
    /// Whether u increases there, or the tip angle. At a turning point: whether u = e₂.
    pub upward: bool,
    /// Upper bound on the error of the time: the bound of u or of the tip angle, divided by its rate. `None` for a turning point, and where
    /// the rate is 0.
    pub time_error: Option<f64>,
    /// Motion at the event, whose time is that of the event.
    pub sample: MotionSample,
}

impl MotionEvent {
    /// Event at which a condition holds.
    pub fn new(condition: Condition, upward: bool, sample: MotionSample) -> Self {
        let time_error = time_error(condition, &sample).filter(|error| error.is_finite());
        Self { upward, time_error, sample }
    }
}

fn time_error(condition: Condition, sample: &MotionSample) -> Option<f64> {
    let bound = sample.error_bound? + f64::EPSILON;
    match condition {
        Condition::Turning => None,
        Condition::Crossing(_) => Some(bound / sample.rates.udot.abs()),
        Condition::TipAngle(_) => {
            let AttitudeState { orientation: Orientation { alpha, beta }, rate } =
                AttitudeState::from_body(sample.orientation, sample.rates.omega_body);
            let product = alpha * beta;
            let change = rate.alpha * beta + alpha * rate.beta;
            let turning = (product.re * change.im - product.im * change.re) / product.norm_squared();
            Some(bound / (2.0 * product.modulus() * turning.abs()))
        }
    }
}
