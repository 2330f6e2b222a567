//! Class `Samples`, a motion at given times.

use crate::arrays::{Given, Numbers, array};
use crate::error::value_error;
use crate::motion::Table;
use crate::point::Point;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::PyDict;
use std::sync::Arc;
use toytop::Orientation;
use toytop_host::motion::ephemeris::Quantity;
use toytop_host::samples::angles;

/// A motion at given times, as arrays. An attribute is computed when it is first asked for, and kept.
///
/// The shape of t comes first in every array; vectors and quaternions add an axis. Frames: the third fixed axis points upward, the
/// third body axis from the tip to the centre of mass.
#[pyclass(module = "toytop", frozen)]
pub(crate) struct Samples {
    times: Given,
    source: Source,
    kept: [PyOnceLock<Py<Numbers>>; Quantity::COUNT],
}

/// Source of samples.
pub(crate) enum Source {
    /// Table, which is evaluated on demand.
    Table(Arc<Table>),
    /// One point for each time.
    Points(Vec<Point>),
}

impl Samples {
    pub(crate) fn new(times: Given, source: Source) -> Self {
        Self { times, source, kept: [const { PyOnceLock::new() }; Quantity::COUNT] }
    }

    /// Array of a quantity.
    fn of<'py>(&self, py: Python<'py>, quantity: Quantity) -> PyResult<Bound<'py, Numbers>> {
        let kept = &self.kept[quantity as usize];
        let computed = || {
            let numbers = match self.times.numbers.len() {
                // releasing the lock takes longer than a few samples
                ..16 => self.computed(quantity),
                _ => py.detach(|| self.computed(quantity)),
            };
            array(py, numbers, &self.times.shape, quantity.width()).map(Bound::unbind)
        };
        Ok(kept.get_or_try_init(py, computed)?.bind(py).clone())
    }

    fn computed(&self, quantity: Quantity) -> Vec<f64> {
        let times = &self.times.numbers;
        match &self.source {
            Source::Table(table) => {
                let mut numbers = vec![0.0; times.len() * quantity.width()];
                table.fill(quantity, times, &mut numbers);
                numbers
            }
            Source::Points(points) => {
                let mut numbers = Vec::with_capacity(times.len() * quantity.width());
                points.iter().for_each(|point| point.push(quantity, &mut numbers));
                numbers
            }
        }
    }

    fn orientations(&self) -> Vec<Orientation<f64>> {
        let quaternions = self.computed(Quantity::Quaternion);
        quaternions.as_chunks().0.iter().map(|q| Orientation::from_quaternion(*q)).collect()
    }
}

#[pymethods]
impl Samples {
    /// Times, s.
    #[getter]
    fn t<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, Numbers>> {
        array(py, self.times.numbers.clone(), &self.times.shape, 1)
    }

    /// Unit quaternions w, x, y, z (scalar first) from body to fixed coordinates. Their sign is continuous in time.
    #[getter]
    fn quaternion<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, Numbers>> {
        self.of(py, Quantity::Quaternion)
    }

    /// Unit vectors from the tip to the centre of mass, in the fixed frame.
    #[getter]
    fn axis<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, Numbers>> {
        self.of(py, Quantity::Axis)
    }

    /// Cosines of the tilt.
    #[getter]
    fn u<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, Numbers>> {
        self.of(py, Quantity::U)
    }

    /// Rates of u, 1/s.
    #[getter]
    fn udot<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, Numbers>> {
        self.of(py, Quantity::Udot)
    }

    /// Angular velocities in the fixed frame, rad/s.
    #[getter]
    fn omega<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, Numbers>> {
        self.of(py, Quantity::Omega)
    }

    /// Angular velocities in the body frame, rad/s.
    #[getter]
    fn omega_body<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, Numbers>> {
        self.of(py, Quantity::OmegaBody)
    }

    /// Positions x, y of the tip on the plane relative to the point below the centre of mass, m; for a fixed tip minus the
    /// horizontal part of the axis, without unit.
    #[getter]
    fn tip<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, Numbers>> {
        self.of(py, Quantity::Tip)
    }

    /// Angles of the tip's position, continued from t = 0, rad; NaN where the axis is vertical at all times.
    #[getter]
    fn tip_angle<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, Numbers>> {
        self.of(py, Quantity::TipAngle)
    }

    /// Upper bounds on the orientation error, rad; NaN where none is known, as for a closed form.
    #[getter]
    fn error_bound<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, Numbers>> {
        let bounds = match &self.source {
            Source::Table(table) => {
                let bound = table.error_bound();
                self.times.numbers.iter().map(|t| bound.after(t * table.ticks)).collect()
            }
            Source::Points(points) => points.iter().map(|point| point.error_bound).collect(),
        };
        array(py, bounds, &self.times.shape, 1)
    }

    /// Euler angles, rad: of the sequence "zxz" (phi, theta, psi: Rz(phi) Rx(theta) Rz(psi)) or "zyz" (azimuth, tilt, roll, as
    /// Top.release takes them: Rz(azimuth) Ry(tilt) Rz(roll)).
    ///
    /// Raises:
    ///     ValueError: another sequence; rotation().as_euler has all.
    #[pyo3(signature = (sequence="zxz"))]
    fn euler<'py>(&self, py: Python<'py>, sequence: &str) -> PyResult<Bound<'py, Numbers>> {
        let of: fn(&Orientation<f64>) -> [f64; 3] = match sequence {
            "zxz" => angles::zxz,
            "zyz" => |phi| {
                let [tilt, azimuth, roll] = angles::tilt_azimuth_roll(phi);
                [azimuth, tilt, roll]
            },
            _ => {
                return Err(value_error("sequence", "must be 'zxz' or 'zyz'; rotation().as_euler() has all"));
            }
        };
        let numbers = py.detach(|| self.orientations().iter().flat_map(of).collect());
        array(py, numbers, &self.times.shape, 3)
    }

    /// Rotations from body to fixed coordinates as one scipy.spatial.transform.Rotation, for t of at most one axis.
    fn rotation<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let scalar_last = |phi: Orientation<f64>| {
            let [w, x, y, z] = phi.quaternion();
            [x, y, z, w]
        };
        let numbers = py.detach(|| self.orientations().into_iter().flat_map(scalar_last).collect());
        let rotations = py.import("scipy.spatial.transform")?.getattr("Rotation")?;
        rotations.call_method1("from_quat", (array(py, numbers, &self.times.shape, 4)?,))
    }

    /// Columns of a table, one-dimensional arrays by name, as the program toytop names them: t, w, x, y, z, wx, wy, wz (omega_body),
    /// u, tip_x, tip_y, phi (tip angle).
    fn columns<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let columns = PyDict::new(py);
        columns.set_item("t", array(py, self.times.numbers.clone(), &[self.times.numbers.len()], 1)?)?;
        let quantities: [(Quantity, &[&str]); 5] = [
            (Quantity::Quaternion, &["w", "x", "y", "z"]),
            (Quantity::OmegaBody, &["wx", "wy", "wz"]),
            (Quantity::U, &["u"]),
            (Quantity::Tip, &["tip_x", "tip_y"]),
            (Quantity::TipAngle, &["phi"]),
        ];
        for (quantity, names) in quantities {
            let numbers = py.detach(|| self.computed(quantity));
            for (component, name) in names.iter().enumerate() {
                let column: Vec<f64> = numbers.iter().skip(component).step_by(names.len()).copied().collect();
                let length = column.len();
                columns.set_item(name, array(py, column, &[length], 1)?)?;
            }
        }
        Ok(columns)
    }

    fn __len__(&self) -> PyResult<usize> {
        self.times
            .shape
            .first()
            .copied()
            .ok_or_else(|| pyo3::exceptions::PyTypeError::new_err("samples at a single time have no length"))
    }

    fn __repr__(&self) -> String {
        format!("<Samples at t of shape {:?}>", self.times.shape)
    }
}
