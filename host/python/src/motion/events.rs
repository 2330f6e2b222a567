//! Events of a motion: times at which it turns, reaches a tilt, a tip angle or a circle, or lifts off.

use crate::arguments::{Array, array, renamed, require_within, value_error};
use crate::interrupt;
use crate::motion::MotionCore;
use pyo3::prelude::*;
use std::f64::consts::TAU;
use toytop::{Phase, Support, Top};
use toytop_host::motion::{
    Scalar,
    evaluator::{EventKind, EventQuery, MotionEvent},
    sample::MotionSample,
};

/// Kind of an event by its name, with `-` or `_` between words.
///
/// # Errors
/// `ValueError`: another name, a value that is missing or too many, or a top without events of this kind.
fn kind(name: &str, value: Option<f64>, top: &Top) -> PyResult<EventKind> {
    match (&*name.replace('-', "_"), value) {
        ("turning" | "lift_off", Some(_)) => {
            Err(value_error("value", format!("must be left out for \"{name}\"")))
        }
        ("tilt" | "tip_angle" | "circle", None) => {
            Err(value_error("value", format!("must be given for \"{name}\"")))
        }
        ("turning", None) => Ok(EventKind::Turning),
        ("lift_off", None) if top.support() == Support::Sliding => Ok(EventKind::LiftOff),
        ("lift_off", None) => {
            Err(value_error("kind", "must not be 'lift_off': the tip does not slide on a plane"))
        }
        ("tilt", Some(tilt)) => Ok(EventKind::Tilt(tilt)),
        ("tip_angle", Some(angle)) if angle.abs() > 1e6 => {
            Err(value_error("value", "must be within ±1e6 rad"))
        }
        ("tip_angle", Some(angle)) => Ok(EventKind::TipAngle(Phase::from_turns(angle / TAU))),
        ("circle", Some(radius)) => Ok(EventKind::Circle(radius)),
        _ => {
            let allowed = "must be one of 'turning', 'tilt', 'tip_angle', 'circle', 'lift_off'";
            Err(value_error("kind", allowed))
        }
    }
}

#[pymethods]
impl MotionCore {
    /// Events from `start` on, in the order of time. A row has the time and its error, 1 where it is upward, u, the tip and its angle.
    fn events<'py>(
        &self,
        py: Python<'py>,
        kind: &str,
        value: Option<f64>,
        start: f64,
        count: usize,
        upward: Option<bool>,
    ) -> PyResult<Bound<'py, Array>> {
        let kind = self::kind(kind, value, &self.top.top)?;
        let table = py.detach(|| self.table(Scalar::F64))?;
        require_within(table.furthest_time(), &[start])
            .map_err(|_| value_error("start", "must be within 2^62 ticks"))?;
        let query = EventQuery { kind, from: start, upward, count };
        let events = interrupt::interruptible(py, move || table.events(&query))?;
        let events = events.map_err(|error| renamed(error, &[("tilt", "value"), ("radius", "value")]))?;
        let row = |event: &MotionEvent| {
            let error = event.time_error.unwrap_or(f64::NAN);
            let MotionSample { t, u, tip, tip_angle, .. } = event.sample;
            let (up, angle) = (f64::from(event.upward), tip_angle.unwrap_or(f64::NAN));
            [t, error, up, u, tip.re, tip.im, angle]
        };
        array(py, events.iter().flat_map(row).collect(), &[events.len(), 7])
    }
}
