//! Fitted launch: its numbers with their standard deviations, and the scenario that it becomes.

#[cfg(feature = "program")]
mod shown;

use super::launch::FitInput;
use super::launch::given;
use crate::Failure;
use crate::output::{number, short};
use toml::{Table, Value};
use toytop_fit::{Drift, Fitted, Measurement};
use toytop_model::equations::dot;

/// First integrals, and the units of their rates.
const RATES: [(&str, &str); 3] = [("l", "N m"), ("n", "N m"), ("h", "W")];

/// Fitted launch.
pub struct FitReport {
    /// Input of the fit.
    pub input: FitInput,
    /// Result of the fit.
    pub fitted: Fitted,
    /// Reason why the launch must not be trusted, in words; `None` where it may be.
    pub reason: Option<String>,
    /// Time of the last measurement, s.
    pub end: f64,
}

impl FitReport {
    /// Values of the free keys with their standard deviations.
    pub fn freed(&self) -> Vec<(&str, f64, f64)> {
        let deviations = self.fitted.deviations();
        let values = self.fitted.launch.other_unknowns().iter().zip(&deviations[6..]);
        let keys = self.input.free.iter().zip(values);
        keys.map(|(key, (value, deviation))| {
            let fitted = given(key, &self.input.table, &self.input.top) * value.exp();
            (key.as_str(), fitted, fitted * deviation)
        })
        .collect()
    }

    /// Biases by sensor, with their standard deviations.
    pub fn biases(&self) -> Vec<(&'static str, [f64; 3], [f64; 3])> {
        let deviations = self.fitted.deviations();
        let values = self.fitted.launch.other_unknowns();
        let losses = if self.fitted.drift.is_some() { Drift::LOSSES.len() } else { 0 };
        let mut place = self.input.free.len() + losses;
        let mut found = Vec::new();
        for instrument in &self.input.sensors.instruments {
            if instrument.sensor.bias_deviation() > 0.0 {
                let three = |from: &[f64]| [from[0], from[1], from[2]];
                found.push((instrument.kind.name, three(&values[place..]), three(&deviations[6 + place..])));
                place += 3;
            }
        }
        found
    }

    /// Whether the launch follows from the samples. Without any value that was used it is that of the beginning.
    pub fn has_launch(&self) -> bool {
        self.fitted.statistics.used > 0
    }

    /// Spin ω·r and tilt (rad), each with its standard deviation.
    pub fn spin_and_tilt(&self) -> [(f64, f64); 2] {
        let launch = &self.fitted.launch;
        let (r, w) = (launch.orientation.axis(), launch.omega);
        let deviation = |row: [f64; 6]| {
            let square: f64 = (0..6)
                .map(|i| (0..6).map(|j| row[i] * self.fitted.covariance.get(i, j) * row[j]).sum::<f64>())
                .sum();
            square.sqrt()
        };
        // ω turns with the axis
        let spin = deviation([0.0, 0.0, 0.0, r[0], r[1], r[2]]);
        let level = (r[0] * r[0] + r[1] * r[1]).sqrt();
        let lean = if level > 0.0 { [-r[1] / level, r[0] / level] } else { [1.0, 0.0] };
        let tilt = deviation([lean[0], lean[1], 0.0, 0.0, 0.0, 0.0]);
        [(dot(w, r), spin), (level.atan2(r[2]), tilt)]
    }

    /// Names of the directions of the launch that the samples do not determine.
    pub fn undetermined(&self) -> Vec<&'static str> {
        let found = self.fitted.unobservable;
        let mut names: Vec<&'static str> = [(found.yaw, "yaw"), (found.roll, "roll"), (found.spin, "spin")]
            .into_iter()
            .filter_map(|(is, name)| is.then_some(name))
            .collect();
        if found.count > names.len() {
            names.push("other");
        }
        names
    }

    /// Residuals of each measurement in standard deviations of the noise, after subtraction of the fitted bias. NaN stands for a
    /// component that the sensor does not have or that is at the end of its range, and for a measurement at a time at which
    /// the derivatives of the motion cannot be computed. All residuals are NaN if no top has the fitted numbers.
    pub fn residuals(&self, measurements: &[Measurement]) -> Vec<[f64; 3]> {
        let Ok(sensitivity) = self.fitted.sensitivity(&self.input.top) else {
            return vec![[f64::NAN; 3]; measurements.len()];
        };
        let mut cursor = sensitivity.cursor();
        let biases = self.biases();
        let of = |Measurement { time, sensor, values }: &Measurement| {
            let Some(partials) = cursor.at(time - self.fitted.epoch) else { return [f64::NAN; 3] };
            let instrument = &self.input.sensors.instruments[*sensor];
            let bias = biases.iter().find(|(name, ..)| *name == instrument.kind.name);
            let bias = bias.map_or([0.0; 3], |(_, bias, _)| *bias);
            let predicted = instrument.sensor.predict(&partials, values);
            [0, 1, 2].map(|k| {
                let deviation = predicted.deviation[k];
                if deviation.is_finite() { (predicted.difference[k] - bias[k]) / deviation } else { f64::NAN }
            })
        };
        measurements.iter().map(of).collect()
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
            format!("# Fitted by `toytop fit`; t = 0 is t = {} of the samples.\n", number(self.fitted.epoch));
        if let Some(drift) = &self.fitted.drift {
            let rates = RATES.iter().zip(drift.rates.iter().zip(drift.deviations()));
            let rates = rates.map(|((name, unit), (rate, deviation))| {
                format!("d{name}/dt = {} +- {} {unit}", short(*rate, 4), short(deviation, 2))
            });
            let rates = rates.collect::<Vec<_>>().join(", ");
            text +=
                &format!("# Drift during the samples, which the motion below does not contain: {rates}\n");
        }
        let mut top = self.input.table.clone();
        for (key, value, _) in self.freed() {
            top.insert(key.to_owned(), Value::Float(value));
        }
        let (phi, omega) = (state.orientation(), state.omega());
        let numbers = |numbers: &[f64]| Value::Array(numbers.iter().copied().map(Value::Float).collect());
        let motion_table = Table::from_iter([
            ("kind".to_owned(), Value::from("state")),
            ("alpha".to_owned(), numbers(&[phi.alpha.re, phi.alpha.im])),
            ("beta".to_owned(), numbers(&[phi.beta.re, phi.beta.im])),
            ("omega".to_owned(), numbers(&omega)),
        ]);
        let mut root = Table::from_iter([
            ("top".to_owned(), Value::Table(top)),
            ("motion".to_owned(), Value::Table(motion_table)),
        ]);
        if let Some(units) = units {
            root.insert("units".to_owned(), Value::from(units));
        }
        Ok(format!("{text}\n{root}"))
    }
}
