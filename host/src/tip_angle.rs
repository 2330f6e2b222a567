//! φ of an ephemeris, continued from t = 0 without going all the way.
//!
//! An orientation says where the tip is, but not how often it has gone round. That is found from a *guide*: the advance in
//! whole nutation periods, plus what one stepper finds in the rest, at most half a period either way. The angle itself is
//! then that of the ephemeris, which is closest to the guide.

use crate::Failure;
use crate::ephemeris::Instant;
use crate::progress::Progress;
use crate::propagate::{Paced, Sample, steps_needed, sweep};
use std::f64::consts::PI;
use toytop::{Averages, Complex, Motion, Regime, Stepper, TipAngle, TipClass};

/// φ at each of the instants, in the order given; `None` where the axis is vertical for ever. `start` is the instant at t = 0,
/// and `noise` is what an orientation may be wrong by, rad.
///
/// Its relative precision is that of `f64`, as long as α and β, whose turns add to those of φ, have turned less than some
/// 10^15 times.
///
/// # Errors
/// As [`steps_needed`].
pub fn continued(
    motion: &Motion,
    start: &Instant,
    instants: &[Instant],
    noise: f64,
) -> Result<Vec<Option<f64>>, Failure> {
    if motion.regime().is_vertical() {
        return Ok(vec![None; instants.len()]);
    }
    let times = || instants.iter().map(|instant| instant.sample.t);
    let guides = match (motion.regime(), motion.averages()) {
        (Regime::Nutating, Some(averages)) => periodic(motion, &averages, start, instants)?,
        (Regime::Aperiodic, _) => rising(motion, &times().collect::<Vec<_>>())?,
        _ => {
            let angle = tip_angle(&Stepper::new(motion));
            times().map(|t| angle.phi.to_radians() + angle.rate * t).collect()
        }
    };
    // a curve that reaches the centre has a signed radius: there the angle is known up to half turns
    let signed = matches!(motion.tip_class(), TipClass::ThroughOrigin | TipClass::Spiral);
    let unit = if signed { PI } else { 2.0 * PI };
    let settle = |(instant, guide): (&Instant, f64)| Some(closest(&instant.sample, guide, unit, noise));
    Ok(instants.iter().zip(guides).map(settle).collect())
}

/// Steps a period of the stepper that guides: its own error should leave no doubt even where the nutation rushes past
/// the vertical.
const GUIDE_STEPS: f64 = 65_536.0;

/// The guide of a motion that nutates.
fn periodic(
    motion: &Motion,
    averages: &Averages,
    start: &Instant,
    instants: &[Instant],
) -> Result<Vec<f64>, Failure> {
    // The place in the period is read off the ephemeris: t less whole periods would lose it at 10^9 of them.
    let shares: Vec<f64> = instants
        .iter()
        .map(|instant| (instant.nutation_phase - start.nutation_phase).principal().to_f64())
        .collect();
    let rests: Vec<f64> = shares.iter().map(|share| share * averages.period).collect();
    let step = averages.period / GUIDE_STEPS;
    let within_period = stepped(motion, &rests, step)?;
    let places = instants.iter().zip(shares).zip(within_period);
    Ok(places
        .map(|((instant, share), phi)| {
            let periods = (instant.sample.t / averages.period - share).round();
            phi + periods * averages.phi_per_period()
        })
        .collect())
}

/// φ of a stepper at each of the times.
fn stepped(motion: &Motion, times: &[f64], step: f64) -> Result<Vec<f64>, Failure> {
    let mut progress = Progress::new(steps_needed(times, step)?, "steps");
    sweep(
        times,
        || Paced::<f64>::new(motion, step),
        |paced, t| {
            paced.reach(t, &mut progress);
            Ok(tip_angle(paced.stepper()).phi.to_radians())
        },
    )
}

/// |β|² of an axis that is vertical but for what no f64 can show.
const UPRIGHT: f64 = 1e-34;

/// The guide of an aperiodic motion: stepped until the axis is upright, in either direction, and from there on at the
/// constant rate that is left, (l + n)/(4A).
fn rising(motion: &Motion, times: &[f64]) -> Result<Vec<f64>, Failure> {
    // at the vertical |β| falls like e^{-λt}; lower down everything is slower
    let (top, e) = (motion.top(), motion.branch_points());
    let lambda = (0.5 * top.p() * top.g() * e.e2_minus_e1 / top.a()).sqrt();
    let step = (1024.0 * lambda).recip();
    let furthest = times.iter().fold(0.0_f64, |most, t| most.max(t.abs()));
    let ends = [1.0, -1.0].map(|sense| upright(motion, sense * step, furthest));
    let held: Vec<f64> = times.iter().map(|&t| ends.iter().fold(t, |t, end| end.hold(t))).collect();
    let within = stepped(motion, &held, step)?;
    let beyond = |((&t, held), phi): ((&f64, &f64), f64)| {
        let rate = ends.iter().find(|end| end.t == *held).map_or(0.0, |end| end.rate);
        phi + rate * (t - held)
    };
    Ok(times.iter().zip(&held).zip(within).map(beyond).collect())
}

/// Where a rise has ended.
struct End {
    t: f64,
    /// φ' from there on.
    rate: f64,
}

impl End {
    /// A time no further than the end.
    fn hold(&self, t: f64) -> f64 {
        if self.t < 0.0 { t.max(self.t) } else { t.min(self.t) }
    }
}

/// Steps until the axis is upright and still rising in the direction of the steps, or `furthest` is passed.
fn upright(motion: &Motion, step: f64, furthest: f64) -> End {
    const BETWEEN_LOOKS: u32 = 64;
    let mut stepper = Stepper::<f64>::new(motion);
    let mut looks = 0.0;
    loop {
        let t = looks * f64::from(BETWEEN_LOOKS) * step;
        let pose = stepper.pose();
        let (beta, rate) = (pose.phi.beta, pose.rate.beta);
        let rising = (beta.conj() * rate).re * step < 0.0 || beta == Complex::ZERO;
        if t.abs() > furthest || (rising && beta.norm_squared() < UPRIGHT) {
            return End { t, rate: tip_angle(&stepper).rate };
        }
        (0..BETWEEN_LOOKS).for_each(|_| stepper.step(step));
        looks += 1.0;
    }
}

fn tip_angle(stepper: &Stepper<f64>) -> TipAngle<f64> {
    // only an axis that is vertical for ever has none, and it has been sorted out
    stepper.tip().angle.unwrap_or(TipAngle { phi: toytop::Turns::ZERO, rate: 0.0 })
}

/// The argument of c, up to multiples of `unit`, that is closest to the guide; the guide itself where it is closer than
/// the noise of c can tell.
fn closest(sample: &Sample, guide: f64, unit: f64, noise: f64) -> f64 {
    let product = sample.alpha * sample.beta;
    let off = remainder(product.im.atan2(product.re) - guide, unit);
    let noise = noise / product.norm_squared().sqrt();
    if off.abs() <= noise || noise.is_nan() { guide } else { guide + off }
}

/// x less the nearest multiple of `unit`.
pub(crate) fn remainder(x: f64, unit: f64) -> f64 {
    x - unit * (x / unit).round()
}
