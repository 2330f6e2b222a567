//! Fit of a launch, and of free keys of the top, to measurements, and its result.

use super::models::Sensors;
use crate::Failure;
use crate::input::scenario::{Launch, to_toml};
use crate::input::section;
use crate::output::{exact, significant};
use serde::Serialize;
use toml::{Table, Value};
use toytop::{ParameterError, Support, Top};
use toytop_fit::{Drift, Fit, FitWarning, Fitted, FreeRatio, Hint, MAX_RATIOS, Measurement, Partials};
use toytop_model::equations::dot;

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
                    let reason = format!("must be one of the numbers that describe the top: {allowed}");
                    return Err(format!("{key}: {reason}"));
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
/// [`Failure::input`] of `free`, `huber`, `drift` or `samples`.
pub fn fit_launch(input: FitInput, measurements: &[Measurement]) -> Result<FitResult, Failure> {
    let ratios = input.ratios().map_err(|reason| Failure::input(reason).at("free"))?;
    let refuse = |error: ParameterError| match error.parameter() {
        "residual" => Failure::input("must be a number from 1, or inf").at("huber"),
        "deviation" => Failure::input("must be a positive number").at("drift"),
        "ratios" if input.drift.is_some() => {
            Failure::input("must be at most one name with a drift").at("free")
        }
        _ => Failure::input(error.to_string()).at("samples"),
    };
    let listed = input.sensors.as_sensors();
    let fit = Fit::new(&input.top, &listed, &ratios).and_then(|fit| fit.with_huber(input.huber));
    let mut fit = fit.map_err(refuse)?;
    if let Some(deviation) = input.drift {
        fit = fit.with_losses(deviation).map_err(refuse)?;
    }
    let fitted = fit.run(measurements.iter().copied()).map_err(refuse)?;
    let reason = fitted.warning.map(|reason| match reason {
        // the sensors that the core asks for exist, so that its advice would mislead
        FitWarning::NoFirstGuess if has_direction(&input.sensors, measurements) => {
            "no start fits the samples: are they of another top?".to_owned()
        }
        reason => reason.to_string(),
    });
    let end = measurements.last().map_or(0.0, |last| last.time);
    drop(listed);
    Ok(FitResult { input, fitted, reason, end })
}

/// Whether the first measurements contain an orientation or a direction.
fn has_direction(sensors: &Sensors, measurements: &[Measurement]) -> bool {
    const FIRST: usize = 64;
    measurements.iter().take(FIRST).any(|Measurement { sensor, values, .. }| {
        let hint = sensors.models.get(*sensor).map(|model| model.sensor.hint(values));
        matches!(hint, Some(Hint::Orientation(_) | Hint::Direction { .. } | Hint::Tip(_)))
    })
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

/// Fitted value with its standard deviation.
#[derive(Clone, Copy, Serialize)]
pub struct Estimated<T> {
    /// Standard deviation.
    pub deviation: T,
    /// Value.
    pub value: T,
}

/// Rates of change of l, n and h with their units.
pub const RATES: [(&str, &str); 3] = [("dl/dt", "N m"), ("dn/dt", "N m"), ("dh/dt", "W")];

impl FitResult {
    /// Values of the free keys with their standard deviations.
    pub(super) fn free_values(&self) -> Vec<(&str, Estimated<f64>)> {
        let FitInput { top, table, free, .. } = &self.input;
        let deviations = self.fitted.deviations();
        // the logarithm of the fitted value over the given one is the unknown
        let logarithms = self.fitted.launch.ratios_losses_and_biases().iter().zip(&deviations[6..]);
        free.iter()
            .zip(logarithms)
            .map(|(key, (logarithm, deviation))| {
                let given = table.get(key).and_then(section::as_f64).unwrap_or(top.gravity());
                let value = given * logarithm.exp();
                (key.as_str(), Estimated { deviation: value * deviation, value })
            })
            .collect()
    }

    /// Biases by sensor, with their standard deviations.
    pub(super) fn biases(&self) -> Vec<(&'static str, Estimated<[f64; 3]>)> {
        let deviations = self.fitted.deviations();
        let losses = if self.fitted.drift.is_some() { Drift::LOSS_NAMES.len() } else { 0 };
        let before = self.input.free.len() + losses;
        let values = self.fitted.launch.ratios_losses_and_biases()[before..].as_chunks().0;
        let deviations = deviations[6 + before..].as_chunks().0;
        let models = self.input.sensors.models.iter();
        let biased = models.filter(|model| model.sensor.noise().bias_deviation > 0.0);
        let estimates =
            values.iter().zip(deviations).map(|(&value, &deviation)| Estimated { deviation, value });
        biased.map(|model| model.kind.name()).zip(estimates).collect()
    }

    /// Whether any value was used. Otherwise the launch is only the first guess.
    pub fn used_any_sample(&self) -> bool {
        self.fitted.statistics.used > 0
    }

    /// Spin ω·r and tilt (rad), each with its standard deviation.
    pub fn spin_and_tilt(&self) -> [Estimated<f64>; 2] {
        let launch = &self.fitted.launch;
        let (r, w) = (launch.orientation.axis(), launch.omega);
        let covariance = |i, j| self.fitted.covariance(i, j).unwrap_or(f64::NAN);
        let deviation = |row: [f64; 6]| variance(row, covariance).sqrt();
        // ω turns with the axis
        let spin = deviation([0.0, 0.0, 0.0, r[0], r[1], r[2]]);
        let level = (r[0] * r[0] + r[1] * r[1]).sqrt();
        let lean = if level > 0.0 { [-r[1] / level, r[0] / level] } else { [1.0, 0.0] };
        let tilt = deviation([lean[0], lean[1], 0.0, 0.0, 0.0, 0.0]);
        [
            Estimated { deviation: spin, value: dot(w, r) },
            Estimated { deviation: tilt, value: level.atan2(r[2]) },
        ]
    }

    /// Standard deviations of the orientation and of the axis, rad, at a time with these derivatives.
    pub(super) fn predicted(&self, partials: &Partials) -> [f64; 2] {
        let covariance = self.fitted.orientation_covariance(partials);
        let trace: f64 = (0..3).map(|k| covariance[k][k]).sum();
        let along = variance(partials.axis(), |i, j| covariance[i][j]);
        [trace, trace - along].map(|variance| variance.max(0.0).sqrt())
    }

    /// Names of the directions of the launch that the samples do not determine.
    pub(super) fn undetermined(&self) -> Vec<&'static str> {
        let unobservable = self.fitted.unobservable;
        let named = [(unobservable.yaw, "yaw"), (unobservable.roll, "roll"), (unobservable.spin, "spin")];
        let mut names: Vec<_> = named.iter().filter(|(is, _)| *is).map(|(_, name)| *name).collect();
        if unobservable.count > names.len() {
            names.push("other");
        }
        names
    }

    /// Residuals of each measurement in standard deviations of the noise, after subtraction of the fitted bias. NaN stands for a
    /// component that the sensor does not have or that is at the end of its range, and for a measurement at a time at which
    /// the derivatives of the motion cannot be computed. All residuals are NaN if no top has the fitted numbers.
    pub fn residuals(&self, measurements: &[Measurement]) -> Vec<[f64; 3]> {
        let Ok(mut sensitivity) = self.fitted.sensitivity() else {
            return vec![[f64::NAN; 3]; measurements.len()];
        };
        let biases = self.biases();
        let residual = |Measurement { time, sensor, values }: &Measurement| {
            let Some(partials) = sensitivity.advance_to(time - self.fitted.launch_time) else {
                return [f64::NAN; 3];
            };
            let model = &self.input.sensors.models[*sensor];
            let bias = biases.iter().find(|(name, _)| *name == model.kind.name());
            let bias = bias.map_or([0.0; 3], |(_, bias)| bias.value);
            let predicted = model.sensor.residual(&partials, values);
            [0, 1, 2].map(|k| {
                let deviation = predicted.deviation[k];
                if deviation.is_finite() { (predicted.difference[k] - bias[k]) / deviation } else { f64::NAN }
            })
        };
        measurements.iter().map(residual).collect()
    }

    /// Scenario of the fitted launch, which is its state at t = 0.
    ///
    /// # Errors
    /// [`Failure::input`]: no top has the fitted numbers.
    pub fn scenario(&self, units: Option<&str>) -> Result<String, Failure> {
        let refuse = |error| Failure::from(error).at("the fitted top");
        self.fitted.motion().map_err(refuse)?;
        let state = self.fitted.state().map_err(refuse)?;
        let mut text = format!(
            "# Fitted by `toytop fit`; t = 0 is t = {} of the samples.\n",
            exact(self.fitted.launch_time)
        );
        if let Some(drift) = &self.fitted.drift {
            let deviations = drift.deviations();
            let rate = |(k, (name, unit)): (usize, &(&str, &str))| {
                format!(
                    "{name} = {} +- {} {unit}",
                    significant(drift.rates[k], 4),
                    significant(deviations[k], 2)
                )
            };
            let rates = RATES.iter().enumerate().map(rate).collect::<Vec<_>>().join(", ");
            text +=
                &format!("# Drift during the samples, which the motion below does not contain: {rates}\n");
        }
        let mut top = self.input.table.clone();
        top.extend(
            self.free_values().into_iter().map(|(key, free)| (key.to_owned(), Value::from(free.value))),
        );
        let units = units.map(|units| format!("units = {units:?}\n")).unwrap_or_default();
        Ok(format!("{text}{units}\n{}", to_toml(&top, &Launch::from(&state))))
    }
}

/// Variance of a sum of unknowns with these factors.
fn variance<const N: usize>(factors: [f64; N], covariance: impl Fn(usize, usize) -> f64) -> f64 {
    (0..N).map(|i| (0..N).map(|j| factors[i] * covariance(i, j) * factors[j]).sum::<f64>()).sum()
}
