//! Fitted launch as a table, as JSON, and as a row of CSV.

use crate::fit::launch::FitReport;
use crate::output::{Record, columns, short};
use serde_json::{Value, json};
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
        columns(rows, 4),
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
    text + "\nprediction\n" + &columns(ahead, 0) + "\n"
}

/// Report as an object of JSON.
pub fn object(report: &FitReport) -> Record {
    let Fitted {
        launch, statistics, drift, unknown_count: count, covariance, other_launch_count, time, ..
    } = &report.fitted;
    let deviations = report.fitted.deviations();
    let [(spin, spin_deviation), (tilt, tilt_deviation)] = report.spin_and_tilt();
    let free = report.freed().into_iter();
    let free = free.map(|(key, value, deviation)| (key, json!({"value": value, "deviation": deviation})));
    let biases = report.biases().into_iter();
    let biases = biases.map(|(name, values, errors)| (name, json!({"value": values, "deviation": errors})));
    let drift = drift
        .as_ref()
        .map(|drift| json!({"rates": drift.rates, "deviation": drift.deviations(), "losses": drift.losses}));
    let covariance = |i: usize| (0..*count).map(|j| covariance.get(i, j)).collect::<Vec<_>>();
    let prediction =
        |[t, orientation, axis]: [f64; 3]| json!({"t": t, "orientation_rad": orientation, "axis_rad": axis});
    Record::default()
        .with("converged", report.fitted.is_trusted())
        .with("reason", report.reason.as_deref())
        .with("epoch", *time)
        .with("quaternion", launch.orientation.quaternion())
        .with("orientation_deviation", &deviations[..3])
        .with("omega", launch.omega)
        .with("omega_deviation", &deviations[3..6])
        .with("spin", spin)
        .with("spin_deviation", spin_deviation)
        .with("tilt_deg", tilt.to_degrees())
        .with("tilt_deviation_deg", tilt_deviation.to_degrees())
        .with("free", free.collect::<Value>())
        .with("biases", biases.collect::<Value>())
        .with("drift", drift)
        .with("covariance", (0..*count).map(covariance).collect::<Value>())
        .with("covariance_of", COVARIANCE)
        .with("reduced_chi_squared", statistics.reduced_chi_squared(*count))
        .with("chi_squared", statistics.chi_squared)
        .with("used", statistics.used)
        .with("saturated", statistics.unused)
        .with("outliers", statistics.outliers)
        .with("largest_residual", statistics.largest)
        .with("undetermined", report.undetermined())
        .with("alternatives", *other_launch_count)
        .with("prediction", predictions(report).into_iter().map(prediction).collect::<Value>())
}

/// Unknowns of the covariance.
const COVARIANCE: &str = "rotation vector delta of the orientation in the fixed frame, change of omega in the frame that delta turns, others";

/// Launch in one row.
pub fn row(FitReport { fitted, reason, .. }: &FitReport) -> Record {
    let [w, x, y, z] = fitted.launch.orientation.quaternion();
    let deviations = fitted.deviations();
    Record::default()
        .with("reason", reason.as_deref())
        .with("epoch", fitted.time)
        .with("w", w)
        .with("x", x)
        .with("y", y)
        .with("z", z)
        .with("omega", fitted.launch.omega)
        .with("orientation_deviation", &deviations[..3])
        .with("omega_deviation", &deviations[3..6])
        .with("reduced_chi_squared", fitted.statistics.reduced_chi_squared(fitted.unknown_count))
}
