//! A state: where the top is and how it moves at t = 0.

use crate::complex::Complex;
use crate::error::{LaunchError, finite, require};
use crate::real::Float;
use crate::su2::{Phi, Vector};

/// Orientation and angular velocity at t = 0. The `f64` numbers count as exact.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct State {
    phi: Phi<f64>,
    omega: Vector<f64>,
}

/// A throw in everyday terms: how the axis leans, how the body spins, how the axis moves. Angles in rad, rates in rad/s.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Release {
    /// Angle of the axis from the upward vertical, in [0, π].
    pub tilt: f64,
    /// Direction in which the axis leans, from the first fixed axis.
    pub azimuth: f64,
    /// Rotation of the body about its axis.
    pub roll: f64,
    /// The whole axial component ω·r = n/C.
    pub spin: f64,
    /// Rate of the azimuth.
    pub precession: f64,
    /// Rate of the tilt.
    pub nutation: f64,
}

impl State {
    /// From the Cayley-Klein parameters and ω (rad/s) in the fixed frame.
    ///
    /// | |α|² + |β|² - 1 | <= 1e-6 is accepted and means the exactly normalised state. A component below 1e-60 counts as 0.
    ///
    /// # Errors
    /// `alpha`, `beta`, `omega`: a component is not finite; `alpha`: further from unit norm; `omega`: above 1e12 rad/s.
    pub fn new(phi: Phi<f64>, omega: Vector<f64>) -> Result<Self, LaunchError> {
        for (name, z) in [("alpha", phi.alpha), ("beta", phi.beta)] {
            finite(name, z.re)?;
            finite(name, z.im)?;
        }
        let defect = Float::abs(phi.norm_squared() - 1.0);
        require(defect <= 1e-6, "alpha", "of unit norm with beta: | |alpha|^2 + |beta|^2 - 1 | <= 1e-6")?;
        for component in omega {
            finite("omega", component)?;
            require(Float::abs(component) <= 1e12, "omega", "at most 1e12 rad/s in every component")?;
        }
        Ok(Self { phi, omega })
    }

    /// From tilt, azimuth, roll and their rates:
    /// α = cos(tilt/2) e^{i(azimuth + roll)/2}, β = -sin(tilt/2) e^{i(azimuth - roll)/2},
    /// ω = precession k + nutation (-sin azimuth, cos azimuth, 0) + (spin - precession cos tilt) r.
    ///
    /// A tilt of exactly 0 or π is exactly vertical.
    ///
    /// # Errors
    /// Names the field that is not finite, a tilt outside [0, π], another angle beyond ±1e6 rad, a rate above 1e11 rad/s.
    pub fn release(release: &Release) -> Result<Self, LaunchError> {
        let Release { tilt, azimuth, roll, spin, precession, nutation } = *release;
        finite("tilt", tilt)?;
        for (name, angle) in [("azimuth", azimuth), ("roll", roll)] {
            finite(name, angle)?;
            require(Float::abs(angle) <= 1e6, name, "between -1e6 and 1e6 rad")?;
        }
        for (name, rate) in [("spin", spin), ("precession", precession), ("nutation", nutation)] {
            finite(name, rate)?;
            require(Float::abs(rate) <= 1e11, name, "at most 1e11 rad/s")?;
        }
        require((0.0..=core::f64::consts::PI).contains(&tilt), "tilt", "in [0, pi]")?;
        let (half_sine, half_cosine) =
            if tilt == core::f64::consts::PI { (1.0, 0.0) } else { libm::sincos(0.5 * tilt) };
        let cis = |angle: f64| {
            let (im, re) = libm::sincos(angle);
            Complex::new(re, im)
        };
        let alpha = cis(0.5 * (azimuth + roll)).scaled(half_cosine);
        let beta = cis(0.5 * (azimuth - roll)).scaled(-half_sine);
        let phi = Phi { alpha, beta };
        let (sine, cosine) = libm::sincos(azimuth);
        let u = (half_cosine - half_sine) * (half_cosine + half_sine);
        let [r1, r2, r3] = phi.axis();
        let axial = spin - precession * u;
        let omega = [axial * r1 - nutation * sine, axial * r2 + nutation * cosine, axial * r3 + precession];
        Self::new(phi, omega)
    }

    /// Φ at t = 0, as given (not normalised).
    #[must_use]
    pub fn phi(&self) -> Phi<f64> {
        self.phi
    }

    /// ω at t = 0 in the fixed frame, rad/s.
    #[must_use]
    pub fn omega(&self) -> Vector<f64> {
        self.omega
    }

    /// The exactly normalised Φ and ω in the number type of a set-up stage.
    pub(crate) fn exact<F: Float>(&self) -> (Phi<F>, Vector<F>) {
        let lift = |z: Complex<f64>| Complex::new(lifted(z.re), lifted(z.im));
        let phi = Phi { alpha: lift(self.phi.alpha), beta: lift(self.phi.beta) };
        (phi.normalised(), self.omega.map(lifted))
    }
}

/// The number, or 0 where its fourth power would leave the range of double-double.
fn lifted<F: Float>(x: f64) -> F {
    const LEAST: f64 = 1e-60;
    if Float::abs(x) < LEAST { F::ZERO } else { F::from_f64(x) }
}
