//! Launches of a `Top`.

use crate::arguments::{refused, renamed, value_error, vector};
use crate::motion::PyMotion;
use crate::top::PyTop;
use pyo3::prelude::*;
use toytop::{InitialPhases, Motion, Orientation, ParameterError, Release, Sign, Signs, State};
use toytop_host::truth::motions::Start;

impl PyTop {
    /// Motion from tilt, spin, precession, nutation, azimuth and roll.
    ///
    /// # Errors
    /// `ValueError` that names the parameter.
    pub(crate) fn motion_of_release(&self, numbers: [f64; 6]) -> PyResult<PyMotion> {
        let [tilt, spin, precession, nutation, azimuth, roll] = numbers;
        let rates = [("spin", spin), ("precession", precession), ("nutation", nutation)];
        let fastest = rates.into_iter().max_by(|(_, x), (_, y)| x.abs().total_cmp(&y.abs()));
        let release = Release { tilt, azimuth, roll, spin, precession, nutation };
        let state = State::release(&release).map_err(refused)?;
        PyMotion::from_state(self, &state, fastest.map_or("spin", |(name, _)| name))
    }

    /// Motion from a quaternion and an angular velocity, `omega` in the fixed frame or `omega_body` in the body frame.
    ///
    /// # Errors
    /// `ValueError` that names the parameter.
    pub(crate) fn motion_of_attitude(
        &self,
        quaternion: [f64; 4],
        name: &str,
        omega: [f64; 3],
    ) -> PyResult<PyMotion> {
        let state = match name {
            "omega" => State::new(Orientation::from_quaternion(quaternion), omega),
            _ => State::from_quaternion_and_gyro(quaternion, omega),
        };
        let refuse = |error: ParameterError| match error.parameter() {
            "alpha" | "beta" => {
                value_error("quaternion", "must be of unit norm: | w^2 + x^2 + y^2 + z^2 - 1 | <= 1e-6")
            }
            _ => renamed(error, &[("gyro", name)]),
        };
        PyMotion::from_state(self, &state.map_err(refuse)?, name)
    }
}

#[pymethods]
impl PyTop {
    /// Motion of this top when it is released with these angles (rad) and rates (rad/s).
    ///
    /// Args:
    ///     tilt: angle of the axis from the upward vertical, in [0, pi].
    ///     spin: the whole component of the angular velocity along the axis, precession included.
    ///     precession: rate of the azimuth.
    ///     nutation: rate of the tilt.
    ///     azimuth: horizontal direction in which the axis leans, from the first fixed axis.
    ///     roll: rotation of the body about its axis.
    ///
    /// Raises:
    ///     ValueError: a number is out of range; the message names it.
    #[pyo3(signature = (*, tilt, spin, precession=0.0, nutation=0.0, azimuth=0.0, roll=0.0))]
    fn release(
        &self,
        tilt: f64,
        spin: f64,
        precession: f64,
        nutation: f64,
        azimuth: f64,
        roll: f64,
    ) -> PyResult<PyMotion> {
        self.motion_of_release([tilt, spin, precession, nutation, azimuth, roll])
    }

    /// Motion of this top from an orientation and an angular velocity, as sensors measure them.
    ///
    /// Args:
    ///     quaternion: unit quaternion w, x, y, z from body to fixed coordinates, or a scipy Rotation. Its norm may differ from 1
    ///         by 1e-6. The third body axis points from the tip to the centre of mass, the third fixed axis upward.
    ///     omega: angular velocity in the fixed frame, rad/s; either this or omega_body.
    ///     omega_body: angular velocity in the body frame, rad/s, as a gyroscope measures it.
    ///
    /// Raises:
    ///     ValueError: a number is out of range; the message names it.
    #[pyo3(signature = (quaternion, omega=None, *, omega_body=None))]
    fn launch(
        &self,
        quaternion: &Bound<'_, PyAny>,
        omega: Option<&Bound<'_, PyAny>>,
        omega_body: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<PyMotion> {
        let (name, omega) = match (omega, omega_body) {
            (Some(omega), None) => ("omega", omega),
            (None, Some(omega)) => ("omega_body", omega),
            (None, None) => return Err(value_error("omega", "must be given, or else omega_body")),
            _ => return Err(value_error("omega", "must be left out if omega_body is given")),
        };
        self.motion_of_attitude(vector("quaternion", quaternion)?, name, vector(name, omega)?)
    }

    /// Motion of this top with given branch points -1 <= e1 <= e2 <= 1 <= e3 of the paper: u, the cosine of the tilt, oscillates
    /// between e1 and e2.
    ///
    /// Args:
    ///     sign_l_plus_n, sign_l_minus_n: signs of l + n and of l - n, 1 or -1.
    ///     nutation_phase: phase of the nutation at t = 0, rad: 0 at u = e1, pi at u = e2.
    ///     arg_alpha, arg_beta: arguments of the Cayley-Klein parameters at t = 0, rad; of the derivative where a parameter is 0.
    ///
    /// Raises:
    ///     ValueError: a number is out of range; the message names it.
    #[pyo3(signature = (e1, e2, e3, *, sign_l_plus_n, sign_l_minus_n, nutation_phase=0.0, arg_alpha=0.0, arg_beta=0.0))]
    #[expect(clippy::too_many_arguments, reason = "they are keywords of Python")]
    fn branch_points(
        &self,
        e1: f64,
        e2: f64,
        e3: f64,
        sign_l_plus_n: f64,
        sign_l_minus_n: f64,
        nutation_phase: f64,
        arg_alpha: f64,
        arg_beta: f64,
    ) -> PyResult<PyMotion> {
        let signs = Signs {
            l_plus_n: sign("sign_l_plus_n", sign_l_plus_n)?,
            l_minus_n: sign("sign_l_minus_n", sign_l_minus_n)?,
        };
        let (e, phases) = ([e1, e2, e3], InitialPhases { theta: nutation_phase, arg_alpha, arg_beta });
        let motion = Motion::from_branch_points(&self.top, e, signs, &phases)
            .map_err(|error| renamed(error, &[("theta", "nutation_phase")]))?;
        Ok(PyMotion::new(*self, Start::BranchPoints { e, signs, phases }, motion))
    }
}

fn sign(name: &str, number: f64) -> PyResult<Sign> {
    match number {
        1.0 => Ok(Sign::Plus),
        -1.0 => Ok(Sign::Minus),
        _ => Err(value_error(name, "must be 1 or -1")),
    }
}
