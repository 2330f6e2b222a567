//! Keys of a top that are unknowns of a fit.

use crate::input::section::number;
use toml::Table;
use toytop::{Support, Top};
use toytop_fit::{FreeRatio, MOST_RATIOS};

/// Keys of a top that a fit may change.
pub const FREE_KEYS: [&str; 6] =
    ["transverse_inertia", "axial_inertia", "com_height", "mass", "mass_moment", "gravity"];

/// Value of a key before the fit: the fitted one is this times e to the power of its unknown.
pub(super) fn given(key: &str, table: &Table, top: &Top) -> f64 {
    table.get(key).and_then(number).unwrap_or(top.gravity())
}

/// Directions of the ratios of a top that belong to free keys.
///
/// * `table`: table `[top]` of its file
///
/// # Errors
/// Key and reason: the table does not have the key, or it is named twice; too many keys.
pub(super) fn ratios(table: &Table, top: &Top, keys: &[String]) -> Result<Vec<FreeRatio>, String> {
    let held = top.support() == Support::Fixed;
    let has = |key: &str| table.contains_key(key);
    let mut ratios = Vec::new();
    for (place, key) in keys.iter().enumerate() {
        if keys[..place].contains(key) {
            return Err(format!("{key}: must be named once"));
        }
        ratios.push(match key.as_str() {
            "gravity" => FreeRatio::GRAVITY,
            key if !FREE_KEYS.contains(&key) => {
                return Err(format!("{key:?} must be one of {}", FREE_KEYS.join(", ")));
            }
            key if !has(key) => {
                let described = FREE_KEYS.into_iter().filter(|key| has(key) || *key == "gravity");
                let allowed = described.collect::<Vec<_>>().join(", ");
                return Err(format!("{key}: must be one of the numbers that describe the top: {allowed}"));
            }
            "axial_inertia" => FreeRatio::AXIAL_INERTIA,
            "transverse_inertia" => FreeRatio::TRANSVERSE_INERTIA,
            // p = M s changes too where the mass is given
            "com_height" if !held && has("mass") => FreeRatio::new([0.0, -2.0, 1.0, 0.0]),
            "com_height" if !held => FreeRatio::COM_HEIGHT,
            _ => FreeRatio::MASS_MOMENT,
        });
    }
    if ratios.len() > MOST_RATIOS {
        return Err("must be at most four keys".to_owned());
    }
    Ok(ratios)
}
