//! Events of a `Motion`: times at which it turns, or reaches a tilt, a direction or a circle, or lifts off.

use crate::arguments::{number, renamed, value_error};
use crate::interrupt;
use crate::motion::PyMotion;
use numpy::IntoPyArray;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use toytop::{Level, Phase, Support};
use toytop_host::motion::Scalar;
use toytop_host::motion::ephemeris::{EventQuery, FoundEvent};

/// Greatest number of events of a call.
const MOST: i64 = 1_000_000;

#[pymethods]
impl PyMotion {
    /// Events of the motion, in the order of time, as arrays by name.
    ///
    /// Args:
    ///     kind: "turning": the tilt has an extreme value. "tilt": it has the given value, rad. "direction": the tip angle has the given
    ///         value, rad, whole turns aside. "circle": the tip is at the given distance from the centre, m (the sine of the tilt for a
    ///         fixed tip). "lift_off": the normal force is 0.
    ///     value: of the kinds tilt, direction and circle.
    ///     start: time of the earliest event, s.
    ///     count: greatest number of events, at most a million.
    ///     sense: "up" or "down": only events at which u, the cosine of the tilt, increases or decreases, or the tip angle does; of turning
    ///         points, only those with the least or with the greatest tilt.
    ///
    /// Returns:
    ///     t (s), t_error (upper bound, s; NaN where none is known), up (bool), u, tip_x, tip_y, phi (tip angle).
    ///
    /// Raises:
    ///     ValueError: an argument is out of range; the message names it.
    #[pyo3(signature = (kind, value=None, *, start=None, count=100, sense=None))]
    fn events<'py>(
        &self,
        py: Python<'py>,
        kind: &str,
        value: Option<&Bound<'py, PyAny>>,
        start: Option<&Bound<'py, PyAny>>,
        count: i64,
        sense: Option<&str>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let searches = self.sought(kind, number("value", value)?)?;
        let start = number("start", start)?.unwrap_or(0.0);
        let upward = match sense {
            None => None,
            Some("up") => Some(true),
            Some("down") => Some(false),
            Some(_) => return Err(value_error("sense", "must be 'up' or 'down'")),
        };
        if !(1..=MOST).contains(&count) {
            return Err(value_error("count", format!("must be between 1 and {MOST}")));
        }
        let table = py.detach(|| self.table(Scalar::F64))?;
        self.within_reach(&[start]).map_err(|_| value_error("start", "must be within 2^62 ticks"))?;
        let (from, most) = ((start * table.ticks_per_time()).floor() as i64, count as usize);
        let wanted = move |t: f64, up: bool| t >= start && upward.is_none_or(|only: bool| only == up);
        let mut found = interrupt::alone(py, move || {
            let events = |sought: EventQuery| {
                let events = table.events(sought, from, &wanted, most).into_iter();
                events.map(move |event| (event.time_error(&sought).unwrap_or(f64::NAN), event))
            };
            searches.into_iter().flat_map(events).collect::<Vec<_>>()
        })?;
        found.sort_by(|(_, a), (_, b)| a.t.total_cmp(&b.t));
        found.truncate(most);
        let events = PyDict::new(py);
        let set = |name: &str, of: fn(&(f64, FoundEvent)) -> f64| {
            events.set_item(name, found.iter().map(of).collect::<Vec<_>>().into_pyarray(py))
        };
        set("t", |(_, event)| event.t)?;
        set("t_error", |(error, _)| *error)?;
        let up: Vec<bool> = found.iter().map(|(_, event)| event.upward).collect();
        events.set_item("up", up.into_pyarray(py))?;
        set("u", |(_, event)| event.state.sample.u)?;
        set("tip_x", |(_, event)| event.state.sample.tip.re)?;
        set("tip_y", |(_, event)| event.state.sample.tip.im)?;
        set("phi", |(_, event)| event.state.sample.tip_angle.unwrap_or(f64::NAN))?;
        Ok(events)
    }
}

impl PyMotion {
    /// Searches for the events of a kind: two where two levels of u belong to a circle, none where a top does not leave the plane.
    fn sought(&self, kind: &str, value: Option<f64>) -> PyResult<Vec<EventQuery>> {
        let top = self.motion.top();
        let named = |error| renamed(error, &[("tilt", "value"), ("radius", "value")]);
        let levels = |levels: &[Level]| levels.iter().copied().map(EventQuery::Crossing).collect();
        let (name, reason) = match (kind, value) {
            ("turning", None) => return Ok(vec![EventQuery::Turning]),
            ("tilt", Some(tilt)) => return Ok(levels(&[Level::of_tilt(tilt).map_err(named)?])),
            ("direction", Some(angle)) if angle.abs() <= 1e6 => {
                return Ok(vec![EventQuery::TipAngle(Phase::new(angle / std::f64::consts::TAU))]);
            }
            ("circle", Some(radius)) => return Ok(levels(&Level::of_circle(top, radius).map_err(named)?)),
            ("lift_off", None) if top.support() == Support::Sliding => {
                return Ok(levels(Level::of_lift_off(&self.motion).as_slice()));
            }
            ("direction", Some(_)) => ("value", "must be within ±1e6 rad".to_owned()),
            ("turning" | "lift_off", Some(_)) => ("value", format!("must be left out for {kind:?}")),
            ("tilt" | "direction" | "circle", None) => ("value", format!("must be given for {kind:?}")),
            ("lift_off", None) => {
                ("kind", "must not be 'lift_off': the tip does not slide on a plane".to_owned())
            }
            _ => {
                let kinds = "'turning', 'tilt', 'direction', 'circle', 'lift_off'";
                ("kind", format!("must be one of {kinds}"))
            }
        };
        Err(value_error(name, reason))
    }
}
