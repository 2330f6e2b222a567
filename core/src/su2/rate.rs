//! Rate of an orientation, and the attitude state: the orientation with its rate.

use super::{Orientation, Vector};
use crate::complex::Complex;
use crate::scalar::{Float, Ring};

/// Rate of change Φ' of an orientation.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct OrientationRate<R> {
    /// Rate α', per unit time.
    pub alpha: Complex<R>,
    /// Rate β', per unit time.
    pub beta: Complex<R>,
}

impl<R: Float> OrientationRate<R> {
    /// Rate Φ' = ω Φ, with ω in the fixed frame.
    pub fn from_fixed(phi: &Orientation<R>, omega: Vector<R>) -> Self {
        let [w1, w2, w3] = omega.map(Float::halved);
        let Orientation { alpha, beta } = Orientation::from_quaternion([R::ZERO, w1, w2, w3]).compose(phi);
        Self { alpha, beta }
    }

    /// Rate Φ' = Φ Ω, with Ω in the body frame.
    pub fn from_body(phi: &Orientation<R>, omega: Vector<R>) -> Self {
        let [x1, x2, x3] = omega.map(Float::halved);
        let (diagonal, transverse) = (Complex::new(R::ZERO, x3), Complex::new(x1, x2));
        Self {
            alpha: phi.alpha * diagonal + (phi.beta * transverse.conj()).times_i(),
            beta: (phi.alpha * transverse).times_i() - phi.beta * diagonal,
        }
    }
}

impl<R: Ring> OrientationRate<R> {
    /// Angular velocity ω = Φ' Φ⁻¹ in the fixed frame: equation (2.2) of the paper, erratum 1 corrected.
    pub fn omega_fixed(&self, phi: &Orientation<R>) -> Vector<R> {
        let diagonal = self.alpha * phi.delta() - self.beta * phi.gamma();
        let upper = self.beta * phi.alpha - self.alpha * phi.beta;
        [upper.im.doubled(), -upper.re.doubled(), diagonal.im.doubled()]
    }

    /// Angular velocity Ω = Φ⁻¹ Φ' in the body frame: equation (2.3) of the paper, erratum 2 corrected.
    pub fn omega_body(&self, phi: &Orientation<R>) -> Vector<R> {
        let (gamma, delta) = (-self.beta.conj(), self.alpha.conj());
        let diagonal = phi.delta() * self.alpha - phi.beta * gamma;
        let upper = phi.delta() * self.beta - phi.beta * delta;
        [upper.im.doubled(), -upper.re.doubled(), diagonal.im.doubled()]
    }

    /// Rate of the cosine of the tilt, u' = d(|α|² - |β|²)/dt.
    pub fn udot(&self, phi: &Orientation<R>) -> R {
        ((phi.alpha.conj() * self.alpha).re - (phi.beta.conj() * self.beta).re).doubled()
    }
}

/// Orientation and its rate at one instant, with the quantities that follow by products.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AttitudeState<R> {
    /// Orientation Φ.
    pub orientation: Orientation<R>,
    /// Rate Φ' of the orientation, per unit time.
    pub rate: OrientationRate<R>,
}

impl<R: Ring> AttitudeState<R> {
    /// Cosine of the tilt, u = ⟨r, k⟩, limited to [-1, 1] unlike [`Sample::u`](crate::Sample::u).
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
