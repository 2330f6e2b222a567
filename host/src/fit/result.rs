//! Fit of a launch, and of free keys of the top, to measurements.

use super::sensors::Sensors;
use crate::Refusal;
use toml::Table;
use toytop::{Support, Top};
use toytop_fit::{Fit, FitError, FitWarning, Fitted, FreeRatio, Hint, MAX_RATIOS, Measurement};

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

/// Fitted launch with its input.
pub struct FitResult {
    /// Input of the fit.
    pub input: FitInput,
    /// Result of the fit.
    pub fitted: Fitted,
    /// Reason why the launch must not be trusted, in words; `None` where it may be.
    pub reason: Option<String>,
    /// Time of the last measurement, s.
    pub end: f64,
}

impl FitInput {
    /// Derivatives of the ratios of the top by the logarithm of each free key.
    ///
    /// # Errors
    /// Key and reason: the table does not have the key, or it is named twice; too many keys.
    fn ratios(&self) -> Result<Vec<FreeRatio>, String> {
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

/// Launch that fits the measurements best.
///
/// # Errors
/// [`Refusal`] of `free`, `huber`, `drift` or `samples`.
pub fn fit_launch(input: FitInput, measurements: &[Measurement]) -> Result<FitResult, Refusal> {
    let ratios = input.ratios().map_err(|reason| ("free", reason))?;
    if input.huber.is_nan() || input.huber < 1.0 {
        return Err(("huber", "must be a number from 1, or inf".to_owned()));
    }
    let refuse = |error: FitError| match error {
        FitError::LossDeviation => ("drift", "must be a positive number".to_owned()),
        FitError::TooManyUnknowns if input.drift.is_some() => {
            ("free", "must be at most one name with a drift".to_owned())
        }
        _ => ("samples", error.to_string()),
    };
    let listed = input.sensors.as_sensors();
    let mut fit = Fit::new(&input.top, &listed, &ratios).map_err(refuse)?.with_huber(input.huber);
    if let Some(deviation) = input.drift {
        fit = fit.with_losses(deviation).map_err(refuse)?;
    }
    let fitted = fit.run(measurements.iter().copied()).map_err(refuse)?;
    let reason = fitted.warning.map(|reason| match reason {
        // the sensors that the core asks for exist, so that its advice would mislead
        FitWarning::NoBeginning if has_beginning(&input.sensors, measurements) => {
            "no start fits the samples: are they of another top?".to_owned()
        }
        reason => reason.to_string(),
    });
    let end = measurements.last().map_or(0.0, |last| last.time);
    drop(listed);
    Ok(FitResult { input, fitted, reason, end })
}

/// Whether the first measurements contain an orientation, an axis, or a direction and rates.
fn has_beginning(sensors: &Sensors, measurements: &[Measurement]) -> bool {
    const FIRST: usize = 64;
    let [mut direction, mut rate] = [false; 2];
    for Measurement { sensor, values, .. } in measurements.iter().take(FIRST) {
        match sensors.setups.get(*sensor).map(|setup| setup.sensor.hint(values)) {
            Some(Hint::Orientation(_) | Hint::Axis(_) | Hint::Tip(_)) => return true,
            Some(Hint::Direction { .. }) => direction = true,
            Some(Hint::Rate { .. }) => rate = true,
            _ => {}
        }
    }
    direction && rate
}
