//! Pictures of a fit: its residuals, and how the error of its prediction grows.

use crate::fit::report::FitReport;
use crate::fit::residuals;
use crate::pictures::figures::{Chart, Curve, Picture};
use toytop::fit::Measurement;
use toytop::su2::Vector;
use toytop::{Motion, Sensitivity};

/// Number of times in the picture of the prediction.
const POINTS: u32 = 80;
/// First and last of these times, after the end of the samples, s.
const AHEAD: [f64; 2] = [0.01, 100.0];

/// Residuals in standard deviations, a curve for each column of the samples; those at the end of the range are left out.
#[must_use]
pub(crate) fn residuals(report: &FitReport<'_>, measurements: &[Measurement]) -> Picture {
    let instruments = &report.sensors.instruments;
    let mut curves: Vec<Vec<Curve>> = instruments
        .iter()
        .map(|one| {
            let names = one.kind.residuals().iter();
            names.map(|name| Curve { name: (*name).to_owned(), points: Vec::new(), marked: false }).collect()
        })
        .collect();
    let found = residuals::residuals(report, measurements);
    for (Measurement { time, sensor, .. }, residual) in measurements.iter().zip(found) {
        for (curve, value) in curves[*sensor].iter_mut().zip(residual) {
            if value.is_finite() {
                curve.points.push([*time, value]);
            }
        }
    }
    let curves: Vec<_> = curves.into_iter().flatten().filter(|curve| !curve.points.is_empty()).collect();
    let chart = Chart {
        title: "Residuals of the fit",
        labels: ["t, s", "residual, standard deviations"],
        powers: [false; 2],
    };
    Picture::new("residuals", "Residuals", chart.draw(&curves))
}

/// Standard deviation of the predicted orientation, and the half axes of the error ellipse of the predicted axis, against the
/// time after the last sample.
#[must_use]
pub(crate) fn prediction(report: &FitReport<'_>, motion: &Motion) -> Picture {
    let sensitivity = Sensitivity::of(motion);
    let names = ["orientation", "axis: long half axis", "axis: short half axis"];
    let mut curves = names.map(|name| Curve { name: name.to_owned(), points: Vec::new(), marked: false });
    for point in 0..POINTS {
        let ahead = AHEAD[0] * (AHEAD[1] / AHEAD[0]).powf(f64::from(point) / f64::from(POINTS - 1));
        let Some(partials) = sensitivity.at(report.end + ahead - report.fitted.epoch) else { break };
        let covariance = report.fitted.orientation_covariance(&partials);
        let trace: f64 = (0..3).map(|k| covariance[k][k]).sum();
        let [long, short] = ellipse(&covariance, partials.axis());
        for (curve, value) in curves.iter_mut().zip([trace.max(0.0).sqrt(), long, short]) {
            curve.points.push([ahead, value]);
        }
    }
    let chart = Chart {
        title: "Standard deviation of the prediction",
        labels: ["time after the last sample, s", "standard deviation, rad"],
        powers: [true; 2],
    };
    Picture::new("prediction", "Error of the prediction", chart.draw(&curves))
}

/// Half axes of the ellipse of the axis, rad: roots of the eigenvalues of the covariance across it.
fn ellipse(covariance: &[Vector<f64>; 3], axis: Vector<f64>) -> [f64; 2] {
    // P = (1 - r rᵀ) covariance (1 - r rᵀ) has the eigenvalue 0 and two others, whose sum is the trace and whose sum of squares is `squares`
    let image = covariance.map(|row| (0..3).map(|j| row[j] * axis[j]).sum::<f64>());
    let along: f64 = (0..3).map(|i| axis[i] * image[i]).sum();
    let trace = (0..3).map(|k| covariance[k][k]).sum::<f64>() - along;
    let mut squares = 0.0;
    for i in 0..3 {
        for j in 0..3 {
            let entry =
                covariance[i][j] - axis[i] * image[j] - image[i] * axis[j] + axis[i] * axis[j] * along;
            squares += entry * entry;
        }
    }
    let half = 0.5 * trace;
    let root = (0.5 * squares - half * half).max(0.0).sqrt();
    [half + root, half - root].map(|value| value.max(0.0).sqrt())
}
