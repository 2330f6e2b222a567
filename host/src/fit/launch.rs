//! Fit of a launch, and of free keys of its top, to measurements.

use super::report::FitReport;
use super::sensors::Sensors;
use crate::input::section::number;
use toml::Table;
use toytop::{Support, Top};
use toytop_fit::{Fit, FitError, FreeRatio, Hint, MOST_RATIOS, Measurement, Reason};

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
    /// Launch that fits the measurements best.
    ///
    /// # Errors
    /// Name of the parameter that is refused, `free`, `huber`, `drift` or `samples`, and the reason.
    pub fn fitted(self, measurements: &[Measurement]) -> Result<FitReport, (&'static str, String)> {
        let ratios = ratios(&self.table, &self.top, &self.free).map_err(|reason| ("free", reason))?;
        if self.huber.is_nan() || self.huber < 1.0 {
            return Err(("huber", "must be a number from 1, or inf".to_owned()));
        }
        let refuse = |error: FitError| match error {
            FitError::DriftDeviation => ("drift", "must be a positive number".to_owned()),
            FitError::TooManyUnknowns if self.drift.is_some() => {
                ("free", "must be at most one name with a drift".to_owned())
            }
            _ => ("samples", error.to_string()),
        };
        let listed = self.sensors.listed();
        let mut fit = Fit::new(&self.top, &listed, &ratios).map_err(refuse)?.with_huber(self.huber);
        if let Some(deviation) = self.drift {
            fit = fit.with_drift(deviation).map_err(refuse)?;
        }
        let fitted = fit.run(measurements.iter().copied()).map_err(refuse)?;
        let reason = fitted.reason.map(|reason| match reason {
            // the sensors that the core asks for exist, so that its advice would mislead
            Reason::NoBeginning if state_a_beginning(&self.sensors, measurements) => {
                "no start fits the samples: are they of another top?".to_owned()
            }
            reason => reason.to_string(),
        });
        let end = measurements.last().map_or(0.0, |last| last.time);
        drop(listed);
        Ok(FitReport { input: self, fitted, reason, end })
    }
}

/// Whether the first measurements contain an orientation, an axis, or a direction and rates.
fn state_a_beginning(sensors: &Sensors, measurements: &[Measurement]) -> bool {
    const FIRST: usize = 64;
    let hint = |measurement: &Measurement| {
        let instrument = sensors.instruments.get(measurement.sensor);
        instrument.map_or(Hint::None, |instrument| instrument.sensor.hint(&measurement.values))
    };
    let has = |wanted: fn(&Hint) -> bool| measurements.iter().take(FIRST).any(|one| wanted(&hint(one)));
    has(|hint| matches!(hint, Hint::Orientation(_) | Hint::Axis(_)))
        || has(|hint| matches!(hint, Hint::Direction { .. })) && has(|hint| matches!(hint, Hint::Rate { .. }))
}

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
