//! Numbers with units, as `"30 g"`, in place of numbers in the units of their keys.

use super::file::excerpt;
use std::f64::consts::PI;

/// Units of a quantity; the first one is the key's.
///
/// Each is (name, m, d): x in this unit is x m/d in the key's unit. With two factors `"30 g"` has the bits of `0.03`.
pub type Quantity = &'static [(&'static str, f64, f64)];

pub const MASS: Quantity = &[("kg", 1.0, 1.0), ("g", 1.0, 1e3), ("mg", 1.0, 1e6)];
pub const LENGTH: Quantity = &[("m", 1.0, 1.0), ("cm", 1.0, 1e2), ("mm", 1.0, 1e3)];
pub const INERTIA: Quantity = &[
    ("kg m^2", 1.0, 1.0),
    ("kg cm^2", 1.0, 1e4),
    ("kg mm^2", 1.0, 1e6),
    ("g cm^2", 1.0, 1e7),
    ("g mm^2", 1.0, 1e9),
];
pub const MOMENT: Quantity =
    &[("kg m", 1.0, 1.0), ("kg cm", 1.0, 1e2), ("g cm", 1.0, 1e5), ("g mm", 1.0, 1e6)];
pub const ACCELERATION: Quantity = &[("m/s^2", 1.0, 1.0), ("cm/s^2", 1.0, 1e2), ("mm/s^2", 1.0, 1e3)];
pub const ANGULAR_MOMENTUM: Quantity = &[
    ("kg m^2/s", 1.0, 1.0),
    ("kg cm^2/s", 1.0, 1e4),
    ("g cm^2/s", 1.0, 1e7),
    ("N m s", 1.0, 1.0),
    ("mN m s", 1.0, 1e3),
];
pub const RATE: Quantity =
    &[("rad/s", 1.0, 1.0), ("deg/s", PI, 180.0), ("rpm", PI, 30.0), ("turns/s", 2.0 * PI, 1.0)];
pub const RADIANS: Quantity = &[("rad", 1.0, 1.0), ("deg", PI, 180.0), ("turns", 2.0 * PI, 1.0)];
pub const DEGREES: Quantity = &[("deg", 1.0, 1.0), ("rad", 180.0, PI), ("turns", 360.0, 1.0)];

/// Number in the first unit of a quantity, from a number with any of its units.
///
/// # Errors
/// Text that is not a number and a unit of the quantity.
pub fn parse(text: &str, quantity: Quantity) -> Result<f64, String> {
    let parsed = text.trim().split_once(char::is_whitespace).and_then(|(number, name)| {
        let number = number.parse::<f64>().ok()?;
        let name = name.split_whitespace().collect::<Vec<_>>().join(" ").replace('²', "^2");
        let (_, times, over) = quantity.iter().find(|(unit, ..)| *unit == name)?;
        Some(number * times / over)
    });
    parsed.filter(|number| number.is_finite()).ok_or_else(|| {
        let names: Vec<_> = quantity.iter().map(|(name, ..)| *name).collect();
        let (own, names) = (names[0], names.join(", "));
        format!("{:?}: must be a number, a space and a unit, as \"2.5 {own}\"; units: {names}", excerpt(text))
    })
}
