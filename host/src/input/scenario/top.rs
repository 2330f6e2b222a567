//! Table `[top]`: support, inertias, mass, gravity.

use crate::Failure;
use crate::input::section::{Key, Section};
use toytop::{Top, TopParameters};

const MAGNITUDE: &str = "a number between 1e-60 and 1e60";

pub const KEYS: [Key; 7] = [
    Key::required("transverse_inertia", MAGNITUDE),
    Key::required("axial_inertia", "a number between 0 and twice transverse_inertia"),
    Key::optional("gravity", 9.80665, MAGNITUDE),
    Key::required("com_height", MAGNITUDE),
    Key::required("mass", MAGNITUDE),
    Key::required("mass_moment", MAGNITUDE),
    Key::optional("rotor_momentum", 0.0, "a finite number of kg m^2/s"),
];

/// Top, and the numbers that are given for it.
pub fn read(section: &Section<'_>) -> Result<(Top, TopParameters), Failure> {
    section.only_with("support", &KEYS)?;
    let support = section.choice("support", &["sliding", "fixed", "free"], Some("sliding"))?;
    let [transverse, axial, gravity, height, mass, moment, rotor] = &KEYS;
    let mut parameters = TopParameters {
        transverse_inertia: section.number(transverse)?,
        axial_inertia: section.number(axial)?,
        gravity: section.number(gravity)?,
        rotor_momentum: section.number(rotor)?,
        ..TopParameters::default()
    };
    // of a free body these keys are allowed and have no effect
    let is_free = support == "free";
    let needs_height = !is_free && (support == "sliding" || section.has(mass));
    match (section.has(mass), section.has(moment)) {
        _ if is_free => {}
        (true, true) => return Err(section.refuse(moment.name, "allowed only without mass")),
        (false, false) => return Err(section.refuse(mass.name, "missing; exactly one of mass, mass_moment")),
        _ if section.has(height) && !needs_height => {
            let reason = "unneeded: with support = \"fixed\" allowed only together with mass";
            return Err(section.refuse(height.name, reason));
        }
        _ => {}
    }
    for (key, value) in [(mass, &mut parameters.mass), (moment, &mut parameters.mass_moment)] {
        if section.has(key) {
            *value = section.number(key)?;
            // in the parameters of a top, 0 stands for a mass or mass moment that is not given
            if *value == 0.0 && !is_free {
                return Err(section.refuse(key.name, "must be positive, between 1e-60 and 1e60"));
            }
        }
    }
    if needs_height || section.has(height) {
        parameters.com_height = section.number(height)?;
    }
    if is_free {
        parameters = TopParameters {
            transverse_inertia: parameters.transverse_inertia,
            axial_inertia: parameters.axial_inertia,
            rotor_momentum: parameters.rotor_momentum,
            ..TopParameters::default()
        };
    }
    let top = match support {
        "sliding" => Top::sliding(&parameters),
        "fixed" => Top::fixed(&parameters),
        _ => Top::free(&parameters),
    };
    Ok((top.map_err(|error| section.refused(&error, &[]))?, parameters))
}
