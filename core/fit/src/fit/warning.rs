//! Reasons not to trust the result of a fit.

use core::fmt;

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
    /// The measurements contain neither two orientations or directions, nor rates within the range.
    NoFirstGuess,
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
            Self::NoFirstGuess => {
                "the measurements do not say where to begin: they need orientations, directions, or rates within the range"
            }
        })
    }
}
