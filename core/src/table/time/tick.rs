//! Tick: the unit of a table's time.

use crate::body::ParameterError;
use crate::scalar::Extended;

/// Length of a tick, an exact fraction of a second.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Tick {
    ticks: u32,
    seconds: u32,
}

impl Tick {
    /// Tick length for a frequency in Hz.
    ///
    /// ```
    /// use toytop::{TableSettings, Tick};
    /// const SETTINGS: TableSettings = match Tick::hertz(1000) {
    ///     Ok(tick) => TableSettings::new(tick),
    ///     Err(_) => panic!(),
    /// };
    /// ```
    ///
    /// # Errors
    /// `tick`: the frequency is 0.
    pub const fn hertz(frequency: u32) -> Result<Self, ParameterError> {
        Self::ratio(frequency, 1)
    }

    /// Tick length for `ticks` ticks in `seconds` seconds: (44100, 2) means 44100/2 Hz.
    ///
    /// # Errors
    /// `tick`: one of the two is 0.
    pub const fn ratio(ticks: u32, seconds: u32) -> Result<Self, ParameterError> {
        if ticks == 0 || seconds == 0 {
            let allowed = "a positive number of ticks in a positive number of seconds";
            return Err(ParameterError::new("tick", allowed));
        }
        Ok(Self { ticks, seconds })
    }

    pub(crate) fn length(self) -> Extended {
        quotient(self.seconds, self.ticks)
    }

    /// Number of ticks in a unit of time.
    pub(crate) fn rate(self) -> Extended {
        quotient(self.ticks, self.seconds)
    }
}

fn quotient(a: u32, b: u32) -> Extended {
    Extended::from(f64::from(a)) / Extended::from(f64::from(b))
}
