//! One instant of a motion: Φ and Φ', and what follows from them.

use crate::complex::Complex;
use crate::error::LaunchError;
use crate::launch::State;
use crate::real::{Float, Ring};
use crate::su2::{Phi, PhiRate, Vector};

/// Orientation and rate at one instant. Everything here is computed on demand, by products alone, and from α, β and
/// their rates: nothing is read back from the constants of the motion, so l, n and h recomputed from a pose are a test.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Pose<R> {
    /// Φ.
    pub phi: Phi<R>,
    /// Φ', per unit time.
    pub rate: PhiRate<R>,
}

impl<R: Float> Pose<R> {
    /// As a state to launch from: after a nudge, or with another top. Rounded as the scalar is.
    ///
    /// # Errors
    /// As [`State::new`]; none for a pose of this crate's own motions, as it is normalised first.
    pub fn state(&self) -> Result<State, LaunchError> {
        let widen = |z: Complex<R>| Complex::new(z.re.to_f64(), z.im.to_f64());
        let phi = Phi { alpha: widen(self.phi.alpha), beta: widen(self.phi.beta) };
        State::new(phi.normalised(), self.omega().map(R::to_f64))
    }
}

impl<R: Ring> Pose<R> {
    /// u = ⟨r, k⟩, the cosine of the tilt.
    #[must_use]
    pub fn u(&self) -> R {
        self.phi.u()
    }

    /// u', per unit time.
    #[must_use]
    pub fn udot(&self) -> R {
        self.rate.udot(&self.phi)
    }

    /// ω in the fixed frame, rad per unit time.
    #[must_use]
    pub fn omega(&self) -> Vector<R> {
        self.rate.omega_fixed(&self.phi)
    }

    /// Ω = Φ⁻¹ω Φ, ω in the body frame, rad per unit time.
    #[must_use]
    pub fn omega_body(&self) -> Vector<R> {
        self.rate.omega_body(&self.phi)
    }
}
