//! Tracking: the fit of each block of measurements begins from the result of the previous block.

use crate::fit::correction::SETTLED;
use crate::fit::fitted::{FitError, Fitted};
use crate::fit::pass::Fit;
use crate::fit::result::carry;
use crate::least_squares::Triangle;
use crate::sensitivity::LAUNCH;
use crate::sensors::Measurement;
use crate::vector::{UNITS, Vector, norm, rotation_vector};
use toytop::scalar::Real;

/// Fit of a block, and its difference from the prediction of the last block.
#[derive(Clone, Copy, Debug)]
pub struct Tracked {
    /// Fit of the block.
    pub fitted: Fitted,
    /// Rotation vector from the predicted to the fitted orientation, rad: the jump to an ephemeris of the new launch.
    pub jump: Vector<f64>,
    /// Rates at which l, n and h changed between the two launches, per unit time.
    pub drift: Vector<f64>,
}

impl<F: Real> Fit<'_, F> {
    /// Fits the next block of measurements from the fit of the last one, carried to it with its covariance.
    ///
    /// * `drift`: standard deviation of the relative change of ω per unit time, as by friction: 1/60 where the spin is lost in a minute
    ///
    /// # Errors
    /// The errors of [`Fit::run`], and [`FitError::OutOfOrder`] where the last fit cannot be followed to the block.
    pub fn track<I>(&mut self, last: &Fitted, drift: f64, measurements: I) -> Result<Tracked, FitError>
    where
        I: Iterator<Item = Measurement> + Clone,
    {
        let extent = self.checked(&measurements)?;
        let span = extent.first - last.epoch;
        let followed = self.model.predicted(&last.launch, span).filter(|_| span >= 0.0);
        let (predicted, at) = followed.ok_or(FitError::OutOfOrder { index: 0 })?;
        let mut covariance = last.covariance;
        carry(&mut covariance, &at);
        let noise = drift * norm(predicted.omega) * span;
        for index in 0..LAUNCH {
            let noise = if index < 3 { 0.5 * span * noise } else { noise };
            covariance.set(index, index, covariance.get(index, index) + noise * noise);
        }
        // the losses may be others now
        for loss in self.model.losses() {
            (0..last.count).for_each(|other| covariance.set(loss, other, 0.0));
            covariance.set(loss, loss, self.model.prior_variance(loss));
        }
        // to changes along the body axes
        let body = predicted.orientation.inverse();
        covariance.turn(&UNITS.map(|axis| body.adjoint(axis)));
        let mut information = Triangle::new(last.count);
        covariance.factorise(last.count);
        for index in 0..last.count {
            information.add(covariance.inverse_row(index).map(F::from_f64), F::ZERO);
        }
        self.prior = Some((predicted, information));
        self.start_from(&predicted);
        let settled = self.settle(&measurements, usize::MAX, SETTLED);
        let fitted = self.fitted(&extent, self.reason(settled), 0);
        self.prior = None;
        let turn = self.best.estimate.orientation.compose(&predicted.orientation.inverse());
        let drift = self.mean_rates([&last.launch, &fitted.launch], fitted.epoch - last.epoch);
        Ok(Tracked { fitted, jump: rotation_vector(&turn), drift })
    }
}
