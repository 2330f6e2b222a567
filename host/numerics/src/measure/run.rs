//! One run of the core over a motion, by a stepper or by an ephemeris.

use crate::Failure;
use crate::motion::Scalar;
use crate::motion::cast;
use crate::motion::ephemeris::smallest;
use crate::motion::invariants::first_integrals;
use crate::motion::propagate::{Sample, TimedStepper};
use crate::output::progress::Progress;
use std::time::{Duration, Instant};
use toytop::scalar::Real;
use toytop::su2::OrientationRate;
use toytop::{Complex, Micromath, Motion, Top};

/// Samples and cost of a run.
pub struct Run {
    /// Samples in the order of the times.
    pub samples: Vec<CoreSample>,
    /// Steps or look-ups.
    pub effort: Effort,
    /// Wall time of the steps, or of the evaluations, alone.
    pub wall: Duration,
}

/// Number of operations of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effort {
    /// Number of steps of a stepper.
    Steps(u64),
    /// Segments and terms of a table, and the number of look-ups in it.
    Table {
        /// Number of segments, and of terms of a polynomial.
        size: [usize; 2],
        /// Number of look-ups.
        look_ups: u64,
    },
}

impl Effort {
    /// Number of steps or look-ups.
    pub fn calls(self) -> u64 {
        match self {
            Self::Steps(calls) | Self::Table { look_ups: calls, .. } => calls,
        }
    }
}

/// Sample of the core and the first integrals computed from it.
pub struct CoreSample {
    /// Sample by the stepper or the ephemeris.
    pub sample: Sample,
    /// First integrals l, n and h.
    pub integrals: [f64; 3],
}

/// Samples in a period.
pub const SAMPLES: u32 = 64;

/// `count` times from 0 to `horizon`, s: one in each of `count` equal parts, at a place in its part that is a multiple of the golden
/// section modulo 1.
pub fn sample_times(horizon: f64, count: u32) -> impl Iterator<Item = f64> {
    const GOLDEN_SECTION: f64 = 0.618_033_988_749_894_9;
    let part = horizon / f64::from(count);
    (0..count).map(move |i| part * (f64::from(i) + (f64::from(i) * GOLDEN_SECTION).fract()))
}

/// Run of the stepper through the times, in steps of `step`, s; run of an ephemeris in fixed point, where there is no stepper.
///
/// # Errors
/// [`Failure::Method`]: no table is large enough.
pub fn step_through(scalar: Scalar, motion: &Motion, times: &[f64], step: f64) -> Result<Run, Failure> {
    match scalar {
        Scalar::F64 => Ok(stepped::<f64>(motion, times, step)),
        Scalar::F32 => Ok(stepped::<f32>(motion, times, step)),
        Scalar::Micromath => Ok(stepped::<Micromath>(motion, times, step)),
        Scalar::Q31 | Scalar::Q15 => look_up(scalar, motion, times),
    }
}

fn stepped<R: Real>(motion: &Motion, times: &[f64], step: f64) -> Run {
    let horizon = times.last().copied().unwrap_or_default();
    let mut progress = Progress::new((horizon / step) as u64, "steps");
    let mut timed = TimedStepper::<R>::new(motion, step);
    let samples = times
        .iter()
        .map(|&t| {
            timed.reach(t, &mut progress);
            let stepper = timed.stepper();
            core_sample(
                motion.top(),
                Sample::stepped(timed.elapsed(), stepper),
                &stepper.attitude_state().rate,
            )
        })
        .collect();
    Run { samples, effort: Effort::Steps(timed.steps()), wall: timed.stepping() }
}

/// Run of an ephemeris at the times.
///
/// # Errors
/// [`Failure::Method`]: no table is large enough.
pub fn look_up(scalar: Scalar, motion: &Motion, times: &[f64]) -> Result<Run, Failure> {
    let ephemeris = smallest(scalar, motion)?;
    let started = Instant::now();
    let instants: Vec<_> = times.iter().map(|&t| ephemeris.at(t)).collect();
    let wall = started.elapsed();
    let samples =
        instants.iter().map(|instant| core_sample(motion.top(), instant.sample, &instant.rate)).collect();
    let effort = Effort::Table { size: ephemeris.size(), look_ups: times.len() as u64 };
    Ok(Run { samples, effort, wall })
}

/// Sample with ω recomputed in f64 from the core's α, β and their rates, so that the errors do not contain the rounding of a product.
fn core_sample<R: Real>(top: &Top, sample: Sample, rate: &OrientationRate<R>) -> CoreSample {
    let widen = |z: Complex<R>| cast::complex(z, R::to_f64);
    let phi = sample.orientation();
    let rate = OrientationRate { alpha: widen(rate.alpha), beta: widen(rate.beta) };
    let integrals = first_integrals(top, phi.alpha, phi.beta, rate.omega_fixed(&phi));
    CoreSample { sample, integrals }
}
