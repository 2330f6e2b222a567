//! Events of an ephemeris of any scalar and capacity.

use super::TimedSample;
use toytop::{EphemerisScalar, EphemerisView, Event, Level, Phase};

/// Event that is searched for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sought {
    /// Turning points of u.
    Turning,
    /// Crossings of a level.
    Crossing(Level),
    /// Times at which the tip angle has this value, modulo whole turns.
    TipAngle(Phase),
}

/// Event with its time and the motion there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FoundEvent {
    /// Time in the motion's unit.
    pub t: f64,
    /// Whether u rises there, or the tip angle; at a turning point, whether u = e₂.
    pub upward: bool,
    /// Motion at the event.
    pub there: TimedSample,
}

/// Events at tick `from` or later, at times that `wanted` accepts.
pub(super) fn found<R: EphemerisScalar>(
    view: &EphemerisView<R>,
    sought: Sought,
    from: i64,
    wanted: &dyn Fn(f64, bool) -> bool,
    most: usize,
    there: impl Fn(&Event, f64) -> TimedSample,
) -> Vec<FoundEvent> {
    let events: Box<dyn Iterator<Item = Event>> = match sought {
        Sought::Turning => Box::new(view.turning_points(from)),
        Sought::Crossing(level) => Box::new(view.crossings(level, from)),
        Sought::TipAngle(angle) => Box::new(view.tip_angles(angle, from)),
    };
    let timed = events.map(|event| (view.time_of(&event), event));
    let timed = timed.filter(|(t, event)| wanted(*t, event.upward)).take(most);
    timed.map(|(t, event)| FoundEvent { t, upward: event.upward, there: there(&event, t) }).collect()
}
