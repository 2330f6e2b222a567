//! Class `Samples`, motions at given times.

use crate::arrays::{Given, Numbers, constant_array};
use crate::error::value_error;
use crate::interrupt::on_all_cores;
use crate::motion::Table;
use numpy::PyArrayMethods;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyDict, PySlice};
use toytop::Orientation;
use toytop_host::motion::propagate::Sample;
use toytop_host::samples::angles;
use toytop_host::samples::column::Column;

/// A motion at given times, or many of them, as arrays. An attribute is computed when it is first asked for, and kept.
///
/// The number of motions, if there are many, and the shape of t come first in every array; vectors and quaternions add an axis. The
/// arrays are read-only. Frames: the third fixed axis points upward, the third body axis from the tip to the centre of mass.
#[pyclass(module = "toytop", frozen)]
pub(crate) struct Samples {
    /// Times of every motion.
    times: Given,
    /// Number of motions, for a `Many`.
    motions: Option<usize>,
    source: Source,
    /// Method that returns these samples at the times.
    origin: Py<PyAny>,
    kept: [PyOnceLock<Py<Numbers>>; KEPT],
}

/// Number of columns that can be kept.
const KEPT: usize = Column::ErrorBound as usize + 1;

/// Source of samples.
pub(crate) enum Source {
    /// A table for each motion, which are evaluated on demand.
    Tables(Vec<Table>),
    /// One point for each time.
    Points(Vec<Sample>),
}

/// Times that one job evaluates.
const BLOCK: usize = 8192;
/// Greatest number of samples for which threads are not worth their start.
const INLINE: usize = 16_384;

impl Samples {
    /// Samples that the method `origin` returns.
    pub(crate) fn new(
        times: Given,
        motions: Option<usize>,
        source: Source,
        origin: Bound<'_, PyAny>,
    ) -> Self {
        let kept = [const { PyOnceLock::new() }; KEPT];
        Self { times, motions, source, origin: origin.unbind(), kept }
    }

    fn shape(&self) -> Vec<usize> {
        self.motions.iter().chain(&self.times.shape).copied().collect()
    }

    /// Array of a column, kept for the next call.
    fn of<'py>(&self, py: Python<'py>, column: Column) -> PyResult<Bound<'py, Numbers>> {
        let computed = || {
            let (_, names) = column.names();
            let at = |table: &Table, t: f64, numbers: &mut Vec<f64>| table.push(column, t, numbers);
            self.computed(py, names.len(), at, |sample, numbers| numbers.extend(column.numbers(sample)))
                .map(Bound::unbind)
        };
        Ok(self.kept[column as usize].get_or_try_init(py, computed)?.bind(py).clone())
    }

    /// Array with rows of `width` numbers, which `at` appends for a table and a time, and `push` for a point.
    fn computed<'py>(
        &self,
        py: Python<'py>,
        width: usize,
        at: impl Fn(&Table, f64, &mut Vec<f64>) + Send + Sync,
        push: impl Fn(&Sample, &mut Vec<f64>) + Send + Sync,
    ) -> PyResult<Bound<'py, Numbers>> {
        let (times, mut shape) = (&self.times.numbers, self.shape());
        if width > 1 {
            shape.push(width);
        }
        // NumPy asks for large pages
        let array = Numbers::zeros(py, shape, false);
        let mut writer = array.readwrite();
        let numbers = writer.as_slice_mut()?;
        let length = numbers.len() / width;
        let rows = numbers.chunks_mut((width * times.len()).max(1)).enumerate();
        let mut jobs = rows.flat_map(|(motion, rows)| {
            let blocks = rows.chunks_mut(width * BLOCK).enumerate();
            blocks.map(move |(block, rows)| (motion, BLOCK * block, rows))
        });
        let fill = |(motion, first, rows): (usize, usize, &mut [f64])| {
            let mut row = Vec::with_capacity(width);
            for (place, out) in rows.chunks_exact_mut(width).enumerate() {
                row.clear();
                match &self.source {
                    Source::Tables(tables) => at(&tables[motion], times[first + place], &mut row),
                    Source::Points(points) => push(&points[first + place], &mut row),
                }
                out.copy_from_slice(&row);
            }
        };
        match length {
            // releasing the lock takes longer than a few samples
            ..16 => jobs.for_each(fill),
            16..=INLINE => py.detach(|| jobs.for_each(fill)),
            _ => on_all_cores(py, jobs.by_ref(), fill)?,
        }
        writer.make_nonwriteable();
        Ok(array)
    }
}

#[pymethods]
impl Samples {
    /// Times, s.
    #[getter]
    fn t<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let times = constant_array(py, self.times.numbers.clone(), &self.times.shape, 1)?;
        py.import("numpy")?.call_method1("broadcast_to", (times, self.shape()))
    }

    /// Unit quaternions w, x, y, z (scalar first) from body to fixed coordinates. Their sign is continuous in time.
    #[getter]
    fn quaternion<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, Numbers>> {
        self.of(py, Column::Quaternion)
    }

    /// Unit vectors from the tip to the centre of mass, in the fixed frame.
    #[getter]
    fn axis<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, Numbers>> {
        self.of(py, Column::Axis)
    }

    /// Cosines of the tilt.
    #[getter]
    fn u<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, Numbers>> {
        self.of(py, Column::U)
    }

    /// Rates of u, 1/s.
    #[getter]
    fn udot<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, Numbers>> {
        self.of(py, Column::Udot)
    }

    /// Angular velocities in the fixed frame, rad/s.
    #[getter]
    fn omega<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, Numbers>> {
        self.of(py, Column::Omega)
    }

    /// Angular velocities in the body frame, rad/s.
    #[getter]
    fn omega_body<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, Numbers>> {
        self.of(py, Column::OmegaBody)
    }

    /// Positions x, y of the tip on the plane relative to the point below the centre of mass, m; for a fixed tip minus the
    /// horizontal part of the axis, without unit.
    #[getter]
    fn tip<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, Numbers>> {
        self.of(py, Column::Tip)
    }

    /// Angles of the tip's position, continued from t = 0, rad; NaN where the axis is vertical at all times.
    #[getter]
    fn tip_angle<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, Numbers>> {
        self.of(py, Column::Phi)
    }

    /// Upper bounds on the orientation error, rad; NaN where none is known, as for a closed form.
    #[getter]
    fn error_bound<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, Numbers>> {
        self.of(py, Column::ErrorBound)
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
        let push = |sample: &Sample, numbers: &mut Vec<f64>| numbers.extend(of(&sample.orientation()));
        self.computed(py, 3, |table, t, numbers| push(&table.at(t).sample, numbers), push)
    }

    /// Rotations from body to fixed coordinates as one scipy.spatial.transform.Rotation, for at most one axis of times and motions.
    fn rotation<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let scalar_last = py.import("numpy")?.call_method1("roll", (self.quaternion(py)?, -1, -1))?;
        py.import("scipy.spatial.transform")?.getattr("Rotation")?.call_method1("from_quat", (scalar_last,))
    }

    /// Columns of a table, one-dimensional arrays by name: t, w, x, y, z (quaternion), omega_x, omega_y, omega_z (fixed frame),
    /// omega_body_x, omega_body_y, omega_body_z (body frame), u, tip_x, tip_y, phi (tip angle). Samples of many motions begin
    /// with the column motion, the index of the motion.
    fn columns<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let (columns, numpy) = (PyDict::new(py), py.import("numpy")?);
        if let Some(motions) = self.motions {
            let indices = numpy.call_method1("arange", (motions,))?;
            columns.set_item("motion", indices.call_method1("repeat", (self.times.numbers.len(),))?)?;
        }
        columns.set_item("t", self.t(py)?.call_method0("ravel")?)?;
        let quantities: [(Column, &[&str]); 6] = [
            (Column::Quaternion, &["w", "x", "y", "z"]),
            (Column::Omega, &["omega_x", "omega_y", "omega_z"]),
            (Column::OmegaBody, &["omega_body_x", "omega_body_y", "omega_body_z"]),
            (Column::U, &["u"]),
            (Column::Tip, &["tip_x", "tip_y"]),
            (Column::Phi, &["phi"]),
        ];
        for (quantity, names) in quantities {
            let numbers = self.of(py, quantity)?.call_method1("reshape", (-1, names.len()))?;
            for (component, name) in names.iter().enumerate() {
                columns.set_item(name, numbers.get_item((PySlice::full(py), component))?)?;
            }
        }
        Ok(columns)
    }

    fn __len__(&self) -> PyResult<usize> {
        let none = || pyo3::exceptions::PyTypeError::new_err("samples at a single time have no length");
        self.shape().first().copied().ok_or_else(none)
    }

    fn __repr__(&self) -> String {
        format!("<Samples of shape {:?}>", self.shape())
    }

    fn __copy__(slf: Py<Self>) -> Py<Self> {
        slf
    }

    fn __deepcopy__(slf: Py<Self>, _memo: &Bound<'_, PyAny>) -> Py<Self> {
        slf
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Py<PyAny>, (Bound<'py, Numbers>,))> {
        Ok((
            self.origin.clone_ref(py),
            (constant_array(py, self.times.numbers.clone(), &self.times.shape, 1)?,),
        ))
    }
}
