//! Residuals of a fit.

use super::report::FitReport;
use toytop::fit::Measurement;

/// Residuals of each measurement in standard deviations of the noise, after subtraction of the fitted bias. NaN stands for a
/// component that the sensor does not have or that is at the end of its range, and for a measurement at a time at which
/// the derivatives of the motion cannot be computed. All residuals are NaN if no top has the fitted numbers.
#[must_use]
pub fn residuals(report: &FitReport<'_>, measurements: &[Measurement]) -> Vec<[f64; 3]> {
    let Ok(sensitivity) = report.fitted.sensitivity(report.top) else {
        return vec![[f64::NAN; 3]; measurements.len()];
    };
    let mut cursor = sensitivity.cursor();
    let biases = report.biases();
    let of = |Measurement { time, sensor, values }: &Measurement| {
        let Some(partials) = cursor.at(time - report.fitted.epoch) else { return [f64::NAN; 3] };
        let instrument = &report.sensors.instruments[*sensor];
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
