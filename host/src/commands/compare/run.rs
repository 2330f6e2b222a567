//! One run of the core over a motion, by a stepper or by an ephemeris.

use crate::Failure;
use crate::motion::Scalar;
use crate::motion::cast;
use crate::motion::ephemeris::smallest;
use crate::motion::invariants::first_integrals;
use crate::motion::propagate::{Sample, TimedStepper};
use crate::output::progress::Progress;
use std::time::Instant;
use toytop::scalar::Real;
use toytop::su2::OrientationRate;
use toytop::{Complex, Motion, Top};

/// Samples and cost of a run.
pub(super) struct Run {
    /// Samples in the order of the times, each with the first integrals l, n and h.
    pub(super) samples: Vec<(Sample, [f64; 3])>,
    /// Number of steps of a stepper.
    pub(super) steps: Option<u64>,
    /// Segments and terms of a table, and the bound on its error at the last time, rad.
    pub(super) table: Option<([usize; 2], f64)>,
    /// Median time of a step or of an evaluation, s.
    pub(super) call: f64,
}

/// Number of repetitions of which the median counts.
const REPEATED: usize = 5;

/// Median of the times that repeated runs take.
fn median(mut run: impl FnMut() -> f64) -> f64 {
    let mut times: Vec<f64> = (0..REPEATED).map(|_| run()).collect();
    times.sort_by(f64::total_cmp);
    times[REPEATED / 2]
}

/// Samples in a period.
pub(super) const SAMPLES: u32 = 64;

/// Run of the stepper through the times, in steps of `step`, s.
pub(super) fn step_through(scalar: Scalar, motion: &Motion, times: &[f64], step: f64) -> Run {
    match scalar {
        Scalar::F64 => stepped::<f64>(motion, times, step),
        _ => stepped::<f32>(motion, times, step),
    }
}

fn stepped<R: Real>(motion: &Motion, times: &[f64], step: f64) -> Run {
    let mut progress = Progress::new(0, "steps");
    let (mut samples, mut steps) = (Vec::new(), 0);
    let call = median(|| {
        let mut timed = TimedStepper::<R>::new(motion, step);
        let sample = |&t: &f64| {
            timed.reach(t, &mut progress);
            let stepper = timed.last();
            let sample = Sample::stepped(timed.elapsed(), stepper);
            with_integrals(motion.top(), sample, &stepper.attitude_state().rate)
        };
        samples = times.iter().map(sample).collect();
        steps = timed.steps();
        timed.stepping().as_secs_f64() / steps.max(1) as f64
    });
    Run { samples, steps: Some(steps), table: None, call }
}

/// Run of an ephemeris at the times.
///
/// # Errors
/// [`Failure::Method`]: no table is large enough.
pub(super) fn look_up(scalar: Scalar, motion: &Motion, times: &[f64]) -> Result<Run, Failure> {
    let table = smallest(scalar, motion)?;
    let mut found = Vec::new();
    let call = median(|| {
        let started = Instant::now();
        found = times.iter().map(|&t| table.at(t)).collect();
        started.elapsed().as_secs_f64() / times.len() as f64
    });
    let samples = found.iter().map(|now| with_integrals(motion.top(), now.sample, &now.rate)).collect();
    let last = times.last().copied().unwrap_or(0.0);
    let bound = table.error_bound().after(last * table.ticks_per_time());
    Ok(Run { samples, steps: None, table: Some((table.size(), bound)), call })
}

/// Sample with l, n and h, recomputed in f64 from the core's α, β and their rates, so that they do not contain the rounding of a product.
fn with_integrals<R: Real>(top: &Top, sample: Sample, rate: &OrientationRate<R>) -> (Sample, [f64; 3]) {
    let widen = |z: Complex<R>| cast::complex(z, R::to_f64);
    let phi = sample.orientation();
    let rate = OrientationRate { alpha: widen(rate.alpha), beta: widen(rate.beta) };
    (sample, first_integrals(top, phi.alpha, phi.beta, rate.omega_fixed(&phi)))
}
