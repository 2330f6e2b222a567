//! Reasons for refusing an input.

use core::fmt;
use core::ops::RangeInclusive;

/// Invalid parameter, with the allowed values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ParameterError {
    /// The parameter is NaN or infinite.
    NotFinite {
        /// Name of the parameter.
        parameter: &'static str,
    },
    /// The parameter is finite but not allowed.
    OutOfRange {
        /// Name of the parameter.
        parameter: &'static str,
        /// Allowed values.
        allowed: &'static str,
    },
    /// An item of a list is not allowed.
    Item {
        /// Name of the list.
        parameter: &'static str,
        /// Index of the item, counted from 0.
        index: usize,
        /// Allowed items.
        allowed: &'static str,
    },
}

impl ParameterError {
    /// Name of the parameter, or of the list.
    pub fn parameter(&self) -> &'static str {
        match self {
            Self::NotFinite { parameter }
            | Self::OutOfRange { parameter, .. }
            | Self::Item { parameter, .. } => parameter,
        }
    }

    /// Allowed values, in words or as an interval.
    pub fn allowed(&self) -> &'static str {
        match self {
            Self::NotFinite { .. } => "a finite number",
            Self::OutOfRange { allowed, .. } | Self::Item { allowed, .. } => allowed,
        }
    }
}

impl fmt::Display for ParameterError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.parameter())?;
        if let Self::Item { index, .. } = self {
            write!(f, " {index}")?;
        }
        write!(f, ": must be {}", self.allowed())
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for ParameterError {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(f, "{=str}", self.parameter());
        if let Self::Item { index, .. } = self {
            defmt::write!(f, " {=usize}", index);
        }
        defmt::write!(f, ": must be {=str}", self.allowed());
    }
}

impl core::error::Error for ParameterError {}

/// The value, or an error where it is not finite.
pub fn check_finite(parameter: &'static str, value: f64) -> Result<f64, ParameterError> {
    if value.is_finite() { Ok(value) } else { Err(ParameterError::NotFinite { parameter }) }
}

/// Error unless `holds`.
pub fn check(holds: bool, parameter: &'static str, allowed: &'static str) -> Result<(), ParameterError> {
    if holds { Ok(()) } else { Err(ParameterError::OutOfRange { parameter, allowed }) }
}

/// Error of an item of a list unless `holds`.
pub fn check_item(
    holds: bool,
    parameter: &'static str,
    index: usize,
    allowed: &'static str,
) -> Result<(), ParameterError> {
    if holds { Ok(()) } else { Err(ParameterError::Item { parameter, index, allowed }) }
}

/// The value, or an error where it is outside a range, which `allowed` describes.
pub(crate) fn check_range(
    range: RangeInclusive<f64>,
    parameter: &'static str,
    value: f64,
    allowed: &'static str,
) -> Result<f64, ParameterError> {
    check(range.contains(&check_finite(parameter, value)?), parameter, allowed)?;
    Ok(value)
}
