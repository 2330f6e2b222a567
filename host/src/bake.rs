//! Ephemeris as a file for other programs: a Rust module, or a C header with its evaluator.
//!
//! Both contain the numbers of a [`Baked`](toytop::Baked) of any size, with format version and checksum. A Rust module in which a
//! number was changed does not compile; the C header has a function that checks the numbers. Both give the bits of the crate.
//!
//! In C, fixed point uses integers only, and `f32` uses integers up to α and β, so that these bits do not depend on the compiler. In u, c
//! and `f64` every product that is added passes a barrier, without which compilers would fuse the product and the sum by default.

mod c;
mod rust;

use crate::motion::Scalar;
use fixed::types::{I2F14, I2F30};
use toytop::{Clock, EphemerisScalar, EphemerisView, ErrorBound};

pub use self::c::{header, split_files};
pub use self::rust::module;

/// Numbers of a [`Baked`](toytop::Baked) of any size and scalar.
pub struct Parts {
    /// Version of the format.
    pub format: u32,
    /// CRC-32 of all other numbers.
    pub crc32: u32,
    /// Scalar of the table.
    pub scalar: Scalar,
    /// Number of segments, and of terms of a polynomial.
    pub size: [usize; 2],
    /// Phases and rates.
    pub clock: Clock<f64>,
    /// Upper bound on the orientation error, rad.
    pub error_bound: ErrorBound,
    /// Upper bound on the error of the angular velocity, rad per unit time.
    pub rate_error_bound: ErrorBound,
    /// Cells of half a period: see core/docs/table_format.md.
    pub cells: [u16; 16],
    /// Coefficients of Re α, Im α, Re β and Im β, by segment and power. An integer of n bits is that of x^k in units of 2^-(n-1+k).
    pub coefficients: Vec<[f64; 4]>,
}

impl Parts {
    /// Size of the table in bytes, without the clock.
    pub fn table_bytes(&self) -> usize {
        let bytes = match self.scalar {
            Scalar::F64 => 8,
            Scalar::F32 | Scalar::Q31 => 4,
            Scalar::Q15 => 2,
        };
        4 * bytes * self.coefficients.len()
    }
}

/// Scalar whose tables can be written to files.
pub trait Bake: EphemerisScalar<Segment: Send + Sync, Quantity: Send + Sync> + Send + Sync + 'static {
    /// Parts of a table.
    fn parts(table: &EphemerisView<Self>) -> Parts;
}

macro_rules! bake {
    ($($scalar:ty: $name:ident),*) => { $(
        impl Bake for $scalar {
            fn parts(table: &EphemerisView<Self>) -> Parts {
                Parts {
                    format: toytop::Baked::<Self, 16>::FORMAT,
                    crc32: table.crc32(),
                    scalar: Scalar::$name,
                    size: [table.capacity(), Self::TERMS],
                    clock: wide(*table.clock()),
                    error_bound: table.error_bound(),
                    rate_error_bound: table.rate_error_bound(),
                    cells: table.cells(),
                    coefficients: table.segments().as_flattened().iter().map(|row| row.map(f64::from)).collect(),
                }
            }
        }
    )* };
}

bake!(f32: F32, f64: F64, I2F30: Q31, I2F14: Q15);

/// Clock with its lengths and rates in `f64`.
fn wide<W: Into<f64>>(clock: Clock<W>) -> Clock<f64> {
    Clock {
        step: clock.step,
        tip_quarter: clock.tip_quarter,
        tip_passes: clock.tip_passes,
        tip_exists: clock.tip_exists,
        has_turning_points: clock.has_turning_points,
        tip_scale: clock.tip_scale.into(),
        rates: clock.rates.map(Into::into),
        first: clock.first,
        exact_step: clock.exact_step,
        ticks_per_time: clock.ticks_per_time,
        tip_start: clock.tip_start,
        tip_step: clock.tip_step,
        epoch: clock.epoch,
    }
}

/// Description of the motion of a table, for the comment of a file.
pub struct Label {
    /// Name of the scenario.
    pub name: String,
    /// Length of a tick, as text.
    pub tick: String,
}

impl Label {
    /// Name as an identifier in lower case: letters and digits of ASCII are kept, any other letter or digit becomes `u` and at least four
    /// hexadecimal digits, and everything between becomes one underscore, but not at the ends.
    pub fn identifier(&self) -> String {
        let mut identifier = String::new();
        for c in self.name.chars() {
            match c {
                _ if c.is_ascii_alphanumeric() => identifier.push(c.to_ascii_lowercase()),
                _ if c.is_alphanumeric() => identifier += &format!("u{:04x}", u32::from(c)),
                _ if identifier.is_empty() || identifier.ends_with('_') => {}
                _ => identifier.push('_'),
            }
        }
        let identifier = identifier.trim_end_matches('_');
        if identifier.starts_with(|c: char| c.is_ascii_lowercase()) {
            identifier.to_owned()
        } else {
            format!("top_{identifier}")
        }
    }

    /// Identifier as a name in C and C++, and of a file. A single word or a name that ends in `_t` may belong to the language or to a library
    /// (`int`, `clock`), and a name that begins with `toytop_` may belong to this library. Such a name gets the prefix `top_`.
    pub fn c_name(&self) -> String {
        let name = self.identifier();
        let free = name.contains('_') && !name.ends_with("_t") && !name.starts_with("toytop_");
        if free { name } else { format!("top_{name}") }
    }

    /// Name and properties of the table for a comment, without characters that could end the comment.
    fn headline(&self, parts: &Parts) -> String {
        let printable = |c: &char| !c.is_control() && !['*', '/', '\\'].contains(c);
        let name: String = self.name.chars().filter(printable).collect();
        let ([segments, terms], ErrorBound { constant, per_tick }) = (parts.size, parts.error_bound);
        format!(
            "{name}, {}: {segments} x {terms} in {}; within {constant:.1e} rad + {per_tick:.1e} rad a tick",
            self.tick,
            parts.scalar.name(),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_becomes_an_unused_identifier() {
        let named = |name: &str| Label { name: name.to_owned(), tick: String::new() };
        for (name, identifier, c_name) in [
            ("int", "int", "top_int"),
            ("Clock", "clock", "top_clock"),
            ("time_t", "time_t", "top_time_t"),
            ("toytop_f32", "toytop_f32", "top_toytop_f32"),
            ("toy_top", "toy_top", "toy_top"),
            ("2 tops", "top_2_tops", "top_2_tops"),
            ("_a__b_", "a_b", "a_b"),
            ("Kreisel ä", "kreisel_u00e4", "kreisel_u00e4"),
            ("Kreisel ö", "kreisel_u00f6", "kreisel_u00f6"),
            ("陀螺", "u9640u87ba", "top_u9640u87ba"),
            ("...", "top_", "top_"),
        ] {
            let label = named(name);
            assert_eq!([label.identifier(), label.c_name()], [identifier, c_name], "{name}");
        }
    }
}
