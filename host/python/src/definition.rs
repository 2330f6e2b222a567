//! Input of a motion, to full precision.

use crate::error::{failed, refused};
use pyo3::prelude::*;
use toml::{Table, Value};
use toytop::{Motion, Sign, Signs, Start, State, Support, Top, TopParameters};
use toytop_host::input::scenario::Scenario;
use toytop_host::truth::exact::Exact;
use toytop_host::truth::motions::Numbers;
use toytop_host::truth::precise::{Precise, precise};
use toytop_host::truth::state_constants::Launched;
use toytop_host::truth::states::StateNumbers;

/// Top with the numbers of its input.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct TopDefinition {
    pub(crate) parameters: TopParameters,
    pub(crate) top: Top,
}

/// State or branch points of the input of a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum StartDefinition {
    State(State),
    BranchPoints { e: [f64; 3], signs: Signs, start: Start },
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

    pub(crate) fn to_toml(self) -> String {
        let TopParameters {
            transverse_inertia,
            axial_inertia,
            com_height,
            mass,
            mass_moment,
            gravity,
            rotor_momentum,
        } = self.parameters;
        let support = support_name(self.top.support());
        let given = [
            ("mass", mass),
            ("mass_moment", mass_moment),
            ("com_height", com_height),
            ("rotor_momentum", rotor_momentum),
        ];
        let given = given.iter().filter(|(_, x)| *x != 0.0).map(|(key, x)| format!("{key} = {x:?}\n"));
        format!(
            "[top]\nsupport = \"{support}\"\n{}transverse_inertia = {transverse_inertia:?}\naxial_inertia = {axial_inertia:?}\n\
             gravity = {gravity:?}\n",
            given.collect::<String>()
        )
    }
}

impl StartDefinition {
    fn to_toml(self) -> String {
        match self {
            Self::State(state) => {
                let (phi, omega) = (state.orientation(), state.omega());
                let [alpha, beta] = [phi.alpha, phi.beta].map(|z| [z.re, z.im]);
                format!("[motion]\nkind = \"state\"\nalpha = {alpha:?}\nbeta = {beta:?}\nomega = {omega:?}\n")
            }
            Self::BranchPoints { e: [e1, e2, e3], signs, start } => {
                let (plus, minus) = (signs.l_plus_n.factor(), signs.l_minus_n.factor());
                let Start { theta, arg_alpha, arg_beta } = start;
                format!(
                    "[motion]\nkind = \"branch_points\"\ne1 = {e1:?}\ne2 = {e2:?}\ne3 = {e3:?}\nsign_l_plus_n = {plus}\n\
                     sign_l_minus_n = {minus}\nnutation_phase = {theta:?}\narg_alpha = {arg_alpha:?}\narg_beta = {arg_beta:?}\n"
                )
            }
        }
    }
}

/// Text of a scenario file.
pub(crate) fn to_toml(top: &TopDefinition, start: &StartDefinition) -> String {
    format!("{}\n{}", top.to_toml(), start.to_toml())
}

/// Motion of a scenario file's text; `file` is its name in messages.
///
/// # Errors
/// `ValueError` that names the key.
pub(crate) fn of_toml(file: &str, text: &str) -> PyResult<(TopDefinition, StartDefinition, Motion)> {
    let Scenario { motion, state, .. } = Scenario::parse(file, text).map_err(|failure| failed(&failure))?;
    // the scenario is valid, so missing keys may be missing
    let root = Scenario::keys_of(file, text).unwrap_or_default();
    let section = |name: &str| root.get(name).and_then(Value::as_table).cloned().unwrap_or_default();
    let (top, given) = (section("top"), section("motion"));
    let default = TopParameters::default();
    let parameters = TopParameters {
        transverse_inertia: number(&top, "transverse_inertia", 0.0),
        axial_inertia: number(&top, "axial_inertia", 0.0),
        com_height: number(&top, "com_height", 0.0),
        mass: number(&top, "mass", 0.0),
        mass_moment: number(&top, "mass_moment", 0.0),
        gravity: number(&top, "gravity", default.gravity),
        rotor_momentum: number(&top, "rotor_momentum", 0.0),
    };
    let sign = |key| Sign::of(number(&given, key, 1.0));
    let start = match state {
        Some(state) => StartDefinition::State(state),
        None => StartDefinition::BranchPoints {
            e: ["e1", "e2", "e3"].map(|key| number(&given, key, 0.0)),
            signs: Signs { l_plus_n: sign("sign_l_plus_n"), l_minus_n: sign("sign_l_minus_n") },
            start: Start {
                theta: number(&given, "nutation_phase", 0.0),
                arg_alpha: number(&given, "arg_alpha", 0.0),
                arg_beta: number(&given, "arg_beta", 0.0),
            },
        },
    };
    Ok((TopDefinition { parameters, top: *motion.top() }, start, motion))
}

fn number(table: &Table, key: &str, default: f64) -> f64 {
    match table.get(key) {
        Some(Value::Float(x)) => *x,
        Some(Value::Integer(x)) => *x as f64,
        _ => default,
    }
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
pub(crate) fn truth(definition: &TopDefinition, start: &StartDefinition) -> Exact {
    let top = &definition.top;
    let (a, c, s, g) = (top.transverse_inertia(), top.axial_inertia(), top.com_height(), top.gravity());
    let (p, mass_moment) = (top.mass_moment(), definition.mass_moment());
    match start {
        StartDefinition::State(state) => {
            let numbers = StateNumbers::of([a, c, s, p, g, top.rotor_momentum()], state);
            Exact::launched(&Launched::with_mass_moment(&numbers, &mass_moment))
        }
        StartDefinition::BranchPoints { e, signs, start } => {
            let numbers = Numbers { a, c, s, p, g, e: *e, signs: *signs, start: *start };
            Exact::with_mass_moment(&numbers, &mass_moment)
        }
    }
}
