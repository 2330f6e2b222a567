//! Table `[top]`: support, inertias, mass, gravity.

use super::section::{Key, Section};
use crate::Failure;
use toytop::{ParameterError, Support, Top, TopParameters};

const MAGNITUDE: &str = "a number between 1e-60 and 1e60";

pub(super) const KEYS: [Key; 7] = [
    Key::required("transverse_inertia", MAGNITUDE),
    Key::required("axial_inertia", "a number between 0 and twice transverse_inertia"),
    Key::optional("gravity", 9.80665, MAGNITUDE),
    Key::required("com_height", MAGNITUDE),
    Key::required("mass", MAGNITUDE),
    Key::required("mass_moment", MAGNITUDE),
    Key::optional("rotor_momentum", 0.0, "a finite number of kg m^2/s"),
];

pub(super) fn read(section: &Section<'_>) -> Result<Top, Failure> {
    section.only("support", &KEYS)?;
    let supports = [("sliding", Support::Sliding), ("fixed", Support::Fixed), ("free", Support::Free)];
    let support = section.choice("support", &supports, Some(Support::Sliding))?;

    let [transverse, axial, gravity, height, mass, moment, rotor] = &KEYS;
    let mut parameters = TopParameters {
        transverse_inertia: section.number(transverse)?,
        axial_inertia: section.number(axial)?,
        gravity: section.number(gravity)?,
        rotor_momentum: section.number(rotor)?,
        ..TopParameters::default()
    };
    if support == Support::Free {
        // these keys are allowed and have no effect
        for (key, value) in [
            (height, &mut parameters.com_height),
            (mass, &mut parameters.mass),
            (moment, &mut parameters.mass_moment),
        ] {
            if section.has(key) {
                *value = section.number(key)?;
            }
        }
        return Top::free(&parameters).map_err(|error| section.refused(&error, &[]));
    }
    match (section.has(mass), section.has(moment)) {
        (true, false) => parameters.mass = given(section, mass)?,
        (false, true) => parameters.mass_moment = given(section, moment)?,
        (true, true) => return Err(section.refuse(moment.name, "allowed only without mass")),
        (false, false) => return Err(section.refuse(mass.name, "missing; exactly one of mass, mass_moment")),
    }
    let takes_height = support == Support::Sliding || section.has(mass);
    if takes_height {
        parameters.com_height = section.number(height)?;
    } else if section.has(height) {
        let reason = "unneeded: with support = \"fixed\" allowed only together with mass";
        return Err(section.refuse(height.name, reason));
    }
    let top = match support {
        Support::Sliding => Top::sliding(&parameters),
        Support::Fixed => Top::fixed(&parameters),
        Support::Free => Top::free(&parameters),
    };
    top.map_err(|error: ParameterError| section.refused(&error, &[]))
}

/// Number of a key that is there. In the parameters of a top, 0 stands for a mass or mass moment that is not given.
fn given(section: &Section<'_>, key: &Key) -> Result<f64, Failure> {
    match section.number(key)? {
        0.0 => Err(section.refuse(key.name, "must be positive, between 1e-60 and 1e60")),
        number => Ok(number),
    }
}
