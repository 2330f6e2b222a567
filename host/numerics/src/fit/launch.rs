//! Launch fitted to measurements.

use toytop::fit::{Fit, FitError, Fitted, Measurement};

/// Launch that fits the measurements best. The function has no type parameters, so that this crate contains the code of the fit.
///
/// # Errors
/// See [`Fit::run`].
pub fn fitted(fit: &mut Fit<'_>, measurements: &[Measurement]) -> Result<Fitted, FitError> {
    fit.run(measurements.iter().copied())
}
