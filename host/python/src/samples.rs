//! Class `Samples`, motions at given times.

use crate::arguments::{Given, Numbers, array, failed, value_error};
use crate::interrupt;
use numpy::PyArrayMethods;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::PyDict;
use rayon::iter::{IndexedParallelIterator, ParallelIterator};
use rayon::slice::ParallelSliceMut;
use std::sync::Arc;
use toytop::{Motion, Orientation};
use toytop_host::motion::Scalar;
use toytop_host::motion::ephemeris::AnyEphemeris;
use toytop_host::motion::propagate::Sample;
use toytop_host::motion::quantity::Quantity;
use toytop_host::motion::tip_angle::TipAngle;

/// A motion at given times, or many of them, as arrays. An attribute is computed when it is first asked for, and kept.
///
/// The number of motions, if there are many, and the shape of t come first in every array; vectors and quaternions add an axis. The
/// arrays are read-only. Frames: the third fixed axis points upward, the third body axis from the tip to the centre of mass.
#[pyclass(module = "toytop", frozen)]
pub(crate) struct Samples {
    origin: Origin,
    /// Times of every motion.
    times: Given,
    /// Number of motions, for a `Many`.
    motions: Option<usize>,
    source: Source,
    kept: [PyOnceLock<Py<Numbers>>; KEPT],
}

/// Number of columns that can be kept.
const KEPT: usize = Quantity::ErrorBound as usize + 1;

/// Call that returns samples: an object, its method, and a scalar.
pub(crate) type Origin = (Py<PyAny>, &'static str, Option<Scalar>);

/// Array of a column for Python.
type Array = PyResult<Py<Numbers>>;

/// Ephemeris of one scalar.
pub(crate) type Table = Arc<dyn AnyEphemeris>;

/// Source of samples.
pub(crate) enum Source {
    /// A table for each motion, which are evaluated on demand.
    Tables(Vec<Table>),
    /// One point for each time.
    Points(Vec<Sample>),
}

/// Samples of one job; for fewer, other threads are not worth their start.
const BLOCK: usize = 8192;
/// Least |αβ| at which the rounding of α and β changes the argument of αβ by less than 1e-5 rad.
const NOISE: f64 = 1e-11;

impl Samples {
    /// Samples that this method returns.
    pub(crate) fn new(origin: Origin, times: Given, motions: Option<usize>, source: Source) -> Self {
        let kept = [const { PyOnceLock::new() }; KEPT];
        Self { origin, times, motions, source, kept }
    }

    /// Samples of a method that computes the orientation, ω and u' at a time, with this error bound if it has one.
    ///
    /// # Errors
    /// `KeyboardInterrupt`, or `ValueError`: no table is large enough for the tip angle.
    pub(crate) fn of_points(
        py: Python<'_>,
        origin: Origin,
        times: Given,
        motion: &Motion,
        error_bound: Option<f64>,
        at: impl Fn(f64) -> (Orientation<f64>, [f64; 3], f64) + Send + Sync,
    ) -> PyResult<Self> {
        let angle = TipAngle::of(motion, NOISE).map_err(failed)?;
        let points = interrupt::map(py, times.numbers.len(), |index| {
            let t = times.numbers[index];
            let (orientation, omega, udot) = at(t);
            Sample { error_bound, ..angle.sample(t, orientation, omega, udot) }
        })?;
        Ok(Self::new(origin, times, None, Source::Points(points)))
    }

    fn shape(&self) -> Vec<usize> {
        self.motions.iter().chain(&self.times.shape).copied().collect()
    }

    /// Array of a column, kept for the next call.
    fn of(&self, py: Python<'_>, column: Quantity) -> Array {
        let array = self.kept[column as usize].get_or_try_init(py, || self.computed(py, column));
        Ok(array?.clone_ref(py))
    }

    fn computed(&self, py: Python<'_>, column: Quantity) -> Array {
        let (times, mut shape) = (&self.times.numbers, self.shape());
        let width = column.names().1.len();
        if width > 1 {
            shape.push(width);
        }
        // NumPy asks for large pages
        let array = Numbers::zeros(py, shape, false);
        let mut writer = array.readwrite();
        let numbers = writer.as_slice_mut()?;
        let fill = |motion: usize, first: usize, rows: &mut [f64]| match &self.source {
            Source::Tables(tables) => tables[motion].fill(column, &times[first..], rows),
            Source::Points(points) => {
                for (point, row) in points[first..].iter().zip(rows.chunks_exact_mut(width)) {
                    row.copy_from_slice(&column.numbers(point));
                }
            }
        };
        let of_motion = (width * times.len()).max(1);
        if numbers.len() <= width * BLOCK {
            let motions = numbers.chunks_mut(of_motion).enumerate();
            py.detach(|| motions.for_each(|(motion, rows)| fill(motion, 0, rows)));
        } else {
            let jobs = numbers.par_chunks_mut(of_motion).enumerate().flat_map(|(motion, rows)| {
                let blocks = rows.par_chunks_mut(width * BLOCK).enumerate();
                blocks.map(move |(block, rows)| (motion, BLOCK * block, rows))
            });
            interrupt::on_all_cores(py, jobs, |(motion, first, rows)| fill(motion, first, rows))?;
        }
        writer.make_nonwriteable();
        Ok(array.unbind())
    }

    /// Times of one motion as an array.
    fn own_times<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, Numbers>> {
        array(py, self.times.numbers.clone(), &self.times.shape)
    }
}

#[pymethods]
impl Samples {
    /// Times, s.
    #[getter]
    fn t<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        py.import("numpy")?.call_method1("broadcast_to", (self.own_times(py)?, self.shape()))
    }

    /// Unit quaternions w, x, y, z (scalar first) from body to fixed coordinates. Their sign is continuous in time.
    #[getter]
    fn quaternion(&self, py: Python<'_>) -> Array {
        self.of(py, Quantity::Quaternion)
    }

    /// Unit vectors from the tip to the centre of mass, in the fixed frame.
    #[getter]
    fn axis(&self, py: Python<'_>) -> Array {
        self.of(py, Quantity::Axis)
    }

    /// Cosines of the tilt.
    #[getter]
    fn u(&self, py: Python<'_>) -> Array {
        self.of(py, Quantity::U)
    }

    /// Rates of u, 1/s.
    #[getter]
    fn udot(&self, py: Python<'_>) -> Array {
        self.of(py, Quantity::Udot)
    }

    /// Angular velocities in the fixed frame, rad/s.
    #[getter]
    fn omega(&self, py: Python<'_>) -> Array {
        self.of(py, Quantity::Omega)
    }

    /// Angular velocities in the body frame, rad/s.
    #[getter]
    fn omega_body(&self, py: Python<'_>) -> Array {
        self.of(py, Quantity::OmegaBody)
    }

    /// Positions x, y of the tip on the plane relative to the point below the centre of mass, m; for a fixed tip minus the
    /// horizontal part of the axis, without unit.
    #[getter]
    fn tip(&self, py: Python<'_>) -> Array {
        self.of(py, Quantity::Tip)
    }

    /// Angles of the tip's position, continued from t = 0, rad; NaN where the axis is vertical at all times.
    #[getter]
    fn tip_angle(&self, py: Python<'_>) -> Array {
        self.of(py, Quantity::Phi)
    }

    /// Upper bounds on the orientation error, rad; NaN where none is known, as for a closed form.
    #[getter]
    fn error_bound(&self, py: Python<'_>) -> Array {
        self.of(py, Quantity::ErrorBound)
    }

    /// Euler angles, rad: of the sequence "zxz" (phi, theta, psi: Rz(phi) Rx(theta) Rz(psi)) or "zyz" (azimuth, tilt, roll, as
    /// Top.release takes them: Rz(azimuth) Ry(tilt) Rz(roll)).
    ///
    /// Raises:
    ///     ValueError: another sequence; rotation().as_euler has all.
    #[pyo3(signature = (sequence="zxz"))]
    fn euler(&self, py: Python<'_>, sequence: &str) -> PyResult<Py<PyAny>> {
        match sequence {
            "zxz" => Ok(self.of(py, Quantity::EulerZxz)?.into_any()),
            "zyz" => {
                let tilt_azimuth_roll = self.of(py, Quantity::Angles)?;
                let angles = tilt_azimuth_roll.call_method1(py, "take", ([1, 0, 2], -1))?;
                angles.call_method1(py, "setflags", (false,))?;
                Ok(angles)
            }
            _ => Err(value_error("sequence", "must be 'zxz' or 'zyz'; rotation().as_euler() has all")),
        }
    }

    /// Rotations from body to fixed coordinates as one scipy.spatial.transform.Rotation, for at most one axis of times and motions.
    fn rotation<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let scalar_last = py.import("numpy")?.call_method1("roll", (self.quaternion(py)?, -1, -1))?;
        py.import("scipy.spatial.transform")?.getattr("Rotation")?.call_method1("from_quat", (scalar_last,))
    }

    /// Columns of a table, one-dimensional arrays by name: t, w, x, y, z (quaternion), omega_x, omega_y, omega_z (fixed frame),
    /// omega_body_x, omega_body_y, omega_body_z (body frame), u, tip_x, tip_y, phi (tip angle). Samples of many motions begin
    /// with the column motion, the index of the motion.
    fn columns<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        let Self { motions, times, .. } = slf.get();
        slf.py().import("toytop._samples")?.call_method1("columns", (slf, motions, times.numbers.len()))
    }

    fn __len__(&self) -> PyResult<usize> {
        let none = || PyTypeError::new_err("samples at a single time have no length");
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

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, (Py<PyAny>,))> {
        let (object, method, scalar) = &self.origin;
        let options = PyDict::new(py);
        if let Some(scalar) = scalar {
            options.set_item("scalar", scalar.name())?;
        }
        let caller = py.import("operator")?.getattr("methodcaller")?;
        Ok((caller.call((*method, self.own_times(py)?), Some(&options))?, (object.clone_ref(py),)))
    }
}
