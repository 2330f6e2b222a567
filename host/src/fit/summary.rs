//! Numbers of a fitted launch by name, with standard deviations and residuals, for the report, JSON, CSV and Python.

use super::result::{FitInput, FitResult};
use crate::Failure;
use crate::input::scenario::{Launch, to_toml};
use crate::input::section;
use crate::output::{exact, significant};
use serde::{Serialize, Serializer};
use toml::Value;
use toytop_fit::{Drift, Measurement, Partials, Sensitivity};
use toytop_model::equations::dot;

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
    fn freed(&self) -> Vec<(&str, Estimated<f64>)> {
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
    fn biases(&self) -> Vec<(&'static str, Estimated<[f64; 3]>)> {
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
    fn predicted(&self, partials: &Partials) -> [f64; 2] {
        let covariance = self.fitted.orientation_covariance(partials);
        let trace: f64 = (0..3).map(|k| covariance[k][k]).sum();
        let along = variance(partials.axis(), |i, j| covariance[i][j]);
        [trace, trace - along].map(|variance| variance.max(0.0).sqrt())
    }

    /// Names of the directions of the launch that the samples do not determine.
    fn undetermined(&self) -> Vec<&'static str> {
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
        self.fitted.motion().map_err(refuse)?;
        let state = self.fitted.state().map_err(refuse)?;
        let mut text =
            format!("# Fitted by `toytop fit`; t = 0 is t = {} of the samples.\n", exact(self.fitted.time));
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
        top.extend(self.freed().into_iter().map(|(key, free)| (key.to_owned(), Value::from(free.value))));
        let units = units.map(|units| format!("units = {units:?}\n")).unwrap_or_default();
        Ok(format!("{text}{units}\n{}", to_toml(&top, &Launch::from(&state))))
    }
}

/// Numbers of a fit. Their names are the keys of JSON.
#[derive(Serialize)]
pub struct FitSummary<'a> {
    /// Whether the launch may be trusted.
    pub converged: bool,
    /// Reason why it must not be trusted.
    pub reason: Option<&'a str>,
    /// Time of the launch among the samples, s.
    pub epoch: f64,
    /// Unit quaternion w, x, y, z from body to fixed coordinates.
    pub quaternion: [f64; 4],
    /// Standard deviations of the rotation vector of the orientation in the fixed frame, rad.
    pub orientation_deviation: [f64; 3],
    /// Angular velocity in the fixed frame, rad/s.
    pub omega: [f64; 3],
    /// Standard deviations of the angular velocity, in the frame that the error of the orientation turns, rad/s.
    pub omega_deviation: [f64; 3],
    /// Component of the angular velocity along the axis, rad/s.
    pub spin: f64,
    /// Its standard deviation, rad/s.
    pub spin_deviation: f64,
    /// Angle of the axis from the upward vertical, degrees.
    pub tilt_deg: f64,
    /// Its standard deviation, degrees.
    pub tilt_deviation_deg: f64,
    /// Free numbers of the top by their keys, in their order.
    #[serde(serialize_with = "as_map")]
    pub free: Vec<(&'a str, Estimated<f64>)>,
    /// Biases by sensor, in their order.
    #[serde(serialize_with = "as_map")]
    pub biases: Vec<(&'static str, Estimated<[f64; 3]>)>,
    /// Losses of rotation and the drift that they cause, if they were fitted.
    pub drift: Option<DriftSummary>,
    /// Covariance of the unknowns by rows.
    pub covariance: Vec<Vec<f64>>,
    /// Unknowns of the covariance.
    pub covariance_of: &'static str,
    /// Sum of squares by degrees of freedom.
    pub reduced_chi_squared: f64,
    /// Sum of the squares of the residuals in standard deviations; an outlier counts as the limit.
    pub chi_squared: f64,
    /// Number of values that were used.
    pub used: u32,
    /// Number of values at the end of their range, which were not used.
    pub saturated: u32,
    /// Number of values beyond the Huber limit.
    pub outliers: u32,
    /// Largest residual, standard deviations.
    pub largest_residual: f64,
    /// Directions of the launch that the samples do not determine.
    pub undetermined: Vec<&'static str>,
    /// Number of other launches that fit the first samples as well.
    pub alternatives: usize,
    /// Predictions up to ten seconds after the samples.
    pub prediction: Vec<Prediction>,
}

/// Mean drift of l, n and h during the samples, with the losses that cause it.
#[derive(Serialize)]
pub struct DriftSummary {
    /// Standard deviations of the rates.
    pub deviation: [f64; 3],
    /// Losses of rotation about the axis, across it and about the vertical, 1/s.
    pub losses: [f64; 3],
    /// Mean rates of l and n, N m, and of h, W.
    pub rates: [f64; 3],
}

/// Error bars of the motion at a time after the samples.
#[derive(Serialize)]
pub struct Prediction {
    /// Standard deviation of the axis, rad.
    pub axis_rad: f64,
    /// Standard deviation of the orientation, rad.
    pub orientation_rad: f64,
    /// Time, s.
    pub t: f64,
}

/// Unknowns of the covariance.
const UNKNOWNS: &str = "rotation vector delta of the orientation in the fixed frame, change of omega in the frame that delta turns, others";

impl FitResult {
    /// Numbers of the fit by name.
    pub fn summary(&self) -> FitSummary<'_> {
        let fitted = &self.fitted;
        let (launch, statistics, count) = (&fitted.launch, &fitted.statistics, fitted.unknown_count);
        let [d0, d1, d2, d3, d4, d5, ..] = fitted.deviations();
        let [spin, tilt] = self.spin_and_tilt();
        let drift = fitted.drift.as_ref().map(|drift| DriftSummary {
            deviation: drift.deviations(),
            losses: drift.losses,
            rates: drift.rates,
        });
        let covariance = |i| (0..count).map(|j| fitted.covariance.get(i, j)).collect();
        FitSummary {
            converged: fitted.is_trusted(),
            reason: self.reason.as_deref(),
            epoch: fitted.time,
            quaternion: launch.orientation.quaternion(),
            orientation_deviation: [d0, d1, d2],
            omega: launch.omega,
            omega_deviation: [d3, d4, d5],
            spin: spin.value,
            spin_deviation: spin.deviation,
            tilt_deg: tilt.value.to_degrees(),
            tilt_deviation_deg: tilt.deviation.to_degrees(),
            free: self.freed(),
            biases: self.biases(),
            drift,
            covariance: (0..count).map(covariance).collect(),
            covariance_of: UNKNOWNS,
            reduced_chi_squared: statistics.reduced_chi_squared(count),
            chi_squared: statistics.chi_squared,
            used: statistics.used,
            saturated: statistics.unused,
            outliers: statistics.outliers,
            largest_residual: statistics.largest,
            undetermined: self.undetermined(),
            alternatives: fitted.other_launch_count,
            prediction: self.predictions(),
        }
    }

    /// Predictions up to ten seconds after the samples; none where there is no launch.
    fn predictions(&self) -> Vec<Prediction> {
        const AHEAD: [f64; 5] = [0.0, 1.0, 2.0, 5.0, 10.0];
        let motion = self.fitted.motion().ok().filter(|_| self.used_any_sample());
        let Some(sensitivity) = motion.map(|motion| Sensitivity::new(&motion)) else { return Vec::new() };
        let at = |ahead: &f64| {
            let t = self.end + ahead;
            let [orientation_rad, axis_rad] = self.predicted(&sensitivity.at(t - self.fitted.time)?);
            Some(Prediction { axis_rad, orientation_rad, t })
        };
        AHEAD.iter().filter_map(at).collect()
    }
}

fn as_map<T: Serialize, S: Serializer>(pairs: &[(&str, T)], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map(pairs.iter().map(|(key, value)| (key, value)))
}

/// Variance of a sum of unknowns with these factors.
fn variance<const N: usize>(factors: [f64; N], covariance: impl Fn(usize, usize) -> f64) -> f64 {
    (0..N).map(|i| (0..N).map(|j| factors[i] * covariance(i, j) * factors[j]).sum::<f64>()).sum()
}
