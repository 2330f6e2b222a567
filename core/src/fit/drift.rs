//! Drift of the first integrals during the measurements, caused by a loss of rotation.

use crate::sensitivity::LOSSES;
use crate::su2::Vector;

/// Drift of the first integrals, averaged over the time of the measurements.
#[derive(Clone, Copy, Debug)]
pub struct Drift {
    /// Rates of change of l, n and h, per unit time.
    pub rates: Vector<f64>,
    /// Covariance of the rates.
    pub covariance: [Vector<f64>; 3],
    /// Losses of rotation about the axis, across it, and about the vertical, in units of the rotation itself per unit time.
    pub losses: Vector<f64>,
}

impl Drift {
    /// Names of the losses, in order.
    pub const LOSSES: [&'static str; LOSSES] = ["loss_axial", "loss_across", "loss_vertical"];

    /// Standard deviations of the rates.
    #[must_use]
    pub fn deviations(&self) -> Vector<f64> {
        let [[l, ..], [_, n, _], [.., h]] = self.covariance;
        [l, n, h].map(libm::sqrt)
    }

    /// Drift caused by losses with this covariance.
    ///
    /// * `by`: derivatives of the rates with respect to each loss
    pub(super) fn of(
        losses: Vector<f64>,
        by: &[Vector<f64>; LOSSES],
        of_losses: &[Vector<f64>; LOSSES],
    ) -> Self {
        let mut rates = [0.0; 3];
        let mut covariance = [[0.0; 3]; 3];
        for ((loss, column), row) in losses.iter().zip(by).zip(of_losses) {
            for (slot, rate) in rates.iter_mut().zip(column) {
                *slot += loss * rate;
            }
            for (entry, other) in row.iter().zip(by) {
                for (line, x) in covariance.iter_mut().zip(column) {
                    for (slot, y) in line.iter_mut().zip(other) {
                        *slot += entry * x * y;
                    }
                }
            }
        }
        Self { rates, covariance, losses }
    }
}
