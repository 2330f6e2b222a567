//! Numbers of a top.

use crate::arguments::{failed, value_error};
use pyo3::prelude::*;
use std::iter::once;
use toml::{Table, Value};
use toytop::{Support, Top, TopParameters};
use toytop_model::parameters::{self, support_name, support_named};

/// Rust side of `toytop.Top`.
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
        let support = support_named(support)
            .ok_or_else(|| value_error("support", "must be 'sliding', 'fixed' or 'free'"))?;
        Ok(Self { parameters, top: parameters::top(support, &parameters).map_err(failed)? })
    }

    /// Support of the tip.
    #[getter]
    pub(crate) fn support(&self) -> &'static str {
        support_name(self.top.support())
    }

    /// Number of the top by the name of its parameter; 0 where the top does not need it, NaN for another name.
    fn number(&self, name: &str) -> f64 {
        let number = match name {
            "transverse_inertia" => Top::transverse_inertia,
            "axial_inertia" => Top::axial_inertia,
            "com_height" => Top::com_height,
            "mass_moment" => Top::mass_moment,
            "gravity" => Top::gravity,
            "rotor_momentum" => Top::rotor_momentum,
            _ => return f64::NAN,
        };
        number(&self.top)
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
}

impl TopCore {
    /// Keys and values of the table `[top]` of a scenario file.
    pub(crate) fn table(&self) -> Table {
        let numbers = self.given().into_iter().map(|(name, x)| (name, Value::from(x)));
        once(("support", Value::from(self.support())))
            .chain(numbers)
            .map(|(name, value)| (name.to_owned(), value))
            .collect()
    }
}
