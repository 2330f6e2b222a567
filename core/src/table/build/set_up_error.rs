//! Reasons for refusing a set-up.

use core::fmt;

use crate::body::ParameterError;

/// Reason why a motion has no table.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum SetUpError {
    /// The table has too few segments for the truncation error.
    TableTooSmall {
        /// Allowed truncation error, rad.
        truncation: f64,
        /// Number of segments; [`Table::segments_needed`](crate::Table::segments_needed) finds a sufficient one.
        segments: u32,
    },
    /// The motion is aperiodic; a stepper or its closed form follows it.
    Aperiodic,
    /// The truncation error is not positive and finite, or a tick so long that a phase advances by 2^31 turns.
    Parameter(ParameterError),
}

impl fmt::Display for SetUpError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TableTooSmall { truncation, segments } => {
                write!(
                    f,
                    "a table of {segments} segments cannot follow the motion to within {truncation:.1e} rad"
                )
            }
            Self::Aperiodic => f.write_str("an aperiodic motion has no table"),
            Self::Parameter(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for SetUpError {}
