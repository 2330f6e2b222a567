//! Everything that a fit needs beside the measurements.

use super::sensors::Sensors;
use toml::Table;
use toytop::{Support, Top};
use toytop_fit::{FreeRatio, MAX_RATIOS};

/// Keys of a top that a fit may change.
pub const FREE_KEYS: [&str; 6] =
    ["transverse_inertia", "axial_inertia", "com_height", "mass", "mass_moment", "gravity"];

/// Everything that a fit needs beside the measurements.
pub struct FitInput {
    /// Top of the file.
    pub top: Top,
    /// Table `[top]` of the file.
    pub table: Table,
    /// Keys of the top that are unknown.
    pub free: Vec<String>,
    /// Sensors of the measurements.
    pub sensors: Sensors,
    /// Residual from which a measurement is an outlier, standard deviations.
    pub huber: f64,
    /// Standard deviation of the losses of rotation, 1/s, where they are unknown too.
    pub drift: Option<f64>,
}

impl FitInput {
    /// Derivatives of the ratios of the top by the logarithm of each free key.
    ///
    /// # Errors
    /// Key and reason: the table does not have the key, or it is named twice; too many keys.
    pub(super) fn ratios(&self) -> Result<Vec<FreeRatio>, String> {
        let held = self.top.support() == Support::Fixed;
        let has = |key: &str| self.table.contains_key(key);
        let mut ratios = Vec::new();
        for (index, key) in self.free.iter().enumerate() {
            if self.free[..index].contains(key) {
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
                    return Err(format!(
                        "{key}: must be one of the numbers that describe the top: {allowed}"
                    ));
                }
                "axial_inertia" => FreeRatio::AXIAL_INERTIA,
                "transverse_inertia" => FreeRatio::TRANSVERSE_INERTIA,
                // p = M s changes too where the mass is given
                "com_height" if !held && has("mass") => FreeRatio::new([0.0, -2.0, 1.0, 0.0]),
                "com_height" if !held => FreeRatio::COM_HEIGHT,
                _ => FreeRatio::MASS_MOMENT,
            });
        }
        if ratios.len() > MAX_RATIOS { Err("must be at most four keys".to_owned()) } else { Ok(ratios) }
    }
}
