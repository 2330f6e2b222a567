//! Error of literal data that are refused.

use core::fmt;

/// Version of the format that this version of the crate reads.
pub(super) const FORMAT: u32 = 6;

/// Reason why literal data are refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum BakedError {
    /// Field `format`: the data were written by another version.
    Format {
        /// Version found.
        found: u32,
    },
    /// Field `crc32`: the checksum does not match the data.
    Checksum {
        /// Checksum in the data.
        stated: u32,
        /// Checksum computed from the data.
        computed: u32,
    },
    /// A field contains a number that is not finite, or so large that a tick would overflow. Set-up writes no such
    /// number.
    OutOfRange {
        /// Name of the field.
        field: &'static str,
    },
}

impl fmt::Display for BakedError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Format { found } => {
                write!(f, "format: must be {FORMAT}, not {found}")
            }
            Self::OutOfRange { field } => {
                write!(f, "{field}: must contain only finite numbers that cannot overflow in a tick")
            }
            Self::Checksum { stated, computed } => {
                write!(f, "crc32: must be {computed:#010x}, not {stated:#010x}: the data were changed")
            }
        }
    }
}

impl core::error::Error for BakedError {}
