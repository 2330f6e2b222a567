//! Motion at one time without a table: all quantities follow from orientation and angular velocity.

use toytop::su2::OrientationRate;
use toytop::{AttitudeState, Orientation};
use toytop_host::motion::ephemeris::Quantity;

/// Orientation and angular velocity at one time.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Point {
    pub(crate) orientation: Orientation<f64>,
    /// Angular velocity in the body frame, rad per unit time.
    pub(crate) omega_body: [f64; 3],
    /// Tip angle, rad; NaN where the axis is vertical at all times.
    pub(crate) tip_angle: f64,
    /// Length that scales the tip, m; 1 for a fixed tip.
    pub(crate) tip_scale: f64,
    /// Upper bound on the orientation error, rad; NaN where none is known.
    pub(crate) error_bound: f64,
}

impl Point {
    /// Appends the components of a quantity.
    pub(crate) fn push(&self, quantity: Quantity, numbers: &mut Vec<f64>) {
        let phi = &self.orientation;
        let state =
            || AttitudeState { orientation: *phi, rate: OrientationRate::from_body(phi, self.omega_body) };
        match quantity {
            Quantity::Quaternion => numbers.extend(phi.quaternion()),
            Quantity::Axis => numbers.extend(phi.axis()),
            Quantity::U => numbers.push(phi.clamped_u()),
            Quantity::Udot => numbers.push(state().udot()),
            Quantity::Omega => numbers.extend(phi.adjoint(self.omega_body)),
            Quantity::OmegaBody => numbers.extend(self.omega_body),
            Quantity::Tip => {
                let tip = phi.tip_over_s();
                numbers.extend([tip.re, tip.im].map(|x| x * self.tip_scale));
            }
            Quantity::TipAngle => numbers.push(self.tip_angle),
        }
    }
}
