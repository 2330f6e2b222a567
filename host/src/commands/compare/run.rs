//! One run of the core over a motion: by a stepper, or by an ephemeris.

use crate::Failure;
use crate::cli::Scalar;
use crate::ephemeris::smallest;
use crate::fixed_steps::FixedSteps;
use crate::invariants::first_integrals;
use crate::progress::Progress;
use crate::propagate::{Paced, Sample};
use std::time::{Duration, Instant};
use toytop::real::Real;
use toytop::su2::PhiRate;
use toytop::{Complex, Motion, Top};

/// What a run gave and took.
pub(super) struct Run {
    pub(super) moments: Vec<Moment>,
    pub(super) effort: Effort,
    /// Wall time of the steps, or of the evaluations, alone.
    pub(super) wall: Duration,
}

/// What it took to get there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Effort {
    /// So many steps.
    Steps(u64),
    /// A table of so many segments and terms, and so many look-ups in it.
    Table { size: [usize; 2], look_ups: u64 },
}

impl Effort {
    /// Steps or look-ups.
    pub(super) fn calls(self) -> u64 {
        match self {
            Self::Steps(calls) | Self::Table { look_ups: calls, .. } => calls,
        }
    }
}

/// A moment of the core.
pub(super) struct Moment {
    pub(super) sample: Sample,
    pub(super) integrals: [f64; 3],
}

/// Samples a period.
pub(super) const SAMPLES: u32 = 64;

/// `count` times over the horizon, evenly spread but at incommensurate places: one in each of `count` equal parts, moved
/// on by multiples of the golden section.
pub(super) fn sample_times(horizon: f64, count: u32) -> impl Iterator<Item = f64> {
    const GOLDEN_SECTION: f64 = 0.618_033_988_749_894_9;
    let part = horizon / f64::from(count);
    (0..count).map(move |i| part * (f64::from(i) + (f64::from(i) * GOLDEN_SECTION).fract()))
}

/// Runs the stepper in steps of `step`, in s, through the times.
pub(super) fn step_through<R: Real>(motion: &Motion, times: &[f64], step: f64) -> Run {
    let horizon = times.last().copied().unwrap_or_default();
    let mut progress = Progress::new((horizon / step) as u64, "steps");
    let mut paced = Paced::<R>::new(motion, step);
    let moments = times
        .iter()
        .map(|&t| {
            paced.reach(t, &mut progress);
            let stepper = paced.stepper();
            moment(motion.top(), Sample::stepped(paced.elapsed(), stepper), &stepper.pose().rate)
        })
        .collect();
    Run { moments, effort: Effort::Steps(paced.steps()), wall: paced.stepping() }
}

/// The same by the fixed-point stepper: at the last tick before each time.
pub(super) fn tick_through(motion: &Motion, times: &[f64], step: f64) -> Result<Run, Failure> {
    let horizon = times.last().copied().unwrap_or_default();
    let mut progress = Progress::new((horizon / step) as u64, "ticks");
    let mut ticks = FixedSteps::new(motion, step)?;
    let moments = times
        .iter()
        .map(|&t| {
            ticks.reach(t, &mut progress);
            moment(motion.top(), ticks.sample(), &ticks.in_f64().pose().rate)
        })
        .collect();
    Ok(Run { moments, effort: Effort::Steps(ticks.steps()), wall: ticks.stepping() })
}

/// Looks the times up in an ephemeris.
pub(super) fn look_up(scalar: Scalar, motion: &Motion, times: &[f64]) -> Result<Run, Failure> {
    let ephemeris = smallest(scalar, motion)?;
    let started = Instant::now();
    let instants: Vec<_> = times.iter().map(|&t| ephemeris.at(t)).collect();
    let wall = started.elapsed();
    let moments =
        instants.iter().map(|instant| moment(motion.top(), instant.sample, &instant.rate)).collect();
    let effort = Effort::Table { size: ephemeris.size(), look_ups: times.len() as u64 };
    Ok(Run { moments, effort, wall })
}

/// ω once more, in f64 from the core's α, β and rates: what is measured is those, not the rounding of a product.
fn moment<R: Real>(top: &Top, sample: Sample, rate: &PhiRate<R>) -> Moment {
    let widen = |z: Complex<R>| Complex::new(z.re.to_f64(), z.im.to_f64());
    let phi = sample.orientation();
    let rate = PhiRate { alpha: widen(rate.alpha), beta: widen(rate.beta) };
    let integrals = first_integrals(top, phi.alpha, phi.beta, rate.omega_fixed(&phi));
    Moment { sample, integrals }
}
