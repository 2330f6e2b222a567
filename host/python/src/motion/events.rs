//! Events of a motion: times at which it turns, or reaches a tilt, a direction or a circle, or lifts off.

use crate::arguments::{Array, array, renamed, value_error, within};
use crate::interrupt;
use crate::motion::MotionCore;
use pyo3::prelude::*;
use std::f64::consts::TAU;
use toytop::Phase;
use toytop_host::motion::Scalar;
use toytop_host::motion::ephemeris::{EventFilter, EventKind, FoundEvent, search};
use toytop_host::motion::sample::Sample;

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
        let kind = match kind {
            "turning" => EventKind::Turning,
            "tilt" => EventKind::Tilt(value),
            "direction" => EventKind::TipAngle(Phase::new(value / TAU)),
            "circle" => EventKind::Circle(value),
            _ => EventKind::LiftOff,
        };
        let (motion, table) = (self.motion, py.detach(|| self.table(Scalar::F64))?);
        within(table.furthest_time(), &[start])
            .map_err(|_| value_error("start", "must be within 2^62 ticks"))?;
        let filter = EventFilter { from: start, upward, count: most };
        let found = interrupt::interruptible(py, move || search(&*table, &motion, kind, &filter))?;
        let found = found.map_err(|error| renamed(error, &[("tilt", "value"), ("radius", "value")]))?;
        let row = |event: &FoundEvent| {
            let error = event.time_error.unwrap_or(f64::NAN);
            let Sample { pose, tip_angle, .. } = event.sample;
            let (up, angle) = (f64::from(event.upward), tip_angle.unwrap_or(f64::NAN));
            [event.t, error, up, pose.u, pose.tip.re, pose.tip.im, angle]
        };
        array(py, found.iter().flat_map(row).collect(), &[found.len(), 7])
    }
}
