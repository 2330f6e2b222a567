//! One row: a motion in one scalar, against the full solver.

use crate::Failure;
use crate::invariants::first_integrals;
use crate::progress::Progress;
use crate::propagate::{Paced, Sample};
use crate::scenario::Scenario;
use crate::truth;
use std::time::Duration;
use toytop::real::Real;
use toytop::{Complex, Motion, Top};

/// The greatest errors over all samples.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Errors {
    /// 2 √(|Δα|² + |Δβ|²), rad.
    pub(super) orientation: f64,
    pub(super) u: f64,
    /// Of the tip, in units of s.
    pub(super) tip: f64,
    /// Of l, n and h as recomputed from α, β and their rates, in units of [`natural_scales`].
    pub(super) integrals: [f64; 3],
}

/// What a run of the stepper gave and took.
#[derive(Clone, Copy, Debug)]
pub(super) struct Measured {
    pub(super) errors: Errors,
    pub(super) steps: u64,
    /// Wall time of the steps alone.
    pub(super) wall: Duration,
}

/// Samples a period.
pub(super) const SAMPLES: u32 = 64;

/// A moment of the core.
struct Moment {
    sample: Sample,
    integrals: [f64; 3],
}

/// Runs the stepper in steps of `step` over `horizon`, both in s, made of `periods` periods, and the full solver to the same
/// moments.
pub(super) fn measure<R: Real>(
    scenario: &Scenario,
    step: f64,
    horizon: f64,
    periods: u32,
) -> Result<Measured, Failure> {
    let motion = &scenario.motion;
    let count = SAMPLES * periods;
    let mut progress = Progress::new((horizon / step) as u64, "steps");
    let mut paced = Paced::<R>::new(motion, step);
    let moments: Vec<Moment> = sample_times(horizon, count)
        .map(|t| {
            paced.reach(t, &mut progress);
            moment(motion.top(), &paced)
        })
        .collect();
    // The truth at the times the core has truly gone through: an f32 step lands next to the time asked for.
    let times: Vec<f64> = moments.iter().map(|moment| moment.sample.t).collect();
    let truths = truth::states(scenario, &times)?;

    let mut errors = Errors::default();
    let scales = natural_scales(motion);
    let constants = motion.first_integrals();
    for (Moment { sample, integrals }, truth) in moments.iter().zip(&truths) {
        let (alpha, beta) = (complex(truth.alpha), complex(truth.beta));
        let (alpha_error, beta_error) = (sample.alpha - alpha, sample.beta - beta);
        let distance = (alpha_error.norm_squared() + beta_error.norm_squared()).sqrt();
        let tip = (alpha * beta).scaled(2.0);
        let tip_error = sample.tip.scaled(1.0 / motion.top().tip_scale()) - tip;
        worsen(&mut errors.orientation, 2.0 * distance);
        worsen(&mut errors.u, (sample.u - (alpha.norm_squared() - beta.norm_squared())).abs());
        worsen(&mut errors.tip, tip_error.norm_squared().sqrt());
        let differences =
            [integrals[0] - constants.l, integrals[1] - constants.n, integrals[2] - constants.h];
        for ((worst, difference), scale) in errors.integrals.iter_mut().zip(differences).zip(scales) {
            worsen(worst, difference.abs() / scale);
        }
    }
    Ok(Measured { errors, steps: paced.steps(), wall: paced.stepping() })
}

/// `count` times over the horizon, evenly spread but at incommensurate places: one in each of `count` equal parts, moved
/// on by multiples of the golden section.
fn sample_times(horizon: f64, count: u32) -> impl Iterator<Item = f64> {
    const GOLDEN_SECTION: f64 = 0.618_033_988_749_894_9;
    let part = horizon / f64::from(count);
    (0..count).map(move |i| part * (f64::from(i) + (f64::from(i) * GOLDEN_SECTION).fract()))
}

fn moment<R: Real>(top: &Top, paced: &Paced<R>) -> Moment {
    let sample = Sample::of(paced.elapsed(), paced.stepper());
    // ω once more, in f64 from the core's α, β and rates: what is measured is those, not the rounding of a product
    let pose = paced.stepper().pose();
    let widen = |z: Complex<R>| Complex::new(z.re.to_f64(), z.im.to_f64());
    let phi = toytop::Phi { alpha: sample.alpha, beta: sample.beta };
    let rate = toytop::su2::PhiRate { alpha: widen(pose.rate.alpha), beta: widen(pose.rate.beta) };
    let omega = rate.omega_fixed(&phi);
    Moment { sample, integrals: first_integrals(top, phi.alpha, phi.beta, omega) }
}

fn complex([re, im]: [f64; 2]) -> Complex<f64> {
    Complex::new(re, im)
}

/// The greatest so far; a NaN stays.
fn worsen(worst: &mut f64, error: f64) {
    if error > *worst || error.is_nan() {
        *worst = error;
    }
}

/// Of l, n and h: the greater of the motion's own and of what the top's weight makes natural, √(2 A p g) and p g.
fn natural_scales(motion: &Motion) -> [f64; 3] {
    let (top, constants) = (motion.top(), motion.first_integrals());
    let weight = top.p() * top.g();
    let momentum = (2.0 * top.a() * weight).sqrt().max(constants.l.abs()).max(constants.n.abs());
    [momentum, momentum, weight.max(constants.h.abs())]
}
