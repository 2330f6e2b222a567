//! `[top]`: support, inertias, heaviness, gravity.

use super::section::{Key, Section};
use crate::Failure;
use toytop::{Heaviness, LaunchError, Support, Top};

const MAGNITUDE: &str = "a number between 1e-12 and 1e12";

const KEYS: [Key; 6] = [
    Key::required("transverse_inertia", MAGNITUDE),
    Key::required("axial_inertia", "a number between 1e-12 and 1e12, at most twice transverse_inertia"),
    Key::optional("gravity", 9.80665, MAGNITUDE),
    Key::required("com_height", MAGNITUDE),
    Key::required("mass", MAGNITUDE),
    Key::required("mass_moment", MAGNITUDE),
];

pub(super) fn read(section: &Section<'_>) -> Result<Top, Failure> {
    section.only("support", &KEYS)?;
    let supports = [("sliding", Support::Sliding), ("fixed", Support::Fixed)];
    let support = section.choice("support", &supports, Some(Support::Sliding))?;

    let [transverse, axial, gravity, height, mass, moment] = &KEYS;
    let heaviness = match (section.has(mass), section.has(moment)) {
        (true, false) => Heaviness::Mass(section.number(mass)?),
        (false, true) => Heaviness::MassMoment(section.number(moment)?),
        (true, true) => return Err(section.refuse(moment.name, "allowed only without mass")),
        (false, false) => return Err(section.refuse(mass.name, "missing; exactly one of mass, mass_moment")),
    };
    let a = section.number(transverse)?;
    let c = section.number(axial)?;
    let g = section.number(gravity)?;
    let refused = |error: LaunchError| section.refused(&error, &[]);
    match (support, heaviness) {
        (Support::Sliding, _) => Top::sliding(a, c, section.number(height)?, heaviness, g).map_err(refused),
        (Support::Fixed, Heaviness::Mass(mass)) => {
            Top::fixed_with_mass(a, c, section.number(height)?, mass, g).map_err(refused)
        }
        (Support::Fixed, Heaviness::MassMoment(_)) if section.has(height) => {
            let reason = "unneeded: with support = \"fixed\" allowed only together with mass";
            Err(section.refuse(height.name, reason))
        }
        (Support::Fixed, Heaviness::MassMoment(moment)) => Top::fixed(a, c, moment, g).map_err(refused),
    }
}
