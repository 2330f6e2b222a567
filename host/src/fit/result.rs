//! Fitted launch with its standard deviations and residuals.

use super::input::FitInput;
use crate::Failure;
use crate::input::scenario::{Launch, to_toml};
use crate::input::section;
use crate::output::{number, short};
use serde::Serialize;
use toml::Value;
use toytop_fit::{Drift, Fitted, Measurement, Partials};
use toytop_model::equations::dot;

/// Fitted value with its standard deviation.
#[derive(Clone, Copy, Serialize)]
pub struct Estimated<T> {
    /// Standard deviation.
    pub deviation: T,
    /// Value.
    pub value: T,
}

/// Fitted launch with its standard deviations.
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

/// Rates of change of l, n and h with their units.
pub const RATES: [(&str, &str); 3] = [("dl/dt", "N m"), ("dn/dt", "N m"), ("dh/dt", "W")];

impl FitResult {
    /// Values of the free keys with their standard deviations.
    pub(super) fn freed(&self) -> Vec<(&str, Estimated<f64>)> {
        let FitInput { top, table, free, .. } = &self.input;
        let deviations = self.fitted.deviations();
        // the logarithm of the fitted value over the given one is the unknown
        let logarithms = self.fitted.launch.other_unknowns().iter().zip(&deviations[6..]);
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
        let values = self.fitted.launch.other_unknowns()[before..].as_chunks().0;
        let deviations = deviations[6 + before..].as_chunks().0;
        let setups = self.input.sensors.setups.iter();
        let biased = setups.filter(|setup| setup.sensor.noise().bias > 0.0);
        let estimates =
            values.iter().zip(deviations).map(|(&value, &deviation)| Estimated { deviation, value });
        biased.map(|setup| setup.kind.name()).zip(estimates).collect()
    }

    /// Whether any value was used. Otherwise the launch is only the first guess.
    pub fn used_any_sample(&self) -> bool {
        self.fitted.statistics.used > 0
    }

    /// Spin ω·r and tilt (rad), each with its standard deviation.
    pub fn spin_and_tilt(&self) -> [Estimated<f64>; 2] {
        let launch = &self.fitted.launch;
        let (r, w) = (launch.orientation.axis(), launch.omega);
        let deviation = |row: [f64; 6]| variance(row, |i, j| self.fitted.covariance.get(i, j)).sqrt();
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
        let found = self.fitted.unobservable;
        let named = [(found.yaw, "yaw"), (found.roll, "roll"), (found.spin, "spin")];
        let mut names: Vec<_> = named.iter().filter(|(is, _)| *is).map(|(_, name)| *name).collect();
        if found.count > names.len() {
            names.push("other");
        }
        names
    }

    /// Residuals of each measurement in standard deviations of the noise, after subtraction of the fitted bias. NaN stands for a
    /// component that the sensor does not have or that is at the end of its range, and for a measurement at a time at which
    /// the derivatives of the motion cannot be computed. All residuals are NaN if no top has the fitted numbers.
    pub fn residuals(&self, measurements: &[Measurement]) -> Vec<[f64; 3]> {
        let Ok(mut sensitivity) = self.fitted.sensitivity(&self.input.top) else {
            return vec![[f64::NAN; 3]; measurements.len()];
        };
        let biases = self.biases();
        let residual = |Measurement { time, sensor, values }: &Measurement| {
            let Some(partials) = sensitivity.advance_to(time - self.fitted.time) else {
                return [f64::NAN; 3];
            };
            let setup = &self.input.sensors.setups[*sensor];
            let bias = biases.iter().find(|(name, _)| *name == setup.kind.name());
            let bias = bias.map_or([0.0; 3], |(_, bias)| bias.value);
            let predicted = setup.sensor.residual(&partials, values);
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
    /// [`Failure::Input`]: no top has the fitted numbers.
    pub fn scenario(&self, units: Option<&str>) -> Result<String, Failure> {
        let refuse = |error: toytop::ParameterError| Failure::Input(format!("the fitted top: {error}"));
        self.fitted.motion(&self.input.top).map_err(refuse)?;
        let state = self.fitted.state().map_err(refuse)?;
        let mut text =
            format!("# Fitted by `toytop fit`; t = 0 is t = {} of the samples.\n", number(self.fitted.time));
        if let Some(drift) = &self.fitted.drift {
            let deviations = drift.deviations();
            let rate = |(k, (name, unit)): (usize, &(&str, &str))| {
                format!("{name} = {} +- {} {unit}", short(drift.rates[k], 4), short(deviations[k], 2))
            };
            let rates = RATES.iter().enumerate().map(rate).collect::<Vec<_>>().join(", ");
            text +=
                &format!("# Drift during the samples, which the motion below does not contain: {rates}\n");
        }
        let mut top = self.input.table.clone();
        top.extend(self.freed().into_iter().map(|(key, free)| (key.to_owned(), Value::from(free.value))));
        let units = units.map(|units| format!("units = {units:?}\n")).unwrap_or_default();
        Ok(format!("{text}{units}\n{}", to_toml(&top, &Launch::from(&state))))
    }
}

/// Variance of a sum of unknowns with these factors.
fn variance<const N: usize>(factors: [f64; N], covariance: impl Fn(usize, usize) -> f64) -> f64 {
    (0..N).map(|i| (0..N).map(|j| factors[i] * covariance(i, j) * factors[j]).sum::<f64>()).sum()
}
