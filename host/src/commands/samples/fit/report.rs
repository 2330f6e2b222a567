//! Fitted launch as a table and as a record.

use crate::fit::launch::FitReport;
use crate::output::short;
use crate::output::table::TextTable;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use toytop_fit::{Fitted, Sensitivity};

const AXES: [&str; 3] = ["x", "y", "z"];

/// Times up to ten seconds after the samples, s, each with the standard deviations of the orientation and of the axis, rad.
fn predictions(report: &FitReport) -> Vec<[f64; 3]> {
    const AHEAD: [f64; 5] = [0.0, 1.0, 2.0, 5.0, 10.0];
    let FitReport { input, fitted, end, .. } = report;
    let motion = fitted.motion(&input.top).ok().filter(|_| report.used_any_sample());
    let Some(sensitivity) = motion.map(|motion| Sensitivity::new(&motion)) else { return Vec::new() };
    let at = |ahead: &f64| {
        let t = end + ahead;
        let [orientation, axis] = report.predicted(&sensitivity.at(t - fitted.time)?);
        Some([t, orientation, axis])
    };
    AHEAD.iter().filter_map(at).collect()
}

/// Report as text, or the reason why there is no launch.
pub fn table(report: &FitReport) -> String {
    let state = match &report.reason {
        None => "converged".to_owned(),
        Some(reason) => format!("NOT CONVERGED: {reason}"),
    };
    if !report.used_any_sample() {
        return state + "\n";
    }
    let Fitted { launch, statistics, time, unknown_count: count, other_launch_count, .. } = report.fitted;
    let deviations = report.fitted.deviations();
    let line = |name: &str, value: f64, deviation: f64, unit: &str| {
        vec![name.to_owned(), short(value, 9), format!("+- {}", short(deviation, 2)), unit.to_owned()]
    };
    let [(spin, spin_deviation), (tilt, tilt_deviation)] = report.spin_and_tilt();
    let mut rows = vec![
        line("tilt", tilt.to_degrees(), tilt_deviation.to_degrees(), "degrees"),
        line("spin", spin, spin_deviation, "rad/s"),
    ];
    for (k, axis) in AXES.into_iter().enumerate() {
        rows.push(line(&format!("omega_{axis}"), launch.omega[k], deviations[3 + k], "rad/s"));
    }
    let quaternion = launch.orientation.quaternion().map(|x| short(x, 9)).join(" ");
    let turned = [0, 1, 2].map(|k| short(deviations[k].to_degrees(), 2)).join(" ");
    rows.push(
        ["orientation", &quaternion, &format!("+- {turned}"), "degrees about x, y, z"]
            .map(str::to_owned)
            .to_vec(),
    );
    for (key, value, deviation) in report.freed() {
        rows.push(line(key, value, deviation, ""));
    }
    for (name, values, errors) in report.biases() {
        for (k, axis) in AXES.into_iter().enumerate() {
            rows.push(line(&format!("bias of {name} {axis}"), values[k], errors[k], ""));
        }
    }
    for (name, rate, deviation, unit) in report.drift_rates() {
        rows.push(line(name, rate, deviation, unit));
    }
    let mut text = format!(
        "{state}\n\nlaunch at t = {}\n{}\n\
         chi squared by degrees of freedom {}; {} values used, {} at the end of the range, {} outliers, largest residual {} sigma\n",
        short(time, 9),
        TextTable { lines: rows, left: 4 }.aligned(),
        short(statistics.reduced_chi_squared(count), 4),
        statistics.used,
        statistics.unused,
        statistics.outliers,
        short(statistics.largest, 3)
    );
    let undetermined = report.undetermined();
    if !undetermined.is_empty() {
        text += &format!("not determined by these samples: {}\n", undetermined.join(", "));
    }
    if other_launch_count > 0 {
        text += &format!("{other_launch_count} other launches fit the first samples as well\n");
    }
    let mut ahead = vec![["t, s", "orientation +-, rad", "axis +-, rad"].map(str::to_owned).to_vec()];
    for [t, orientation, axis] in predictions(report) {
        ahead.push(vec![short(t, 6), short(orientation, 2), short(axis, 2)]);
    }
    text + "\nprediction\n" + &TextTable { lines: ahead, left: 0 }.aligned() + "\n"
}

/// Report as a record.
pub fn record(report: &FitReport) -> Value {
    let Fitted {
        launch, statistics, drift, unknown_count: count, covariance, other_launch_count, time, ..
    } = &report.fitted;
    let deviations = report.fitted.deviations();
    let [(spin, spin_deviation), (tilt, tilt_deviation)] = report.spin_and_tilt();
    let free = report.freed().into_iter();
    let free = free.map(|(key, value, deviation)| (key, json!({"deviation": deviation, "value": value})));
    let biases = report.biases().into_iter();
    let biases = biases.map(|(name, values, errors)| (name, json!({"deviation": errors, "value": values})));
    let drift = drift
        .as_ref()
        .map(|drift| json!({"deviation": drift.deviations(), "losses": drift.losses, "rates": drift.rates}));
    let covariance = |i: usize| (0..*count).map(|j| covariance.get(i, j)).collect::<Vec<_>>();
    let prediction =
        |[t, orientation, axis]: [f64; 3]| json!({"axis_rad": axis, "orientation_rad": orientation, "t": t});
    json!({
        "converged": report.fitted.is_trusted(),
        "reason": report.reason,
        "epoch": time,
        "quaternion": launch.orientation.quaternion(),
        "orientation_deviation": &deviations[..3],
        "omega": launch.omega,
        "omega_deviation": &deviations[3..6],
        "spin": spin,
        "spin_deviation": spin_deviation,
        "tilt_deg": tilt.to_degrees(),
        "tilt_deviation_deg": tilt_deviation.to_degrees(),
        "free": free.collect::<BTreeMap<_, _>>(),
        "biases": biases.collect::<BTreeMap<_, _>>(),
        "drift": drift,
        "covariance": (0..*count).map(covariance).collect::<Vec<_>>(),
        "covariance_of": COVARIANCE,
        "reduced_chi_squared": statistics.reduced_chi_squared(*count),
        "chi_squared": statistics.chi_squared,
        "used": statistics.used,
        "saturated": statistics.unused,
        "outliers": statistics.outliers,
        "largest_residual": statistics.largest,
        "undetermined": report.undetermined(),
        "alternatives": other_launch_count,
        "prediction": predictions(report).into_iter().map(prediction).collect::<Vec<_>>(),
    })
}

/// Unknowns of the covariance.
const COVARIANCE: &str = "rotation vector delta of the orientation in the fixed frame, change of omega in the frame that delta turns, others";
