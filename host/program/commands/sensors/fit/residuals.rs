//! Picture of the residuals of a fit.

use crate::drawing::{BOUND_COLOR, chart::COLORS, frame};
use kuva::plot::LinePlot;
use kuva::plot::scatter::ScatterPlot;
use kuva::render::figure::Figure;
use kuva::render::plots::Plot;
use kuva::render::render::Scene;
use toytop_fit::Measurement;
use toytop_host::sensors::fit::FitResult;

/// Residuals in standard deviations: a strip for each sensor, with a dot for each sample and lines where outliers begin. Saturated
/// readings are left out.
pub fn draw(fit: &FitResult, measurements: &[Measurement]) -> Scene {
    let residuals = fit.residuals(measurements);
    let ends = ends_of(measurements);
    let level = |x: f64| {
        LinePlot::new().with_data(ends.map(|t| (t, x))).with_color(BOUND_COLOR).with_stroke_width(0.8).into()
    };
    let (mut strips, mut layouts) = (Vec::new(), Vec::new());
    for (sensor, model) in fit.input.sensors.models.iter().enumerate() {
        let huber = fit.input.huber;
        let limits = [huber, -huber].into_iter().filter(|x| x.is_finite());
        let mut furthest = limits.clone().fold(4.0, f64::max);
        let mut strip: Vec<Plot> = limits.map(level).collect();
        for (k, (name, color)) in model.kind.residuals().iter().zip(COLORS).enumerate() {
            let of_sensor = measurements.iter().zip(&residuals).filter(|(sample, _)| sample.sensor == sensor);
            let points = of_sensor.map(|(sample, residual)| (sample.time, residual[k]));
            let points: Vec<_> = points.filter(|(_, residual)| residual.is_finite()).collect();
            if !points.is_empty() {
                furthest = points.iter().map(|(_, residual)| residual.abs()).fold(furthest, f64::max);
                let dots = ScatterPlot::new().with_data(points).with_color(color).with_size(1.6);
                strip.push(dots.with_legend(*name).into());
            }
        }
        let title = format!("{}: residuals of the fit, standard deviations", model.kind.name());
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
