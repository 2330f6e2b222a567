//! Fit of a launch, and of free keys of the top, to measurements.

use super::input::FitInput;
use super::result::FitResult;
use super::sensors::Sensors;
use toytop_fit::{Fit, FitError, FitWarning, Hint, Measurement};

/// Launch that fits the measurements best.
///
/// # Errors
/// Name of the parameter that is refused, `free`, `huber`, `drift` or `samples`, and the reason.
pub fn fit_launch(
    input: FitInput,
    measurements: &[Measurement],
) -> Result<FitResult, (&'static str, String)> {
    let ratios = input.ratios().map_err(|reason| ("free", reason))?;
    if input.huber.is_nan() || input.huber < 1.0 {
        return Err(("huber", "must be a number from 1, or inf".to_owned()));
    }
    let refuse = |error: FitError| match error {
        FitError::LossDeviation => ("drift", "must be a positive number".to_owned()),
        FitError::TooManyUnknowns if input.drift.is_some() => {
            ("free", "must be at most one name with a drift".to_owned())
        }
        _ => ("samples", error.to_string()),
    };
    let listed = input.sensors.as_core();
    let mut fit = Fit::new(&input.top, &listed, &ratios).map_err(refuse)?.with_huber(input.huber);
    if let Some(deviation) = input.drift {
        fit = fit.with_losses(deviation).map_err(refuse)?;
    }
    let fitted = fit.run(measurements.iter().copied()).map_err(refuse)?;
    let reason = fitted.warning.map(|reason| match reason {
        // the sensors that the core asks for exist, so that its advice would mislead
        FitWarning::NoBeginning if has_beginning(&input.sensors, measurements) => {
            "no start fits the samples: are they of another top?".to_owned()
        }
        reason => reason.to_string(),
    });
    let end = measurements.last().map_or(0.0, |last| last.time);
    drop(listed);
    Ok(FitResult { input, fitted, reason, end })
}

/// Whether the first measurements contain an orientation, an axis, or a direction and rates.
fn has_beginning(sensors: &Sensors, measurements: &[Measurement]) -> bool {
    const FIRST: usize = 64;
    let [mut direction, mut rate] = [false; 2];
    for Measurement { sensor, values, .. } in measurements.iter().take(FIRST) {
        match sensors.setups.get(*sensor).map(|setup| setup.sensor.hint(values)) {
            Some(Hint::Orientation(_) | Hint::Axis(_) | Hint::Tip(_)) => return true,
            Some(Hint::Direction { .. }) => direction = true,
            Some(Hint::Rate { .. }) => rate = true,
            _ => {}
        }
    }
    direction && rate
}
