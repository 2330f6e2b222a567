//! Fitted launch as text and as JSON.

use super::{FitReport, RATES};
use crate::output::{columns, short};
use serde_json::json;
use std::collections::BTreeMap;
use toytop_fit::{Fitted, Sensitivity};

/// Times after the end of the samples at which the error of the prediction is stated, s.
const AHEAD: [f64; 5] = [0.0, 1.0, 2.0, 5.0, 10.0];

impl FitReport {
    /// Times of the prediction, s, each with the standard deviations of the orientation and of the axis, rad.
    fn predictions(&self) -> Vec<[f64; 3]> {
        if !self.has_launch() {
            return Vec::new();
        }
        let Ok(motion) = self.fitted.motion(&self.input.top) else { return Vec::new() };
        let sensitivity = Sensitivity::new(&motion);
        let at = |ahead: &f64| {
            let t = self.end + ahead;
            let partials = sensitivity.at(t - self.fitted.epoch)?;
            let covariance = self.fitted.orientation_covariance(&partials);
            let axis = partials.axis();
            let trace: f64 = (0..3).map(|k| covariance[k][k]).sum();
            let along: f64 =
                (0..3).map(|i| (0..3).map(|j| axis[i] * covariance[i][j] * axis[j]).sum::<f64>()).sum();
            Some([t, trace.sqrt(), (trace - along).max(0.0).sqrt()])
        };
        AHEAD.iter().filter_map(at).collect()
    }

    /// Report as text; of a launch that does not exist, the reason.
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
            line(key, plus(value, deviation, ""));
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
        for [t, orientation, axis] in self.predictions() {
            ahead.push(vec![short(t, 6), short(orientation, 2), short(axis, 2)]);
        }
        text + "\nprediction\n" + &columns(ahead, 0) + "\n"
    }

    /// Report as JSON.
    pub fn json(&self) -> serde_json::Value {
        let Fitted { launch, statistics, .. } = self.fitted;
        let deviations = self.fitted.deviations();
        let [(spin, spin_deviation), (tilt, tilt_deviation)] = self.spin_and_tilt();
        let freed = self.freed().into_iter();
        let free: BTreeMap<_, _> = freed
            .map(|(key, value, deviation)| (key, json!({"value": value, "deviation": deviation})))
            .collect();
        let biases = self.biases().into_iter();
        let biases: BTreeMap<_, _> = biases
            .map(|(name, values, errors)| (name, json!({"value": values, "deviation": errors})))
            .collect();
        let count = self.fitted.count;
        let covariance: Vec<Vec<f64>> =
            (0..count).map(|i| (0..count).map(|j| self.fitted.covariance.get(i, j)).collect()).collect();
        let predictions: Vec<_> = self
            .predictions()
            .iter()
            .map(|[t, orientation, axis]| json!({"t": t, "orientation_rad": orientation, "axis_rad": axis}))
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
            "covariance_of": "rotation vector delta of the orientation in the fixed frame, change of omega in the frame that delta turns, others",
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
}
