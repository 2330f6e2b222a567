//! Unknowns of a fit: their order, their units, and the derivatives of a motion with respect to them.

use crate::fit::launch::{FreeRatio, LAUNCH, Launch};
use crate::fit::outcome::{share_of, with_ratios};
use crate::fit::path::Path;
use crate::fit::period::Turns;
use crate::fit::sensor::Sensor;
use crate::fit::triangle::MOST_UNKNOWNS;
use crate::fit::{MOST_RATIOS, MOST_SENSORS};
use crate::motion::Motion;
use crate::scalar::Real;
use crate::sensitivity::{COLUMNS, Coefficients, Equations, LOSSES};
use crate::state::State;
use crate::su2::{Vector, bracket, dot};
use crate::top::{Support, Top};
use core::ops::Range;

/// Order and units of the unknowns.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Model {
    pub(super) top: Top,
    pub(super) given: [f64; 4],
    pub(super) free: [FreeRatio; MOST_RATIOS],
    pub(super) free_count: usize,
    /// Prior deviation of the losses, which are unknowns if there is one.
    pub(super) drift: Option<f64>,
    /// First unknown of each sensor's bias, and its prior deviation.
    pub(super) biases: [Option<(usize, f64)>; MOST_SENSORS],
    pub(crate) count: usize,
}

impl Model {
    pub(crate) fn new<F>(top: &Top, sensors: &[&dyn Sensor<F>], ratios: &[FreeRatio]) -> Self {
        let (a, p, s) = (top.transverse_inertia(), top.mass_moment(), top.com_height());
        let lever = match top.support() {
            Support::Sliding => a / (p * s),
            Support::Fixed => a / p,
            // without effect, but finite, so that its products with 0 are 0
            Support::Free => 1.0,
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

    /// Model whose unknowns include the losses, before the biases. `None` where there are too many unknowns.
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

    /// Number of unknowns that are not biases.
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

    /// Path before the first pass.
    pub(crate) fn path<F: Real>(&self) -> Path<F> {
        let known = match (self.drift, self.free_count) {
            (Some(_), 0) => LAUNCH + LOSSES,
            (None, 0) => LAUNCH,
            _ => COLUMNS,
        };
        Path::new(self.top.tip_scale(), &self.equations(&Launch::default()), known)
    }

    /// Nutation period of a launch, and the rotations during it.
    #[inline(never)] // the top is on the stack only here
    pub(crate) fn turns_in_period(&self, launch: &Launch) -> Option<Turns> {
        let state = State::new(launch.orientation, launch.omega).ok()?;
        if self.free_count == 0 {
            Turns::of(&self.top, &state)
        } else {
            Turns::of(&self.top_of(launch)?, &state)
        }
    }

    /// Motion of a launch.
    pub(crate) fn motion(&self, launch: &Launch) -> Option<Motion> {
        let state = State::new(launch.orientation, launch.omega).ok()?;
        Motion::launch(&self.top_of(launch)?, &state).ok()
    }

    #[inline(never)] // the ratios are on the stack only here
    fn top_of(&self, launch: &Launch) -> Option<Top> {
        if self.free_count == 0 { Some(self.top) } else { with_ratios(&self.top, &self.ratios(launch)).ok() }
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

    /// First integrals l, n and h of a launch: A times those of the model, whose coefficients are relative to A.
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
            // the free ratio, if there is one, takes the place after the losses
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

    /// Derivatives of the four ratios with respect to each unknown that is a direction of them.
    fn ratio_shares(&self, launch: &Launch) -> [[f64; 4]; MOST_RATIOS] {
        let ratios = self.ratios(launch);
        self.free.map(|free| {
            let mut shares = free.direction;
            for (share, ratio) in shares.iter_mut().zip(ratios) {
                *share = share_of(*share, ratio);
            }
            shares
        })
    }

    /// Shares of the columns after those of the launch in the derivative with respect to each unknown that is not a bias.
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

    /// Fills a row from the derivatives with respect to the launch and the four ratios.
    pub(crate) fn fill<F: Real>(
        &self,
        row: &mut [F],
        shares: &[[F; 4]; MOST_RATIOS],
        columns: &[F; COLUMNS],
    ) {
        let (Some((launch, others)), Some((by_launch, by_others))) =
            (row.split_first_chunk_mut::<LAUNCH>(), columns.split_first_chunk::<LAUNCH>())
        else {
            return;
        };
        *launch = *by_launch;
        for (slot, shares) in others.iter_mut().zip(shares).take(self.common() - LAUNCH) {
            let terms = shares.iter().zip(by_others);
            *slot = terms.fold(F::ZERO, |sum, (share, column)| sum + *share * *column);
        }
    }
}
