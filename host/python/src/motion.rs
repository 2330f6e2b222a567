//! Class `Motion`, which computes a motion at any time, and its input to full precision.

mod constants;
mod events;
mod other_methods;
mod partials;

pub(crate) use other_methods::PyClosedForm;

use crate::arguments::{Given, failed, number, renamed, value_error, within};
use crate::samples::{Source, Table, samples};
use crate::top::PyTop;
use pyo3::prelude::*;
use std::path::PathBuf;
use std::sync::OnceLock;
use std::{fs, io};
use toytop::{InitialPhases, Motion, State};
use toytop_host::input::scenario::{Given as Numbers, Scenario, ScenarioFile};
use toytop_host::motion::Scalar;
use toytop_host::motion::ephemeris::{furthest_time, smallest_ephemeris};
use toytop_host::pictures::curve::Curve;
use toytop_host::pictures::view;
use toytop_host::truth::exact::Exact;
use toytop_host::truth::motions::Start;

/// Exact motion of one launch, at any time, past or future.
///
/// It is made by a Top, or by Motion.from_toml from a scenario file, and is immutable: threads may share it. Its constants are
/// attributes. The first call of at sets up a table, from which every time costs the same and has an error within a stated bound.
#[pyclass(name = "Motion", module = "toytop", frozen)]
pub(crate) struct PyMotion {
    /// Top of the motion.
    #[pyo3(get)]
    pub(crate) top: PyTop,
    pub(crate) start: Start,
    pub(crate) motion: Motion,
    tables: [OnceLock<Result<Table, String>>; Scalar::ALL.len()],
    /// Motion in numbers of 640 bits.
    pub(crate) truth: OnceLock<Exact>,
}

/// Scalar of this name.
///
/// # Errors
/// `ValueError`: there is none.
pub(crate) fn scalar_named(name: &str) -> PyResult<Scalar> {
    let found = Scalar::ALL.into_iter().find(|scalar| scalar.name() == name);
    found.ok_or_else(|| value_error("scalar", "must be one of 'f64', 'f32', 'q31', 'q15'"))
}

impl PyMotion {
    pub(crate) fn new(top: PyTop, start: Start, motion: Motion) -> Self {
        Self { top, start, motion, tables: Default::default(), truth: OnceLock::new() }
    }

    /// Motion from a state, with this name of the rates in error messages.
    ///
    /// # Errors
    /// `ValueError` that names the parameter.
    pub(crate) fn from_state(top: &PyTop, state: &State, rate: &str) -> PyResult<Self> {
        let motion = Motion::launch(&top.top, state).map_err(|error| renamed(error, &[("omega", rate)]))?;
        Ok(Self::new(*top, Start::from(state), motion))
    }

    /// Motion of a scenario file's text; `file` is its name in messages.
    ///
    /// # Errors
    /// `ValueError` that names the key.
    pub(crate) fn from_text(file: &str, text: &str) -> PyResult<Self> {
        let Scenario { motion, given, .. } = Scenario::parse(file, text).map_err(failed)?;
        let Numbers { top: parameters, start } =
            given.ok_or_else(|| value_error(file, "must have numbers"))?;
        Ok(Self::new(PyTop { parameters, top: *motion.top() }, start, motion))
    }

    /// Table in a scalar, set up at its first use.
    ///
    /// # Errors
    /// `ValueError`: no table in this scalar is large enough.
    pub(crate) fn table(&self, scalar: Scalar) -> PyResult<Table> {
        let set_up = || {
            smallest_ephemeris(scalar, &self.motion).map(Table::from).map_err(|failure| failure.to_string())
        };
        let table = self.tables[scalar as usize].get_or_init(set_up).clone();
        table.map_err(|reason| value_error("scalar", reason))
    }

    /// Table in a scalar whose ticks reach the times.
    ///
    /// # Errors
    /// `ValueError`: as [`Self::table`], or one of the times is beyond the ticks.
    pub(crate) fn table_for(&self, scalar: Scalar, times: &[f64]) -> PyResult<Table> {
        let table = self.table(scalar)?;
        within(62_f64.exp2() / table.ticks_per_time(), times)?;
        Ok(table)
    }

    /// Checks that the ticks of a table would reach the times, without setting one up.
    ///
    /// # Errors
    /// `ValueError`: one of the times is beyond them.
    pub(crate) fn within_reach(&self, times: &[f64]) -> PyResult<()> {
        within(furthest_time(&self.motion), times)
    }

    /// Table in a scalar, and a time as its number of ticks.
    fn table_and_ticks(&self, t: Option<&Bound<'_, PyAny>>, scalar: &str) -> PyResult<(Table, f64)> {
        let t = number("t", t)?.unwrap_or(0.0);
        let table = self.table(scalar_named(scalar)?)?;
        let ticks = t * table.ticks_per_time();
        Ok((table, ticks))
    }
}

#[pymethods]
impl PyMotion {
    /// Motion of a scenario file, whose keys host/scenarios/README.md explains.
    ///
    /// Raises:
    ///     ValueError: a key is wrong; the message names the file, the key and what is allowed.
    ///     OSError: the file cannot be read.
    #[staticmethod]
    fn from_toml(path: PathBuf) -> PyResult<Self> {
        let file = path.display();
        let named = |error: io::Error| io::Error::new(error.kind(), format!("{file}: {error}"));
        Self::from_text(&file.to_string(), &fs::read_to_string(&path).map_err(named)?)
    }

    /// Motion of the text of a scenario file.
    ///
    /// Raises:
    ///     ValueError: a key is wrong; the message names it and what is allowed.
    #[staticmethod]
    fn from_toml_text(text: &str) -> PyResult<Self> {
        Self::from_text("text", text)
    }

    /// Text of a scenario file with this motion, exact to the last bit.
    pub(crate) fn to_toml(&self) -> String {
        let motion = match &self.start {
            Start::State { phi: [alpha, beta], omega } => {
                format!("kind = \"state\"\nalpha = {alpha:?}\nbeta = {beta:?}\nomega = {omega:?}\n")
            }
            Start::BranchPoints { e: [e1, e2, e3], signs, phases } => {
                let (plus, minus) = (signs.l_plus_n.factor(), signs.l_minus_n.factor());
                let InitialPhases { theta, arg_alpha, arg_beta } = phases;
                format!(
                    "kind = \"branch_points\"\ne1 = {e1:?}\ne2 = {e2:?}\ne3 = {e3:?}\nsign_l_plus_n = {plus}\n\
                     sign_l_minus_n = {minus}\nnutation_phase = {theta:?}\narg_alpha = {arg_alpha:?}\narg_beta = {arg_beta:?}\n"
                )
            }
        };
        format!("{}\n[motion]\n{motion}", self.top.to_toml())
    }

    /// Page with the top in motion, for a notebook or a browser: it computes in the page itself and needs no network.
    fn view<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let file = ScenarioFile::parse("A spinning top", &self.to_toml()).map_err(failed)?;
        let html = view::page(&file).map_err(failed)?;
        py.import("toytop._notebook")?.call_method1("Page", (html,))
    }

    /// Picture of the curve that the tip draws, for a notebook.
    fn _repr_html_<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let Curve { points, circles, .. } = py.detach(|| Curve::of(&self.motion)).map_err(failed)?;
        let radii: Vec<_> = circles.iter().map(|circle| circle.radius).collect();
        py.import("toytop._notebook")?.call_method1("tip_curve", (points, radii))
    }

    /// Samples of the motion at time t, s: a number, or an array of any shape.
    ///
    /// Args:
    ///     scalar: number type of the arithmetic, "f64", "f32", "q31" or "q15" (fixed point of 32 and of 16 bits); the arrays are
    ///         float64 in any case, and hold the scalar's numbers without rounding.
    ///
    /// Raises:
    ///     ValueError: t is not finite or beyond 2^62 ticks; no table in this scalar is large enough.
    #[pyo3(signature = (t, *, scalar="f64"))]
    fn at<'py>(slf: &Bound<'py, Self>, t: Given, scalar: &str) -> PyResult<Bound<'py, PyAny>> {
        let (motion, scalar) = (slf.get(), scalar_named(scalar)?);
        let table = slf.py().detach(|| motion.table_for(scalar, &t.numbers))?;
        let origin = slf.clone().into_any().unbind();
        samples(slf.py(), (origin, "at", Some(scalar)), t, None, Source::Tables(vec![table]))
    }

    /// Upper bound on the orientation error at time t, rad: 2 sqrt(|d alpha|^2 + |d beta|^2), which is the angle of the rotation
    /// between both where it is small.
    #[pyo3(signature = (t=None, *, scalar="f64"))]
    fn error_bound(&self, t: Option<&Bound<'_, PyAny>>, scalar: &str) -> PyResult<f64> {
        let (table, ticks) = self.table_and_ticks(t, scalar)?;
        Ok(table.error_bound().after(ticks))
    }

    /// Upper bound on the error of omega, omega_body and udot at time t, rad/s.
    #[pyo3(signature = (t=None, *, scalar="f64"))]
    fn rate_error_bound(&self, t: Option<&Bound<'_, PyAny>>, scalar: &str) -> PyResult<f64> {
        let (table, ticks) = self.table_and_ticks(t, scalar)?;
        Ok(table.rate_error_bound().after(ticks))
    }

    fn __repr__(&self) -> String {
        let (e, regime, support) = (self.motion.branch_points(), self.regime(), self.top.support());
        format!("<Motion of a {support} top: {regime}, e1 = {:?}, e2 = {:?}, e3 = {:?}>", e.e1, e.e2, e.e3)
    }

    fn __eq__(&self, other: &Self) -> bool {
        self.top == other.top && self.start == other.start
    }

    fn __hash__(&self) -> u64 {
        let integrals = self.motion.first_integrals();
        [integrals.l, integrals.n, integrals.h].iter().fold(0, |hash, x| hash.rotate_left(9) ^ x.to_bits())
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, (String,))> {
        Ok((py.get_type::<Self>().getattr("from_toml_text")?, (self.to_toml(),)))
    }
}
