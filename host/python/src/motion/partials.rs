//! Changes of a `Motion`: partial derivatives by its launch and its top, and impulses.

use crate::arguments::{Given, Numbers, array, number, refused, value_error, vector};
use crate::interrupt;
use crate::motion::PyMotion;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};
use toytop::{Complex, Orientation, State};
use toytop_fit::{Partials, Sensitivity};
use toytop_host::motion::Scalar;
use toytop_host::truth::motions::Start;

/// Number of derivatives.
const COLUMNS: usize = Sensitivity::NAMES.len();
/// Name and shape of a quantity, and its derivatives component by component.
type Quantity = (&'static str, &'static [usize], fn(&Partials) -> Vec<f64>);

const QUANTITIES: [Quantity; 6] = [
    ("orientation", &[3], |partials| by_component(partials.d_orientation())),
    ("omega", &[3], |partials| by_component(partials.d_omega())),
    ("omega_body", &[3], |partials| by_component(partials.d_omega_body())),
    ("axis", &[3], |partials| by_component(partials.d_axis())),
    ("tip", &[2], |partials| by_component(partials.d_tip().map(|tip| [tip.re, tip.im]))),
    ("tip_angle", &[], |partials| partials.d_tip_angle().unwrap_or([f64::NAN; COLUMNS]).to_vec()),
];

fn by_component<const N: usize>(columns: [[f64; N]; COLUMNS]) -> Vec<f64> {
    (0..N).flat_map(|component| columns.map(|column| column[component])).collect()
}

#[pymethods]
impl PyMotion {
    /// Names of the derivatives in the last axis of the arrays of partials.
    #[classattr]
    fn partial_names(py: Python<'_>) -> PyResult<Bound<'_, PyTuple>> {
        PyTuple::new(py, Sensitivity::NAMES)
    }

    /// Partial derivatives at time t, s, as arrays by name: the shape of t comes first, then the components, then the ten derivatives
    /// that partial_names lists.
    ///
    /// They are with respect to the rotation vector (rad, fixed frame) that turns the orientation of the launch, to omega of the launch
    /// (rad/s, fixed frame), and to the numbers A/C, A/(p s) (A/p for a fixed tip), s and g of the top, while the launch and the other
    /// three are kept. Relative to the largest derivative of a column the error is about 1e-12.
    ///
    /// Returns:
    ///     orientation (rotation vectors in the fixed frame, rad), omega, omega_body, axis, tip and tip_angle.
    ///
    /// Raises:
    ///     ValueError: t is not finite or too far.
    fn partials<'py>(&self, py: Python<'py>, t: Given) -> PyResult<Bound<'py, PyDict>> {
        let Given { numbers, shape } = t;
        let rows = |now: &Partials| QUANTITIES.map(|(_, _, derivatives)| derivatives(now));
        let found = self.partials_at(py, &numbers, rows)?;
        let found = found.ok_or_else(|| value_error("t", "must not be so far"))?;
        let partials = PyDict::new(py);
        for (place, (name, components, _)) in QUANTITIES.into_iter().enumerate() {
            let shape = [&shape, components, &[COLUMNS]].concat();
            let numbers = found.iter().flat_map(|rows| &rows[place]).copied().collect();
            partials.set_item(name, array(py, numbers, &shape)?)?;
        }
        Ok(partials)
    }

    /// Motion after an impulse at time t, whose own time begins then.
    ///
    /// Args:
    ///     impulse: N s, in the fixed frame.
    ///     point: where it acts, m, in the body frame from the tip (from the centre of mass of a free body).
    ///     t: time of the impulse, s.
    ///
    /// Raises:
    ///     ValueError: a number is out of range; the message names it.
    #[pyo3(signature = (impulse, point, *, t=None))]
    fn with_impulse(
        &self,
        impulse: &Bound<'_, PyAny>,
        point: &Bound<'_, PyAny>,
        t: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Self> {
        let (state, impulse, point) = (self.state(t)?, vector("impulse", impulse)?, vector("point", point)?);
        let struck = state.with_impulse(&self.top.top, impulse, point).map_err(refused)?;
        Self::from_state(&self.top, &struck, "impulse")
    }

    /// Impulse of the support's reaction to an impulse, N s in the fixed frame. Where its third component is negative, a real sliding top
    /// leaves the plane and does not follow the motion of with_impulse.
    ///
    /// Args:
    ///     impulse, point, t: as those of with_impulse.
    ///
    /// Raises:
    ///     ValueError: a number is out of range; the message names it.
    #[pyo3(signature = (impulse, point, *, t=None))]
    fn reaction_impulse<'py>(
        &self,
        py: Python<'py>,
        impulse: &Bound<'_, PyAny>,
        point: &Bound<'_, PyAny>,
        t: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Bound<'py, Numbers>> {
        let (state, impulse, point) = (self.state(t)?, vector("impulse", impulse)?, vector("point", point)?);
        let reaction = state.reaction_impulse(&self.top.top, impulse, point).map_err(refused)?;
        array(py, reaction.to_vec(), &[3])
    }
}

impl PyMotion {
    /// Values of a function of the partial derivatives at these times; `None` where one of them is too far.
    pub(crate) fn partials_at<T: Send>(
        &self,
        py: Python<'_>,
        times: &[f64],
        of: impl Fn(&Partials) -> T + Sync + Send,
    ) -> PyResult<Option<Vec<T>>> {
        let sensitivity = py.detach(|| Sensitivity::new(&self.motion));
        let found = interrupt::map(py, times.len(), |index| Some(of(&sensitivity.at(times[index])?)))?;
        Ok(found.into_iter().collect())
    }

    /// State at a time; that of the launch without a rounding.
    fn state(&self, t: Option<&Bound<'_, PyAny>>) -> PyResult<State> {
        let t = number("t", t)?.unwrap_or(0.0);
        let (phi, omega) = match self.start {
            Start::State { phi: [[a, b], [c, d]], omega } if t == 0.0 => {
                (Orientation { alpha: Complex::new(a, b), beta: Complex::new(c, d) }, omega)
            }
            _ => {
                let now = self.table_for(Scalar::F64, &[t])?.at(t).sample;
                (now.orientation(), now.omega)
            }
        };
        State::new(phi, omega).map_err(refused)
    }
}
