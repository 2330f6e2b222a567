//! Stepper of the core at given times: equal steps, and one shorter last step to each time.

use crate::Failure;
use crate::motion::sample::MotionSample;
use crate::motion::times::step_to_each;
use std::convert::Infallible;
use toytop::scalar::Real;
use toytop::{Motion, Phase, Stepper};

/// Greatest number of steps that is computed.
const MAX_STEPS: f64 = 1e10;

/// Number of steps of size `step`, s, that reach all of `times`.
///
/// # Errors
/// [`Failure::input`]: there would be more than 10^10 steps.
pub fn steps_needed(times: &[f64], step: f64) -> Result<u64, Failure> {
    let furthest = |sign: f64| times.iter().fold(0.0_f64, |most, t| most.max(sign * t));
    let steps = (furthest(1.0) + furthest(-1.0)) / step + times.len() as f64;
    if steps > MAX_STEPS {
        let reason = format!("{steps:.1e} steps of {step:.1e} s; must be at most 1e10 steps");
        return Err(Failure::input(reason));
    }
    Ok(steps as u64)
}

/// Samples by the stepper at `times`, in steps of `step`, s. `advanced` is called with the number of steps after each batch.
pub fn samples<R: Real>(
    motion: &Motion,
    times: &[f64],
    step: f64,
    advanced: &dyn Fn(u64),
) -> Vec<MotionSample> {
    let sample = |stepper: &mut TimedStepper<R>, t| {
        stepper.advance_to(t, advanced);
        Ok::<_, Infallible>(MotionSample { t, ..stepper.sample() })
    };
    let Ok(samples) = step_to_each(times, || TimedStepper::new(motion, step), sample);
    samples
}

/// Stepper that reaches any time by whole steps, and one shorter last step on a copy.
pub struct TimedStepper<R> {
    /// Stepper after `whole` steps.
    stepper: Stepper<R>,
    whole: i64,
    /// Step size h > 0, rounded to the scalar.
    step: R,
    /// Stepper at the elapsed time.
    pub last: Stepper<R>,
    elapsed: f64,
    /// Number of steps.
    pub steps: u64,
}

impl<R: Real> TimedStepper<R> {
    /// Stepper at t = 0 with steps of h = `step`, s.
    pub fn new(motion: &Motion, step: f64) -> Self {
        let (stepper, step) = (Stepper::new(motion), R::from_f64(step));
        Self { stepper, whole: 0, step, last: stepper, elapsed: 0.0, steps: 0 }
    }

    /// Steps to the time `t`, s, in either direction. `advanced` is called with the number of steps after each batch.
    pub fn advance_to(&mut self, t: f64, advanced: impl Fn(u64)) {
        const BATCH: u64 = 1 << 16;
        let h = self.step.to_f64();
        let whole = (t / h) as i64;
        let step = if whole < self.whole { -self.step } else { self.step };
        let mut left = whole.abs_diff(self.whole);
        self.steps += left;
        while left > 0 {
            let batch = left.min(BATCH);
            (0..batch).for_each(|_| self.stepper.step(step));
            left -= batch;
            advanced(batch);
        }
        self.whole = whole;
        // exact up to one rounding, because the product is not rounded
        let rest = R::from_f64((-(whole as f64)).mul_add(h, t));
        self.last = self.stepper;
        if rest != R::ZERO {
            self.last.step(rest);
            self.steps += 1;
        }
        self.elapsed = (whole as f64).mul_add(h, rest.to_f64());
    }

    /// Sample at the elapsed time, which contains the rounding of the last step to the scalar.
    pub fn sample(&self) -> MotionSample {
        let tip_angle = self.last.tip_angle().map(Phase::to_radians);
        MotionSample::from_state(self.elapsed, &self.last.attitude_state(), self.last.tip(), tip_angle)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use toytop::{InitialAngles, Signs, Top, TopParameters};
    use toytop_model::motion_with_period::MotionWithPeriod;

    fn motion() -> Motion {
        let top = Top::sliding(&TopParameters {
            transverse_inertia: 1.1,
            axial_inertia: 0.8,
            com_height: 0.6,
            mass_moment: 0.9,
            gravity: 1.0,
            ..TopParameters::default()
        })
        .unwrap();
        Motion::from_branch_points(&top, [0.2, 0.8, 1.5], Signs::default(), &InitialAngles::default())
            .unwrap()
    }

    /// Greatest difference of elapsed and requested time over a million requests, s: 0 in f64, the rounding of one last step in f32.
    fn greatest_gap<R: Real>() -> f64 {
        let step = MotionWithPeriod::new(motion()).characteristic_time() / 4096.0;
        let mut stepper = TimedStepper::<R>::new(&motion(), step);
        let gap = |i: u32| {
            let t = 0.3 * step * f64::from(i);
            stepper.advance_to(t, |_| ());
            (stepper.elapsed - t).abs() / step
        };
        (1..1_000_000).map(gap).fold(0.0, f64::max)
    }

    #[test]
    fn elapsed_time_is_the_requested_time() {
        assert_eq!(greatest_gap::<f64>(), 0.0);
        let single = greatest_gap::<f32>();
        assert!(single > 1e-9 && single < 1e-7, "{single:e}");
    }

    #[test]
    fn a_time_requested_twice_is_reached_once() {
        let mut stepper = TimedStepper::<f32>::new(&motion(), 0.01);
        for i in 1..100 {
            let [once, twice] = [(); 2].map(|()| {
                stepper.advance_to(0.017 * f64::from(i), |_| ());
                (stepper.elapsed, stepper.last)
            });
            assert_eq!(once, twice);
        }
    }

    #[test]
    fn too_many_steps_are_refused_before_the_first() {
        assert_eq!(steps_needed(&[3.0, -2.0, 1.0], 0.5).unwrap(), 13);
        assert!(steps_needed(&[1e10, 1.0], 0.5).is_err());
        assert!(steps_needed(&[-1e10], 0.5).is_err());
    }
}
