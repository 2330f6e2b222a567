//! Unknowns of a fit: their order, their units, and how the derivatives of a motion belong to them.

use crate::fit::launch::{FreeRatio, LAUNCH, Launch};
use crate::fit::outcome::{Unobservable, with_ratios};
use crate::fit::path::Path;
use crate::fit::sensor::Sensor;
use crate::fit::triangle::{MOST_UNKNOWNS, Triangle, Unknowns};
use crate::fit::{MOST_RATIOS, MOST_SENSORS};
use crate::motion::{self, Motion};
use crate::phase::Phase;
use crate::scalar::Real;
use crate::sensitivity::{COLUMNS, Coefficients, Equations, LOSSES, total};
use crate::state::State;
use crate::su2::{Orientation, Vector, bracket, dot};
use crate::top::{Support, Top};
use core::ops::Range;

/// Order and units of the unknowns.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Model {
    top: Top,
    given: [f64; 4],
    free: [FreeRatio; MOST_RATIOS],
    free_count: usize,
    /// Prior deviation of the losses, which are unknowns if there is one.
    drift: Option<f64>,
    /// First unknown of each sensor's bias, and its prior deviation.
    biases: [Option<(usize, f64)>; MOST_SENSORS],
    pub(crate) count: usize,
}

impl Model {
    pub(crate) fn new<F>(top: &Top, sensors: &[&dyn Sensor<F>], ratios: &[FreeRatio]) -> Self {
        let (a, p, s) = (top.transverse_inertia(), top.mass_moment(), top.com_height());
        let lever = match top.support() {
            Support::Sliding => a / (p * s),
            Support::Fixed => a / p,
            Support::Free => f64::INFINITY,
        };
        let mut free = [FreeRatio::of([0.0; 4]); MOST_RATIOS];
        for (slot, ratio) in free.iter_mut().zip(ratios) {
            *slot = *ratio;
        }
        let free_count = ratios.len().min(MOST_RATIOS);
        let mut count = LAUNCH + free_count;
        let mut biases = [None; MOST_SENSORS];
        for (slot, sensor) in biases.iter_mut().zip(sensors) {
            let deviation = sensor.bias_deviation();
            if deviation > 0.0 {
                *slot = Some((count, deviation));
                count += 3;
            }
        }
        Self {
            top: *top,
            given: [a / top.axial_inertia(), lever, s, top.gravity()],
            free,
            free_count,
            drift: None,
            biases,
            count,
        }
    }

    /// The same unknowns and the losses, which come before the biases. `None` where there are too many.
    ///
    /// * `deviation`: prior deviation of the losses
    pub(crate) fn with_losses(mut self, deviation: f64) -> Option<Self> {
        if self.drift.is_none() {
            self.count += LOSSES;
            for (first, _) in self.biases.iter_mut().flatten() {
                *first += LOSSES;
            }
        }
        self.drift = Some(deviation);
        (self.common() <= LAUNCH + MOST_RATIOS && self.count <= MOST_UNKNOWNS).then_some(self)
    }

    /// Variance of a loss before any measurement.
    pub(crate) fn loss_variance(&self) -> f64 {
        self.drift.map_or(0.0, |deviation| deviation * deviation)
    }

    pub(crate) fn transverse_inertia(&self) -> f64 {
        self.top.transverse_inertia()
    }

    pub(crate) fn has_losses(&self) -> bool {
        self.drift.is_some()
    }

    /// Number of unknowns that are no biases.
    pub(crate) fn common(&self) -> usize {
        LAUNCH + self.free_count + if self.drift.is_some() { LOSSES } else { 0 }
    }

    /// Places of the losses among the unknowns.
    pub(crate) fn loss_places(&self) -> Range<usize> {
        LAUNCH + self.free_count..self.common()
    }

    /// Directions of the free ratios; 0 for the others.
    pub(crate) fn directions(&self) -> [[f64; 4]; MOST_RATIOS] {
        self.free.map(|free| free.direction)
    }

    /// Path to begin with.
    pub(crate) fn path<F: Real>(&self) -> Path<F> {
        let known = match (self.drift, self.free_count) {
            (Some(_), 0) => LAUNCH + LOSSES,
            (None, 0) => LAUNCH,
            _ => COLUMNS,
        };
        Path::new(self.top.tip_scale(), &self.equations(&Launch::default()), known)
    }

    /// Nutation period of a launch, and the rotations about the vertical and about the axis in it.
    #[inline(never)] // the motion is on the stack only here
    pub(crate) fn turns_in_period(&self, launch: &Launch) -> Option<(f64, [Phase; 2])> {
        let (top, state) = self.top_and_state(launch)?;
        motion::Launch::new(&top, &state).turns_in_period()
    }

    /// Motion of a launch.
    pub(crate) fn motion(&self, launch: &Launch) -> Option<Motion> {
        let (top, state) = self.top_and_state(launch)?;
        Motion::launch(&top, &state).ok()
    }

    fn top_and_state(&self, launch: &Launch) -> Option<(Top, State)> {
        let top = if self.free_count == 0 {
            self.top
        } else {
            with_ratios(&self.top, &self.ratios(launch)).ok()?
        };
        Some((top, State::new(launch.orientation, launch.omega).ok()?))
    }

    /// First bias of a sensor, counted from 0.
    pub(crate) fn bias_of(&self, sensor: usize) -> Option<usize> {
        let (first, _) = self.biases.get(sensor).copied().flatten()?;
        first.checked_sub(self.common())
    }

    /// Ratios A/C, A/(ps), s and g of a launch; A/p in the second place for a fixed tip.
    pub(crate) fn ratios(&self, launch: &Launch) -> [f64; 4] {
        let mut logarithms = [0.0; 4];
        for (free, value) in self.free.iter().take(self.free_count).zip(launch.rest.iter().skip(LAUNCH)) {
            for (slot, share) in logarithms.iter_mut().zip(free.direction) {
                *slot += share * value;
            }
        }
        let mut ratios = self.given;
        for (ratio, logarithm) in ratios.iter_mut().zip(logarithms) {
            if logarithm != 0.0 {
                *ratio *= libm::exp(logarithm);
            }
        }
        ratios
    }

    /// First integrals l, n and h of a launch, from A.
    pub(crate) fn integrals(&self, launch: &Launch) -> Vector<f64> {
        let Coefficients { inertia, moment, height, gravity, rotor, .. } =
            self.equations(launch).coefficients;
        let (axis, omega) = (launch.orientation.axis(), launch.omega);
        let spin = dot(axis, omega);
        let [.., u] = axis;
        let [.., rise] = bracket(omega, axis);
        let [.., vertical] = omega;
        let l = vertical + ((inertia - 1.0) * spin + rotor) * u;
        let energy = 0.5
            * (dot(omega, omega) + (inertia - 1.0) * spin * spin + moment * height * rise * rise)
            + moment * gravity * u;
        [l, inertia * spin + rotor, energy].map(|x| x * self.top.transverse_inertia())
    }

    pub(crate) fn equations(&self, launch: &Launch) -> Equations<f64> {
        let [inertia, lever, height, gravity] = self.ratios(launch);
        let support = self.top.support();
        let moment = match support {
            Support::Sliding => 1.0 / (lever * height),
            Support::Fixed => 1.0 / lever,
            Support::Free => 0.0,
        };
        let rotor = self.top.rotor_momentum() / self.top.transverse_inertia();
        let losses = self.losses(launch);
        let coefficients = Coefficients { inertia: 1.0 / inertia, moment, height, gravity, rotor, losses };
        let mut changes = coefficients.derivatives(support);
        if self.drift.is_some() {
            // the free ratio, if there is one, takes the place behind the losses
            let [ratio, ..] = self.ratio_shares(launch);
            let [axial, across, vertical] = Coefficients::by_losses();
            changes = [axial, across, vertical, Coefficients::combined(&changes, &ratio)];
        }
        Equations { coefficients, changes, lossy: self.drift.is_some() }
    }

    /// Losses of a launch.
    pub(crate) fn losses(&self, launch: &Launch) -> [f64; LOSSES] {
        let mut losses = [0.0; LOSSES];
        for (slot, value) in losses.iter_mut().zip(launch.rest.get(self.loss_places()).unwrap_or(&[])) {
            *slot = *value;
        }
        losses
    }

    /// Derivatives of the four ratios by each unknown that is a direction of them.
    fn ratio_shares(&self, launch: &Launch) -> [[f64; 4]; MOST_RATIOS] {
        let ratios = self.ratios(launch);
        self.free.map(|free| {
            let mut shares = free.direction;
            for (share, ratio) in shares.iter_mut().zip(ratios) {
                *share *= ratio;
            }
            shares
        })
    }

    /// Shares of the columns behind those of the launch in each unknown that is no bias.
    pub(crate) fn shares<F: Real>(&self, launch: &Launch) -> [[F; 4]; MOST_RATIOS] {
        if self.drift.is_none() {
            return self.ratio_shares(launch).map(|shares| shares.map(F::from_f64));
        }
        let [zero, one] = [F::ZERO, F::ONE];
        let losses = [[one, zero, zero, zero], [zero, one, zero, zero], [zero, zero, one, zero]];
        let [axial, across, vertical] = losses;
        if self.free_count > 0 {
            [[zero, zero, zero, one], axial, across, vertical]
        } else {
            [axial, across, vertical, [zero; 4]]
        }
    }

    /// Fills a row from the derivatives by the launch and the four ratios.
    pub(crate) fn fill<F: Real>(
        &self,
        row: &mut [F],
        shares: &[[F; 4]; MOST_RATIOS],
        column: impl Fn(usize) -> F,
    ) {
        for (index, slot) in row.iter_mut().enumerate().take(LAUNCH) {
            *slot = column(index);
        }
        for (slot, shares) in row.iter_mut().skip(LAUNCH).zip(shares).take(self.common() - LAUNCH) {
            let terms = shares.iter().enumerate();
            *slot = terms.fold(F::ZERO, |sum, (index, share)| sum + *share * column(LAUNCH + index));
        }
    }

    /// Adds the information before any measurement; returns the sum of squares of the differences of the launch from it.
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

    /// Standard deviations before any measurement; infinite for none.
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

    /// Unit of each unknown: a radian, a change of ω by its own size, a ratio by its own size, a bias by its prior
    /// deviation, a loss by ten times its own, so that rounding does not make one undetermined that has its prior only.
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

    /// Deviations that damp a correction: Marquardt's, and so many units for directions without information.
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

    /// Launch after a correction. ω is corrected in the frame that the rotation turns, so that a rotation about the
    /// vertical, which may be poorly known, leaves the motion as it is however large it is.
    pub(crate) fn moved<F: Real>(&self, launch: &Launch, change: &Unknowns<F>) -> Launch {
        let change = change.map(F::to_f64);
        let [t1, t2, t3, w1, w2, w3, ..] = change;
        let turn = Orientation::exp([t1, t2, t3]);
        let eta = total([w1, w2, w3], bracket([t1, t2, t3], launch.omega), -1.0);
        let mut rest = launch.rest;
        for (slot, by) in rest.iter_mut().zip(change).skip(LAUNCH) {
            *slot += by;
        }
        Launch {
            orientation: turn.compose(&launch.orientation).normalised(),
            omega: turn.adjoint(total(launch.omega, eta, 1.0)),
            rest,
        }
    }

    /// Adds the information about changes of the launch after a correction, from that about changes of the launch before it.
    ///
    /// A rotation of everything by θ changes ω by θ × ω: with ω the row of a measurement by θ changes, which matters
    /// where the rotation is poorly known. What stays is the row by θ and by the change of ω that an observer sees who
    /// turns with θ, in the frame that the correction turned.
    pub(crate) fn carry<F: Real>(
        information: &Triangle<F>,
        before: &Launch,
        change: &Unknowns<F>,
        after: &Launch,
        to: &mut Triangle<F>,
    ) {
        let [t1, t2, t3, ..] = *change;
        let turn = Orientation::exp([t1, t2, t3].map(F::to_f64));
        to.add_mapped(information, |row| {
            let [x, y, z, p, q, r, ..] = *row;
            let ([x, y, z], by_omega) = ([x, y, z].map(F::to_f64), [p, q, r].map(F::to_f64));
            let by_theta = turn.adjoint(total([x, y, z], bracket(before.omega, by_omega), 1.0));
            let by_omega = turn.adjoint(by_omega);
            let by_theta = total(by_theta, bracket(after.omega, by_omega), -1.0);
            for (slot, entry) in row.iter_mut().zip(by_theta.into_iter().chain(by_omega)) {
                *slot = F::from_f64(entry);
            }
        });
    }

    /// Directions of the launch that the information does not determine to one unit.
    pub(crate) fn unobservable<F: Real>(&self, launch: &Launch, information: &Triangle<F>) -> Unobservable {
        let units = self.units(launch);
        let (values, vectors) = information.singular(&units.map(F::from_f64));
        let count = values.iter().take(self.count).filter(|value| **value < F::ONE).count();
        let axis = launch.orientation.axis();
        let up = [0.0, 0.0, 1.0];
        let none = [0.0; 3];
        // share of a direction that lies in the undetermined ones
        let share = |theta: Vector<f64>, omega: Vector<f64>| {
            let mut direction = [0.0; MOST_UNKNOWNS];
            for ((slot, x), unit) in direction.iter_mut().zip(theta.into_iter().chain(omega)).zip(units) {
                *slot = x / unit;
            }
            let size: f64 = direction.iter().map(|x| x * x).sum();
            let inside: f64 = values
                .iter()
                .zip(&vectors)
                .take(self.count)
                .filter(|(value, _)| **value < F::ONE)
                .map(|(_, vector)| {
                    let inner: f64 = vector.iter().zip(&direction).map(|(a, b)| a.to_f64() * b).sum();
                    inner * inner
                })
                .sum();
            inside / size
        };
        Unobservable {
            yaw: share(up, bracket(up, launch.omega)) > 0.9,
            roll: share(axis, none) > 0.9,
            spin: share(none, axis) > 0.9,
            count,
        }
    }
}
