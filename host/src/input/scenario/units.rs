//! Numbers with units, as `"30 g"`, in place of numbers in the units of their keys.

use crate::Failure;
use crate::input::section::Section;
use crate::output::shown;
use std::f64::consts::PI;
use toml::{Table, Value};

/// Unit of a quantity: its name, and two factors. A number of it, times the first and divided by the second, is a number of the key's unit.
///
/// Both are whole powers of ten for decimal units, so that `"30 g"` has the bits of `0.03`.
type Unit = (&'static str, f64, f64);

/// Units of a quantity; the first one is the key's.
type Quantity = &'static [Unit];

const MASS: Quantity = &[("kg", 1.0, 1.0), ("g", 1.0, 1e3), ("mg", 1.0, 1e6)];
const LENGTH: Quantity = &[("m", 1.0, 1.0), ("cm", 1.0, 1e2), ("mm", 1.0, 1e3)];
const INERTIA: Quantity = &[
    ("kg m^2", 1.0, 1.0),
    ("kg cm^2", 1.0, 1e4),
    ("kg mm^2", 1.0, 1e6),
    ("g cm^2", 1.0, 1e7),
    ("g mm^2", 1.0, 1e9),
];
const MOMENT: Quantity = &[("kg m", 1.0, 1.0), ("kg cm", 1.0, 1e2), ("g cm", 1.0, 1e5), ("g mm", 1.0, 1e6)];
const ACCELERATION: Quantity = &[("m/s^2", 1.0, 1.0), ("cm/s^2", 1.0, 1e2), ("mm/s^2", 1.0, 1e3)];
const ANGULAR_MOMENTUM: Quantity = &[
    ("kg m^2/s", 1.0, 1.0),
    ("kg cm^2/s", 1.0, 1e4),
    ("g cm^2/s", 1.0, 1e7),
    ("N m s", 1.0, 1.0),
    ("mN m s", 1.0, 1e3),
];
const RATE: Quantity =
    &[("rad/s", 1.0, 1.0), ("deg/s", PI, 180.0), ("rpm", PI, 30.0), ("turns/s", 2.0 * PI, 1.0)];
const RADIANS: Quantity = &[("rad", 1.0, 1.0), ("deg", PI, 180.0), ("turns", 2.0 * PI, 1.0)];
const DEGREES: Quantity = &[("deg", 1.0, 1.0), ("rad", 180.0, PI), ("turns", 360.0, 1.0)];

/// Quantities of the keys of `[top]` and `[motion]`; an array has numbers of one quantity.
const QUANTITIES: [(&str, Quantity); 14] = [
    ("transverse_inertia", INERTIA),
    ("axial_inertia", INERTIA),
    ("mass", MASS),
    ("mass_moment", MOMENT),
    ("com_height", LENGTH),
    ("gravity", ACCELERATION),
    ("rotor_momentum", ANGULAR_MOMENTUM),
    ("spin", RATE),
    ("precession", RATE),
    ("nutation", RATE),
    ("omega", RATE),
    ("nutation_phase", RADIANS),
    ("arg_alpha", RADIANS),
    ("arg_beta", RADIANS),
];

/// Angles of a release: their keys, which need a unit, and their keys in degrees.
pub const ANGLES: [(&str, &str); 3] =
    [("tilt", "tilt_deg"), ("azimuth", "azimuth_deg"), ("roll", "roll_deg")];

/// Keys and values with every number in the unit of its key, and the angles of a release under their keys in degrees.
///
/// # Errors
/// [`Failure::Input`]: not a number and a unit of the quantity; kg, m or s in a scenario without units; one angle twice.
pub fn in_units_of_keys(file: &str, mut root: Table) -> Result<Table, Failure> {
    let no_units = root.get("units").and_then(Value::as_str) == Some("none");
    for name in ["top", "motion"] {
        if let Some(Value::Table(written)) = root.get(name) {
            let mut table = written.clone();
            let section = Section { file, name, table: written };
            replace_texts(&section, &mut table, no_units)?;
            if written.get("kind").and_then(Value::as_str) == Some("release") {
                replace_angles(&section, &mut table)?;
            }
            root.insert(name.to_owned(), Value::Table(table));
        }
    }
    Ok(root)
}

fn replace_texts(section: &Section<'_>, table: &mut Table, no_units: bool) -> Result<(), Failure> {
    for (key, quantity) in QUANTITIES {
        let entries = match table.get_mut(key) {
            None => continue,
            Some(Value::Array(entries)) => entries.as_mut_slice(),
            Some(value) => std::slice::from_mut(value),
        };
        for entry in entries {
            let Value::String(text) = entry else { continue };
            if no_units && quantity[0].0 != RADIANS[0].0 {
                return Err(section.refuse(key, "must be a number, because of units = \"none\""));
            }
            *entry = Value::Float(number(text, quantity).map_err(|reason| section.refuse(key, &reason))?);
        }
    }
    Ok(())
}

fn replace_angles(section: &Section<'_>, table: &mut Table) -> Result<(), Failure> {
    for (key, in_degrees) in ANGLES {
        if let Some(Value::String(text)) = table.get(in_degrees)
            && number(text, DEGREES).is_ok()
        {
            let reason = format!("must be a number of degrees; with a unit: {key} = {:?}", shown(text));
            return Err(section.refuse(in_degrees, &reason));
        }
        let Some(value) = table.remove(key) else { continue };
        // one reader would take a number without a unit for degrees, and another for radians
        let Value::String(text) = value else {
            let reason = format!("must be a text with a unit, as \"20 deg\", or {in_degrees} a number");
            return Err(section.refuse(key, &reason));
        };
        let degrees = number(&text, DEGREES).map_err(|reason| section.refuse(key, &reason))?;
        if key == "tilt" && !(0.0..=180.0).contains(&degrees) {
            return Err(section.refuse(key, "must be from 0 to 180 deg"));
        }
        if table.insert(in_degrees.to_owned(), Value::Float(degrees)).is_some() {
            return Err(section.refuse(key, &format!("allowed only without {in_degrees}")));
        }
    }
    Ok(())
}

/// Number of the first unit of a quantity.
fn number(text: &str, quantity: Quantity) -> Result<f64, String> {
    let parsed = text.trim().split_once(char::is_whitespace).and_then(|(number, name)| {
        let number = number.parse::<f64>().ok()?;
        let name = name.split_whitespace().collect::<Vec<_>>().join(" ").replace('²', "^2");
        let (_, times, over) = quantity.iter().find(|(unit, ..)| *unit == name)?;
        Some(number * times / over)
    });
    parsed.filter(|number| number.is_finite()).ok_or_else(|| {
        let names = quantity.iter().map(|(name, ..)| *name).collect::<Vec<_>>().join(", ");
        let own = quantity[0].0;
        format!("{:?}: must be a number, a space and a unit, as \"2.5 {own}\"; units: {names}", shown(text))
    })
}
