//! End of a fit with a drift: the launch of the last measurement, and the rates of the first integrals.
//!
//! The losses are unknowns of the fit, and the motion that is compared with the measurements contains them
//! (`docs/partials.md`). After the fit the launch is that of the last measurement, from where on the motion is exact.

use crate::fit::Fit;
use crate::fit::covariance::Covariance;
use crate::fit::drift::Drift;
use crate::fit::model::Model;
use crate::fit::outcome::Fitted;
use crate::fit::triangle::MOST_UNKNOWNS;
use crate::scalar::Real;
use crate::sensitivity::{COLUMNS, Flow, LOSSES, Sensitivity};
use crate::su2::Vector;

/// Number of instants at which the rates of l, n and h are averaged.
const INSTANTS: u32 = 64;

impl<F: Real> Fit<'_, F> {
    /// Moves the launch to the last measurement, and adds the drift. `None` where the motion cannot be followed.
    #[inline(never)] // only a fit with a drift needs its matrices
    pub(super) fn carry_to_end(&self, fitted: &mut Fitted, end: f64) -> Option<()> {
        let (model, span) = (&self.model, end - fitted.epoch);
        let equations = model.equations(&fitted.launch);
        let start = Flow::launched(&fitted.launch.orientation, fitted.launch.omega);
        let sensitivity = Sensitivity::losing(&equations, start, 0.0);
        let mut cursor = sensitivity.cursor();
        let mut by = [[0.0; 3]; LOSSES];
        for instant in 0..INSTANTS {
            let at = cursor.at(span * (f64::from(instant) + 0.5) / f64::from(INSTANTS))?;
            for (slot, rates) in by.iter_mut().zip(equations.integral_rates(&at.flow)) {
                for (sum, rate) in slot.iter_mut().zip(rates) {
                    *sum += rate * model.transverse_inertia() / f64::from(INSTANTS);
                }
            }
        }
        let at = cursor.at(span)?;
        let shares = model.shares(&fitted.launch);
        let columns = [at.orientation(), at.omega()].map(|columns| model.columns(&shares, &columns));
        fitted.covariance.carry(&columns);
        let losses = model.losses(&fitted.launch);
        fitted.drift = Some(Drift::of(losses, &by, &model.losses_of(&fitted.covariance)));
        fitted.epoch = end;
        fitted.launch.orientation = at.orientation_now();
        fitted.launch.omega = at.angular_velocity();
        Some(())
    }
}

impl Model {
    /// Derivatives of a vector with respect to the unknowns, from its columns.
    fn columns(&self, shares: &[[f64; 4]; 4], by: &[Vector<f64>; COLUMNS]) -> [Vector<f64>; MOST_UNKNOWNS] {
        let mut columns = [[0.0; 3]; MOST_UNKNOWNS];
        for component in 0..3 {
            let mut row = [0.0; MOST_UNKNOWNS];
            let entries = by.map(|column| column.get(component).copied().unwrap_or(0.0));
            self.fill(&mut row, shares, &entries);
            for (column, entry) in columns.iter_mut().zip(row) {
                if let Some(slot) = column.get_mut(component) {
                    *slot = entry;
                }
            }
        }
        columns
    }

    /// Covariance of the losses.
    fn losses_of(&self, covariance: &Covariance) -> [Vector<f64>; LOSSES] {
        let first = self.loss_places().start;
        [0, 1, 2].map(|i| [0, 1, 2].map(|j| covariance.of(first + i, first + j)))
    }

    /// Makes the losses as uncertain as before any measurement, because the losses at another time may differ.
    pub(super) fn forget_losses(&self, covariance: &mut Covariance) {
        for loss in self.loss_places() {
            for other in 0..self.count {
                if let Some(slot) = covariance.entry(loss, other) {
                    *slot = if loss == other { self.loss_variance() } else { 0.0 };
                }
            }
        }
    }
}
