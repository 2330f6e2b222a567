//! Result of a fit from its best pass.

use crate::fit::fitted::{Drift, Fitted, Reason, Unobservable};
use crate::fit::pass::{Fit, Pass};
use crate::fit::search::Extent;
use crate::least_squares::{Columns, Covariance, MOST_UNKNOWNS, Unknowns};
use crate::model::Estimate;
use crate::sensitivity::{Flow, LAUNCH, Partials, Tangent};
use crate::vector::{UP, Vector, add_scaled, cross, dot, scaled};
use toytop::scalar::Real;

impl<F: Real> Fit<'_, F> {
    /// Result of the best estimate.
    pub(super) fn fitted(&mut self, extent: &Extent, reason: Option<Reason>, alternatives: usize) -> Fitted {
        self.limit_information();
        let launch = self.best.estimate;
        let mut fitted = Fitted {
            epoch: extent.first,
            launch,
            covariance: Covariance::ZERO,
            statistics: self.best.statistics,
            unobservable: Unobservable::default(),
            reason,
            alternatives,
            count: self.model.count,
            coefficients: self.model.coefficients(&launch),
            ratio_shares: self.model.ratio_shares(&launch),
            drift: None,
        };
        fitted.covariance.add_inverse(&self.current.information, self.model.count);
        fitted.covariance.turn(&Flow::launched(&launch.orientation, launch.omega).axes());
        fitted.unobservable = unobservable(&fitted, &self.model.units(&launch));
        if self.model.has_losses() && self.carry_to_end(&mut fitted, extent.last).is_none() {
            fitted.reason = fitted.reason.or(Some(Reason::NotSettled));
        }
        fitted
    }

    /// Copies the information of the best pass to the current one, and limits the deviations of undetermined directions.
    #[inline(never)] // its numbers and the result must not be on the stack together
    fn limit_information(&mut self) {
        let Pass { estimate, information, .. } = &self.best;
        // not larger, so that the covariance keeps the digits of what is determined
        self.current.information.clone_from(information);
        self.model.damp(estimate, information, [0.0, 10.0], &mut self.current.information);
    }

    /// Moves the launch to the last measurement, and adds the drift. `None` where the motion cannot be followed.
    ///
    /// From the last measurement on, the motion is exact (`docs/partials.md`).
    #[inline(never)] // only a fit with a drift needs its matrices
    fn carry_to_end(&self, fitted: &mut Fitted, end: f64) -> Option<()> {
        let span = end - fitted.epoch;
        let (launch, at) = self.model.predicted(&fitted.launch, span)?;
        let rates = self.mean_rates([&fitted.launch, &launch], span);
        // a change of a loss changes nothing at the launch, and the integrals at the end by their gradients
        let [by_l, by_spin, by_h] = at.equations.gradients(&at.flow);
        let [inertia, ..] = at.equations.coefficients;
        let per_time = self.model.top.transverse_inertia() / span;
        let mut rates_by = [[0.0; 3]; MOST_UNKNOWNS];
        for (loss, (slot, tangent)) in rates_by.iter_mut().zip(&at.flow.tangents).enumerate() {
            if self.model.losses().contains(&loss) {
                let change = |by: &Tangent<f64>| dot(by.theta, tangent.theta) + dot(by.eta, tangent.eta);
                *slot = scaled([change(&by_l), inertia * change(&by_spin), change(&by_h)], per_time);
            }
        }
        let covariance = fitted.covariance.of_vector(&rates_by);
        fitted.drift = Some(Drift { rates, covariance, losses: self.model.losses_of(&launch) });
        carry(&mut fitted.covariance, &at);
        (fitted.epoch, fitted.launch) = (end, launch);
        Some(())
    }

    /// Mean rates of l, n and h between two launches that are `span` apart; 0 where that is 0.
    pub(super) fn mean_rates(&self, [before, after]: [&Estimate; 2], span: f64) -> Vector<f64> {
        let change = add_scaled(self.model.integrals(after), self.model.integrals(before), -1.0);
        scaled(change, if span > 0.0 { 1.0 / span } else { 0.0 })
    }
}

/// Propagates the covariance of a launch to the time of these derivatives with respect to the unknowns.
pub(super) fn carry(covariance: &mut Covariance, at: &Partials) {
    let [mut turns, mut rates]: [Columns; 2] = [[[0.0; 3]; MOST_UNKNOWNS]; 2];
    for ((turn, rate), tangent) in turns.iter_mut().zip(&mut rates).zip(&at.flow.tangents) {
        (*turn, *rate) = (tangent.theta, tangent.eta);
    }
    covariance.carry(&turns, &rates);
}

/// Sine of the angle from an undetermined direction within which a named one is called undetermined.
const ALONG: f64 = 0.1;

/// Directions of the launch that the measurements do not determine to one unit.
///
/// With the covariance C in these units, a direction of variance λ counts as λ/(1 + λ), which is about 0 or 1: an eigenvalue of
/// 1 - (1 + C)⁻¹. A named direction d is undetermined if its information d (ε² + C)⁻¹ d is below 1, for a small ε: at a small tilt, yaw and
/// roll are nearly the same rotation.
#[inline(never)] // its matrix must not be on the stack during other work
fn unobservable(fitted: &Fitted, units: &Unknowns) -> Unobservable {
    let Fitted { launch, count, .. } = fitted;
    let factor = |least: f64| {
        let mut factor = fitted.covariance;
        for (i, x) in units.iter().enumerate() {
            for (j, y) in units.iter().enumerate().take(i + 1) {
                factor.set(i, j, factor.get(i, j) / (x * y) + if i == j { least } else { 0.0 });
            }
        }
        factor.factorise(*count);
        factor
    };
    let sum = factor(1.0);
    let squares = (0..*count).flat_map(|index| sum.inverse_row(index)).map(|x| x * x);
    let undetermined = libm::round((*count as f64 - squares.sum::<f64>()).max(0.0)) as usize;
    let sum = factor(ALONG * ALONG);
    let (axis, none) = (launch.orientation.axis(), [0.0; 3]);
    let [yaw, roll, spin] = [[UP, none], [axis, cross(launch.omega, axis)], [none, axis]].map(|direction| {
        let mut along = [0.0; LAUNCH];
        let parts = direction.as_flattened().iter().zip(units);
        along.iter_mut().zip(parts).for_each(|(slot, (x, unit))| *slot = x / unit);
        let inner = |x: &[f64]| x.iter().zip(&along).map(|(x, y)| x * y).sum::<f64>();
        let shares = (0..LAUNCH).map(|index| inner(&sum.inverse_row(index)));
        shares.map(|share| share * share).sum::<f64>() < inner(&along)
    });
    Unobservable { yaw, roll, spin, count: undetermined }
}
