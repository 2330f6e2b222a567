//! Pictures of a fit: its residuals, and how the error of its prediction grows.

use super::chart::{COLORS, Chart, Curve};
use super::drawing::{BOUND, frame};
use crate::fit::launch::FitReport;
use crate::motion::propagate::period;
use kuva::plot::LinePlot;
use kuva::plot::scatter::ScatterPlot;
use kuva::render::figure::Figure;
use kuva::render::plots::Plot;
use kuva::render::render::Scene;
use nalgebra::{Matrix3, Vector3};
use toytop::Motion;
use toytop::su2::Vector;
use toytop_fit::{Measurement, Sensitivity};

/// Residual of an outlier, standard deviations.
const OUTLIER: f64 = 3.0;

/// Residuals in standard deviations: a strip for each sensor, with a dot for each sample and lines at ±3. Those at the end of the range
/// of a sensor are left out.
pub fn residuals(report: &FitReport, measurements: &[Measurement]) -> Scene {
    let found = report.residuals(measurements);
    let ends = ends_of(measurements);
    let level = |x: f64| {
        LinePlot::new().with_data(ends.map(|t| (t, x))).with_color(BOUND).with_stroke_width(0.8).into()
    };
    let (mut strips, mut layouts) = (Vec::new(), Vec::new());
    for (sensor, instrument) in report.input.sensors.instruments.iter().enumerate() {
        let mut strip: Vec<Plot> = vec![level(OUTLIER), level(-OUTLIER)];
        let mut furthest = 4.0;
        for (k, (name, color)) in instrument.kind.residuals().iter().zip(COLORS).enumerate() {
            let of_sensor = measurements.iter().zip(&found).filter(|(sample, _)| sample.sensor == sensor);
            let points = of_sensor.map(|(sample, residual)| (sample.time, residual[k]));
            let points: Vec<_> = points.filter(|(_, residual)| residual.is_finite()).collect();
            if !points.is_empty() {
                furthest = points.iter().map(|(_, residual)| residual.abs()).fold(furthest, f64::max);
                let dots = ScatterPlot::new().with_data(points).with_color(color).with_size(1.6);
                strip.push(dots.with_legend(*name).into());
            }
        }
        let title = format!("{}: residuals of the fit, standard deviations", instrument.kind.name);
        let range = [-1.1 * furthest, 1.1 * furthest];
        let layout = frame(&strip, &title, "t, s", [ends, range]).with_title_size(14).with_show_grid(false);
        layouts.push(layout.with_force_margins(60.0, 110.0));
        strips.push(strip);
    }
    let figure = Figure::new(strips.len(), 1).with_cell_size(920.0, 210.0).with_plots(strips);
    figure.with_layouts(layouts).with_keep_panel_legends().render()
}

/// First and last time of the measurements, s, apart from each other even if there is only one.
fn ends_of(measurements: &[Measurement]) -> [f64; 2] {
    let time = |measurement: Option<&Measurement>| measurement.map_or(0.0, |one| one.time);
    let [from, until] = [time(measurements.first()), time(measurements.last())];
    if from < until { [from, until] } else { [from - 0.5, from + 0.5] }
}

/// Number of intervals of time in the picture of the prediction.
const INTERVALS: u32 = 80;
/// Begin of the first interval and end of the last, after the end of the samples, s.
const AHEAD: [f64; 2] = [0.01, 100.0];
/// Number of times in a nutation period, with which the standard deviations oscillate: one time in an interval would show an alias.
const PER_PERIOD: f64 = 16.0;
/// Greatest number of times in an interval.
const MOST_TIMES: f64 = 200.0;

/// Greatest standard deviation of the predicted orientation, and greatest half axes of the error ellipse of the predicted axis, in
/// each of the intervals of time after the last sample.
pub fn prediction(report: &FitReport, motion: &Motion) -> Scene {
    let sensitivity = Sensitivity::new(motion);
    let mut cursor = sensitivity.cursor();
    let names = ["orientation", "axis: long half axis", "axis: short half axis"];
    let mut curves = names.map(|name| Curve::line(name, Vec::new()));
    let step = period(motion) / PER_PERIOD;
    let begin =
        |interval: u32| AHEAD[0] * (AHEAD[1] / AHEAD[0]).powf(f64::from(interval) / f64::from(INTERVALS));
    let mut deviations = |ahead: f64| {
        let partials = cursor.at(report.end + ahead - report.fitted.epoch)?;
        let [orientation, _] = report.predicted(&partials);
        let [long, short] = ellipse(&report.fitted.orientation_covariance(&partials), partials.axis());
        Some([orientation, long, short])
    };
    for interval in 0..INTERVALS {
        let [from, until] = [begin(interval), begin(interval + 1)];
        let times = ((until - from) / step).ceil().clamp(1.0, MOST_TIMES) as u32;
        let ahead = |time: u32| from + (until - from) * f64::from(time) / f64::from(times);
        let greatest = (1..=times).try_fold([0.0; 3], |most: [f64; 3], time| {
            let now = deviations(ahead(time))?;
            Some([0, 1, 2].map(|k| f64::max(most[k], now[k])))
        });
        let Some(greatest) = greatest else { break };
        for (curve, value) in curves.iter_mut().zip(greatest) {
            curve.points.push([until, value]);
        }
    }
    let chart = Chart {
        title: "Standard deviation of the prediction: the greatest in each interval",
        labels: ["time after the last sample, s", "standard deviation, rad"],
        powers: [true; 2],
    };
    chart.draw(&curves)
}

/// Half axes of the ellipse of the axis, rad: roots of the eigenvalues of the covariance across it.
fn ellipse(covariance: &[Vector<f64>; 3], axis: Vector<f64>) -> [f64; 2] {
    let axis = Vector3::from(axis);
    let across = Matrix3::identity() - axis * axis.transpose();
    let covariance = across * Matrix3::from_fn(|i, j| covariance[i][j]) * across;
    let mut squares: [f64; 3] = covariance.symmetric_eigenvalues().into();
    squares.sort_by(f64::total_cmp);
    // the least one is 0, along the axis
    [squares[2], squares[1]].map(|square| square.max(0.0).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An axis needs two ends, even for the samples of one time.
    #[test]
    fn samples_of_one_time_have_an_axis() {
        let at = |time: f64| Measurement { time, sensor: 0, values: [0.0; 4] };
        assert_eq!(ends_of(&[at(3.0), at(4.0)]), [3.0, 4.0]);
        assert_eq!(ends_of(&[at(3.0), at(3.0)]), [2.5, 3.5]);
        assert_eq!(ends_of(&[]), [-0.5, 0.5]);
    }
}
