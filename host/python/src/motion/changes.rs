//! A motion changes with its launch, its top and impulses: partial derivatives, and struck motions.

use crate::arguments::{Array, NumericArg, array, failed, value_error};
use crate::interrupt;
use crate::motion::MotionCore;
use pyo3::prelude::*;
use toytop::{PointImpulse, State};
use toytop_fit::{Partials, Sensitivity};
use toytop_host::input::scenario::Launch;
use toytop_host::motion::Scalar;

/// Number of derivatives.
const DERIVATIVES: usize = Sensitivity::NAMES.len();

fn by_component<const N: usize>(columns: [[f64; N]; DERIVATIVES]) -> impl Iterator<Item = f64> {
    (0..N).flat_map(move |component| columns.map(|column| column[component]))
}

/// Derivatives of orientation, ω, Ω, axis, tip and tip angle, component by component.
fn row(partials: &Partials) -> Vec<f64> {
    let vectors = [partials.d_orientation(), partials.d_omega(), partials.d_omega_body(), partials.d_axis()];
    let tip = by_component(partials.d_tip().map(|tip| [tip.re, tip.im]));
    let angle = partials.d_tip_angle().unwrap_or([f64::NAN; DERIVATIVES]);
    vectors.into_iter().flat_map(by_component).chain(tip).chain(angle).collect()
}

#[pymethods]
impl MotionCore {
    /// Derivatives at these times. The last axis but one has the fifteen components of [`row`].
    fn partials<'py>(&self, py: Python<'py>, t: NumericArg) -> PyResult<Bound<'py, Array>> {
        let rows = self.partials_at(py, &t.numbers, row)?;
        let rows = rows.ok_or_else(|| value_error("t", "must not be so far"))?;
        array(py, rows.concat(), &[&t.shape[..], &[15, DERIVATIVES]].concat())
    }

    /// Motion after an impulse at time t.
    fn with_impulse(&self, impulse: [f64; 3], point: [f64; 3], t: f64) -> PyResult<Self> {
        let struck =
            self.state(t)?.with_impulse(&self.top.top, &PointImpulse { impulse, point }).map_err(failed)?;
        Self::from_state(&self.top, &struck, "impulse")
    }

    /// Impulse of the support's reaction to an impulse at time t.
    fn reaction_impulse<'py>(
        &self,
        py: Python<'py>,
        impulse: [f64; 3],
        point: [f64; 3],
        t: f64,
    ) -> PyResult<Bound<'py, Array>> {
        let reaction = self
            .state(t)?
            .reaction_impulse(&self.top.top, &PointImpulse { impulse, point })
            .map_err(failed)?;
        array(py, reaction.to_vec(), &[3])
    }
}

impl MotionCore {
    /// Values of a function of the partial derivatives at these times; `None` where one of them is too far.
    pub(crate) fn partials_at<T: Send>(
        &self,
        py: Python<'_>,
        times: &[f64],
        of: impl Fn(&Partials) -> T + Sync + Send,
    ) -> PyResult<Option<Vec<T>>> {
        let sensitivity = py.detach(|| Sensitivity::new(&self.motion));
        let values = interrupt::map(py, times.len(), |index| Some(of(&sensitivity.at(times[index])?)))?;
        Ok(values.into_iter().collect())
    }

    /// State at a time. At t = 0 it is the state of the launch, without rounding.
    fn state(&self, t: f64) -> PyResult<State> {
        let (orientation, omega) = match self.launch {
            Launch::State { orientation, omega } if t == 0.0 => (orientation, omega),
            _ => {
                let now = self.table_for(Scalar::F64, &[t])?.at(t);
                (now.orientation, now.rates.omega)
            }
        };
        State::new(orientation, omega).map_err(failed)
    }
}
