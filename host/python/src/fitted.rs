//! Class `Fitted`, the result of a fit.

use crate::arrays::{Given, Numbers, array};
use crate::error::value_error;
use crate::motion::PyMotion;
use crate::sensors::dictionary;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use toytop::Sensitivity;
use toytop::fit::Drift;
use toytop_host::fit::columns::Columns;
use toytop_host::fit::report::FitReport;

/// Launch of a top fitted to samples, with its error bars. It is made by toytop.fit.
#[pyclass(module = "toytop", frozen)]
pub(crate) struct Fitted {
    core: toytop::fit::Fitted,
    motion: Result<Py<PyMotion>, String>,
    unknowns: Vec<String>,
    free: Vec<(&'static str, [f64; 2])>,
    biases: Vec<(&'static str, [[f64; 3]; 2])>,
    undetermined: Vec<&'static str>,
    spin_and_tilt: [(f64, f64); 2],
    residuals: Columns,
}

impl Fitted {
    pub(crate) fn new(py: Python<'_>, report: &FitReport<'_>, residuals: Columns) -> PyResult<Self> {
        let core = *report.fitted;
        let motion = match (core.reason, report.scenario(None)) {
            (Some(reason), _) => Err(format!("must be that of a fit that has converged: {reason}")),
            (None, Err(failure)) => Err(failure.to_string()),
            (None, Ok((text, _))) => Ok(Py::new(py, PyMotion::parsed("fitted", &text)?)?),
        };
        let free: Vec<_> = report
            .freed()
            .into_iter()
            .map(|(key, value, deviation)| (key.name(), [value, deviation]))
            .collect();
        let biases: Vec<_> = report
            .biases()
            .into_iter()
            .map(|(name, values, deviations)| (name, [values, deviations]))
            .collect();
        let launch = Sensitivity::NAMES.iter().take(6).map(|name| (*name).to_owned());
        let numbers = free.iter().map(|(name, _)| (*name).to_owned());
        let losses = core.drift.iter().flat_map(|_| Drift::LOSSES.map(str::to_owned));
        let axes = ["x", "y", "z"];
        let components = biases.iter().flat_map(|(name, _)| axes.map(|axis| format!("{name}_bias_{axis}")));
        let unknowns = launch.chain(numbers).chain(losses).chain(components).collect();
        Ok(Self {
            core,
            motion,
            unknowns,
            free,
            biases,
            undetermined: report.undetermined(),
            spin_and_tilt: report.spin_and_tilt(),
            residuals,
        })
    }

    fn believed(&self) -> PyResult<&Py<PyMotion>> {
        self.motion.as_ref().map_err(|reason| value_error("motion", reason))
    }
}

#[pymethods]
impl Fitted {
    /// Whether the launch may be trusted.
    #[getter]
    fn converged(&self) -> bool {
        self.core.converged()
    }

    /// Reason why the launch must not be trusted; None where it may be.
    #[getter]
    fn reason(&self) -> Option<String> {
        self.core.reason.map(|reason| reason.to_string())
    }

    /// Motion of the launch, whose t = 0 is the epoch.
    ///
    /// Raises:
    ///     ValueError: the fit has not converged.
    #[getter]
    fn motion(&self, py: Python<'_>) -> PyResult<Py<PyMotion>> {
        Ok(self.believed()?.clone_ref(py))
    }

    /// Time of the launch among the samples, s: that of the first one; with a drift, that of the last one.
    #[getter]
    fn epoch(&self) -> f64 {
        self.core.epoch
    }

    /// Quaternion w, x, y, z of the launch.
    #[getter]
    fn quaternion<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, Numbers>> {
        array(py, self.core.launch.orientation.quaternion().to_vec(), &[4], 1)
    }

    /// Angular velocity of the launch in the fixed frame, rad/s.
    #[getter]
    fn omega<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, Numbers>> {
        array(py, self.core.launch.omega.to_vec(), &[3], 1)
    }

    /// Component of the angular velocity along the axis, rad/s, and its standard deviation.
    #[getter]
    fn spin(&self) -> (f64, f64) {
        self.spin_and_tilt[0]
    }

    /// Angle of the axis from the upward vertical at the epoch, rad, and its standard deviation.
    #[getter]
    fn tilt(&self) -> (f64, f64) {
        self.spin_and_tilt[1]
    }

    /// Names of the rows and columns of the covariance: the rotation vector of the orientation in the fixed frame (rad), omega (rad/s), the
    /// logarithms of the free numbers of the top, the losses of rotation (1/s) if there is a drift, and the biases in the units of their sensors.
    #[getter]
    fn unknowns(&self) -> Vec<String> {
        self.unknowns.clone()
    }

    /// Covariance of the unknowns. In a direction that is undetermined the standard deviation is 10 rad, or ten times omega.
    #[getter]
    fn covariance<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, Numbers>> {
        let count = self.core.count;
        let entries = (0..count * count).map(|place| self.core.covariance.of(place / count, place % count));
        array(py, entries.collect(), &[count, count], 1)
    }

    /// Standard deviations of the unknowns.
    #[getter]
    fn deviations<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, Numbers>> {
        let count = self.core.count;
        array(py, self.core.deviations()[..count].to_vec(), &[count], 1)
    }

    /// Mean rates of change of the first integrals l, n (N m) and h (W) during the samples, and their standard deviations; None where no
    /// drift was fitted.
    #[getter]
    fn drift<'py>(&self, py: Python<'py>) -> PyResult<Option<(Bound<'py, Numbers>, Bound<'py, Numbers>)>> {
        let Some(drift) = &self.core.drift else { return Ok(None) };
        let [rates, deviations] = [drift.rates, drift.deviations()].map(|x| array(py, x.to_vec(), &[3], 1));
        Ok(Some((rates?, deviations?)))
    }

    /// Free numbers of the top by name, each with its standard deviation.
    #[getter]
    fn free<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let free = PyDict::new(py);
        for (name, [value, deviation]) in &self.free {
            free.set_item(name, (*value, *deviation))?;
        }
        Ok(free)
    }

    /// Biases by sensor: three values, and their standard deviations.
    #[getter]
    fn biases<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let biases = PyDict::new(py);
        for (name, pair) in &self.biases {
            let [values, deviations] = pair.map(|three| array(py, three.to_vec(), &[3], 1));
            biases.set_item(name, (values?, deviations?))?;
        }
        Ok(biases)
    }

    /// Directions of the launch that the samples do not determine: "yaw", "roll", "spin", or "other".
    #[getter]
    fn undetermined(&self) -> Vec<&'static str> {
        self.undetermined.clone()
    }

    /// Number of other launches that fit the first samples as well.
    #[getter]
    fn alternatives(&self) -> usize {
        self.core.alternatives
    }

    /// Sum of the squares of the residuals in standard deviations, those of outliers at the limit.
    #[getter]
    fn chi_squared(&self) -> f64 {
        self.core.statistics.chi_squared
    }

    /// Sum of squares by degrees of freedom: about 1 where the model and the noise are right.
    #[getter]
    fn reduced_chi_squared(&self) -> f64 {
        self.core.statistics.reduced_chi_squared(self.core.count)
    }

    /// Number of values that were used.
    #[getter]
    fn used(&self) -> u32 {
        self.core.statistics.used
    }

    /// Number of values at the end of their range, which were not used.
    #[getter]
    fn saturated(&self) -> u32 {
        self.core.statistics.unused
    }

    /// Number of values beyond the Huber limit.
    #[getter]
    fn outliers(&self) -> u32 {
        self.core.statistics.outliers
    }

    /// Residuals in standard deviations by column, and t; NaN where there is no reading or it is at the end of its range. Those of an
    /// orientation are x, y, z of the rotation vector in the fixed frame.
    #[getter]
    fn residuals<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        dictionary(py, self.residuals.clone())
    }

    /// Covariance of the predicted orientation at the time t of the motion, as a rotation vector in the fixed frame, rad²: the shape of t
    /// comes first, (..., 3, 3).
    ///
    /// Raises:
    ///     ValueError: the fit has not converged, or the motion has no period and cannot be followed for so long.
    fn orientation_covariance<'py>(
        &self,
        py: Python<'py>,
        t: &Bound<'_, PyAny>,
    ) -> PyResult<Bound<'py, Numbers>> {
        let motion = self.believed()?.get().motion;
        let Given { numbers, shape } = Given::read("t", t)?;
        let found: Option<Vec<f64>> = py.detach(|| {
            let sensitivity = Sensitivity::of(&motion);
            let at = |t: &f64| Some(self.core.orientation_covariance(&sensitivity.at(*t)?));
            let all = numbers.iter().map(at).collect::<Option<Vec<_>>>()?;
            Some(all.into_iter().flatten().flatten().collect())
        });
        let refuse = || value_error("t", "must not be so far for a motion without a period");
        array(py, found.ok_or_else(refuse)?, &[&shape[..], &[3]].concat(), 3)
    }

    fn __repr__(&self) -> String {
        let [(spin, spin_deviation), (tilt, tilt_deviation)] = self.spin_and_tilt;
        let reduced = self.reduced_chi_squared();
        match self.core.reason {
            Some(reason) => format!("<Fitted: not converged: {reason}>"),
            None => format!(
                "<Fitted: tilt {tilt:.6} +- {tilt_deviation:.1e} rad, spin {spin:.6} +- {spin_deviation:.1e} rad/s, \
                 reduced chi squared {reduced:.3}>"
            ),
        }
    }
}
