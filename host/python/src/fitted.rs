//! Class `Fitted`, the result of a fit.

use crate::arrays::{Given, Numbers, array};
use crate::error::value_error;
use crate::interrupt;
use crate::motion::{PyMotion, Single};
use numpy::{IntoPyArray, PyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use toytop_fit::{Drift, Sensitivity};
use toytop_host::fit::columns::Columns;
use toytop_host::fit::launch::FitReport;

/// Array of one axis for Python.
type Array = Py<PyArray1<f64>>;

/// Launch of a top fitted to samples, with its error bars. It is made by toytop.fit.
#[pyclass(module = "toytop", frozen)]
pub(crate) struct Fitted {
    core: toytop_fit::Fitted,
    motion: Result<Py<PyMotion>, String>,
    /// Whether the launch may be trusted.
    #[pyo3(get)]
    converged: bool,
    /// Reason why the launch must not be trusted; None where it may be.
    #[pyo3(get)]
    reason: Option<String>,
    /// Time of the launch among the samples, s: that of the first one; with a drift, that of the last one.
    #[pyo3(get)]
    epoch: f64,
    /// Quaternion w, x, y, z of the launch.
    #[pyo3(get)]
    quaternion: Array,
    /// Angular velocity of the launch in the fixed frame, rad/s.
    #[pyo3(get)]
    omega: Array,
    /// Component of the angular velocity along the axis, rad/s, and its standard deviation.
    #[pyo3(get)]
    spin: (f64, f64),
    /// Angle of the axis from the upward vertical at the epoch, rad, and its standard deviation.
    #[pyo3(get)]
    tilt: (f64, f64),
    /// Names of the rows and columns of the covariance: the rotation vector of the orientation in the fixed frame (rad), the change of omega
    /// in the frame that this rotation turns (rad/s), in which a poorly known yaw does not make omega uncertain, the logarithms of the free
    /// numbers of the top, the losses of rotation (1/s) if there is a drift, and the biases in the units of their sensors.
    #[pyo3(get)]
    unknowns: Vec<String>,
    /// Covariance of the unknowns. In a direction that is undetermined the standard deviation is 10 rad, or ten times omega.
    #[pyo3(get)]
    covariance: Py<Numbers>,
    /// Standard deviations of the unknowns.
    #[pyo3(get)]
    deviations: Array,
    /// Mean rates of change of the first integrals l, n (N m) and h (W) during the samples, and their standard deviations; None where no
    /// drift was fitted.
    #[pyo3(get)]
    drift: Option<(Array, Array)>,
    /// Free numbers of the top by name, each with its standard deviation.
    #[pyo3(get)]
    free: Py<PyDict>,
    /// Losses of rotation about the axis, across it, and about the vertical, in units of the rotation itself per second, each with its
    /// standard deviation; None where no drift was fitted.
    #[pyo3(get)]
    losses: Option<Py<PyDict>>,
    /// Biases by sensor: three values, and their standard deviations.
    #[pyo3(get)]
    biases: Py<PyDict>,
    /// Directions of the launch that the samples do not determine: "yaw", "roll", "spin", or "other".
    #[pyo3(get)]
    undetermined: Vec<&'static str>,
    /// Number of other launches that fit the first samples as well.
    #[pyo3(get)]
    alternatives: usize,
    /// Sum of the squares of the residuals in standard deviations, those of outliers at the limit.
    #[pyo3(get)]
    chi_squared: f64,
    /// Sum of squares by degrees of freedom: about 1 where the model and the noise are right.
    #[pyo3(get)]
    reduced_chi_squared: f64,
    /// Number of values that were used.
    #[pyo3(get)]
    used: u32,
    /// Number of values at the end of their range, which were not used.
    #[pyo3(get)]
    saturated: u32,
    /// Number of values beyond the Huber limit.
    #[pyo3(get)]
    outliers: u32,
    /// Residuals in standard deviations by column, and t; NaN where there is no reading or it is at the end of its range. Those of an
    /// orientation are x, y, z of the rotation vector in the fixed frame.
    #[pyo3(get)]
    residuals: Py<PyDict>,
}

impl Fitted {
    pub(crate) fn new(py: Python<'_>, report: &FitReport, residuals: Columns) -> PyResult<Self> {
        let core = report.fitted;
        let motion = match (core.reason, report.scenario(None)) {
            (Some(reason), _) => Err(format!("must be that of a fit that has converged: {reason}")),
            (None, Err(failure)) => Err(failure.to_string()),
            (None, Ok(text)) => Ok(Py::new(py, PyMotion(Single::parsed("fitted", &text)?))?),
        };
        let numbers = |numbers: &[f64]| numbers.to_vec().into_pyarray(py).unbind();
        let all = core.deviations();
        let mut unknowns: Vec<_> = Sensitivity::NAMES[..6].iter().map(|name| (*name).to_owned()).collect();
        let (free, biases) = (PyDict::new(py), PyDict::new(py));
        for (key, value, deviation) in report.freed() {
            free.set_item(key, (value, deviation))?;
            unknowns.push(key.to_owned());
        }
        let mut losses = None;
        if let Some(drift) = &core.drift {
            let by_name = PyDict::new(py);
            for (name, loss) in Drift::LOSSES.into_iter().zip(drift.losses) {
                by_name.set_item(name, (loss, all[unknowns.len()]))?;
                unknowns.push(name.to_owned());
            }
            losses = Some(by_name.unbind());
        }
        for (name, values, deviations) in report.biases() {
            biases.set_item(name, (numbers(&values), numbers(&deviations)))?;
            unknowns.extend(["x", "y", "z"].map(|axis| format!("{name}_bias_{axis}")));
        }
        let (count, [spin, tilt]) = (core.count, report.spin_and_tilt());
        let covariance = (0..count * count).map(|at| core.covariance.get(at / count, at % count)).collect();
        Ok(Self {
            core,
            motion,
            converged: core.converged(),
            reason: report.reason.clone(),
            epoch: core.epoch,
            quaternion: numbers(&core.launch.orientation.quaternion()),
            omega: numbers(&core.launch.omega),
            spin,
            tilt,
            unknowns,
            covariance: array(py, covariance, &[count, count])?.unbind(),
            deviations: numbers(&all[..count]),
            drift: core.drift.map(|drift| (numbers(&drift.rates), numbers(&drift.deviations()))),
            free: free.unbind(),
            losses,
            biases: biases.unbind(),
            undetermined: report.undetermined(),
            alternatives: core.alternatives,
            chi_squared: core.statistics.chi_squared,
            reduced_chi_squared: core.statistics.reduced_chi_squared(count),
            used: core.statistics.used,
            saturated: core.statistics.unused,
            outliers: core.statistics.outliers,
            residuals: dictionary(py, residuals)?.unbind(),
        })
    }

    fn believed(&self) -> PyResult<&Py<PyMotion>> {
        self.motion.as_ref().map_err(|reason| value_error("motion", reason))
    }
}

#[pymethods]
impl Fitted {
    /// Motion of the launch, whose t = 0 is the epoch.
    ///
    /// Raises:
    ///     ValueError: the fit has not converged.
    #[getter]
    fn motion(&self, py: Python<'_>) -> PyResult<Py<PyMotion>> {
        Ok(self.believed()?.clone_ref(py))
    }

    /// Covariance of the predicted orientation at the time t of the motion, as a rotation vector in the fixed frame, rad²: the shape of t
    /// comes first, (..., 3, 3).
    ///
    /// Raises:
    ///     ValueError: the fit has not converged, or the motion has no period and cannot be followed for so long.
    fn orientation_covariance<'py>(&self, py: Python<'py>, t: Given) -> PyResult<Bound<'py, Numbers>> {
        let motion = self.believed()?.get().0.motion;
        let Given { numbers, shape } = t;
        let sensitivity = py.detach(|| Sensitivity::new(&motion));
        let found = interrupt::map(py, numbers.len(), |index| {
            Some(self.core.orientation_covariance(&sensitivity.at(numbers[index])?))
        })?;
        let found: Option<Vec<_>> = found.into_iter().collect();
        let refuse = || value_error("t", "must not be so far for a motion without a period");
        let found = found.ok_or_else(refuse)?.into_iter().flatten().flatten().collect();
        array(py, found, &[&shape[..], &[3, 3]].concat())
    }

    fn __repr__(&self) -> String {
        let ((spin, spin_deviation), (tilt, tilt_deviation)) = (self.spin, self.tilt);
        let reduced = self.reduced_chi_squared;
        match &self.reason {
            Some(reason) => format!("<Fitted: not converged: {reason}>"),
            None => format!(
                "<Fitted: tilt {tilt:.6} +- {tilt_deviation:.1e} rad, spin {spin:.6} +- {spin_deviation:.1e} rad/s, \
                 reduced chi squared {reduced:.3}>"
            ),
        }
    }
}

/// Columns as a dictionary of arrays.
pub(crate) fn dictionary<'py>(py: Python<'py>, columns: Columns) -> PyResult<Bound<'py, PyDict>> {
    let dictionary = PyDict::new(py);
    for (name, numbers) in [("t", columns.t)].into_iter().chain(columns.readings) {
        dictionary.set_item(name, numbers.into_pyarray(py))?;
    }
    Ok(dictionary)
}
