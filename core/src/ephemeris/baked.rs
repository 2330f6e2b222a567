//! Baked ephemeris: an ephemeris as literal data, set up on a host and compiled into the flash of a chip.

mod range;
mod refusal;

pub use refusal::BakedError;

use crate::ephemeris::cell::CELLS;
use crate::ephemeris::clock::{Clock, TipClock};
use crate::ephemeris::crc32::Crc32;
use crate::ephemeris::error_bound::ErrorBound;
use crate::ephemeris::evaluation::EphemerisScalar;
use crate::ephemeris::storage::{Ephemeris, EphemerisStorage, EphemerisView};

/// Fields of an [`Ephemeris`] as plain numbers, which a program writes as source text and the compiler reads.
///
/// A checksum covers every bit: data in which a number was changed, lost or rounded are refused; in a constant, the
/// refusal is a compile error. Numbers that would overflow in a tick are refused whatever the checksum is. `toytop
/// bake SCENARIO` writes such constants, from [`Ephemeris::to_baked`]. `core/docs/table_format.md` specifies every
/// field.
#[derive(Clone, Debug, PartialEq)]
pub struct Baked<R: EphemerisScalar, const SEGMENTS: usize> {
    /// Version of the format: [`Baked::FORMAT`].
    pub format: u32,
    /// CRC-32 of the format, the scalar, the number of segments and all fields below.
    pub crc32: u32,
    /// Phases and rates.
    pub clock: Clock<R::Wide>,
    /// Error bound of the orientation, rad.
    pub error_bound: ErrorBound,
    /// Error bound of the angular velocity, rad per unit time.
    pub rate_error_bound: ErrorBound,
    /// Cells: the half period in which u rises consists of sixteen cells of equal length, and each number encodes the
    /// segments of one cell. `core/docs/table_format.md` specifies it.
    pub cells: [u16; CELLS],
    /// Segments: coefficients of Re α, Im α, Re β and Im β, lowest power first.
    pub segments: [R::Segment; SEGMENTS],
}

impl<R: EphemerisScalar, const SEGMENTS: usize> Baked<R, SEGMENTS> {
    /// Version of the format that this version of the crate reads.
    pub const FORMAT: u32 = 5;

    const fn data(&self) -> TableData<'_, R> {
        TableData {
            format: self.format,
            crc32: self.crc32,
            clock: self.clock,
            error_bound: self.error_bound,
            rate_error_bound: self.rate_error_bound,
            cells: self.cells,
            segments: &self.segments,
        }
    }

    const fn unpacked(&self) -> Ephemeris<R, SEGMENTS> {
        EphemerisStorage {
            clock: self.clock,
            error_bound: self.error_bound,
            rate_error_bound: self.rate_error_bound,
            cells: self.cells,
            segments: self.segments,
        }
    }
}

/// Fields of an [`EphemerisView`] as plain numbers, for a program that writes them: the fields of [`Baked`], for any
/// capacity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TableData<'a, R: EphemerisScalar> {
    /// Version of the format.
    pub format: u32,
    /// CRC-32 of the format, the scalar, the number of segments and all fields below.
    pub crc32: u32,
    /// Phases and rates.
    pub clock: Clock<R::Wide>,
    /// Error bound of the orientation, rad.
    pub error_bound: ErrorBound,
    /// Error bound of the angular velocity, rad per unit time.
    pub rate_error_bound: ErrorBound,
    /// Cells: see [`Baked::cells`].
    pub cells: [u16; CELLS],
    /// Segments: see [`Baked::segments`].
    pub segments: &'a [R::Segment],
}

impl<R: EphemerisScalar> TableData<'_, R> {
    /// Checksum of the fields whose type does not depend on the scalar.
    const fn crc32_of_head(&self) -> Crc32 {
        let mut sum =
            Crc32::EMPTY.u32(self.format).u32(R::CODE).u32(self.segments.len() as u32).u32(R::TERMS as u32);
        let Clock { step, first, horizon, exact_step, ticks_per_time, tip, turns, .. } = &self.clock;
        let [nutation, a, b] = step;
        sum = sum.words(nutation).words(a).words(b);
        let [nutation, a, b] = *first;
        sum = sum.u64(nutation).u64(a).u64(b);
        let [first, last] = match horizon {
            Some(horizon) => *horizon,
            None => [0; 2],
        };
        sum = sum.u8(horizon.is_some() as u8).i64(first).i64(last);
        let [nutation, a, b] = *exact_step;
        sum = sum.pair(nutation).pair(a).pair(b).pair(*ticks_per_time);
        let TipClock { start, step, quarter, passes, exists } = tip;
        sum = sum.words(start).words(step).u8(*quarter as u8).u8(*passes).u8(*exists as u8).u8(*turns as u8);
        sum = sum.f64(self.error_bound.constant).f64(self.error_bound.per_tick);
        sum = sum.f64(self.rate_error_bound.constant).f64(self.rate_error_bound.per_tick);
        let mut cells = self.cells.as_slice();
        while let [cell, rest @ ..] = cells {
            sum = sum.u16(*cell);
            cells = rest;
        }
        sum
    }

    /// Name of the first field with a number that is not finite, among the fields whose type does not depend on the
    /// scalar.
    const fn not_finite(&self) -> Option<&'static str> {
        let [nutation, a, b] = self.clock.exact_step;
        let ErrorBound { constant, per_tick } = self.error_bound;
        let ErrorBound { constant: rate_constant, per_tick: rate_per_tick } = self.rate_error_bound;
        if !(range::finite(nutation) && range::finite(a) && range::finite(b)) {
            Some("exact_step")
        } else if !range::finite(self.clock.ticks_per_time) {
            Some("ticks_per_time")
        } else if !range::finite([constant, per_tick]) {
            Some("error_bound")
        } else if !range::finite([rate_constant, rate_per_tick]) {
            Some("rate_error_bound")
        } else {
            None
        }
    }
}

/// Functions that must be `const`, which a trait cannot declare; the macro defines them for each scalar.
macro_rules! baked {
    ($scalar:ty, $wide:ident, $coefficient:ident, $terms:ident) => {
        impl TableData<'_, $scalar> {
            /// Checksum of the data, which may differ from the field `crc32`.
            #[must_use]
            pub const fn computed_crc32(&self) -> u32 {
                let [x, mean, axial] = self.clock.rates;
                let mut sum = self.crc32_of_head().$wide(self.clock.tip_scale);
                sum = sum.$wide(x).$wide(mean).$wide(axial);
                let mut rows = self.segments.as_flattened();
                while let [[re_alpha, im_alpha, re_beta, im_beta], rest @ ..] = rows {
                    sum = sum
                        .$coefficient(*re_alpha)
                        .$coefficient(*im_alpha)
                        .$coefficient(*re_beta)
                        .$coefficient(*im_beta);
                    rows = rest;
                }
                sum.value()
            }

            /// Name of the first field with a number that a tick cannot compute with.
            const fn out_of_range(&self) -> Option<&'static str> {
                let [x, mean, axial] = self.clock.rates;
                if let Some(field) = self.not_finite() {
                    return Some(field);
                }
                if !range::$wide(self.clock.tip_scale) {
                    return Some("tip_scale");
                }
                if !(range::$wide(x) && range::$wide(mean) && range::$wide(axial)) {
                    return Some("rates");
                }
                let mut segments = self.segments;
                while let [segment, rest @ ..] = segments {
                    if !range::$terms(segment) {
                        return Some("segments");
                    }
                    segments = rest;
                }
                None
            }
        }

        impl<const SEGMENTS: usize> Baked<$scalar, SEGMENTS> {
            /// Checksum of the data, which may differ from the field `crc32`.
            #[must_use]
            pub const fn computed_crc32(&self) -> u32 {
                self.data().computed_crc32()
            }

            /// Ephemeris of these data, if they pass all checks. The function copies the table, and is meant for constants.
            ///
            /// # Errors
            /// [`BakedError`]: the data have another format, were changed, or contain numbers that a tick cannot
            /// compute with.
            pub const fn ephemeris(&self) -> Result<Ephemeris<$scalar, SEGMENTS>, BakedError> {
                if self.format != Self::FORMAT {
                    return Err(BakedError::Format { found: self.format });
                }
                let computed = self.computed_crc32();
                if self.crc32 != computed {
                    return Err(BakedError::Checksum { stated: self.crc32, computed });
                }
                if let Some(field) = self.data().out_of_range() {
                    return Err(BakedError::OutOfRange { field });
                }
                Ok(self.unpacked())
            }
        }

        impl EphemerisView<$scalar> {
            /// Fields of the ephemeris as plain numbers, for a program that writes them.
            #[must_use]
            pub fn data(&self) -> TableData<'_, $scalar> {
                let mut data = TableData::<$scalar> {
                    format: Baked::<$scalar, 16>::FORMAT,
                    crc32: 0,
                    clock: self.clock,
                    error_bound: self.error_bound,
                    rate_error_bound: self.rate_error_bound,
                    cells: self.cells,
                    segments: &self.segments,
                };
                data.crc32 = data.computed_crc32();
                data
            }
        }

        impl<const SEGMENTS: usize> Ephemeris<$scalar, SEGMENTS> {
            /// Literal data of the ephemeris, from which an equal one can be made. The result is as large as the
            /// table, too large for the stack of a chip.
            #[must_use]
            pub fn to_baked(&self) -> Baked<$scalar, SEGMENTS> {
                let TableData { format, crc32, clock, error_bound, rate_error_bound, cells, .. } =
                    self.data();
                let segments = self.segments;
                Baked { format, crc32, clock, error_bound, rate_error_bound, cells, segments }
            }
        }
    };
}

baked!(f32, f32, i32, long_terms);
baked!(f64, f64, f64, double_terms);
#[cfg(feature = "fixed")]
baked!(fixed::types::I2F30, f32, i32, long_terms);
#[cfg(feature = "fixed")]
baked!(fixed::types::I2F14, f32, i16, short_terms);
