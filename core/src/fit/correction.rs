//! Correction of the launch after a pass, and the reason why a fit must not be trusted.

use crate::fit::Fit;
use crate::fit::launch::{LAUNCH, Launch};
use crate::fit::model::Model;
use crate::fit::outcome::{Reason, Statistics};
use crate::fit::pass::{FIRST_DAMPING, Progress};
use crate::fit::triangle::{Triangle, Unknowns};
use crate::scalar::Real;
use crate::sensitivity::total;
use crate::su2::{Orientation, Vector, bracket};

/// Estimated size of the next correction, in standard deviations, below which the fit has converged without a pass that
/// confirms it.
const NEXT_SETTLED: f64 = 0.1;
/// Largest correction, in standard deviations, after which the fit converges without such a pass.
const MOST_UNCONFIRMED: f64 = 10.0;
/// Least sine of the tilt at which the fit converges without such a pass.
const LEAST_TILT: f64 = 0.1;
/// Change of the sum of squares that the error of the integration may cause.
const ROUNDING: f64 = 0.05;
/// Number of standard deviations of the sum of squares beyond which the residuals are larger than the noise explains.
const MISFIT: f64 = 5.0;

impl<F: Real> Fit<'_, F> {
    /// Corrects the launch after a pass. The current launch becomes that of the next pass, if there must be one.
    #[inline(never)] // its triangles are on the stack between passes only
    pub(super) fn improve(&mut self, settled: f64) -> Progress {
        let previous = self.best.cost;
        let improved = self.current.cost <= previous && self.current.cost.is_finite();
        if !improved && self.current.cost - previous < ROUNDING {
            return Progress::Settled;
        }
        // a bad fit that hardly improves
        let Statistics { used, outliers, .. } = self.current.statistics;
        if improved && outliers > used / 5 + 10 && previous - self.current.cost < 1e-3 * previous {
            self.best = self.current;
            return Progress::Stuck;
        }
        if improved {
            self.best = self.current;
            self.damping *= 0.1;
        } else {
            self.damping = (10.0 * self.damping).max(FIRST_DAMPING);
            if self.damping > 1e9 || !self.best.cost.is_finite() {
                return Progress::Stuck;
            }
        }
        // the information of the current pass is not needed any more
        let (information, scratch) = (&self.best.information, &mut self.current.information);
        let deviations = self.model.damping(&self.best.launch, information, self.damping, 1000.0);
        scratch.clone_from(information);
        scratch.damp(&deviations);
        let change = scratch.solution();
        if change.iter().any(|x| !x.to_f64().is_finite()) {
            return Progress::Stuck;
        }
        let next = self.model.moved(&self.best.launch, &change);
        let size = information.size(&change).to_f64();
        let last_change = self.last_change.replace(size).filter(|_| improved);
        if let Some(last) = last_change {
            self.curvature = size / (last * last);
        }
        // near the vertical the derivatives themselves depend on the launch
        let [x, y, _] = next.orientation.axis();
        let near = x * x + y * y > LEAST_TILT * LEAST_TILT
            && size < MOST_UNCONFIRMED
            && self.curvature * size * size < NEXT_SETTLED;
        if size < settled || near {
            scratch.clear();
            Model::carry(information, &self.best.launch, &change, &next, scratch);
            self.best.information.clone_from(scratch);
            self.best.launch = next;
            // the correction lowers the sum of squares by this amount, as far as the equations are linear
            self.best.cost -= size * size;
            let statistics = &mut self.best.statistics;
            statistics.chi_squared = (statistics.chi_squared - size * size).max(0.0);
            return Progress::Settled;
        }
        self.current.launch = next;
        Progress::Again
    }

    /// Reason why the best launch must not be trusted.
    pub(super) fn reason(&self, progress: Progress) -> Option<Reason> {
        let statistics = &self.best.statistics;
        match progress {
            Progress::TooFew => Some(Reason::TooFew),
            Progress::NoBeginning => Some(Reason::NoBeginning),
            _ if statistics.used == 0 && statistics.unused > 0 => Some(Reason::AllSaturated),
            _ if statistics.used < LAUNCH as u32 => Some(Reason::TooFew),
            _ if statistics.is_misfit(self.model.count, MISFIT, self.huber) => Some(Reason::Misfit),
            Progress::SpinUnknown => Some(Reason::SpinUnknown),
            Progress::Settled => None,
            Progress::Again | Progress::Stuck => Some(Reason::NotSettled),
        }
    }
}

impl Model {
    /// Launch after a correction. ω is corrected in the frame that the rotation turns. A rotation about the vertical,
    /// which may be large because it is poorly known, then changes nothing else in the motion.
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

    /// Adds the information about changes of the corrected launch, from the information about changes of the launch
    /// before the correction.
    ///
    /// A rotation of the whole motion by θ changes ω by θ × ω. Therefore the derivatives of a measurement with respect
    /// to θ at constant ω change with ω, which matters where the rotation is poorly known. The derivatives with
    /// respect to θ and to the change of ω in a frame that turns by θ do not change, in coordinates that the
    /// correction rotated.
    pub(crate) fn carry<F: Real>(
        information: &Triangle<F>,
        before: &Launch,
        change: &Unknowns<F>,
        after: &Launch,
        to: &mut Triangle<F>,
    ) {
        let [t1, t2, t3, ..] = *change;
        let turn = Orientation::exp([t1, t2, t3].map(F::to_f64));
        // columns of the rotation matrix, in the scalar of the rows
        let cast = |x: Vector<f64>| x.map(F::from_f64);
        let [x_axis, y_axis, z_axis] =
            [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|axis| cast(turn.adjoint(axis)));
        let turned = |[x, y, z]: Vector<F>| total(total(x_axis.map(|c| c * x), y_axis, y), z_axis, z);
        let (before, after) = (cast(before.omega), cast(after.omega));
        to.add_mapped(information, |row| {
            let [x, y, z, p, q, r, ..] = *row;
            let by_theta = turned(total([x, y, z], bracket(before, [p, q, r]), F::ONE));
            let by_omega = turned([p, q, r]);
            let by_theta = total(by_theta, bracket(after, by_omega), -F::ONE);
            for (slot, entry) in row.iter_mut().zip(by_theta.into_iter().chain(by_omega)) {
                *slot = entry;
            }
        });
    }
}
