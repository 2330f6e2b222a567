//! Runs of the core's propagators through the times of a comparison.

use super::bounds::{stepper_bound, steps_per_period};
use crate::arguments::options::Method;
use std::time::Instant;
use toytop::scalar::Real;
use toytop_host::Failure;
use toytop_host::motion::Scalar;
use toytop_host::motion::evaluator::MotionEvaluator;
use toytop_host::motion::sample::MotionSample;
use toytop_host::motion::stepper::TimedStepper;
use toytop_model::motion_with_period::MotionWithPeriod;

/// Run of a propagator; empty where no table is large enough.
#[derive(Default)]
pub struct Propagation {
    /// Samples in the order of the times.
    pub samples: Vec<MotionSample>,
    /// Number of steps of a stepper.
    pub steps: Option<u64>,
    /// Segments and terms of a table.
    pub table: Option<String>,
    /// Bound on the error at the last time, rad.
    pub bound: f64,
    /// Median time of a step or of a look-up.
    pub ns: Option<f64>,
}

/// Samples at the times, and the computing time of one, ns: the median of five parts of the times.
fn timed_samples(times: &[f64], mut sample: impl FnMut(f64) -> MotionSample) -> (Vec<MotionSample>, f64) {
    let (mut samples, mut spent) = (Vec::new(), Vec::new());
    for part in times.chunks(times.len().div_ceil(5)) {
        let started = Instant::now();
        samples.extend(part.iter().map(|&t| sample(t)));
        spent.push(1e9 * started.elapsed().as_secs_f64() / part.len() as f64);
    }
    spent.sort_by(f64::total_cmp);
    (samples, spent[spent.len() / 2])
}

/// Run of a method at the times, which cover this number of periods.
///
/// # Errors
/// [`Failure::method`]: no table is large enough, or the motion is aperiodic and the scalar is not `f64`.
pub fn propagate(
    (method, scalar): (Method, Scalar),
    motion: &MotionWithPeriod,
    times: &[f64],
    periods: u32,
) -> Result<Propagation, Failure> {
    let stepper = match (method, scalar) {
        (Method::Table, _) => return propagate_by_table(scalar, motion, times),
        (_, Scalar::F64) => propagate_by_stepper::<f64>,
        _ => propagate_by_stepper::<f32>,
    };
    Ok(Propagation { bound: stepper_bound(motion, scalar, periods), ..stepper(scalar, motion, times) })
}

/// Run of the stepper through the times.
fn propagate_by_stepper<R: Real>(scalar: Scalar, motion: &MotionWithPeriod, times: &[f64]) -> Propagation {
    let step = motion.characteristic_time() / f64::from(steps_per_period(scalar));
    let mut timed = TimedStepper::<R>::new(motion, step);
    let (samples, ns) = timed_samples(times, |t| {
        timed.advance_to(t, |_| ());
        timed.sample()
    });
    let ns = ns * times.len() as f64 / timed.steps.max(1) as f64;
    Propagation { samples, steps: Some(timed.steps), ns: Some(ns), ..Propagation::default() }
}

/// Run of a table or a closed form at the times.
fn propagate_by_table(
    scalar: Scalar,
    motion: &MotionWithPeriod,
    times: &[f64],
) -> Result<Propagation, Failure> {
    let evaluator = MotionEvaluator::new(motion, scalar)?;
    let (samples, ns) = timed_samples(times, |t| evaluator.at(t));
    let ticks = times.last().map_or(0.0, |last| last * evaluator.ticks_per_time);
    let table = evaluator.size.map(|[segments, terms]| format!("{segments}x{terms}"));
    Ok(Propagation { samples, table, bound: evaluator.error_bound.after(ticks), ns: Some(ns), steps: None })
}
