//! Class `Motion`, which computes a motion at any time.

use crate::arrays::Given;
use crate::closed_form::PyClosedForm;
use crate::definition::{self, TopDefinition};
use crate::error::{failed, value_error};
use crate::page::{self, Page};
use crate::reference;
use crate::samples::{Samples, Source};
use crate::top::PyTop;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::path::PathBuf;
use std::sync::{Arc, OnceLock};
use std::{fs, io};
use toytop::Motion;
use toytop_host::motion::Scalar;
use toytop_host::motion::ephemeris::{AnyScalar, furthest_time, smallest};
use toytop_host::truth::exact::Exact;
use toytop_host::truth::motions::Start;

/// Exact motion of one throw, at any time, past or future.
///
/// It is made by a Top, or by Motion.from_toml from a scenario file, and is immutable: threads may share it. Its constants are
/// attributes. The first call of at sets up a table, from which every time costs the same and has an error within a stated bound.
#[pyclass(name = "Motion", module = "toytop", frozen)]
pub(crate) struct PyMotion(pub(crate) Arc<Single>);

/// Motion with its input, and its tables.
pub(crate) struct Single {
    pub(crate) top: TopDefinition,
    pub(crate) start: Start,
    pub(crate) motion: Motion,
    tables: [OnceLock<Result<Table, String>>; Scalar::ALL.len()],
    truth: OnceLock<Arc<Exact>>,
}

/// Ephemeris of one scalar.
pub(crate) type Table = Arc<dyn AnyScalar>;

/// Scalar of this name.
///
/// # Errors
/// `ValueError`: there is none.
pub(crate) fn scalar_named(name: &str) -> PyResult<Scalar> {
    let found = Scalar::ALL.into_iter().find(|scalar| scalar.name() == name);
    found.ok_or_else(|| value_error("scalar", "must be one of 'f64', 'f32', 'q31', 'q15'"))
}

/// Method `at` of an object, for a scalar.
pub(crate) fn at<'py>(object: &Bound<'py, PyAny>, scalar: &str) -> PyResult<Bound<'py, PyAny>> {
    let at = object.getattr("at")?;
    if scalar == "f64" {
        return Ok(at);
    }
    let options = PyDict::new(object.py());
    options.set_item("scalar", scalar)?;
    object.py().import("functools")?.getattr("partial")?.call((at,), Some(&options))
}

/// Greatest distance of the times from t = 0.
pub(crate) fn furthest(times: &Given) -> f64 {
    times.numbers.iter().fold(0.0, |furthest, t| f64::max(furthest, t.abs()))
}

impl Single {
    pub(crate) fn new(top: TopDefinition, start: Start, motion: Motion) -> Self {
        Self { top, start, motion, tables: Default::default(), truth: OnceLock::new() }
    }

    /// Table in a scalar, set up at its first use.
    pub(crate) fn table(&self, scalar: Scalar) -> PyResult<Table> {
        let set_up =
            || smallest(scalar, &self.motion).map(Table::from).map_err(|failure| failure.to_string());
        let table = self.tables[scalar as usize].get_or_init(set_up).clone();
        table.map_err(|reason| value_error("scalar", &reason))
    }

    /// Motion in numbers of 192 bits.
    pub(crate) fn truth(&self) -> Arc<Exact> {
        self.truth.get_or_init(|| Arc::new(definition::truth(&self.top, self.start))).clone()
    }

    fn text(&self) -> String {
        definition::to_toml(&self.top, &self.start)
    }

    /// # Errors
    /// `ValueError`: a time at this distance from t = 0 is beyond the ticks of a table.
    pub(crate) fn within_reach(&self, furthest: f64) -> PyResult<()> {
        let reach = furthest_time(&self.motion);
        if furthest <= reach {
            return Ok(());
        }
        Err(value_error("t", &format!("{furthest:e} must be within ±{reach:.1e}")))
    }
}

impl PyMotion {
    pub(crate) fn new(top: TopDefinition, start: Start, motion: Motion) -> Self {
        Self(Arc::new(Single::new(top, start, motion)))
    }

    /// Motion of a scenario file's text.
    pub(crate) fn parsed(file: &str, text: &str) -> PyResult<Self> {
        let (top, start, motion) = definition::of_toml(file, text)?;
        Ok(Self::new(top, start, motion))
    }

    /// Table in a scalar, and a time as its number of ticks.
    fn table_and_ticks(&self, t: Option<&Bound<'_, PyAny>>, scalar: &str) -> PyResult<(Table, f64)> {
        let t = t.map_or(Ok(0.0), |t| Given::number("t", t))?;
        let table = self.0.table(scalar_named(scalar)?)?;
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
        let file = path.display().to_string();
        let named = |error: io::Error| io::Error::new(error.kind(), format!("{file}: {error}"));
        Self::parsed(&file, &fs::read_to_string(&path).map_err(named)?)
    }

    /// Motion of the text of a scenario file.
    ///
    /// Raises:
    ///     ValueError: a key is wrong; the message names it and what is allowed.
    #[staticmethod]
    fn from_toml_text(text: &str) -> PyResult<Self> {
        Self::parsed("text", text)
    }

    /// Text of a scenario file with this motion, exact to the last bit.
    fn to_toml(&self) -> String {
        self.0.text()
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
    fn at(slf: &Bound<'_, Self>, t: &Bound<'_, PyAny>, scalar: &str) -> PyResult<Samples> {
        let (times, number) = (Given::read("t", t)?, scalar_named(scalar)?);
        let motion = &slf.get().0;
        let table = slf.py().detach(|| motion.table(number))?;
        motion.within_reach(furthest(&times))?;
        Ok(Samples::new(times, None, Source::Tables(vec![table]), at(slf, scalar)?))
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

    /// Closed form of the motion, in elementary or elliptic functions.
    ///
    /// Raises:
    ///     ValueError: the motion has none; the message says which motions do.
    fn closed_form(slf: &Bound<'_, Self>) -> PyResult<PyClosedForm> {
        PyClosedForm::of(slf)
    }

    /// Truth at time t, s, rounded to float64: the paper's integrals in numbers of 192 bits, which share no formula and no
    /// arithmetic with Motion.at. It takes about a millisecond a time.
    ///
    /// Raises:
    ///     ValueError: t is not finite or beyond 2^62 ticks.
    fn reference(slf: &Bound<'_, Self>, t: &Bound<'_, PyAny>) -> PyResult<Samples> {
        reference::samples(slf, Given::read("t", t)?)
    }

    /// Truth at time t, s, to as many digits as wanted: an array of decimal.Decimal with the quaternion w, x, y, z in its last
    /// axis.
    ///
    /// Args:
    ///     digits: significant digits, from 1 to 50; the truth itself has more than thirty.
    #[pyo3(signature = (t, *, digits=30))]
    fn reference_digits<'py>(
        &self,
        py: Python<'py>,
        t: &Bound<'_, PyAny>,
        digits: i64,
    ) -> PyResult<Bound<'py, PyAny>> {
        reference::digits(py, &self.0, Given::read("t", t)?, digits)
    }

    /// Page with the top in motion, for a notebook or a browser: it computes in the page itself and needs no network.
    fn view(&self) -> PyResult<Page> {
        page::live(&self.0.text()).map_err(|failure| failed(&failure))
    }

    /// Top of the motion.
    #[getter]
    fn top(&self) -> PyTop {
        PyTop(self.0.top)
    }

    fn __repr__(&self) -> String {
        let e = self.0.motion.branch_points();
        let regime = self.regime();
        let support = definition::support_name(self.0.motion.top().support());
        format!("<Motion of a {support} top: {regime}, e1 = {:?}, e2 = {:?}, e3 = {:?}>", e.e1, e.e2, e.e3)
    }

    /// Picture of the curve that the tip draws, for a notebook.
    fn _repr_html_(&self, py: Python<'_>) -> PyResult<String> {
        py.detach(|| page::tip_curve(&self.0.motion)).map_err(|failure| failed(&failure))
    }

    fn __eq__(&self, other: &Self) -> bool {
        self.0.top == other.0.top && self.0.start == other.0.start
    }

    fn __hash__(&self) -> u64 {
        let integrals = self.0.motion.first_integrals();
        [integrals.l, integrals.n, integrals.h].iter().fold(0, |hash, x| hash.rotate_left(9) ^ x.to_bits())
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, (String,))> {
        Ok((py.get_type::<Self>().getattr("from_toml_text")?, (self.0.text(),)))
    }
}
