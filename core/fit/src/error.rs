//! Errors and warnings of a fit.

use core::fmt;

/// Input that a fit refuses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct FitError {
    /// Name of the parameter, or of the list whose item is refused.
    pub parameter: &'static str,
    /// Index of the item in its list, counted from 0.
    pub index: Option<usize>,
    /// Rule that is broken, after the word *must*: `be finite`.
    pub must: &'static str,
}

/// Error unless `holds`.
pub(crate) fn require(
    holds: bool,
    parameter: &'static str,
    index: Option<usize>,
    must: &'static str,
) -> Result<(), FitError> {
    if holds { Ok(()) } else { Err(FitError { parameter, index, must }) }
}

impl fmt::Display for FitError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.parameter)?;
        if let Some(index) = self.index {
            write!(f, " {index}")?;
        }
        write!(f, ": must {}", self.must)
    }
}

impl core::error::Error for FitError {}

/// Reason why a launch must not be trusted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum FitWarning {
    /// The corrections did not become small.
    NotConverged,
    /// The residuals of a sensor are far larger than the noise: the model, a unit, the noise or the solution is wrong.
    Misfit,
    /// The residuals become small when the rates are read as degrees per second.
    RatesInDegrees,
    /// All rates are below 0.1 per unit time, and the residuals are large: the top does not move freely.
    AtRest,
    /// Every component of every measurement was at the end of its range.
    AllSaturated,
    /// Fewer observations than unknowns of a launch.
    TooFew,
    /// The top is upright, and no measurement determines its rate about the axis.
    SpinUnknown,
    /// The measurements contain neither an orientation, nor an axis, nor rates within the range.
    NoBeginning,
}

impl fmt::Display for FitWarning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::NotConverged => "the corrections did not become small",
            Self::Misfit => "the residuals are far larger than the noise",
            Self::RatesInDegrees => "the rates seem to be in degrees per second: the residuals then are small",
            Self::AtRest => "the top is at rest, held by something that the model does not know",
            Self::AllSaturated => "every component is at the end of its range",
            Self::TooFew => "there are fewer observations than unknowns",
            Self::SpinUnknown => "the top stands upright, and nothing tells its rate about the axis",
            Self::NoBeginning => {
                "the measurements do not say where to begin: they need an orientation, an axis, or rates within the range"
            }
        })
    }
}
