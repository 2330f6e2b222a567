//! State of a top at t = 0: orientation and angular velocity.

use super::{ParameterError, check, check_finite, check_range};
use crate::complex::Complex;
use crate::scalar::{Extended, Float, Ring, sine_cosine_of_radians};
use crate::su2::{AttitudeState, Orientation, Vector, dot};
use core::f64::consts::PI;

/// Largest component of an angular velocity, rad/s.
pub(super) const MAX_RATE: f64 = 1e12;

/// Orientation and angular velocity at t = 0. Numbers below 1e-60 in magnitude count as 0; the others are taken as exact.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct State {
    pub(super) orientation: Orientation<f64>,
    pub(super) omega: Vector<f64>,
}

/// Release of a top: angles (rad) and rates (rad/s) at t = 0.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Release {
    /// Tilt: angle of the axis from the upward vertical, rad, in [0, π].
    pub tilt: f64,
    /// Azimuth of the leaning axis, from the first fixed axis, rad.
    pub azimuth: f64,
    /// Roll: rotation of the body about its axis, rad.
    pub roll: f64,
    /// Spin: the whole axial component ω·r = (n - K)/C of the angular velocity, rad/s.
    pub spin: f64,
    /// Rate of the azimuth, rad/s.
    pub precession: f64,
    /// Rate of the tilt, rad/s.
    pub nutation: f64,
}

impl State {
    /// State from the Cayley-Klein parameters and ω (rad/s) in the fixed frame.
    ///
    /// Φ may differ from a unit norm by roundings: its squared norm by 1e-6.
    ///
    /// # Errors
    /// `alpha`, `beta`, `omega`: a component is not finite; `alpha`: the squared norm differs from 1 by more than 1e-6; `omega`: above 1e12 rad/s.
    pub fn new(orientation: Orientation<f64>, omega: Vector<f64>) -> Result<Self, ParameterError> {
        for (name, z) in [("alpha", orientation.alpha), ("beta", orientation.beta)] {
            check_finite(name, z.re)?;
            check_finite(name, z.im)?;
        }
        check(
            is_unit(&orientation),
            "alpha",
            "of unit norm with beta: | |alpha|^2 + |beta|^2 - 1 | <= 1e-6",
        )?;
        for component in omega {
            check_range(
                -MAX_RATE..=MAX_RATE,
                "omega",
                component,
                "between -1e12 and 1e12 rad/s in every component",
            )?;
        }
        Ok(Self { orientation, omega })
    }

    /// State from the unit quaternion [w, x, y, z] from body to fixed coordinates, and the angular velocity Ω (rad/s) that a gyroscope
    /// measures in the body frame. The third body axis points from the tip to the centre of mass.
    ///
    /// ```
    /// use toytop::State;
    /// let state = State::from_quaternion_and_gyro([0.6, 0.0, 0.8, 0.0], [0.4, -0.2, 150.0])?;
    /// let [x, ..] = state.omega();
    /// assert!((x - (-0.28 * 0.4 + 0.96 * 150.0)).abs() < 1e-12);
    /// # Ok::<(), toytop::ParameterError>(())
    /// ```
    ///
    /// # Errors
    /// `quaternion`: a component is not finite, or the squared norm differs from 1 by more than 1e-6; `gyro`: a component is not
    /// finite, or the magnitude is above 1e12 rad/s.
    pub fn from_quaternion_and_gyro(quaternion: [f64; 4], gyro: Vector<f64>) -> Result<Self, ParameterError> {
        for component in quaternion {
            check_finite("quaternion", component)?;
        }
        for component in gyro {
            check_finite("gyro", component)?;
        }
        let orientation = Orientation::from_quaternion(quaternion);
        check(is_unit(&orientation), "quaternion", "of unit norm: | w^2 + x^2 + y^2 + z^2 - 1 | <= 1e-6")?;
        check(dot(gyro, gyro) <= MAX_RATE * MAX_RATE, "gyro", "at most 1e12 rad/s in magnitude")?;
        Ok(Self { orientation, omega: orientation.normalised().adjoint(gyro) })
    }

    /// State of a release:
    /// α = cos(tilt/2) e^{i(azimuth + roll)/2}, β = -sin(tilt/2) e^{i(azimuth - roll)/2},
    /// ω = precession k + nutation (-sin azimuth, cos azimuth, 0) + (spin - precession cos tilt) r.
    ///
    /// A tilt of exactly 0 or π gives an exactly vertical axis.
    ///
    /// # Errors
    /// [`ParameterError`] names the field: it is not finite, the tilt is outside [0, π], another angle is beyond ±1e6
    /// rad, or a rate is above 1e11 rad/s.
    pub fn from_release(release: &Release) -> Result<Self, ParameterError> {
        let Release { tilt, azimuth, roll, spin, precession, nutation } = *release;
        for (name, angle) in [("azimuth", azimuth), ("roll", roll)] {
            check_range(-1e6..=1e6, name, angle, "between -1e6 and 1e6 rad")?;
        }
        for (name, rate) in [("spin", spin), ("precession", precession), ("nutation", nutation)] {
            check_range(-1e11..=1e11, name, rate, "between -1e11 and 1e11 rad/s")?;
        }
        let (half_sine, half_cosine) = half_tilt_sine_cosine(tilt)?;
        let cis = |angle: f64| {
            let (im, re) = sine_cosine_of_radians(angle);
            Complex::new(re, im)
        };
        let alpha = cis(0.5 * (azimuth + roll)).scaled(half_cosine);
        let beta = cis(0.5 * (azimuth - roll)).scaled(-half_sine);
        let orientation = Orientation { alpha, beta };
        let (sine, cosine) = sine_cosine_of_radians(azimuth);
        let u = (half_cosine - half_sine) * (half_cosine + half_sine);
        let [r1, r2, r3] = orientation.axis();
        let axial = spin - precession * u;
        let omega = [axial * r1 - nutation * sine, axial * r2 + nutation * cosine, axial * r3 + precession];
        Self::new(orientation, omega)
    }

    /// State from an orientation, which is normalised, and its rate.
    ///
    /// # Errors
    /// See [`State::new`].
    pub fn from_attitude<R: Float>(start: &AttitudeState<R>) -> Result<Self, ParameterError> {
        Self::new(start.orientation.map(R::to_f64).normalised(), start.omega().map(R::to_f64))
    }

    /// Orientation Φ at t = 0, not normalised.
    pub fn orientation(&self) -> Orientation<f64> {
        self.orientation
    }

    /// Angular velocity ω at t = 0 in the fixed frame, rad/s.
    pub fn omega(&self) -> Vector<f64> {
        self.omega
    }

    /// Φ and ω, with 0 for components below 1e-60.
    pub(crate) fn to_extended(self) -> (Orientation<Extended>, Vector<Extended>) {
        let extended = |x: f64| if x.abs() < 1e-60 { Extended::ZERO } else { x.into() };
        let number = |z: Complex<f64>| Complex::new(extended(z.re), extended(z.im));
        let Orientation { alpha, beta } = self.orientation;
        (Orientation { alpha: number(alpha), beta: number(beta) }, self.omega.map(extended))
    }
}

/// Sine and cosine of half a tilt; exact at 0 and at π.
///
/// # Errors
/// `tilt`: not in [0, π].
pub(crate) fn half_tilt_sine_cosine(tilt: f64) -> Result<(f64, f64), ParameterError> {
    check_range(0.0..=PI, "tilt", tilt, "between 0 and pi")?;
    Ok(if tilt == PI { (1.0, 0.0) } else { sine_cosine_of_radians(0.5 * tilt) })
}

fn is_unit(orientation: &Orientation<f64>) -> bool {
    (orientation.norm_squared() - 1.0).abs() <= 1e-6
}
