//! Report of a fitted launch, and the scenario that it becomes.

use super::free::FreeKey;
use super::sensors::Sensors;
use crate::Failure;
#[cfg(feature = "program")]
use crate::output::columns;
use crate::output::number;
use crate::output::short;
use serde_json::json;
use toml::{Table, Value};
use toytop::fit::{Drift, Fitted};
use toytop::{Motion, Sensitivity, Top};

/// Times after the end of the samples at which the error of the prediction is stated, s.
const AHEAD: [f64; 5] = [0.0, 1.0, 2.0, 5.0, 10.0];

/// First integrals, and the units of their rates.
const RATES: [(&str, &str); 3] = [("l", "N m"), ("n", "N m"), ("h", "W")];

/// Fitted launch with the data of its report.
pub struct FitReport<'a> {
    /// Result of the fit.
    pub fitted: &'a Fitted,
    /// Reason why the launch must not be trusted, in words; `None` where it may be.
    pub reason: Option<String>,
    /// Top of the file.
    pub top: &'a Top,
    /// Table `[top]` of the file.
    pub table: &'a Table,
    /// Keys that were free.
    pub free: &'a [FreeKey],
    /// Sensors that were used.
    pub sensors: &'a Sensors,
    /// Time of the last sample, s.
    pub end: f64,
}

/// Uncertainty of the predicted orientation at a time.
struct Prediction {
    t: f64,
    orientation: f64,
    axis: f64,
}

impl FitReport<'_> {
    /// Values of the free keys with their standard deviations.
    #[must_use]
    pub fn freed(&self) -> Vec<(FreeKey, f64, f64)> {
        let deviations = self.fitted.deviations();
        let values = self.fitted.launch.other_unknowns().iter().zip(&deviations[6..]);
        let of = |(key, (value, deviation)): (&FreeKey, (&f64, &f64))| {
            let fitted = key.given(self.table, self.top) * value.exp();
            (*key, fitted, fitted * deviation)
        };
        self.free.iter().zip(values).map(of).collect()
    }

    /// Biases by sensor, with their standard deviations.
    #[must_use]
    pub fn biases(&self) -> Vec<(&'static str, [f64; 3], [f64; 3])> {
        let deviations = self.fitted.deviations();
        let values = self.fitted.launch.other_unknowns();
        let losses = if self.fitted.drift.is_some() { Drift::LOSSES.len() } else { 0 };
        let mut place = self.free.len() + losses;
        let mut found = Vec::new();
        for instrument in &self.sensors.instruments {
            if instrument.sensor.bias_deviation() > 0.0 {
                let three = |from: &[f64]| [from[0], from[1], from[2]];
                found.push((instrument.kind.name, three(&values[place..]), three(&deviations[6 + place..])));
                place += 3;
            }
        }
        found
    }

    /// Whether the launch follows from the samples. Without any value that was used it is that of the beginning.
    #[must_use]
    pub fn has_launch(&self) -> bool {
        self.fitted.statistics.used > 0
    }

    fn predictions(&self) -> Vec<Prediction> {
        if !self.has_launch() {
            return Vec::new();
        }
        let Ok(motion) = self.fitted.motion(self.top) else { return Vec::new() };
        let sensitivity = Sensitivity::of(&motion);
        let at = |ahead: &f64| {
            let t = self.end + ahead;
            let partials = sensitivity.at(t - self.fitted.epoch)?;
            let covariance = self.fitted.orientation_covariance(&partials);
            let axis = partials.axis();
            let trace: f64 = (0..3).map(|k| covariance[k][k]).sum();
            let along: f64 =
                (0..3).map(|i| (0..3).map(|j| axis[i] * covariance[i][j] * axis[j]).sum::<f64>()).sum();
            Some(Prediction { t, orientation: trace.sqrt(), axis: (trace - along).max(0.0).sqrt() })
        };
        AHEAD.iter().filter_map(at).collect()
    }

    /// Spin ω·r and tilt (rad), each with its standard deviation.
    #[must_use]
    pub fn spin_and_tilt(&self) -> [(f64, f64); 2] {
        let launch = &self.fitted.launch;
        let (r, w) = (launch.orientation.axis(), launch.omega);
        let cross = |x: [f64; 3], y: [f64; 3]| {
            [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]]
        };
        let dot = |x: [f64; 3], y: [f64; 3]| x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
        let deviation = |row: [f64; 6]| {
            let square: f64 = (0..6)
                .map(|i| (0..6).map(|j| row[i] * self.fitted.covariance.of(i, j) * row[j]).sum::<f64>())
                .sum();
            square.sqrt()
        };
        let by_turn = cross(r, w);
        let spin = deviation([by_turn[0], by_turn[1], by_turn[2], r[0], r[1], r[2]]);
        let level = (r[0] * r[0] + r[1] * r[1]).sqrt();
        let lean = if level > 0.0 { [-r[1] / level, r[0] / level] } else { [1.0, 0.0] };
        let tilt = deviation([lean[0], lean[1], 0.0, 0.0, 0.0, 0.0]);
        [(dot(w, r), spin), (level.atan2(r[2]), tilt)]
    }

    /// Names of the directions of the launch that the samples do not determine.
    #[must_use]
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

    /// Report as text; of a launch that does not exist, the reason.
    #[cfg(feature = "program")]
    #[must_use]
    pub fn table(&self) -> String {
        let state = match &self.reason {
            None => "converged".to_owned(),
            Some(reason) => format!("NOT CONVERGED: {reason}"),
        };
        if !self.has_launch() {
            return state + "\n";
        }
        let Fitted { launch, statistics, .. } = self.fitted;
        let deviations = self.fitted.deviations();
        let plus = |value: f64, deviation: f64, unit: &str| {
            [short(value, 9), format!("+- {}", short(deviation, 2)), unit.to_owned()]
        };
        let [(spin, spin_deviation), (tilt, tilt_deviation)] = self.spin_and_tilt();
        let degrees = |x: f64| x.to_degrees();
        let mut rows: Vec<Vec<String>> = Vec::new();
        let mut line = |name: &str, rest: [String; 3]| {
            rows.push(std::iter::once(name.to_owned()).chain(rest).collect());
        };
        line("tilt", plus(degrees(tilt), degrees(tilt_deviation), "degrees"));
        line("spin", plus(spin, spin_deviation, "rad/s"));
        for (k, name) in ["omega_x", "omega_y", "omega_z"].into_iter().enumerate() {
            line(name, plus(launch.omega[k], deviations[3 + k], "rad/s"));
        }
        let quaternion = launch.orientation.quaternion().map(|x| short(x, 9)).join(" ");
        let turned = [0, 1, 2].map(|k| short(degrees(deviations[k]), 2)).join(" ");
        line("orientation", [quaternion, format!("+- {turned}"), "degrees about x, y, z".to_owned()]);
        for (key, value, deviation) in self.freed() {
            line(key.name(), plus(value, deviation, ""));
        }
        for (name, values, errors) in self.biases() {
            for (k, axis) in ["x", "y", "z"].into_iter().enumerate() {
                line(&format!("bias of {name} {axis}"), plus(values[k], errors[k], ""));
            }
        }
        if let Some(drift) = &self.fitted.drift {
            let errors = drift.deviations();
            for (k, (name, unit)) in RATES.into_iter().enumerate() {
                line(&format!("d{name}/dt"), plus(drift.rates[k], errors[k], unit));
            }
        }
        let reduced = statistics.reduced_chi_squared(self.fitted.count);
        let mut text =
            format!("{state}\n\nlaunch at t = {}\n{}\n", short(self.fitted.epoch, 9), columns(rows, 4));
        text += &format!(
            "chi squared by degrees of freedom {}; {} values used, {} at the end of the range, {} outliers, largest residual {} sigma\n",
            short(reduced, 4),
            statistics.used,
            statistics.unused,
            statistics.outliers,
            short(statistics.largest, 3)
        );
        let undetermined = self.undetermined();
        if !undetermined.is_empty() {
            text += &format!("not determined by these samples: {}\n", undetermined.join(", "));
        }
        if self.fitted.alternatives > 0 {
            text += &format!("{} other launches fit the first samples as well\n", self.fitted.alternatives);
        }
        let mut ahead = vec![["t, s", "orientation +-, rad", "axis +-, rad"].map(str::to_owned).to_vec()];
        for Prediction { t, orientation, axis } in self.predictions() {
            ahead.push(vec![short(t, 6), short(orientation, 2), short(axis, 2)]);
        }
        text + "\nprediction\n" + &columns(ahead, 0) + "\n"
    }

    /// Report as JSON.
    #[must_use]
    pub fn json(&self) -> serde_json::Value {
        let Fitted { launch, statistics, .. } = self.fitted;
        let deviations = self.fitted.deviations();
        let [(spin, spin_deviation), (tilt, tilt_deviation)] = self.spin_and_tilt();
        let free: serde_json::Map<String, serde_json::Value> = self
            .freed()
            .into_iter()
            .map(|(key, value, deviation)| {
                (key.name().to_owned(), json!({"value": value, "deviation": deviation}))
            })
            .collect();
        let biases: serde_json::Map<String, serde_json::Value> = self
            .biases()
            .into_iter()
            .map(|(name, values, errors)| (name.to_owned(), json!({"value": values, "deviation": errors})))
            .collect();
        let count = self.fitted.count;
        let covariance: Vec<Vec<f64>> =
            (0..count).map(|i| (0..count).map(|j| self.fitted.covariance.of(i, j)).collect()).collect();
        let predictions: Vec<_> = self
            .predictions()
            .iter()
            .map(|one| json!({"t": one.t, "orientation_rad": one.orientation, "axis_rad": one.axis}))
            .collect();
        json!({
            "converged": self.fitted.converged(),
            "reason": self.reason,
            "epoch": self.fitted.epoch,
            "quaternion": launch.orientation.quaternion(),
            "orientation_deviation": deviations[..3],
            "omega": launch.omega,
            "omega_deviation": deviations[3..6],
            "spin": spin,
            "spin_deviation": spin_deviation,
            "tilt_deg": tilt.to_degrees(),
            "tilt_deviation_deg": tilt_deviation.to_degrees(),
            "free": free,
            "biases": biases,
            "drift": self.fitted.drift.map(|drift| json!({
                "rates": drift.rates,
                "deviation": drift.deviations(),
                "losses": drift.losses,
            })),
            "covariance": covariance,
            "reduced_chi_squared": statistics.reduced_chi_squared(count),
            "chi_squared": statistics.chi_squared,
            "used": statistics.used,
            "saturated": statistics.unused,
            "outliers": statistics.outliers,
            "largest_residual": statistics.largest,
            "undetermined": self.undetermined(),
            "alternatives": self.fitted.alternatives,
            "prediction": predictions,
        })
    }

    /// Scenario of the fitted launch, which is its state at t = 0.
    ///
    /// # Errors
    /// [`Failure::Input`]: no top has the fitted numbers.
    pub fn scenario(&self, units: Option<&str>) -> Result<(String, Motion), Failure> {
        let refuse = |error: toytop::ParameterError| Failure::Input(format!("the fitted top: {error}"));
        let motion = self.fitted.motion(self.top).map_err(refuse)?;
        let state = self.fitted.state().map_err(refuse)?;
        let mut text =
            format!("# Fitted by `toytop fit`; t = 0 is t = {} of the samples.\n", number(self.fitted.epoch));
        if let Some(drift) = &self.fitted.drift {
            text += "# Drift during the samples, which the motion below does not contain:";
            let errors = drift.deviations();
            for (k, (name, unit)) in RATES.into_iter().enumerate() {
                text +=
                    &format!(" d{name}/dt = {} +- {} {unit}", short(drift.rates[k], 4), short(errors[k], 2));
                text += if k < 2 { "," } else { "\n" };
            }
        }
        text += "\n";
        if let Some(units) = units {
            text += &format!("units = {units:?}\n\n");
        }
        text += "[top]\n";
        let freed = self.freed();
        let value_of =
            |name: &str| freed.iter().find(|(key, ..)| key.name() == name).map(|(_, value, _)| *value);
        for (name, value) in self.table {
            match value_of(name) {
                Some(fitted) => text += &format!("{name} = {}\n", number(fitted)),
                None => match value {
                    Value::String(word) => text += &format!("{name} = {word:?}\n"),
                    Value::Integer(whole) => text += &format!("{name} = {whole}\n"),
                    other => text += &format!("{name} = {}\n", number(other.as_float().unwrap_or(f64::NAN))),
                },
            }
        }
        if let Some(gravity) = value_of("gravity").filter(|_| !self.table.contains_key("gravity")) {
            text += &format!("gravity = {}\n", number(gravity));
        }
        let orientation = state.orientation();
        let omega = state.omega().map(number).join(", ");
        let pair = |z: toytop::Complex<f64>| format!("[{}, {}]", number(z.re), number(z.im));
        text += &format!(
            "\n[motion]\nkind = \"state\"\nalpha = {}\nbeta = {}\nomega = [{omega}]\n",
            pair(orientation.alpha),
            pair(orientation.beta)
        );
        Ok((text, motion))
    }
}
