//! Numbers with units, as `"30 g"`, in place of numbers in the units of their keys.

use crate::excerpt;
use std::f64::consts::PI;

/// Units of a quantity, the key's own first. (name, m, d): one of the unit is m/d of the key's unit. Dividing by d gives `"30 g"` the bits
/// of `0.03`.
pub type UnitTable = &'static [(&'static str, f64, f64)];

pub const MASS: UnitTable = &[("kg", 1.0, 1.0), ("g", 1.0, 1e3), ("mg", 1.0, 1e6)];
pub const LENGTH: UnitTable = &[("m", 1.0, 1.0), ("cm", 1.0, 1e2), ("mm", 1.0, 1e3)];
pub const INERTIA: UnitTable = &[
    ("kg m^2", 1.0, 1.0),
    ("kg cm^2", 1.0, 1e4),
    ("kg mm^2", 1.0, 1e6),
    ("g cm^2", 1.0, 1e7),
    ("g mm^2", 1.0, 1e9),
];
pub const MOMENT: UnitTable =
    &[("kg m", 1.0, 1.0), ("kg cm", 1.0, 1e2), ("g cm", 1.0, 1e5), ("g mm", 1.0, 1e6)];
pub const ACCELERATION: UnitTable = &[("m/s^2", 1.0, 1.0), ("cm/s^2", 1.0, 1e2), ("mm/s^2", 1.0, 1e3)];
pub const ANGULAR_MOMENTUM: UnitTable = &[
    ("kg m^2/s", 1.0, 1.0),
    ("kg cm^2/s", 1.0, 1e4),
    ("g cm^2/s", 1.0, 1e7),
    ("N m s", 1.0, 1.0),
    ("mN m s", 1.0, 1e3),
];
pub const RATE: UnitTable =
    &[("rad/s", 1.0, 1.0), ("deg/s", PI, 180.0), ("rpm", PI, 30.0), ("turns/s", 2.0 * PI, 1.0)];
pub const RADIANS: UnitTable = &[("rad", 1.0, 1.0), ("deg", PI, 180.0), ("turns", 2.0 * PI, 1.0)];
pub const DEGREES: UnitTable = &[("deg", 1.0, 1.0), ("rad", 180.0, PI), ("turns", 360.0, 1.0)];

/// Number in the first unit, from a number with any of the units.
///
/// # Errors
/// Text that is not a number and one of the units.
pub fn parse(text: &str, units: UnitTable) -> Result<f64, String> {
    let parsed = text.trim().split_once(char::is_whitespace).and_then(|(number, name)| {
        let number = number.parse::<f64>().ok()?;
        let name = name.split_whitespace().collect::<Vec<_>>().join(" ").replace('²', "^2");
        let (_, times, over) = units.iter().find(|(unit, ..)| *unit == name)?;
        Some(number * times / over)
    });
    parsed.filter(|number| number.is_finite()).ok_or_else(|| {
        let names: Vec<_> = units.iter().map(|(name, ..)| *name).collect();
        let (first, names) = (names[0], names.join(", "));
        format!(
            "{:?}: must be a number, a space and a unit, as \"2.5 {first}\"; units: {names}",
            excerpt(text)
        )
    })
}
