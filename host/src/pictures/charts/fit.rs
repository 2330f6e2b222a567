//! Pictures of a fit: its residuals, and how the error of its prediction grows.

use super::chart::{COLORS, Chart, Curve};
use crate::fit::launch::FitReport;
use crate::motion::propagate::period;
use kuva::plot::scatter::ScatterPlot;
use kuva::plot::{LegendPosition, LinePlot};
use kuva::render::figure::Figure;
use kuva::render::layout::Layout;
use kuva::render::plots::Plot;
use kuva::render::render::Scene;
use toytop::Motion;
use toytop::su2::Vector;
use toytop_fit::{Measurement, Sensitivity};

/// Width of a strip of residuals, and its height with its title and the labels of its axis, pixels.
const STRIP: [f64; 2] = [920.0, 210.0];
/// Residual of an outlier, standard deviations.
const OUTLIER: f64 = 3.0;
const LEVEL: &str = "#8a8a8a";

/// Residuals in standard deviations: a strip for each sensor, with a dot for each sample and lines at ±3. Those at the end of the range
/// of a sensor are left out.
pub fn residuals(report: &FitReport, measurements: &[Measurement]) -> Scene {
    let instruments = &report.input.sensors.instruments;
    let mut columns: Vec<Vec<Vec<(f64, f64)>>> =
        instruments.iter().map(|one| vec![Vec::new(); one.kind.residuals().len()]).collect();
    let found = report.residuals(measurements);
    for (Measurement { time, sensor, .. }, residual) in measurements.iter().zip(found) {
        for (points, value) in columns[*sensor].iter_mut().zip(residual) {
            if value.is_finite() {
                points.push((*time, value));
            }
        }
    }
    let ends = ends_of(measurements);
    let (mut plots, mut layouts) = (Vec::new(), Vec::new());
    for (instrument, columns) in instruments.iter().zip(&columns) {
        let kind = &instrument.kind;
        let strip = strip(kind.residuals(), columns, ends);
        let furthest = columns.iter().flatten().map(|(_, x)| x.abs()).fold(4.0, f64::max);
        let layout = Layout::auto_from_plots(&strip)
            .with_title(format!("{}: residuals of the fit, standard deviations", kind.name))
            .with_title_size(14)
            .with_x_label("t, s")
            .with_x_axis_min(ends[0])
            .with_x_axis_max(ends[1])
            .with_y_axis_min(-1.1 * furthest)
            .with_y_axis_max(1.1 * furthest)
            .with_force_margins(60.0, 110.0)
            .with_box_axes()
            .with_show_grid(false)
            .with_legend_position(LegendPosition::OutsideRightTop)
            .with_legend_box(false);
        plots.push(strip);
        layouts.push(layout);
    }
    let rows = plots.len();
    let figure =
        Figure::new(rows, 1).with_cell_size(STRIP[0], STRIP[1]).with_plots(plots).with_layouts(layouts);
    figure.with_keep_panel_legends().render()
}

/// First and last time of the measurements, s, apart from each other even if there is only one.
fn ends_of(measurements: &[Measurement]) -> [f64; 2] {
    let time = |measurement: Option<&Measurement>| measurement.map_or(0.0, |one| one.time);
    let [from, until] = [time(measurements.first()), time(measurements.last())];
    if from < until { [from, until] } else { [from - 0.5, from + 0.5] }
}

/// Lines at ±3 and dots of the columns of a sensor.
fn strip(names: &[&str], columns: &[Vec<(f64, f64)>], ends: [f64; 2]) -> Vec<Plot> {
    let level = |x: f64| {
        LinePlot::new().with_data(ends.map(|t| (t, x))).with_color(LEVEL).with_stroke_width(0.8).into()
    };
    let mut plots: Vec<Plot> = vec![level(OUTLIER), level(-OUTLIER)];
    for ((name, points), color) in names.iter().zip(columns).zip(COLORS) {
        if !points.is_empty() {
            let dots = ScatterPlot::new().with_data(points.clone()).with_color(color).with_size(1.6);
            plots.push(dots.with_legend(*name).into());
        }
    }
    plots
}

/// Number of intervals of time in the picture of the prediction.
const INTERVALS: u32 = 80;
/// Begin of the first interval and end of the last, after the end of the samples, s.
const AHEAD: [f64; 2] = [0.01, 100.0];
/// Number of times in a nutation period, and greatest number in an interval, at which the standard deviations are computed. They
/// oscillate with the nutation, so that one time in an interval would show an alias.
const PER_PERIOD: f64 = 16.0;
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
        let covariance = report.fitted.orientation_covariance(&partials);
        let trace: f64 = (0..3).map(|k| covariance[k][k]).sum();
        let [long, short] = ellipse(&covariance, partials.axis());
        Some([trace.max(0.0).sqrt(), long, short])
    };
    'intervals: for interval in 0..INTERVALS {
        let [from, until] = [begin(interval), begin(interval + 1)];
        let times = ((until - from) / step).ceil().clamp(1.0, MOST_TIMES) as u32;
        let mut greatest = [0.0; 3];
        for time in 1..=times {
            let ahead = from + (until - from) * f64::from(time) / f64::from(times);
            let Some(now) = deviations(ahead) else { break 'intervals };
            greatest = [0, 1, 2].map(|k| f64::max(greatest[k], now[k]));
        }
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
