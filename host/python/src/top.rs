//! Class `Top`, and its launches.

use crate::arrays::{quaternion, vector};
use crate::error::{renamed, value_error};
use crate::launch::{Launch, rates};
use crate::motion::{PyMotion, Single, TopDefinition};
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyType};
use toytop::{InitialPhases, Motion, Release, Sign, Signs, Support, TopParameters};
use toytop_host::truth::motions::Start;

/// Symmetric top whose tip slides on a horizontal plane, or is held at a point, or a free symmetric body.
///
/// It is made by Top.sliding, Top.fixed or Top.free, in SI or any consistent units, and is immutable.
///
/// >>> import toytop
/// >>> top = toytop.Top.sliding(mass=0.05, com_height=0.03, transverse_inertia=3.0e-5, axial_inertia=2.0e-5)
/// >>> motion = top.release(tilt=0.35, spin=150.0)
/// >>> round(motion.period, 6)
/// 0.075985
#[pyclass(name = "Top", module = "toytop", frozen, eq)]
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct PyTop(pub(crate) TopDefinition);

#[pymethods]
impl PyTop {
    /// Top whose tip slides without friction on a horizontal plane: Springborn's toy top.
    ///
    /// Args:
    ///     mass: mass M, kg; either this or mass_moment.
    ///     mass_moment: mass moment p = M s, kg m.
    ///     com_height: distance s of the centre of mass from the tip, m.
    ///     transverse_inertia: moment of inertia A about a transverse axis through the centre of mass, kg m².
    ///     axial_inertia: moment of inertia C <= 2A about the axis of symmetry, kg m².
    ///     gravity: gravity g, m/s².
    ///     rotor_momentum: axial angular momentum K of a wheel inside, relative to the body, kg m²/s.
    ///
    /// Raises:
    ///     ValueError: a parameter is out of range; the message names it.
    #[staticmethod]
    #[pyo3(signature = (*, com_height, transverse_inertia, axial_inertia, mass=0.0, mass_moment=0.0, gravity=9.80665, rotor_momentum=0.0))]
    #[allow(clippy::too_many_arguments)] // keywords in Python
    fn sliding(
        com_height: f64,
        transverse_inertia: f64,
        axial_inertia: f64,
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
        TopDefinition::new(Support::Sliding, parameters).map(Self)
    }

    /// Top whose tip is held at a fixed point: the Lagrange top.
    ///
    /// Args:
    ///     mass_moment: mass moment p = M s, kg m; either this, or mass and com_height.
    ///     mass: mass M, kg.
    ///     com_height: distance of the centre of mass from the tip, m; only together with mass.
    ///     transverse_inertia: moment of inertia A about a transverse axis through the tip, kg m².
    ///     axial_inertia: moment of inertia C about the axis of symmetry, kg m².
    ///     gravity: gravity g, m/s².
    ///     rotor_momentum: axial angular momentum K of a wheel inside, relative to the body, kg m²/s.
    ///
    /// Raises:
    ///     ValueError: a parameter is out of range; the message names it.
    #[staticmethod]
    #[pyo3(signature = (*, transverse_inertia, axial_inertia, mass_moment=0.0, mass=0.0, com_height=0.0, gravity=9.80665, rotor_momentum=0.0))]
    #[allow(clippy::too_many_arguments)] // keywords in Python
    fn fixed(
        transverse_inertia: f64,
        axial_inertia: f64,
        mass_moment: f64,
        mass: f64,
        com_height: f64,
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
        TopDefinition::new(Support::Fixed, parameters).map(Self)
    }

    /// Body without torque: thrown, or in orbit. Its tip is 2 alpha beta, the axis as a complex number.
    ///
    /// Args:
    ///     transverse_inertia: moment of inertia A about a transverse axis through the centre of mass, kg m².
    ///     axial_inertia: moment of inertia C <= 2A about the axis of symmetry, kg m².
    ///     rotor_momentum: axial angular momentum K of a wheel inside, relative to the body, kg m²/s.
    ///
    /// Raises:
    ///     ValueError: a parameter is out of range; the message names it.
    #[staticmethod]
    #[pyo3(signature = (*, transverse_inertia, axial_inertia, rotor_momentum=0.0))]
    fn free(transverse_inertia: f64, axial_inertia: f64, rotor_momentum: f64) -> PyResult<Self> {
        let parameters =
            TopParameters { transverse_inertia, axial_inertia, rotor_momentum, ..TopParameters::default() };
        TopDefinition::new(Support::Free, parameters).map(Self)
    }

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
        let release = Release { tilt, azimuth, roll, spin, precession, nutation };
        Launch::Release(release).of(&self.0).map(PyMotion)
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
        let Some((name, omega)) = rates(omega, omega_body)? else {
            return Err(value_error("omega", "must be given, or else omega_body"));
        };
        let quaternion = self::quaternion("quaternion", quaternion)?;
        Launch::Attitude { quaternion, omega: vector(name, omega)?, name }.of(&self.0).map(PyMotion)
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
        let motion = Motion::from_branch_points(&self.0.top, e, signs, &phases)
            .map_err(|error| renamed(error, &[("theta", "nutation_phase")]))?;
        Ok(PyMotion(Single::new(self.0, Start::BranchPoints { e, signs, phases }, motion)))
    }

    /// Support of the tip: "sliding", "fixed" or "free".
    #[getter]
    fn support(&self) -> &'static str {
        self.0.support()
    }

    /// Transverse moment of inertia A, kg m²: about the centre of mass for a sliding tip, about the tip for a fixed one.
    #[getter]
    fn transverse_inertia(&self) -> f64 {
        self.0.top.transverse_inertia()
    }

    /// Axial moment of inertia C, kg m².
    #[getter]
    fn axial_inertia(&self) -> f64 {
        self.0.top.axial_inertia()
    }

    /// Distance s of the centre of mass from a sliding tip, m; 0 for a fixed tip, for which only the mass moment matters.
    #[getter]
    fn com_height(&self) -> f64 {
        self.0.top.com_height()
    }

    /// Mass moment p = M s, kg m.
    #[getter]
    fn mass_moment(&self) -> f64 {
        self.0.top.mass_moment()
    }

    /// Axial angular momentum K of a wheel inside, relative to the body, kg m²/s.
    #[getter]
    fn rotor_momentum(&self) -> f64 {
        self.0.top.rotor_momentum()
    }

    /// Gravity g, m/s².
    #[getter]
    fn gravity(&self) -> f64 {
        self.0.top.gravity()
    }

    /// Branch point e4 = sqrt(1 + A/(p s)); None for a fixed tip.
    #[getter]
    fn e4(&self) -> Option<f64> {
        self.0.top.e4()
    }

    fn __repr__(&self) -> String {
        let arguments: Vec<_> = self.0.numbers().iter().map(|(name, x)| format!("{name}={x:?}")).collect();
        format!("Top.{}({})", self.support(), arguments.join(", "))
    }

    fn __hash__(&self) -> u64 {
        self.0.numbers().iter().fold(0, |hash, (_, x)| hash.rotate_left(9) ^ x.to_bits())
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, (Bound<'py, PyType>,))> {
        let numbers = self.0.numbers().into_py_dict(py)?;
        let caller = py.import("operator")?.getattr("methodcaller")?;
        Ok((caller.call((self.support(),), Some(&numbers))?, (py.get_type::<Self>(),)))
    }
}

#[pymethods]
impl PyMotion {
    /// Top of the motion.
    #[getter]
    fn top(&self) -> PyTop {
        PyTop(self.0.top)
    }
}

fn sign(name: &str, number: f64) -> PyResult<Sign> {
    match number {
        1.0 => Ok(Sign::Plus),
        -1.0 => Ok(Sign::Minus),
        _ => Err(value_error(name, "must be 1 or -1")),
    }
}
