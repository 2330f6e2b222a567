//! Class `Motion`, which computes a motion at any time.

use crate::arrays::Given;
use crate::closed_form::PyClosedForm;
use crate::definition::{self, StartDefinition, TopDefinition};
use crate::error::{failed, value_error};
use crate::page::{self, Page};
use crate::reference;
use crate::samples::{Samples, Source};
use crate::top::PyTop;
use pyo3::prelude::*;
use std::ops::Deref;
use std::path::PathBuf;
use std::sync::{Arc, OnceLock};
use std::{fs, io};
use toytop::Motion;
use toytop_host::motion::Scalar;
use toytop_host::motion::ephemeris::{AnyScalar, smallest, ticks_per_time};
use toytop_host::truth::exact::Exact;

/// Exact motion of one throw, at any time, past or future.
///
/// It is made by a Top, or by Motion.from_toml from a scenario file, and is immutable: threads may share it. Its constants are
/// attributes. The first call of at sets up a table, from which every time costs the same and has an error within a stated bound.
#[pyclass(name = "Motion", module = "toytop", frozen)]
pub(crate) struct PyMotion {
    pub(crate) top: TopDefinition,
    start: StartDefinition,
    pub(crate) motion: Motion,
    tables: [OnceLock<Result<Arc<Table>, String>>; SCALARS.len()],
    truth: OnceLock<Arc<Exact>>,
}

/// Ephemeris of one scalar, with its clock.
pub(crate) struct Table {
    ephemeris: Box<dyn AnyScalar>,
    /// Ticks in a unit of time.
    pub(crate) ticks: f64,
}

impl Deref for Table {
    type Target = dyn AnyScalar;

    fn deref(&self) -> &Self::Target {
        &*self.ephemeris
    }
}

/// Scalars by their names here.
const SCALARS: [(&str, Scalar); 4] =
    [("f64", Scalar::F64), ("f32", Scalar::F32), ("q31", Scalar::Q31), ("q15", Scalar::Q15)];

/// Ticks from t = 0 of the furthest time.
const MOST_TICKS: f64 = (1_u64 << 62) as f64;

impl PyMotion {
    pub(crate) fn new(top: TopDefinition, start: StartDefinition, motion: Motion) -> Self {
        Self { top, start, motion, tables: Default::default(), truth: OnceLock::new() }
    }

    /// Motion of a scenario file's text.
    pub(crate) fn parsed(file: &str, text: &str) -> PyResult<Self> {
        let (top, start, motion) = definition::of_toml(file, text)?;
        Ok(Self::new(top, start, motion))
    }

    /// Table in a scalar, set up at its first use.
    pub(crate) fn table(&self, scalar: &str) -> PyResult<Arc<Table>> {
        let place = SCALARS.iter().position(|(name, _)| *name == scalar);
        let Some(place) = place else {
            return Err(value_error("scalar", "must be one of 'f64', 'f32', 'q31', 'q15'"));
        };
        let (_, scalar) = SCALARS[place];
        let set_up = || {
            let ephemeris = smallest(scalar, &self.motion).map_err(|failure| failure.to_string())?;
            Ok(Arc::new(Table { ephemeris, ticks: ticks_per_time(&self.motion) }))
        };
        self.tables[place].get_or_init(set_up).clone().map_err(|reason| value_error("scalar", &reason))
    }

    /// Motion in numbers of 192 bits.
    pub(crate) fn truth(&self) -> Arc<Exact> {
        self.truth.get_or_init(|| Arc::new(definition::truth(&self.top, &self.start))).clone()
    }

    fn text(&self) -> String {
        definition::to_toml(&self.top, &self.start)
    }

    /// Error for a time that is beyond the ticks of a table.
    pub(crate) fn within_reach(&self, times: &Given, ticks: f64) -> PyResult<()> {
        let reach = MOST_TICKS / ticks;
        match times.numbers.iter().find(|t| t.abs() > reach) {
            None => Ok(()),
            Some(t) => Err(value_error("t", &format!("{t:e} must be within ±{reach:.1e}"))),
        }
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
        self.text()
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
    fn at(&self, py: Python<'_>, t: &Bound<'_, PyAny>, scalar: &str) -> PyResult<Samples> {
        let times = Given::read("t", t)?;
        let table = py.detach(|| self.table(scalar))?;
        self.within_reach(&times, table.ticks)?;
        Ok(Samples::new(times, Source::Table(table)))
    }

    /// Upper bound on the orientation error at time t, rad: 2 sqrt(|d alpha|^2 + |d beta|^2), which is the angle of the rotation
    /// between both where it is small.
    #[pyo3(signature = (t=0.0, *, scalar="f64"))]
    fn error_bound(&self, py: Python<'_>, t: f64, scalar: &str) -> PyResult<f64> {
        let table = py.detach(|| self.table(scalar))?;
        Ok(table.error_bound().after(t * table.ticks))
    }

    /// Upper bound on the error of omega, omega_body and udot at time t, rad/s.
    #[pyo3(signature = (t=0.0, *, scalar="f64"))]
    fn rate_error_bound(&self, py: Python<'_>, t: f64, scalar: &str) -> PyResult<f64> {
        let table = py.detach(|| self.table(scalar))?;
        Ok(table.rate_error_bound().after(t * table.ticks))
    }

    /// Closed form of the motion, in elementary or elliptic functions.
    ///
    /// Raises:
    ///     ValueError: the motion has none; the message says which motions do.
    fn closed_form(&self) -> PyResult<PyClosedForm> {
        PyClosedForm::of(&self.motion)
    }

    /// Truth at time t, s, rounded to float64: the paper's integrals in numbers of 192 bits, which share no formula and no
    /// arithmetic with Motion.at. It takes about a millisecond a time.
    ///
    /// Raises:
    ///     ValueError: t is not finite or beyond 2^62 ticks.
    fn reference(&self, py: Python<'_>, t: &Bound<'_, PyAny>) -> PyResult<Samples> {
        reference::samples(py, self, Given::read("t", t)?)
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
        digits: usize,
    ) -> PyResult<Bound<'py, PyAny>> {
        reference::digits(py, self, Given::read("t", t)?, digits)
    }

    /// Page with the top in motion, for a notebook or a browser: it computes in the page itself and needs no network.
    fn view(&self) -> PyResult<Page> {
        page::live(&self.text()).map_err(|failure| failed(&failure))
    }

    /// Top of the motion.
    #[getter]
    fn top(&self) -> PyTop {
        PyTop(self.top)
    }

    fn __repr__(&self) -> String {
        let e = self.motion.branch_points();
        let regime = self.regime();
        let support = definition::support_name(self.motion.top().support());
        format!("<Motion of a {support} top: {regime}, e1 = {:?}, e2 = {:?}, e3 = {:?}>", e.e1, e.e2, e.e3)
    }

    /// Picture of the curve that the tip draws, for a notebook.
    fn _repr_html_(&self, py: Python<'_>) -> PyResult<String> {
        py.detach(|| page::tip_curve(&self.motion)).map_err(|failure| failed(&failure))
    }

    fn __eq__(&self, other: &Self) -> bool {
        self.top == other.top && self.start == other.start
    }

    fn __hash__(&self) -> u64 {
        let integrals = self.motion.first_integrals();
        [integrals.l, integrals.n, integrals.h].iter().fold(0, |hash, x| hash.rotate_left(9) ^ x.to_bits())
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, (String,))> {
        Ok((py.get_type::<Self>().getattr("from_toml_text")?, (self.text(),)))
    }
}
