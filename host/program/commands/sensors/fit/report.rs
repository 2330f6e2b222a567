//! Fitted launch as a table.

use crate::terminal::table::TextTable;
use toytop_host::output::significant;
use toytop_host::sensors::fit::{Estimated, FitResult, RATES};
use toytop_host::sensors::summary::{DriftSummary, FitSummary, Prediction};

/// Report as text, or the reason why there is no launch.
pub fn table(fit: &FitResult, summary: &FitSummary<'_>) -> String {
    const AXES: [&str; 3] = ["x", "y", "z"];
    let state = match summary.reason {
        None => "converged".to_owned(),
        Some(reason) => format!("NOT CONVERGED: {reason}"),
    };
    if !fit.used_any_sample() {
        return state + "\n";
    }
    let line = |name: &str, value: f64, deviation: f64, unit: &str| {
        let deviation = format!("+- {}", significant(deviation, 2));
        [name.to_owned(), significant(value, 9), deviation, unit.to_owned()]
    };
    let mut rows = vec![
        line("tilt", summary.tilt_deg, summary.tilt_deviation_deg, "degrees"),
        line("spin", summary.spin, summary.spin_deviation, "rad/s"),
    ];
    for (k, axis) in AXES.into_iter().enumerate() {
        rows.push(line(&format!("omega_{axis}"), summary.omega[k], summary.omega_deviation[k], "rad/s"));
    }
    let quaternion = summary.quaternion.map(|x| significant(x, 9)).join(" ");
    let turned = summary.orientation_deviation.map(|x| significant(x.to_degrees(), 2)).join(" ");
    rows.push(
        ["orientation", &quaternion, &format!("+- {turned}"), "degrees about x, y, z"].map(str::to_owned),
    );
    for (key, Estimated { deviation, value }) in &summary.free {
        rows.push(line(key, *value, *deviation, ""));
    }
    for (sensor, Estimated { deviation, value }) in &summary.biases {
        for (k, axis) in AXES.into_iter().enumerate() {
            rows.push(line(&format!("bias of {sensor} {axis}"), value[k], deviation[k], ""));
        }
    }
    if let Some(DriftSummary { deviation, rates, .. }) = &summary.drift {
        for (k, (name, unit)) in RATES.into_iter().enumerate() {
            rows.push(line(name, rates[k], deviation[k], unit));
        }
    }
    let mut text = format!(
        "{state}\n\nlaunch at t = {}\n{}\n\
         chi squared by degrees of freedom {}; {} values used, {} at the end of the range, {} outliers, largest residual {} sigma\n",
        significant(summary.epoch, 9),
        TextTable::new(4, [""; 0], rows).aligned(),
        significant(summary.reduced_chi_squared, 4),
        summary.used,
        summary.saturated,
        summary.outliers,
        significant(summary.largest_residual, 3)
    );
    if !summary.undetermined.is_empty() {
        text += &format!("not determined by these samples: {}\n", summary.undetermined.join(", "));
    }
    if summary.alternatives > 0 {
        text += &format!("{} other launches fit the first samples as well\n", summary.alternatives);
    }
    let ahead = |Prediction { axis_rad, orientation_rad, t }: &Prediction| {
        [significant(*t, 6), significant(*orientation_rad, 2), significant(*axis_rad, 2)]
    };
    let header = ["t, s", "orientation +-, rad", "axis +-, rad"];
    let prediction = TextTable::new(0, header, summary.prediction.iter().map(ahead));
    text + "\nprediction\n" + &prediction.aligned() + "\n"
}
