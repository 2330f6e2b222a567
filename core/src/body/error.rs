//! Reasons for refusing an input.

use core::fmt;
use core::ops::RangeInclusive;

/// Invalid parameter, with the allowed values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ParameterError {
    parameter: &'static str,
    /// Index in a list.
    index: Option<usize>,
    allowed: &'static str,
}

/// Allowed values where a number is NaN or infinite.
const FINITE: &str = "a finite number";

impl ParameterError {
    /// Error of a parameter whose allowed values are described in words or as an interval.
    #[must_use]
    pub const fn new(parameter: &'static str, allowed: &'static str) -> Self {
        Self { parameter, index: None, allowed }
    }

    /// Name of the parameter, or of the list.
    pub fn parameter(&self) -> &'static str {
        self.parameter
    }

    /// Index of the item, counted from 0, if the parameter is a list.
    pub fn index(&self) -> Option<usize> {
        self.index
    }

    /// Allowed values, in words or as an interval.
    pub fn allowed(&self) -> &'static str {
        self.allowed
    }

    /// Whether the parameter is NaN or infinite.
    pub fn is_not_finite(&self) -> bool {
        self.allowed == FINITE
    }
}

impl fmt::Display for ParameterError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { parameter, index, allowed } = self;
        f.write_str(parameter)?;
        if let Some(index) = index {
            write!(f, " {index}")?;
        }
        write!(f, ": must be {allowed}")
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for ParameterError {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(f, "{=str}", self.parameter);
        if let Some(index) = self.index {
            defmt::write!(f, " {=usize}", index);
        }
        defmt::write!(f, ": must be {=str}", self.allowed);
    }
}

impl core::error::Error for ParameterError {}

/// The value, or an error where it is not finite.
pub fn check_finite(parameter: &'static str, value: f64) -> Result<f64, ParameterError> {
    if value.is_finite() { Ok(value) } else { Err(ParameterError::new(parameter, FINITE)) }
}

/// Error unless `holds`.
pub fn check(holds: bool, parameter: &'static str, allowed: &'static str) -> Result<(), ParameterError> {
    if holds { Ok(()) } else { Err(ParameterError::new(parameter, allowed)) }
}

/// Error of an item of a list unless `holds`.
pub fn check_item(
    holds: bool,
    parameter: &'static str,
    index: usize,
    allowed: &'static str,
) -> Result<(), ParameterError> {
    if holds { Ok(()) } else { Err(ParameterError { parameter, index: Some(index), allowed }) }
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
