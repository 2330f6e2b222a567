//! Numbers of a top, and launches of its motions.

use crate::arguments::{refused, renamed, value_error};
use crate::motion::MotionCore;
use pyo3::prelude::*;
use toytop::{InitialPhases, Motion, Orientation, ParameterError, Release, Sign, Signs, State};
use toytop::{Support, Top, TopParameters};
use toytop_host::truth::motions::Start;

/// Computing part of the Python class `Top`.
#[pyclass(module = "toytop._toytop", frozen, from_py_object)]
#[derive(Clone, Copy)]
pub(crate) struct TopCore {
    /// Numbers as they were given.
    pub(crate) parameters: TopParameters,
    pub(crate) top: Top,
}

#[pymethods]
impl TopCore {
    #[new]
    #[expect(clippy::too_many_arguments, reason = "the numbers of a top")]
    fn new(
        support: &str,
        transverse_inertia: f64,
        axial_inertia: f64,
        com_height: f64,
        mass: f64,
        mass_moment: f64,
        gravity: f64,
        rotor_momentum: f64,
    ) -> PyResult<Self> {
        let parameters = TopParameters {
            transverse_inertia,
            axial_inertia,
            com_height,
            mass,
            mass_moment,
            gravity,
            rotor_momentum,
        };
        let top = match support {
            "sliding" => Top::sliding(&parameters),
            "fixed" => Top::fixed(&parameters),
            _ => Top::free(&parameters),
        };
        Ok(Self { parameters, top: top.map_err(refused)? })
    }

    /// Support of the tip.
    #[getter]
    pub(crate) fn support(&self) -> &'static str {
        match self.top.support() {
            Support::Sliding => "sliding",
            Support::Fixed => "fixed",
            Support::Free => "free",
        }
    }

    /// Numbers A, C, s, p, g and K.
    pub(crate) fn numbers(&self) -> [f64; 6] {
        let top = &self.top;
        [
            top.transverse_inertia(),
            top.axial_inertia(),
            top.com_height(),
            top.mass_moment(),
            top.gravity(),
            top.rotor_momentum(),
        ]
    }

    fn e4(&self) -> Option<f64> {
        self.top.e4()
    }

    /// Numbers that were given, by their names: all but those that are 0 by default.
    pub(crate) fn given(&self) -> Vec<(&'static str, f64)> {
        let given = &self.parameters;
        let mut numbers = vec![
            ("transverse_inertia", given.transverse_inertia),
            ("axial_inertia", given.axial_inertia),
            ("rotor_momentum", given.rotor_momentum),
            ("gravity", given.gravity),
            ("mass", given.mass),
            ("mass_moment", given.mass_moment),
            ("com_height", given.com_height),
        ];
        numbers.retain(|(name, x)| match *name {
            "axial_inertia" => true,
            "gravity" => self.top.support() != Support::Free,
            _ => *x != 0.0,
        });
        numbers
    }

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
        let rates = [("spin", spin), ("precession", precession), ("nutation", nutation)];
        let fastest = rates.into_iter().max_by(|(_, x), (_, y)| x.abs().total_cmp(&y.abs()));
        let release = Release { tilt, azimuth, roll, spin, precession, nutation };
        let state = State::release(&release).map_err(refused)?;
        MotionCore::from_state(self, &state, fastest.map_or("spin", |(name, _)| name))
    }

    /// Motion from a quaternion and an angular velocity, `omega` in the fixed frame or `omega_body` in the body frame.
    pub(crate) fn launch(&self, quaternion: [f64; 4], name: &str, omega: [f64; 3]) -> PyResult<MotionCore> {
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
        MotionCore::from_state(self, &state.map_err(refuse)?, name)
    }

    /// Motion from branch points, whether l + n and l - n are positive, and the nutation phase and arguments of α and β at t = 0.
    fn branch_points(&self, e: [f64; 3], positive: [bool; 2], phases: [f64; 3]) -> PyResult<MotionCore> {
        let [l_plus_n, l_minus_n] = positive.map(|positive| if positive { Sign::Plus } else { Sign::Minus });
        let [theta, arg_alpha, arg_beta] = phases;
        let (signs, phases) = (Signs { l_plus_n, l_minus_n }, InitialPhases { theta, arg_alpha, arg_beta });
        let motion = Motion::from_branch_points(&self.top, e, signs, &phases)
            .map_err(|error| renamed(error, &[("theta", "nutation_phase")]))?;
        Ok(MotionCore::new(*self, Start::BranchPoints { e, signs, phases }, motion))
    }
}

impl TopCore {
    /// Table `[top]` of a scenario file.
    pub(crate) fn to_toml(self) -> String {
        let lines: String = self.given().iter().map(|(name, x)| format!("{name} = {x:?}\n")).collect();
        format!("[top]\nsupport = \"{}\"\n{lines}", self.support())
    }
}
