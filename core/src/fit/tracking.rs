//! Tracking: the fit of each block of measurements begins from the result of the previous block.

use crate::fit::Fit;
use crate::fit::instruments::rotation_vector;
use crate::fit::launch::Launch;
use crate::fit::outcome::{FitError, Fitted};
use crate::fit::pass::SETTLED;
use crate::fit::sensor::Measurement;
use crate::fit::triangle::{MOST_UNKNOWNS, Symmetric, Triangle, Unknowns};
use crate::fit::window::Window;
use crate::scalar::Real;
use crate::sensitivity::{Partials, Sensitivity, total};
use crate::su2::{Vector, bracket, dot};

/// Knowledge of a launch before its measurements.
#[derive(Clone, Copy, Debug)]
pub(super) struct Prior<F> {
    launch: Launch,
    information: Triangle<F>,
}

/// Fit of a block, and how it differs from what the last block predicted.
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
    /// * `drift`: standard deviation of the relative change of ω per unit time by what the model does not contain, such
    ///   as friction: 1/60 where the spin is lost in a minute
    ///
    /// # Errors
    /// As [`Fit::run`], and [`FitError::OutOfOrder`] for a block before the last one.
    pub fn track<I>(&mut self, last: &Fitted, drift: f64, measurements: I) -> Result<Tracked, FitError>
    where
        I: Iterator<Item = Measurement> + Clone,
    {
        let (epoch, _) = self.checked(measurements.clone())?;
        let span = epoch - last.epoch;
        let motion = self.model.motion(&last.launch).ok_or(FitError::OutOfOrder { index: 0 })?;
        let partials = (span >= 0.0)
            .then(|| Sensitivity::of(&motion).at(span))
            .flatten()
            .ok_or(FitError::OutOfOrder { index: 0 })?;
        let mut predicted = last.launch;
        predicted.orientation = partials.orientation_now();
        predicted.omega = partials.angular_velocity();
        let covariance = carried_covariance(last, &partials, drift, span);
        let mut information = Triangle::new(last.count);
        for row in inverse_factor(&covariance, last.count).iter().take(last.count) {
            information.add(&row.map(F::from_f64), F::ZERO);
        }
        self.prior = Some(Prior { launch: predicted, information });
        self.start(predicted);
        let progress = self.settle(Window::all(measurements), SETTLED);
        let fitted = self.fitted(epoch, self.reason(progress), 0);
        self.prior = None;
        let turn = fitted.launch.orientation.compose(&predicted.orientation.inverse());
        let [before, after] = [&last.launch, &fitted.launch].map(|launch| self.model.integrals(launch));
        let per_time = if span > 0.0 { 1.0 / span } else { 0.0 };
        let drift = total(after, before, -1.0).map(|x| x * per_time);
        Ok(Tracked { fitted, jump: rotation_vector(&turn), drift })
    }
}

impl<F: Real> Prior<F> {
    /// Information of the prior about changes of a launch, and the sum of squares by which the launch contradicts it.
    pub(super) fn information(&self, launch: &Launch) -> (Triangle<F>, f64) {
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
        let (information, size) = self.information.towards(&change.map(|x| F::from_f64(-x)));
        (information, size.to_f64() * size.to_f64())
    }
}

/// Covariance of the launch at a later time, with the drift of ω.
fn carried_covariance(last: &Fitted, at: &Partials, drift: f64, span: f64) -> Symmetric {
    let [theta, omega] = [at.orientation(), at.omega()].map(|columns| last.columns(&columns));
    let mut map = [[0.0; MOST_UNKNOWNS]; MOST_UNKNOWNS];
    for (index, row) in map.iter_mut().enumerate() {
        let columns = if index < 3 { &theta } else { &omega };
        for (slot, column) in row.iter_mut().zip(columns) {
            *slot = column.get(index % 3).copied().unwrap_or(0.0);
        }
        if index >= 6 {
            *row = [0.0; MOST_UNKNOWNS];
            if let Some(slot) = row.get_mut(index) {
                *slot = 1.0;
            }
        }
    }
    let mut half = [[0.0; MOST_UNKNOWNS]; MOST_UNKNOWNS];
    for (target, row) in half.iter_mut().zip(&map) {
        for (weight, line) in row.iter().zip(&last.covariance) {
            for (slot, entry) in target.iter_mut().zip(line) {
                *slot += weight * entry;
            }
        }
    }
    let mut carried = [[0.0; MOST_UNKNOWNS]; MOST_UNKNOWNS];
    let speed = libm::sqrt(dot(at.angular_velocity(), at.angular_velocity()));
    let lost = drift * speed * span;
    for (index, (target, row)) in carried.iter_mut().zip(&half).enumerate() {
        for (slot, other) in target.iter_mut().zip(&map) {
            *slot = row.iter().zip(other).map(|(a, b)| a * b).sum();
        }
        let noise = match index {
            0..3 => 0.5 * lost * span,
            3..6 => lost,
            _ => 0.0,
        };
        if let Some(slot) = target.get_mut(index) {
            *slot += noise * noise;
        }
    }
    carried
}

/// Rows of L⁻¹ of a covariance L Lᵀ of so many unknowns. A pivot that rounding made negative counts as known to 1e-12.
fn inverse_factor(covariance: &Symmetric, count: usize) -> Symmetric {
    let mut rest = *covariance;
    let mut inverse = [[0.0; MOST_UNKNOWNS]; MOST_UNKNOWNS];
    for (index, row) in inverse.iter_mut().enumerate() {
        if let Some(slot) = row.get_mut(index) {
            *slot = 1.0;
        }
    }
    // elimination of the columns one after another, with the same operations on the identity
    for pivot in 0..count.min(MOST_UNKNOWNS) {
        let (Some(&line), Some(&image)) = (rest.get(pivot), inverse.get(pivot)) else { continue };
        let size = line.get(pivot).copied().unwrap_or(0.0).max(1e-24);
        let eliminate = |target: &mut Unknowns, by: f64, source: &Unknowns| {
            for (slot, entry) in target.iter_mut().zip(source) {
                *slot -= by * entry;
            }
        };
        for (lower, below) in rest.iter_mut().zip(&mut inverse).skip(pivot + 1) {
            let by = lower.get(pivot).copied().unwrap_or(0.0) / size;
            eliminate(lower, by, &line);
            eliminate(below, by, &image);
        }
        if let Some(row) = inverse.get_mut(pivot) {
            let scale = 1.0 / libm::sqrt(size);
            *row = image.map(|x| x * scale);
        }
    }
    inverse
}
