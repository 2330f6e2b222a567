//! Tracking: the fit of each block of measurements begins from the result of the previous block.

use crate::fit::Fit;
use crate::fit::instruments::rotation_vector;
use crate::fit::launch::{LAUNCH, Launch};
use crate::fit::outcome::{FitError, Fitted};
use crate::fit::pass::SETTLED;
use crate::fit::search::Found;
use crate::fit::sensor::Measurement;
use crate::fit::triangle::{MOST_UNKNOWNS, Triangle};
use crate::fit::window::Part;
use crate::scalar::Real;
use crate::sensitivity::{Sensitivity, total};
use crate::su2::{Vector, bracket, dot};

/// Prior information about a launch.
#[derive(Clone, Copy, Debug)]
pub(super) struct Prior<F> {
    launch: Launch,
    information: Triangle<F>,
}

/// Fit of a block, and its difference from the prediction of the last block.
#[derive(Clone, Copy, Debug)]
pub struct Tracked {
    /// Fit of the block.
    pub fitted: Fitted,
    /// Rotation vector from the predicted to the fitted orientation at the epoch of the block, rad: the jump that an
    /// ephemeris of the new launch makes.
    pub jump: Vector<f64>,
    /// Rates at which l, n and h changed between the two launches, per unit time. The exact motion keeps them.
    pub drift: Vector<f64>,
}

impl<F: Real> Fit<'_, F> {
    /// Fits the next block of measurements from the fit of the last one, which is carried to the first time of the
    /// block together with its covariance.
    ///
    /// * `drift`: standard deviation of the relative change of ω per unit time that the model does not contain, such as
    ///   that by friction: 1/60 where the spin is lost in a minute
    ///
    /// # Errors
    /// The errors of [`Fit::run`], and [`FitError::OutOfOrder`] for a block before the last one, and where the motion of the last fit
    /// cannot be followed to the block.
    pub fn track<I>(&mut self, last: &Fitted, drift: f64, measurements: I) -> Result<Tracked, FitError>
    where
        I: Iterator<Item = Measurement> + Clone,
    {
        let (times, _) = self.checked(&measurements)?;
        let [epoch, _] = times;
        let span = epoch - last.epoch;
        let motion = self.model.motion(&last.launch).ok_or(FitError::OutOfOrder { index: 0 })?;
        let partials = (span >= 0.0)
            .then(|| Sensitivity::of(&motion).at(span))
            .flatten()
            .ok_or(FitError::OutOfOrder { index: 0 })?;
        let mut predicted = last.launch;
        predicted.orientation = partials.orientation_now();
        predicted.omega = partials.angular_velocity();
        let columns = [partials.orientation(), partials.omega()].map(|columns| last.columns(&columns));
        let mut covariance = last.covariance;
        covariance.carry(&columns);
        let [theta, omega] = [0.5 * span, 1.0].map(|share| share * drift * speed(predicted.omega) * span);
        for index in 0..LAUNCH {
            let noise = if index < 3 { theta } else { omega };
            if let Some(slot) = covariance.entry(index, index) {
                *slot += noise * noise;
            }
        }
        self.model.forget_losses(&mut covariance);
        let mut information = Triangle::new(last.count);
        covariance.factorise(last.count);
        for index in 0..last.count {
            information.add(&covariance.inverse_row(index).map(F::from_f64), F::ZERO);
        }
        self.prior = Some(Prior { launch: predicted, information });
        self.start_from(&predicted);
        let progress = self.settle(&measurements, Part::ALL, SETTLED);
        let fitted = self.fitted(&Found { times, progress, alternatives: 0 });
        self.prior = None;
        let turn = self.best.launch.orientation.compose(&predicted.orientation.inverse());
        let [before, after] = [&last.launch, &fitted.launch].map(|launch| self.model.integrals(launch));
        let between = fitted.epoch - last.epoch;
        let per_time = if between > 0.0 { 1.0 / between } else { 0.0 };
        let drift = total(after, before, -1.0).map(|x| x * per_time);
        Ok(Tracked { fitted, jump: rotation_vector(&turn), drift })
    }
}

impl<F: Real> Prior<F> {
    /// Replaces `information` by that of the prior about changes of a launch. Returns the sum of squares of the
    /// difference of the launch from the prior.
    pub(super) fn add_to(&self, launch: &Launch, information: &mut Triangle<F>) -> f64 {
        let turn = launch.orientation.compose(&self.launch.orientation.inverse());
        let theta = rotation_vector(&turn);
        let eta = total(turn.inverse().adjoint(launch.omega), self.launch.omega, -1.0);
        let moved = theta.into_iter().chain(total(eta, bracket(theta, self.launch.omega), 1.0));
        let mut change = [0.0; MOST_UNKNOWNS];
        for (slot, (now, then)) in change.iter_mut().zip(launch.rest.iter().zip(&self.launch.rest)) {
            *slot = now - then;
        }
        for (slot, by) in change.iter_mut().zip(moved) {
            *slot = by;
        }
        information.clone_from(&self.information);
        let size = information.point_to(&change.map(|x| F::from_f64(-x))).to_f64();
        size * size
    }
}

fn speed(omega: Vector<f64>) -> f64 {
    libm::sqrt(dot(omega, omega))
}
