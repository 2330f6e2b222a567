//! The core's fixed-point stepper taken to given times: it goes by whole ticks; what is left of one is gone in `f64`.

use crate::Failure;
use crate::progress::Progress;
use crate::propagate::Sample;
use fixed::types::I2F30;
use std::time::{Duration, Instant};
use toytop::real::{DoubleDouble, Float};
use toytop::{Complex, ErrorBound, FixedStepper, Motion, NoTickMap, Phi, Stepper, Tick};

/// A stepper with a table of any size.
trait Ticking {
    fn step(&mut self);
    fn step_back(&mut self);
    fn phi(&self) -> Phi<I2F30>;
    fn u(&self) -> I2F30;
    fn in_f64(&self, motion: &Motion) -> Stepper<f64>;
    fn error_bound(&self) -> ErrorBound;
    fn again(&self) -> Box<dyn Ticking>;
}

impl<const SEGMENTS: usize, const TERMS: usize> Ticking for FixedStepper<SEGMENTS, TERMS> {
    fn step(&mut self) {
        Self::step(self);
    }

    fn step_back(&mut self) {
        Self::step_back(self);
    }

    fn phi(&self) -> Phi<I2F30> {
        Self::phi(self)
    }

    fn u(&self) -> I2F30 {
        Self::u(self)
    }

    fn in_f64(&self, motion: &Motion) -> Stepper<f64> {
        Self::in_f64(self, motion)
    }

    fn error_bound(&self) -> ErrorBound {
        Self::error_bound(self)
    }

    fn again(&self) -> Box<dyn Ticking> {
        Box::new(*self)
    }
}

/// Sets up one size.
type SetUp = fn(&Motion, Tick) -> Result<Box<dyn Ticking>, NoTickMap>;

/// The crate's own first.
const SIZES: [SetUp; 3] = [set_up::<32>, set_up::<128>, set_up::<512>];

fn set_up<const SEGMENTS: usize>(motion: &Motion, tick: Tick) -> Result<Box<dyn Ticking>, NoTickMap> {
    Ok(Box::new(FixedStepper::<SEGMENTS, 8>::new(motion, tick)?))
}

/// A fixed-point stepper that knows how long its tick is.
pub struct FixedSteps<'a> {
    motion: &'a Motion,
    stepper: Box<dyn Ticking>,
    /// Of a tick, exactly.
    length: DoubleDouble,
    /// Gone so far; negative backwards.
    ticks: i64,
    stepping: Duration,
}

impl Clone for FixedSteps<'_> {
    fn clone(&self) -> Self {
        Self { stepper: self.stepper.again(), ..*self }
    }
}

impl<'a> FixedSteps<'a> {
    /// At t = 0, to go on in ticks of about `step` in s, by the smallest table that fits.
    ///
    /// # Errors
    /// [`Failure::Method`]: none does, or the motion is aperiodic.
    pub fn new(motion: &'a Motion, step: f64) -> Result<Self, Failure> {
        let seconds = (1e9 / (1.0 + step.recip())).ceil() as u32;
        let ticks = (f64::from(seconds) / step).max(1.0) as u32;
        let refused = |reason: String| Failure::Method(format!("no fixed-point stepper: {reason}"));
        let tick = Tick::ratio(ticks, seconds).map_err(|error| refused(error.to_string()))?;
        let stepper = SIZES[1..].iter().fold(SIZES[0](motion, tick), |found, size| match found {
            Err(NoTickMap::TooCoarse { .. }) => size(motion, tick),
            found => found,
        });
        let length = DoubleDouble::from(f64::from(seconds)) / DoubleDouble::from(f64::from(ticks));
        let stepper = stepper.map_err(|error| refused(error.to_string()))?;
        Ok(Self { motion, stepper, length, ticks: 0, stepping: Duration::ZERO })
    }

    /// Steps on, away from t = 0, to the last tick before `t` in s.
    pub fn reach(&mut self, t: f64, progress: &mut Progress) {
        let ahead = ((DoubleDouble::from(t) - self.elapsed()) / self.length).to_f64();
        let (whole, step): (_, fn(&mut dyn Ticking)) = match t < 0.0 {
            false => (ahead.floor(), |stepper| stepper.step()),
            true => (ahead.ceil(), |stepper| stepper.step_back()),
        };
        let started = Instant::now();
        (0..whole.abs() as u64).for_each(|_| step(&mut *self.stepper));
        self.stepping += started.elapsed();
        self.ticks += whole as i64;
        progress.add(whole.abs() as u64);
    }

    fn elapsed(&self) -> DoubleDouble {
        self.length * DoubleDouble::from(self.ticks as f64)
    }

    /// How far the orientation can be from the truth after so many steps.
    #[must_use]
    pub fn error_bound(&self) -> ErrorBound {
        self.stepper.error_bound()
    }

    /// Steps made.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.ticks.unsigned_abs()
    }

    /// Wall time spent in them.
    #[must_use]
    pub fn stepping(&self) -> Duration {
        self.stepping
    }

    /// At the last tick, in `f64`.
    #[must_use]
    pub fn in_f64(&self) -> Stepper<f64> {
        self.stepper.in_f64(self.motion)
    }

    /// The last tick: α, β and u as fixed point has them, all else from its phases in `f64`.
    #[must_use]
    pub fn sample(&self) -> Sample {
        let exact = |z: Complex<I2F30>| Complex::new(z.re.into(), z.im.into());
        let phi = self.stepper.phi();
        Sample {
            u: self.stepper.u().into(),
            alpha: exact(phi.alpha),
            beta: exact(phi.beta),
            ..Sample::stepped(self.elapsed().to_f64(), &self.in_f64())
        }
    }

    /// A time not further than a tick from the last: the phases of fixed point, taken there and read in `f64`.
    #[must_use]
    pub fn sample_at(&self, t: f64) -> Sample {
        let mut stepper = self.in_f64();
        stepper.step((DoubleDouble::from(t) - self.elapsed()).to_f64());
        Sample::stepped(t, &stepper)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::propagate::period;
    use toytop::{Heaviness, Signs, Start, Top};

    #[test]
    fn every_time_is_reached_in_both_directions() {
        let top = Top::sliding(1.1, 0.8, 0.6, Heaviness::MassMoment(0.9), 1.0).unwrap();
        let motion =
            Motion::from_branch_points(&top, [0.2, 0.8, 1.5], Signs::default(), &Start::default()).unwrap();
        let step = period(&motion) / 512.0;
        for sense in [1.0, -1.0] {
            let mut fixed = FixedSteps::new(&motion, step).unwrap();
            let mut truth = Stepper::<f64>::new(&motion);
            for i in 1..=1000 {
                let t = sense * 0.7 * step * f64::from(i);
                fixed.reach(t, &mut Progress::new(0, "steps"));
                let behind = (t - fixed.elapsed().to_f64()) * sense / fixed.length.to_f64();
                assert!((-1e-9..1.0).contains(&behind), "{behind}");
                truth.step(sense * 0.7 * step);
                let [ours, exact] = [fixed.sample_at(t), Sample::stepped(t, &truth)];
                let off = |a: Complex<f64>, b: Complex<f64>| (a - b).norm_squared().sqrt();
                let error = off(ours.alpha, exact.alpha).hypot(off(ours.beta, exact.beta));
                // the phases have 1e-9 turns and less; a tick away would be 1e-2
                assert!(error < 1e-8 && (ours.phi.unwrap() - exact.phi.unwrap()).abs() < 1e-7, "{error:e}");
            }
        }
    }
}
