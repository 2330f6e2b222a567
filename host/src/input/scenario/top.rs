//! Table `[top]`: support, inertias, mass, gravity.

use crate::Failure;
use crate::input::section::{Key, Section};
use crate::input::units::{ACCELERATION, ANGULAR_MOMENTUM, INERTIA, LENGTH, MASS, MOMENT};
use toytop::{Support, Top, TopParameters};
use toytop_model::parameters::{self, SUPPORTS, top_parameters};

const MAGNITUDE: &str = "a number between 1e-60 and 1e60";

/// Keys of a top, in the order of [`top_parameters`]. A default of 0 stands for a number that is not given.
pub static KEYS: [Key; 7] = [
    Key::required("transverse_inertia", MAGNITUDE).with_units(INERTIA),
    Key::required("axial_inertia", "a number between 0 and twice transverse_inertia").with_units(INERTIA),
    Key::optional("com_height", 0.0, MAGNITUDE).with_units(LENGTH),
    Key::optional("mass", 0.0, MAGNITUDE).with_units(MASS),
    Key::optional("mass_moment", 0.0, MAGNITUDE).with_units(MOMENT),
    Key::optional("gravity", 9.80665, "a number between 1e-60 and 1e60, or 0 if the tip is held")
        .with_units(ACCELERATION),
    Key::optional("rotor_momentum", 0.0, "a finite number of kg m^2/s").with_units(ANGULAR_MOMENTUM),
];

/// Top, and the numbers that are given for it.
pub fn read(section: &Section<'_>) -> Result<(Top, TopParameters), Failure> {
    let (name, support) = section.choice("support", &SUPPORTS, Some(SUPPORTS[0]))?;
    let parameters = top_parameters(section.only_numbers(Some(("support", name)), &KEYS)?);
    let refused = |error| section.refusal(error);
    // of a free body the other keys are allowed and have no effect
    if support == Support::Free {
        let TopParameters { transverse_inertia, axial_inertia, rotor_momentum, .. } = parameters;
        let inertias =
            TopParameters { transverse_inertia, axial_inertia, rotor_momentum, ..TopParameters::default() };
        return Ok((Top::free(&inertias).map_err(refused)?, inertias));
    }
    let [has_height, has_mass, has_moment] =
        ["com_height", "mass", "mass_moment"].map(|key| section.table.contains_key(key));
    let needs_height = support == Support::Sliding || has_mass;
    let positive = "must be positive, between 1e-60 and 1e60";
    let fault = match (has_mass, has_moment) {
        (true, true) => Some(("mass_moment", "allowed only without mass")),
        (false, false) => Some(("mass", "missing; exactly one of mass, mass_moment")),
        _ if has_height && !needs_height => {
            Some(("com_height", "unneeded: with support = \"fixed\" allowed only together with mass"))
        }
        (true, false) if parameters.mass == 0.0 => Some(("mass", positive)),
        (false, true) if parameters.mass_moment == 0.0 => Some(("mass_moment", positive)),
        _ if needs_height && !has_height => {
            Some(("com_height", "missing; must be a number between 1e-60 and 1e60"))
        }
        _ => None,
    };
    if let Some((key, reason)) = fault {
        return Err(section.failure(key, reason));
    }
    Ok((parameters::top(support, &parameters).map_err(refused)?, parameters))
}
