//! Samples are computed column by column: an array of one quantity of motions at given times.

use crate::arguments::{Array, NumericArg, array};
use crate::interrupt;
use numpy::PyArrayMethods;
use pyo3::exceptions::PyKeyError;
use pyo3::prelude::*;
use rayon::iter::{IndexedParallelIterator, ParallelIterator};
use rayon::slice::ParallelSliceMut;
use std::sync::Arc;
use toytop::Orientation;
use toytop_host::motion::tip_angle::TipAngle;
use toytop_host::motion::{column::SampleColumn, evaluator::MotionEvaluator, sample::MotionSample};
use toytop_model::equations::Rates;
use toytop_model::motion_with_period::MotionWithPeriod;

/// Quantities of samples that an array can hold.
const COLUMNS: [SampleColumn; 11] = [
    SampleColumn::Quaternion,
    SampleColumn::Axis,
    SampleColumn::U,
    SampleColumn::Udot,
    SampleColumn::Omega,
    SampleColumn::OmegaBody,
    SampleColumn::Tip,
    SampleColumn::TipAngle,
    SampleColumn::ErrorBound,
    SampleColumn::EulerZxz,
    SampleColumn::Angles,
];

/// Evaluator in one scalar.
pub(crate) type SharedEvaluator = Arc<MotionEvaluator>;

/// Source of samples.
pub(crate) enum Source {
    /// A table for each motion, which are evaluated on demand.
    Tables(Vec<SharedEvaluator>),
    /// One point for each time.
    Points(Vec<MotionSample>),
}

/// Number of samples of a job of one thread.
const BLOCK: usize = 8192;

/// Motion at given times, or many of them, whose columns are computed on demand.
#[pyclass(module = "toytop._toytop", frozen)]
pub(crate) struct Sampler {
    /// Times of every motion.
    times: NumericArg,
    /// Number of motions, for a `Many`.
    #[pyo3(get)]
    motions: Option<usize>,
    source: Source,
}

impl Sampler {
    pub(crate) fn new(times: NumericArg, motions: Option<usize>, source: Source) -> Self {
        Self { times, motions, source }
    }

    /// Samples of a method that computes the orientation and the rates at a time, with this error bound if it has one.
    ///
    /// # Errors
    /// `KeyboardInterrupt`.
    pub(crate) fn by_method(
        py: Python<'_>,
        times: NumericArg,
        motion: &MotionWithPeriod,
        error_bound: Option<f64>,
        at: impl Fn(f64) -> (Orientation<f64>, Rates) + Send + Sync,
    ) -> PyResult<Self> {
        let angle = TipAngle::new(motion);
        let points = interrupt::map(py, times.numbers.len(), |index| {
            let t = times.numbers[index];
            let (orientation, rates) = at(t);
            MotionSample { error_bound, ..angle.sample(t, orientation, rates) }
        })?;
        Ok(Self::new(times, None, Source::Points(points)))
    }
}

#[pymethods]
impl Sampler {
    /// Times of every motion.
    #[getter]
    fn times<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, Array>> {
        array(py, self.times.numbers.clone(), &self.times.shape)
    }

    /// Array of the quantity of this name, which cannot be written to.
    fn column<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, Array>> {
        let named = COLUMNS.into_iter().find(|column| column.key() == name);
        let column = named.ok_or_else(|| PyKeyError::new_err(name.to_owned()))?;
        let (times, width) = (&self.times.numbers, column.names().len());
        let mut shape: Vec<_> = self.motions.iter().chain(&self.times.shape).copied().collect();
        if width > 1 {
            shape.push(width);
        }
        // NumPy asks for large pages
        let array = Array::zeros(py, shape, false);
        let mut writer = array.readwrite();
        let numbers = writer.as_slice_mut()?;
        let fill = |motion: usize, first: usize, rows: &mut [f64]| match &self.source {
            Source::Tables(tables) => tables[motion].write(column, &times[first..], rows),
            Source::Points(points) => {
                let rows = points[first..].iter().zip(rows.chunks_exact_mut(width));
                rows.for_each(|(point, row)| column.write(point, row));
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
            interrupt::for_each(py, jobs, |(motion, first, rows)| fill(motion, first, rows))?;
        }
        writer.make_nonwriteable();
        Ok(array)
    }
}
