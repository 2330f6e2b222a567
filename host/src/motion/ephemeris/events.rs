//! Search for the events of a motion.

use crate::motion::sample::Sample;
use toytop::{
    AttitudeState, EphemerisScalar, Event, Level, Motion, Orientation, ParameterError, Phase, Table,
};

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
        t >= self.from && self.upward.is_none_or(|only| only == upward)
    }
}

/// Event with its time and the motion there.
pub struct MotionEvent {
    /// Time in the motion's unit.
    pub t: f64,
    /// Whether u increases there, or the tip angle. At a turning point: whether u = e₂.
    pub upward: bool,
    /// Upper bound on the error of the time: the bound of u or of the tip angle, divided by its rate. `None` for a turning point, and where
    /// the rate is 0.
    pub time_error: Option<f64>,
    /// Motion at the event.
    pub sample: Sample,
}

impl MotionEvent {
    /// Event at which a condition holds.
    pub fn new(condition: Condition, t: f64, upward: bool, sample: Sample) -> Self {
        let time_error = time_error(condition, &sample).filter(|error| error.is_finite());
        Self { t, upward, time_error, sample }
    }
}

fn time_error(condition: Condition, sample: &Sample) -> Option<f64> {
    let bound = sample.error_bound? + f64::EPSILON;
    match condition {
        Condition::Turning => None,
        Condition::Crossing(_) => Some(bound / sample.rates.udot.abs()),
        Condition::TipAngle(_) => {
            let AttitudeState { orientation: Orientation { alpha, beta }, rate } =
                AttitudeState::from_body(sample.pose.orientation, sample.rates.omega_body);
            let product = alpha * beta;
            let change = rate.alpha * beta + alpha * rate.beta;
            let turning = (product.re * change.im - product.im * change.re) / product.norm_squared();
            Some(bound / (2.0 * product.modulus() * turning.abs()))
        }
    }
}

/// Number of consecutive events of the other direction after which a search ends.
const MAX_UNWANTED: u32 = 10_000;

/// First events of a table at which a condition holds; `sample` computes the sample of an event and its time.
pub fn table_events<R: EphemerisScalar>(
    table: &Table<R>,
    condition: Condition,
    query: &EventQuery,
    sample: impl Fn(&Event, f64) -> Sample,
) -> Vec<MotionEvent> {
    let [ticks_per_time, _] = table.clock().ticks_per_time;
    let from = (query.from * ticks_per_time).floor() as i64;
    let events: Box<dyn Iterator<Item = Event>> = match condition {
        Condition::Turning => Box::new(table.turning_points(from)),
        Condition::Crossing(level) => Box::new(table.crossings(level, from)),
        Condition::TipAngle(angle) => Box::new(table.tip_angles(angle, from)),
    };
    let mut unwanted = 0;
    let mut included = Vec::new();
    for event in events {
        let t = table.time_of(&event);
        if query.includes(t, event.upward) {
            unwanted = 0;
            included.push(MotionEvent::new(condition, t, event.upward, sample(&event, t)));
        } else {
            unwanted += 1;
        }
        if included.len() >= query.count || unwanted == MAX_UNWANTED {
            break;
        }
    }
    included
}
