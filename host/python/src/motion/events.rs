//! Events of a motion: times at which it turns, or reaches a tilt, a direction or a circle, or lifts off.

use crate::arguments::{Array, array, renamed, value_error};
use crate::interrupt;
use crate::motion::MotionCore;
use pyo3::prelude::*;
use std::f64::consts::TAU;
use toytop::{Level, Phase};
use toytop_host::motion::Scalar;
use toytop_host::motion::ephemeris::{EventQuery, FoundEvent};

#[pymethods]
impl MotionCore {
    /// Events from `start` on, in the order of time. A row has the time and its error, 1 where it is upward, u, the tip and its angle.
    fn events<'py>(
        &self,
        py: Python<'py>,
        kind: &str,
        value: f64,
        start: f64,
        most: usize,
        upward: Option<bool>,
    ) -> PyResult<Bound<'py, Array>> {
        let searches = self.sought(kind, value)?;
        let table = py.detach(|| self.table(Scalar::F64))?;
        self.within_reach(&[start]).map_err(|_| value_error("start", "must be within 2^62 ticks"))?;
        let from = (start * table.ticks_per_time()).floor() as i64;
        let wanted = move |t: f64, up: bool| t >= start && upward.is_none_or(|only: bool| only == up);
        let mut found = interrupt::interruptible(py, move || {
            let events = |sought: EventQuery| {
                let events = table.events(sought, from, &wanted, most).into_iter();
                events.map(move |event| (event.time_error(&sought).unwrap_or(f64::NAN), event))
            };
            searches.into_iter().flat_map(events).collect::<Vec<_>>()
        })?;
        found.sort_by(|(_, a), (_, b)| a.t.total_cmp(&b.t));
        found.truncate(most);
        let row = |(error, event): &(f64, FoundEvent)| {
            let sample = &event.state.sample;
            let (up, angle) = (f64::from(event.upward), sample.tip_angle.unwrap_or(f64::NAN));
            [event.t, *error, up, sample.u, sample.tip.re, sample.tip.im, angle]
        };
        array(py, found.iter().flat_map(row).collect(), &[found.len(), 7])
    }
}

impl MotionCore {
    /// Searches for the events of a kind. A circle has two where two levels of u belong to it; a top that does not leave the plane has none.
    fn sought(&self, kind: &str, value: f64) -> PyResult<Vec<EventQuery>> {
        let named = |error| renamed(error, &[("tilt", "value"), ("radius", "value")]);
        let levels = |levels: &[Level]| levels.iter().copied().map(EventQuery::Crossing).collect();
        Ok(match kind {
            "turning" => vec![EventQuery::Turning],
            "tilt" => levels(&[Level::of_tilt(value).map_err(named)?]),
            "tip_angle" => vec![EventQuery::TipAngle(Phase::new(value / TAU))],
            "circle" => levels(&Level::of_circle(self.motion.top(), value).map_err(named)?),
            _ => levels(Level::of_lift_off(&self.motion).as_slice()),
        })
    }
}
