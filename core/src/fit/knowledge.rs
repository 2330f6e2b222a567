//! Information about the unknowns: prior information, units, and the directions that the measurements do not determine.

use crate::fit::launch::{LAUNCH, Launch};
use crate::fit::model::Model;
use crate::fit::outcome::Unobservable;
use crate::fit::triangle::{MOST_UNKNOWNS, Triangle, Unknowns};
use crate::scalar::Real;
use crate::sensitivity::Coefficients;
use crate::su2::{Vector, bracket, dot};

impl Model {
    /// Adds the prior information; returns the sum of squares of the differences of the launch from it.
    #[inline(never)] // its deviations are on the stack only here
    pub(crate) fn add_prior<F: Real>(&self, launch: &Launch, information: &mut Triangle<F>) -> f64 {
        let mut cost = 0.0;
        for (index, (value, deviation)) in launch.rest.iter().zip(self.prior_deviations()).enumerate() {
            if deviation.is_finite() {
                let mut row = [F::ZERO; MOST_UNKNOWNS];
                if let Some(slot) = row.get_mut(index) {
                    *slot = F::from_f64(1.0 / deviation);
                }
                let residual = -value / deviation;
                cost += residual * residual;
                information.add(&row, F::from_f64(residual));
            }
        }
        cost
    }

    /// Prior standard deviations; infinite where there is no prior information.
    fn prior_deviations(&self) -> Unknowns {
        let mut deviations = [f64::INFINITY; MOST_UNKNOWNS];
        for (slot, free) in deviations.iter_mut().skip(LAUNCH).zip(&self.free).take(self.free_count) {
            *slot = free.deviation;
        }
        if let (Some(drift), Some(losses)) = (self.drift, deviations.get_mut(self.loss_places())) {
            losses.fill(drift);
        }
        for (first, deviation) in self.biases.iter().flatten() {
            for slot in deviations.iter_mut().skip(*first).take(3) {
                *slot = *deviation;
            }
        }
        deviations
    }

    /// Unit of each unknown: 1 rad, a change of ω by its own size, a change of a ratio by its own size, the prior
    /// deviation of a bias, and ten times the prior deviation of a loss, so that rounding does not make a loss
    /// undetermined that only its prior determines.
    fn units(&self, launch: &Launch) -> Unknowns {
        let Coefficients { moment, gravity, .. } = self.equations(launch).coefficients;
        let rate = libm::sqrt(dot(launch.omega, launch.omega) + moment * gravity);
        let mut units = [1.0; MOST_UNKNOWNS];
        for slot in units.iter_mut().take(LAUNCH).skip(3) {
            *slot = rate;
        }
        if let (Some(drift), Some(losses)) = (self.drift, units.get_mut(self.loss_places())) {
            losses.fill(10.0 * drift);
        }
        for (first, deviation) in self.biases.iter().flatten() {
            for slot in units.iter_mut().skip(*first).take(3) {
                *slot = *deviation;
            }
        }
        units
    }

    /// Standard deviations that damp a correction: those of Marquardt's method, and `units` units for directions
    /// without information.
    pub(crate) fn damping<F: Real>(
        &self,
        launch: &Launch,
        information: &Triangle<F>,
        damping: f64,
        units: f64,
    ) -> Unknowns<F> {
        let mut deviations = self.units(launch).map(|unit| F::from_f64(units * unit));
        let damping = F::from_f64(damping);
        for (slot, square) in deviations.iter_mut().zip(information.column_squares()) {
            *slot = F::ONE / (damping * square + F::ONE / slot.squared()).sqrt();
        }
        deviations
    }

    /// Directions of the launch that the information does not determine to one unit.
    pub(crate) fn unobservable<F: Real>(&self, launch: &Launch, information: &Triangle<F>) -> Unobservable {
        let units = self.units(launch);
        let axis = launch.orientation.axis();
        let up = [0.0, 0.0, 1.0];
        let none = [0.0; 3];
        // unit vector along a change of the launch
        let direction = |theta: Vector<f64>, omega: Vector<f64>| {
            let mut direction = [F::ZERO; MOST_UNKNOWNS];
            let scaled = theta.into_iter().chain(omega).zip(units).map(|(x, unit)| x / unit);
            let per_size = 1.0 / libm::sqrt(scaled.clone().map(|x| x * x).sum());
            for (slot, x) in direction.iter_mut().zip(scaled) {
                *slot = F::from_f64(x * per_size);
            }
            direction
        };
        let mut directions =
            [direction(up, bracket(up, launch.omega)), direction(axis, none), direction(none, axis)];
        let values = information.singular(&units.map(F::from_f64), &mut directions);
        let is_undetermined = |value: &&F| **value < F::ONE;
        let count = values.iter().take(self.count).filter(is_undetermined).count();
        // whether a direction lies in the space of the undetermined directions
        let [yaw, roll, spin] = directions.map(|components| {
            let along = values.iter().zip(components).take(self.count);
            let share =
                along.filter(|(value, _)| is_undetermined(value)).fold(F::ZERO, |sum, (_, x)| sum + x * x);
            share > F::from_f64(0.9)
        });
        Unobservable { yaw, roll, spin, count }
    }
}
