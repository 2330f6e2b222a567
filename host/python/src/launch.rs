//! Launches of a top.

use crate::arguments::{failed, renamed, value_error};
use crate::motion::MotionCore;
use crate::top::TopCore;
use pyo3::prelude::*;
use toytop::{InitialAngles, Motion, Orientation, ParameterError, Release, Sign, Signs, State};
use toytop_host::input::scenario::{Launch, fastest_rate};
use toytop_model::motion_with_period::MotionWithPeriod;

#[pymethods]
impl TopCore {
    /// Motion from angles and rates. A refusal of ω names the fastest rate.
    pub(crate) fn release(
        &self,
        tilt: f64,
        spin: f64,
        precession: f64,
        nutation: f64,
        azimuth: f64,
        roll: f64,
    ) -> PyResult<MotionCore> {
        let release = Release { tilt, azimuth, roll, spin, precession, nutation };
        let state = State::from_release(&release).map_err(failed)?;
        MotionCore::from_state(self, &state, fastest_rate(&release))
    }

    /// Motion from a quaternion and an angular velocity, `omega` in the fixed frame or `omega_body` in the body frame.
    pub(crate) fn launch(&self, quaternion: [f64; 4], name: &str, omega: [f64; 3]) -> PyResult<MotionCore> {
        let state = match name {
            "omega" => State::new(Orientation::from_quaternion(quaternion), omega),
            "omega_body" => State::from_quaternion_and_gyro(quaternion, omega),
            _ => return Err(value_error(name, "must be omega or omega_body")),
        };
        let refuse = |error: ParameterError| match error.parameter() {
            "alpha" | "beta" => {
                value_error("quaternion", "must be of unit norm: | w^2 + x^2 + y^2 + z^2 - 1 | <= 1e-6")
            }
            _ => renamed(error, &[("gyro", name)]),
        };
        MotionCore::from_state(self, &state.map_err(refuse)?, name)
    }

    /// Motion from branch points, whether l + n and l - n are positive, and the nutation phase and arguments of α and β at t = 0.
    fn branch_points(&self, e: [f64; 3], positive: [bool; 2], phases: [f64; 3]) -> PyResult<MotionCore> {
        let [l_plus_n, l_minus_n] = positive.map(|positive| if positive { Sign::Plus } else { Sign::Minus });
        let [theta, arg_alpha, arg_beta] = phases;
        let (signs, phases) = (Signs { l_plus_n, l_minus_n }, InitialAngles { theta, arg_alpha, arg_beta });
        let motion = Motion::from_branch_points(&self.top, e, signs, &phases)
            .map_err(|error| renamed(error, &[("theta", "nutation_phase")]))?;
        Ok(MotionCore::new(*self, Launch::BranchPoints { e, signs, phases }, MotionWithPeriod::new(motion)))
    }
}
