//! Launch fitted to measurements.

use super::sensors::Sensors;
use toytop::fit::{Fit, FitError, Fitted, Hint, Measurement, Reason};

/// Launch that fits the measurements best. The function has no type parameters, so that this crate contains the code of the fit.
///
/// # Errors
/// See [`Fit::run`].
pub fn fitted(fit: &mut Fit<'_>, measurements: &[Measurement]) -> Result<Fitted, FitError> {
    fit.run(measurements.iter().copied())
}

/// Reason why a launch must not be trusted, in words; `None` where it may be.
///
/// * `top`: name of the top that was given
#[must_use]
pub fn reason(fitted: &Fitted, sensors: &Sensors, measurements: &[Measurement], top: &str) -> Option<String> {
    Some(match fitted.reason? {
        // the core asks for sensors that are there
        Reason::NoBeginning if state_a_beginning(sensors, measurements) => {
            format!("no start fits the samples: is {top} the top that they are of?")
        }
        reason => reason.to_string(),
    })
}

/// Whether the first measurements contain an orientation, an axis, or a direction and rates.
fn state_a_beginning(sensors: &Sensors, measurements: &[Measurement]) -> bool {
    const FIRST: usize = 64;
    let hint = |measurement: &Measurement| {
        let instrument = sensors.instruments.get(measurement.sensor);
        instrument.map_or(Hint::None, |instrument| instrument.sensor.hint(&measurement.values))
    };
    let has = |wanted: fn(&Hint) -> bool| measurements.iter().take(FIRST).any(|one| wanted(&hint(one)));
    has(|hint| matches!(hint, Hint::Orientation(_) | Hint::Axis(_)))
        || has(|hint| matches!(hint, Hint::Direction { .. })) && has(|hint| matches!(hint, Hint::Rate { .. }))
}
