//! Why a top, a state or a motion is refused.

use core::fmt;

/// What is wrong with the input of a launch, and with which parameter.
///
/// Returned by everything that runs before the first tick; once a [`crate::Motion`] stands, nothing can fail.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum LaunchError {
    /// The parameter is NaN or infinite.
    NotFinite {
        /// Its name.
        parameter: &'static str,
    },
    /// The parameter is a number, but not one of the allowed.
    OutOfRange {
        /// Its name.
        parameter: &'static str,
        /// What is allowed, in words or as an interval.
        allowed: &'static str,
    },
}

impl LaunchError {
    /// The name of the parameter that is wrong.
    #[must_use]
    pub fn parameter(&self) -> &'static str {
        match self {
            Self::NotFinite { parameter } | Self::OutOfRange { parameter, .. } => parameter,
        }
    }

    /// What is allowed.
    #[must_use]
    pub fn allowed(&self) -> &'static str {
        match self {
            Self::NotFinite { .. } => "a finite number",
            Self::OutOfRange { allowed, .. } => allowed,
        }
    }
}

impl fmt::Display for LaunchError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: must be {}", self.parameter(), self.allowed())
    }
}

impl core::error::Error for LaunchError {}

/// `value` if it is finite.
pub(crate) fn finite(parameter: &'static str, value: f64) -> Result<f64, LaunchError> {
    if value.is_finite() { Ok(value) } else { Err(LaunchError::NotFinite { parameter }) }
}

/// Refuses unless `holds`.
pub(crate) fn require(
    holds: bool,
    parameter: &'static str,
    allowed: &'static str,
) -> Result<(), LaunchError> {
    if holds { Ok(()) } else { Err(LaunchError::OutOfRange { parameter, allowed }) }
}
