//! Input of a motion, to full precision.

use crate::error::{failed, refused, value_error};
use pyo3::prelude::*;
use toytop::{InitialPhases, Motion, Support, Top, TopParameters};
use toytop_host::input::scenario::{Given, Scenario};
use toytop_host::truth::exact::Exact;
use toytop_host::truth::motions::{Numbers, Start};
use toytop_host::truth::precise::{Precise, precise};

/// Top with the numbers of its input.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct TopDefinition {
    pub(crate) parameters: TopParameters,
    pub(crate) top: Top,
}

impl TopDefinition {
    /// Top of this support.
    ///
    /// # Errors
    /// `ValueError` that names the parameter.
    pub(crate) fn new(support: Support, parameters: TopParameters) -> PyResult<Self> {
        let top = match support {
            Support::Sliding => Top::sliding(&parameters),
            Support::Fixed => Top::fixed(&parameters),
            Support::Free => Top::free(&parameters),
        };
        Ok(Self { parameters, top: top.map_err(|error| refused(&error, &[]))? })
    }

    /// Mass moment p = M s, whose product is not rounded to `f64`.
    fn mass_moment(&self) -> Precise {
        if self.top.support() == Support::Free {
            return precise(0.0);
        }
        let TopParameters { mass, mass_moment, com_height, .. } = self.parameters;
        if mass == 0.0 { precise(mass_moment) } else { precise(mass) * precise(com_height) }
    }

    /// Numbers by their names, without those that are 0 because they are not given.
    pub(crate) fn numbers(&self) -> Vec<(&'static str, f64)> {
        let given = self.parameters;
        let all = [
            ("transverse_inertia", given.transverse_inertia),
            ("axial_inertia", given.axial_inertia),
            ("rotor_momentum", given.rotor_momentum),
            ("gravity", given.gravity),
            ("mass", given.mass),
            ("mass_moment", given.mass_moment),
            ("com_height", given.com_height),
        ];
        let of_body = if self.top.support() == Support::Free { &all[..3] } else { &all[..] };
        let required = ["axial_inertia", "gravity"];
        of_body.iter().copied().filter(|(name, x)| *x != 0.0 || required.contains(name)).collect()
    }

    pub(crate) fn to_toml(self) -> String {
        let lines: String = self.numbers().iter().map(|(name, x)| format!("{name} = {x:?}\n")).collect();
        format!("[top]\nsupport = \"{}\"\n{lines}", support_name(self.top.support()))
    }
}

/// Text of a scenario file.
pub(crate) fn to_toml(top: &TopDefinition, start: &Start) -> String {
    let motion = match start {
        Start::State { phi: [alpha, beta], omega } => {
            format!("kind = \"state\"\nalpha = {alpha:?}\nbeta = {beta:?}\nomega = {omega:?}\n")
        }
        Start::BranchPoints { e: [e1, e2, e3], signs, phases } => {
            let (plus, minus) = (signs.l_plus_n.factor(), signs.l_minus_n.factor());
            let InitialPhases { theta, arg_alpha, arg_beta } = phases;
            format!(
                "kind = \"branch_points\"\ne1 = {e1:?}\ne2 = {e2:?}\ne3 = {e3:?}\nsign_l_plus_n = {plus}\n\
                 sign_l_minus_n = {minus}\nnutation_phase = {theta:?}\narg_alpha = {arg_alpha:?}\narg_beta = {arg_beta:?}\n"
            )
        }
    };
    format!("{}\n[motion]\n{motion}", top.to_toml())
}

/// Motion of a scenario file's text; `file` is its name in messages.
///
/// # Errors
/// `ValueError` that names the key.
pub(crate) fn of_toml(file: &str, text: &str) -> PyResult<(TopDefinition, Start, Motion)> {
    let Scenario { motion, given, .. } = Scenario::parse(file, text).map_err(|failure| failed(&failure))?;
    let Given { top: parameters, start } = given.ok_or_else(|| value_error(file, "must have numbers"))?;
    Ok((TopDefinition { parameters, top: *motion.top() }, start, motion))
}

/// Name of a support: `sliding`, `fixed` or `free`.
pub(crate) fn support_name(support: Support) -> &'static str {
    match support {
        Support::Sliding => "sliding",
        Support::Fixed => "fixed",
        Support::Free => "free",
    }
}

/// Motion in numbers of 192 bits.
pub(crate) fn truth(definition: &TopDefinition, start: Start) -> Exact {
    let top = &definition.top;
    let (a, c, s, g) = (top.transverse_inertia(), top.axial_inertia(), top.com_height(), top.gravity());
    let numbers = Numbers { top: [a, c, s, top.mass_moment(), g, top.rotor_momentum()], start };
    Exact::with_mass_moment(&numbers, &definition.mass_moment())
}
