//! An ephemeris as a file for other programs: a Rust module, a C header with its evaluator, or JSON.
//!
//! All three hold the same numbers, the crate's [`Baked`], of any size, with its version and checksum. A Rust module with a
//! changed number does not compile; the C header has a function that tells; both give the bits that the crate gives.
//!
//! C: fixed point is integers throughout, and `f32` is integers up to α and β, whose bits depend on nothing; u, c and `f64` need sums and products that are rounded
//! one by one (`-ffp-contract=off`). GCC 12.2 fuses some of them in spite of that at `-O3` for a machine with a fused
//! multiply-add; `-fno-tree-slp-vectorize` keeps it from doing so.

mod c;
mod json;
mod rust;

use crate::cli::Scalar;
use fixed::types::{I2F14, I2F30};
use toytop::{Bakeable, Baked};

pub use self::{c::header, json::object, rust::module};

/// The numbers of a [`Baked`], whatever its size and scalar.
#[derive(Clone, Debug, PartialEq)]
pub struct Parts {
    /// The version of the format.
    pub format: u32,
    /// Of all that follows.
    pub checksum: u32,
    /// Of the crate.
    pub scalar: Scalar,
    /// Segments and terms.
    pub size: [usize; 2],
    /// Nutation phase, A and B at tick `i64::MIN`, in units of 2^-64 turns.
    pub first: [u64; 3],
    /// What a tick adds, in units of 2^-96 turns: words of 32 bits, the least significant first.
    pub step: [[u32; 3]; 3],
    /// The same in turns, each a sum of two.
    pub exact_step: [[f64; 2]; 3],
    /// Ticks in a unit of time, a sum of two.
    pub ticks_per_time: [f64; 2],
    /// The ticks between which an aperiodic motion moves.
    pub horizon: Option<[i64; 2]>,
    /// On the orientation, rad: constant, and per tick.
    pub bound: [f64; 2],
    /// 2s, and the rates of x, A and B.
    pub scales: [f64; 4],
    /// Of each cell of half a period: its first segment, times 16, and the binary logarithm of how many it has.
    pub cells: [u16; 16],
    /// Those of Re α, Im α, Re β and Im β, by segment and power.
    pub coefficients: Coefficients,
}

/// The coefficients of a table, in rows of four.
#[derive(Clone, Debug, PartialEq)]
pub enum Coefficients {
    /// Integers; that of x^k in units of 2^-(31+k).
    Integers(Vec<[i32; 4]>),
    /// Short ones; that of x^k in units of 2^-(15+k).
    Shorts(Vec<[i16; 4]>),
    /// Floating point.
    Doubles(Vec<[f64; 4]>),
}

impl Parts {
    /// The parts of a table.
    #[must_use]
    pub fn of<R: Bake, const SEGMENTS: usize, const TERMS: usize>(baked: &Baked<R, SEGMENTS, TERMS>) -> Self {
        let [x, a, b] = baked.rates;
        Self {
            format: baked.format,
            checksum: baked.checksum,
            scalar: R::NAME,
            size: [SEGMENTS, TERMS],
            first: baked.first,
            step: baked.step,
            exact_step: baked.exact_step,
            ticks_per_time: baked.ticks_per_time,
            horizon: baked.horizon,
            bound: baked.bound,
            scales: [baked.tip_scale, x, a, b].map(Into::into),
            cells: baked.cells,
            coefficients: R::coefficients(baked.coefficients.as_flattened()),
        }
    }

    /// Bytes of the table, without the clock.
    #[must_use]
    pub fn table_bytes(&self) -> usize {
        let [segments, terms] = self.size;
        let coefficient = match &self.coefficients {
            Coefficients::Integers(_) => 4,
            Coefficients::Shorts(_) => 2,
            Coefficients::Doubles(_) => 8,
        };
        4 * segments * terms * coefficient
    }
}

/// A scalar whose tables can be written.
pub trait Bake: Bakeable<Wide: Into<f64>> {
    /// Which it is.
    const NAME: Scalar;

    /// Its coefficients.
    fn coefficients(rows: &[[Self::Coefficient; 4]]) -> Coefficients;
}

impl Bake for f32 {
    const NAME: Scalar = Scalar::F32;

    fn coefficients(rows: &[[i32; 4]]) -> Coefficients {
        Coefficients::Integers(rows.to_vec())
    }
}

impl Bake for I2F30 {
    const NAME: Scalar = Scalar::Q31;

    fn coefficients(rows: &[[i32; 4]]) -> Coefficients {
        Coefficients::Integers(rows.to_vec())
    }
}

impl Bake for I2F14 {
    const NAME: Scalar = Scalar::Q15;

    fn coefficients(rows: &[[i16; 4]]) -> Coefficients {
        Coefficients::Shorts(rows.to_vec())
    }
}

impl Bake for f64 {
    const NAME: Scalar = Scalar::F64;

    fn coefficients(rows: &[[Self; 4]]) -> Coefficients {
        Coefficients::Doubles(rows.to_vec())
    }
}

/// What a file says of the motion it holds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Label {
    /// Of the scenario.
    pub name: String,
    /// How long a tick is.
    pub tick: String,
}

impl Label {
    /// The name as an identifier in lower case: letters and digits of ASCII, anything else an underscore.
    #[must_use]
    pub fn identifier(&self) -> String {
        let letter = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '_' };
        let identifier: String = self.name.chars().map(letter).collect();
        if identifier.starts_with(|c: char| c.is_ascii_lowercase()) {
            identifier
        } else {
            format!("top_{identifier}")
        }
    }

    /// The name and what the table is, for a comment: without what could end one.
    fn headline(&self, parts: &Parts) -> String {
        let printable = |c: &char| !c.is_control() && !['*', '/', '\\'].contains(c);
        let name: String = self.name.chars().filter(printable).collect();
        let ([segments, terms], [constant, per_tick]) = (parts.size, parts.bound);
        format!(
            "{name}, {}: {segments} x {terms} in {}; within {constant:.1e} rad + {per_tick:.1e} rad a tick",
            self.tick,
            parts.scalar.name(),
        )
    }
}
