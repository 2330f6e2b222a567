//! Class `Top`: the numbers of a top.

use crate::arguments::refused;
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyType};
use toytop::{Support, Top, TopParameters};

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
pub(crate) struct PyTop {
    /// Numbers as they were given.
    pub(crate) parameters: TopParameters,
    pub(crate) top: Top,
}

impl PyTop {
    fn new(support: Support, parameters: TopParameters) -> PyResult<Self> {
        let top = match support {
            Support::Sliding => Top::sliding(&parameters),
            Support::Fixed => Top::fixed(&parameters),
            Support::Free => Top::free(&parameters),
        };
        Ok(Self { parameters, top: top.map_err(refused)? })
    }

    /// Numbers by their names, without those that are 0 because they are not given.
    fn numbers(&self) -> Vec<(&'static str, f64)> {
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

    /// Table `[top]` of a scenario file.
    pub(crate) fn to_toml(self) -> String {
        let lines: String = self.numbers().iter().map(|(name, x)| format!("{name} = {x:?}\n")).collect();
        format!("[top]\nsupport = \"{}\"\n{lines}", self.support())
    }
}

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
        Self::new(Support::Sliding, parameters)
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
        Self::new(Support::Fixed, parameters)
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
        Self::new(Support::Free, parameters)
    }

    /// Support of the tip: "sliding", "fixed" or "free".
    #[getter]
    pub(crate) fn support(&self) -> &'static str {
        match self.top.support() {
            Support::Sliding => "sliding",
            Support::Fixed => "fixed",
            Support::Free => "free",
        }
    }

    /// Transverse moment of inertia A, kg m²: about the centre of mass for a sliding tip, about the tip for a fixed one.
    #[getter]
    fn transverse_inertia(&self) -> f64 {
        self.top.transverse_inertia()
    }

    /// Axial moment of inertia C, kg m².
    #[getter]
    fn axial_inertia(&self) -> f64 {
        self.top.axial_inertia()
    }

    /// Distance s of the centre of mass from a sliding tip, m; 0 for a fixed tip, for which only the mass moment matters.
    #[getter]
    fn com_height(&self) -> f64 {
        self.top.com_height()
    }

    /// Mass moment p = M s, kg m.
    #[getter]
    fn mass_moment(&self) -> f64 {
        self.top.mass_moment()
    }

    /// Axial angular momentum K of a wheel inside, relative to the body, kg m²/s.
    #[getter]
    fn rotor_momentum(&self) -> f64 {
        self.top.rotor_momentum()
    }

    /// Gravity g, m/s².
    #[getter]
    fn gravity(&self) -> f64 {
        self.top.gravity()
    }

    /// Branch point e4 = sqrt(1 + A/(p s)); None for a fixed tip.
    #[getter]
    fn e4(&self) -> Option<f64> {
        self.top.e4()
    }

    fn __repr__(&self) -> String {
        let arguments: Vec<_> = self.numbers().iter().map(|(name, x)| format!("{name}={x:?}")).collect();
        format!("Top.{}({})", self.support(), arguments.join(", "))
    }

    fn __hash__(&self) -> u64 {
        self.numbers().iter().fold(0, |hash, (_, x)| hash.rotate_left(9) ^ x.to_bits())
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, (Bound<'py, PyType>,))> {
        let numbers = self.numbers().into_py_dict(py)?;
        let caller = py.import("operator")?.getattr("methodcaller")?;
        Ok((caller.call((self.support(),), Some(&numbers))?, (py.get_type::<Self>(),)))
    }
}
