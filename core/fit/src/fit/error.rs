//! Errors and warnings of a fit.

use core::fmt;

/// Input that a fit refuses. `index` counts the measurements from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum FitError {
    /// A time or a value is NaN or infinite.
    NotFinite {
        /// Index of the measurement.
        index: usize,
    },
    /// A measurement is earlier than the one before.
    OutOfOrder {
        /// Index of the measurement.
        index: usize,
    },
    /// A measurement names a sensor that is not in the list.
    UnknownSensor {
        /// Index of the measurement.
        index: usize,
    },
    /// There is no measurement.
    NoMeasurements,
    /// There are more than four sensors, or more than four free ratios, or more than one with losses.
    TooManyUnknowns,
    /// A standard deviation is not finite, negative, or 0 where it must be positive.
    Deviation {
        /// Name of the parameter.
        parameter: &'static str,
    },
    /// The last fit has another top, or other unknowns, than this one.
    OtherModel,
    /// The motion of the last fit cannot be followed to the first measurement.
    LastFit,
    /// The direction of a free ratio is 0 or not finite, or its deviation is not positive.
    FreeRatio {
        /// Index of the ratio in the list.
        ratio: usize,
    },
    /// The deviation of a sensor's noise is not a positive number, or its bias has a negative or infinite deviation.
    SensorNoise {
        /// Index of the sensor in the list.
        sensor: usize,
    },
}

impl fmt::Display for FitError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite { index } => write!(f, "measurement {index}: must be finite"),
            Self::OutOfOrder { index } => {
                write!(f, "measurement {index}: must not be earlier than the one before")
            }
            Self::UnknownSensor { index } => {
                write!(f, "measurement {index}: must be of a sensor in the list")
            }
            Self::NoMeasurements => f.write_str("measurements: must not be empty"),
            Self::TooManyUnknowns => {
                f.write_str("sensors, ratios: must be at most four each, and one ratio with losses")
            }
            Self::SensorNoise { sensor } => {
                write!(f, "sensor {sensor}: its noise must be positive, and its bias not negative")
            }
            Self::FreeRatio { ratio } => {
                write!(f, "ratio {ratio}: its direction must be finite and not 0, and its deviation positive")
            }
            Self::Deviation { parameter } => {
                write!(f, "{parameter}: must be finite and positive, or 0 between two blocks")
            }
            Self::OtherModel => f.write_str("last fit: must have the same top and the same unknowns"),
            Self::LastFit => f.write_str("last fit: must be a motion that reaches the first measurement"),
        }
    }
}

impl core::error::Error for FitError {}

/// Reason why a launch must not be trusted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum FitWarning {
    /// The corrections did not become small.
    NotSettled,
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
            Self::NotSettled => "the corrections did not become small",
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
