//! One run of the core over a motion: by a stepper, or by an ephemeris.

use crate::Failure;
use crate::ephemeris::{Sizes, smallest};
use crate::invariants::first_integrals;
use crate::progress::Progress;
use crate::propagate::{Paced, Sample};
use std::time::{Duration, Instant};
use toytop::real::Real;
use toytop::su2::PhiRate;
use toytop::{Complex, Motion, Phi, Pose, Top};

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
    /// A table of so many segments and terms.
    Table([usize; 2]),
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
            moment(motion.top(), Sample::stepped(paced.elapsed(), stepper), &stepper.pose())
        })
        .collect();
    Run { moments, effort: Effort::Steps(paced.steps()), wall: paced.stepping() }
}

/// Looks the times up in an ephemeris.
pub(super) fn look_up<R: Sizes>(motion: &Motion, times: &[f64]) -> Result<Run, Failure> {
    let ephemeris = smallest::<R>(motion)?;
    let started = Instant::now();
    let instants: Vec<_> = times.iter().map(|&t| ephemeris.at(t)).collect();
    let wall = started.elapsed();
    let moment = |(t, instant): (&f64, &crate::ephemeris::Instant<R>)| {
        moment(motion.top(), Sample::of(*t, &instant.pose, instant.tip, None), &instant.pose)
    };
    let moments = times.iter().zip(&instants).map(moment).collect();
    Ok(Run { moments, effort: Effort::Table(ephemeris.size()), wall })
}

/// ω once more, in f64 from the core's α, β and rates: what is measured is those, not the rounding of a product.
fn moment<R: Real>(top: &Top, sample: Sample, pose: &Pose<R>) -> Moment {
    let widen = |z: Complex<R>| Complex::new(z.re.to_f64(), z.im.to_f64());
    let phi = Phi { alpha: sample.alpha, beta: sample.beta };
    let rate = PhiRate { alpha: widen(pose.rate.alpha), beta: widen(pose.rate.beta) };
    let integrals = first_integrals(top, phi.alpha, phi.beta, rate.omega_fixed(&phi));
    Moment { sample, integrals }
}
