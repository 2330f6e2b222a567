//! Baked ephemeris: an ephemeris as literal data, set up on a host and compiled into the flash of a chip.

mod range;
mod refusal;

pub use refusal::BakedError;

use refusal::FORMAT;

use crate::table::build::bound::ErrorBound;
use crate::table::cell::CELLS;
use crate::table::data::clock::Clock;
use crate::table::data::crc32::Crc32;
use crate::table::data::storage::{Ephemeris, EphemerisStorage, EphemerisView};
use crate::table::data::tip_clock::TipClock;
use crate::table::scalar::EphemerisScalar;

/// Fields of an [`Ephemeris`] as plain numbers, which a program writes as source text and the compiler reads: `toytop bake SCENARIO`.
///
/// Data in which a number was changed, lost or rounded are refused; in a constant, the refusal is a compile error. Numbers that would
/// overflow in a tick are refused whatever the checksum is. `core/docs/table_format.md` specifies every field.
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
    /// Level and first segment of each sixteenth of half a period.
    pub cells: [u16; CELLS],
    /// Segments: coefficients of Re α, Im α, Re β and Im β, lowest power first.
    pub segments: [R::Segment; SEGMENTS],
}

impl<R: EphemerisScalar, const SEGMENTS: usize> Baked<R, SEGMENTS> {
    /// Version of the format that this version of the crate reads.
    pub const FORMAT: u32 = FORMAT;

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

impl<R: EphemerisScalar> EphemerisView<R> {
    /// Checksum of the fields whose type does not depend on the scalar.
    const fn crc32_of_head(&self) -> Crc32 {
        let mut sum =
            Crc32::EMPTY.u32(FORMAT).u32(R::CODE).u32(self.segments.len() as u32).u32(R::TERMS as u32);
        let Clock { step, first, exact_step, ticks_per_time, tip, has_turning_points, .. } = &self.clock;
        let [nutation, a, b] = step;
        sum = sum.words(nutation).words(a).words(b);
        let [nutation, a, b] = *first;
        sum = sum.u64(nutation).u64(a).u64(b);
        let [nutation, a, b] = *exact_step;
        sum = sum.pair(nutation).pair(a).pair(b).pair(*ticks_per_time);
        let TipClock { start, step, quarter, passes, exists } = tip;
        sum = sum.words(start).words(step).u8(*quarter as u8).u8(*passes).u8(*exists as u8);
        sum = sum.u8(*has_turning_points as u8);
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
        impl EphemerisView<$scalar> {
            /// Checksum of the table, as in table data.
            #[must_use]
            pub const fn crc32(&self) -> u32 {
                let [x, mean, axial] = self.clock.rates;
                let mut sum = self.crc32_of_head().$wide(self.clock.tip_scale);
                sum = sum.$wide(x).$wide(mean).$wide(axial);
                let mut rows = self.segments.as_flattened();
                while let [[re_alpha, im_alpha, re_beta, im_beta], rest @ ..] = rows {
                    sum = sum.$coefficient(*re_alpha).$coefficient(*im_alpha);
                    sum = sum.$coefficient(*re_beta).$coefficient(*im_beta);
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
                let mut segments = &self.segments;
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
                let table: &EphemerisView<$scalar> = &self.unpacked();
                table.crc32()
            }

            /// Ephemeris of these data, if they pass all checks. The function copies the table, and is meant for constants.
            ///
            /// # Errors
            /// [`BakedError`]: the data have another format, were changed, or contain numbers that a tick cannot
            /// compute with.
            pub const fn ephemeris(&self) -> Result<Ephemeris<$scalar, SEGMENTS>, BakedError> {
                if self.format != FORMAT {
                    return Err(BakedError::Format { found: self.format });
                }
                let table = self.unpacked();
                let view: &EphemerisView<$scalar> = &table;
                let computed = view.crc32();
                if self.crc32 != computed {
                    return Err(BakedError::Checksum { stated: self.crc32, computed });
                }
                match view.out_of_range() {
                    Some(field) => Err(BakedError::OutOfRange { field }),
                    None => Ok(table),
                }
            }
        }

        impl<const SEGMENTS: usize> Ephemeris<$scalar, SEGMENTS> {
            /// Literal data of the ephemeris, from which an equal one can be made. The result is as large as the
            /// table, too large for the stack of a chip.
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

baked!(f32, f32, i32, long_terms);
baked!(f64, f64, f64, double_terms);
#[cfg(feature = "fixed")]
baked!(fixed::types::I2F30, f32, i32, long_terms);
#[cfg(feature = "fixed")]
baked!(fixed::types::I2F14, f32, i16, short_terms);
