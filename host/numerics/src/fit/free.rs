//! Keys of a top that are unknowns of a fit.

use toml::Table;
use toytop::fit::{FreeRatio, MOST_RATIOS};
use toytop::{Support, Top};

/// Key of a top that a fit may change.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "program", derive(clap::ValueEnum), value(rename_all = "snake_case"))]
pub enum FreeKey {
    /// A
    TransverseInertia,
    /// C
    AxialInertia,
    /// s
    ComHeight,
    /// M
    Mass,
    /// p
    MassMoment,
    /// g
    Gravity,
}

impl FreeKey {
    /// All keys.
    pub const ALL: [Self; 6] = [
        Self::TransverseInertia,
        Self::AxialInertia,
        Self::ComHeight,
        Self::Mass,
        Self::MassMoment,
        Self::Gravity,
    ];

    /// Name of the key in a scenario file.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::TransverseInertia => "transverse_inertia",
            Self::AxialInertia => "axial_inertia",
            Self::ComHeight => "com_height",
            Self::Mass => "mass",
            Self::MassMoment => "mass_moment",
            Self::Gravity => "gravity",
        }
    }

    /// Value of the key before the fit: the fitted one is this times e to the power of its unknown.
    pub(super) fn given(self, table: &Table, top: &Top) -> f64 {
        let value = table.get(self.name());
        let number = value.and_then(|value| value.as_float().or(value.as_integer().map(|x| x as f64)));
        number.unwrap_or(top.gravity())
    }
}

/// Directions of the ratios of a top that belong to free keys.
///
/// * `table`: table `[top]` of its file
///
/// # Errors
/// Key and reason: the table does not have the key, or it is named twice; too many keys.
pub fn ratios(table: &Table, top: &Top, keys: &[FreeKey]) -> Result<Vec<FreeRatio>, String> {
    let held = top.support() == Support::Fixed;
    let has = |key: FreeKey| table.contains_key(key.name());
    let mut ratios = Vec::new();
    for (place, key) in keys.iter().enumerate() {
        let refuse = |reason: &str| Err(format!("{}: {reason}", key.name()));
        if keys[..place].contains(key) {
            return refuse("must be named once");
        }
        if !has(*key) && *key != FreeKey::Gravity {
            let described = FreeKey::ALL.into_iter().filter(|key| has(*key) || *key == FreeKey::Gravity);
            let allowed = described.map(FreeKey::name).collect::<Vec<_>>().join(", ");
            return refuse(&format!("must be one of the numbers that describe the top: {allowed}"));
        }
        ratios.push(match key {
            FreeKey::AxialInertia => FreeRatio::AXIAL_INERTIA,
            FreeKey::TransverseInertia => FreeRatio::TRANSVERSE_INERTIA,
            FreeKey::Mass | FreeKey::MassMoment => FreeRatio::MASS_MOMENT,
            FreeKey::Gravity => FreeRatio::GRAVITY,
            // p = M s changes too where the mass is given
            FreeKey::ComHeight if held => FreeRatio::MASS_MOMENT,
            FreeKey::ComHeight if has(FreeKey::Mass) => FreeRatio::of([0.0, -2.0, 1.0, 0.0]),
            FreeKey::ComHeight => FreeRatio::COM_HEIGHT,
        });
    }
    if ratios.len() > MOST_RATIOS {
        return Err("must be at most four keys".to_owned());
    }
    Ok(ratios)
}
