//! Baked table: literal data for the flash of a chip.

mod crc32;

use core::fmt;

use crate::table::data::Clock;
use crate::table::data::ErrorBound;
use crate::table::data::cell::{CELLS, Cell};
use crate::table::data::table::{SizedTable, Table};
use crate::table::evaluation::{TableScalar, range};
use crc32::Crc32;

/// Version of the format.
const FORMAT: u32 = 11;

/// Fields of a [`SizedTable`] as `toytop bake SCENARIO` writes them, in [the table format](crate::table_format).
///
/// `table` refuses data that were changed or would overflow. In a constant this is a compile error.
#[derive(Clone, Debug, PartialEq)]
pub struct Baked<R: TableScalar, const SEGMENTS: usize> {
    /// Version of the format: [`Baked::FORMAT`].
    pub format: u32,
    /// CRC-32 of the format, the scalar, the number of segments and all fields below.
    pub crc32: u32,
    /// Clock: phases and rates.
    pub clock: Clock<R::Quantity>,
    /// Error bound of the orientation, rad.
    pub error_bound: ErrorBound,
    /// Error bound of the angular velocity, rad/s.
    pub rate_error_bound: ErrorBound,
    /// Cells, each a sixteenth of half a period: see [the table format](crate::table_format).
    pub cells: [u16; CELLS],
    /// Segments: coefficients of Re a, Im a, Re b and Im b, lowest power first.
    pub segments: [R::Segment; SEGMENTS],
}

/// Reason for refusing a baked table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum BakedError {
    /// The data have another version of the format.
    Format {
        /// Version found.
        found: u32,
    },
    /// The checksum does not match the data.
    Checksum {
        /// Checksum in the data.
        stated: u32,
        /// Checksum computed from the data.
        computed: u32,
    },
    /// A number is not finite, or too large for a tick; or a cell refers to a segment that is not there.
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
            Self::OutOfRange { field: "cells" } => f.write_str("cells: must refer to segments of the table"),
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

impl<R: TableScalar, const SEGMENTS: usize> Baked<R, SEGMENTS> {
    /// Version of the format that is read.
    pub const FORMAT: u32 = FORMAT;
}

impl<R: TableScalar> Table<R> {
    /// Checksum of the fields whose type does not depend on the scalar.
    const fn crc32_of_head(&self) -> Crc32 {
        let clock = &self.clock;
        let flags = [
            clock.ab_quarter_turns_at_e1 as u8,
            clock.tip_passages,
            clock.tip_exists as u8,
            clock.has_turning_points as u8,
        ];
        Crc32::EMPTY
            .u32(&[FORMAT, R::CODE, self.segments.len() as u32, R::TERMS as u32])
            .u32(clock.increments.as_flattened())
            .u64(&clock.first_phases)
            .i64(&[clock.epoch])
            .f64(&clock.ticks_per_time)
            .u32(&clock.mean_tip_at_tick_0)
            .u8(&flags)
            .f64(&self.error_bound.numbers())
            .f64(&self.rate_error_bound.numbers())
            .u16(&self.cells)
    }

    /// Whether every cell refers to segments of the table.
    const fn has_segments_of_cells(&self) -> bool {
        let mut cells: &[u16] = &self.cells;
        while let [rest @ .., cell] = cells
            && Cell(*cell).is_within(rest.len() as u32, self.segments.len())
        {
            cells = rest;
        }
        cells.is_empty()
    }
}

/// Functions of each scalar. They are `const`, which a trait cannot declare.
macro_rules! baked {
    ($scalar:ty, $quantity:ident <= $greatest:ident, $coefficient:ident, $coefficients:ident) => {
        impl Table<$scalar> {
            /// CRC-32 of the table: see [`Baked::crc32`].
            #[must_use]
            pub const fn crc32(&self) -> u32 {
                let clock = &self.clock;
                let head = self.crc32_of_head().$quantity(&[clock.twice_tip_scale]).$quantity(&clock.rates());
                head.$coefficient(self.segments.as_flattened().as_flattened()).value()
            }

            /// First field with a number out of range.
            const fn out_of_range(&self) -> Option<&'static str> {
                const fn is_small(number: $quantity) -> bool {
                    range::all_at_most(&[number as f64], range::$greatest)
                }
                let mut segments = &self.segments;
                while let [segment, rest @ ..] = segments
                    && range::$coefficients(segment.as_flattened())
                {
                    segments = rest;
                }
                let clock = &self.clock;
                let mut fields: &[_] = &[
                    ("ticks_per_time", range::all_finite(&clock.ticks_per_time)),
                    ("error_bound", range::all_finite(&self.error_bound.numbers())),
                    ("rate_error_bound", range::all_finite(&self.rate_error_bound.numbers())),
                    ("twice_tip_scale", is_small(clock.twice_tip_scale)),
                    ("x_rate", is_small(clock.x_rate)),
                    ("mean_sum_rate", is_small(clock.mean_sum_rate)),
                    ("spin", is_small(clock.spin)),
                    ("segments", segments.is_empty()),
                    ("cells", self.has_segments_of_cells()),
                ];
                while let [(field, in_range), rest @ ..] = fields {
                    if !*in_range {
                        return Some(field);
                    }
                    fields = rest;
                }
                None
            }
        }

        impl<const SEGMENTS: usize> Baked<$scalar, SEGMENTS> {
            /// Table of these data. It can be computed in a constant.
            ///
            /// # Errors
            /// [`BakedError`]
            pub const fn table(&self) -> Result<SizedTable<$scalar, SEGMENTS>, BakedError> {
                if self.format != FORMAT {
                    return Err(BakedError::Format { found: self.format });
                }
                let table = Table {
                    clock: self.clock,
                    error_bound: self.error_bound,
                    rate_error_bound: self.rate_error_bound,
                    cells: self.cells,
                    segments: self.segments,
                };
                let of_any_capacity: &Table<$scalar> = &table;
                let computed = of_any_capacity.crc32();
                if self.crc32 != computed {
                    return Err(BakedError::Checksum { stated: self.crc32, computed });
                }
                match of_any_capacity.out_of_range() {
                    Some(field) => Err(BakedError::OutOfRange { field }),
                    None => Ok(table),
                }
            }
        }

        impl<const SEGMENTS: usize> SizedTable<$scalar, SEGMENTS> {
            /// Literal data of the table. They may be too large for the stack of a chip.
            #[must_use]
            pub fn to_baked(&self) -> Baked<$scalar, SEGMENTS> {
                Baked {
                    format: FORMAT,
                    crc32: self.crc32(),
                    clock: self.clock,
                    error_bound: self.error_bound,
                    rate_error_bound: self.rate_error_bound,
                    cells: self.cells,
                    segments: self.segments,
                }
            }
        }
    };
}

baked!(f32, f32 <= MAX_F32, i32, are_safe_i32);
baked!(f64, f64 <= MAX_F64, f64, are_safe_f64);
#[cfg(feature = "fixed")]
baked!(fixed::types::I2F30, f32 <= MAX_F32, i32, are_safe_i32);
#[cfg(feature = "fixed")]
baked!(fixed::types::I2F14, f32 <= MAX_F32, i16, are_safe_i16);
