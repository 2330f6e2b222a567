//! Attitude state: orientation and rate at one instant.

use crate::body::{ParameterError, State};
use crate::scalar::{Float, Ring};
use crate::su2::{Orientation, OrientationRate, Vector};

/// Orientation and its rate at one instant, with the quantities that follow by products.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AttitudeState<R> {
    /// Orientation Φ.
    pub orientation: Orientation<R>,
    /// Rate Φ' of the orientation, per unit time.
    pub rate: OrientationRate<R>,
}

impl<R: Float> AttitudeState<R> {
    /// State to launch from; the orientation is normalised.
    ///
    /// # Errors
    /// The errors of [`State::new`].
    pub fn state(&self) -> Result<State, ParameterError> {
        State::new(self.orientation.cast().normalised(), self.omega().map(R::to_f64))
    }
}

impl<R: Ring> AttitudeState<R> {
    /// Cosine of the tilt, u = ⟨r, k⟩, in [-1, 1].
    pub fn u(&self) -> R {
        self.orientation.clamped_u()
    }

    /// Rate u' of the cosine of the tilt, per unit time.
    pub fn udot(&self) -> R {
        self.rate.udot(&self.orientation)
    }

    /// Unit vector r from the tip to the centre of mass, in the fixed frame.
    pub fn axis(&self) -> Vector<R> {
        self.orientation.axis()
    }

    /// Unit quaternion [w, x, y, z] from body to fixed coordinates. Φ and -Φ give quaternions of opposite sign.
    pub fn quaternion(&self) -> [R; 4] {
        self.orientation.quaternion()
    }

    /// Angular velocity ω in the fixed frame, rad per unit time.
    pub fn omega(&self) -> Vector<R> {
        self.rate.omega_fixed(&self.orientation)
    }

    /// Angular velocity Ω = Φ⁻¹ω Φ in the body frame, rad per unit time.
    pub fn omega_body(&self) -> Vector<R> {
        self.rate.omega_body(&self.orientation)
    }
}
