//! An ephemeris as literal data: set up on a host, compiled into the flash of a chip that need not set up anything.

mod checksum;

use super::{Clock, Ephemeris};
use crate::cycle::Cycle;
use crate::launch::{CELLS, Cell};
use crate::real::DoubleDouble;
use crate::tick::table::{ErrorBound, Table};
use crate::tick::tabular::Tabular;
use checksum::Checksum;
use core::fmt;

/// All that an [`Ephemeris`] is made of, as plain numbers: what a program writes as source text, and the compiler reads.
///
/// A checksum over every bit is part of it: a number that was changed, lost or rounded on the way is refused, and in a
/// constant that is a compile error. `toytop bake SCENARIO` writes such constants; [`Ephemeris::to_baked`] is what it writes.
///
/// ```
/// use toytop::{Baked, Ephemeris};
/// static RESTING: Ephemeris<f32, 2, 2> = match (Baked::<f32, 2, 2> {
///     format: 2,
///     checksum: 0x1b59_3b33,
///     first: [0; 3],
///     step: [[0; 3], [0, 0, 1 << 31], [0; 3]],
///     exact_step: [[0.0; 2], [0.5, 0.0], [0.0; 2]],
///     ticks_per_time: [1000.0, 0.0],
///     horizon: None,
///     bound: [1e-8, 1e-28],
///     tip_scale: 0.06,
///     rates: [0.0, 3141.5928, 0.0],
///     cells: [0; 16],
///     coefficients: [[[i32::MAX, 0, 0, 0], [0; 4]]; 2],
/// })
/// .ephemeris()
/// {
///     Ok(ephemeris) => ephemeris,
///     Err(_) => panic!("checksum"),
/// };
/// assert_eq!(RESTING.at_tick(3).phi().alpha.re, -1.0); // half a turn a tick
/// ```
///
/// One bit of it changed does not compile:
/// ```compile_fail,E0080
/// # use toytop::{Baked, Ephemeris};
/// static RESTING: Ephemeris<f32, 2, 2> = match (Baked::<f32, 2, 2> {
/// #   format: 2,
/// #   checksum: 0x1b59_3b33,
/// #   first: [0; 3],
/// #   step: [[0; 3], [0, 0, 1 << 31], [0; 3]],
/// #   exact_step: [[0.0; 2], [0.5, 0.0], [0.0; 2]],
/// #   ticks_per_time: [1000.0, 0.0],
/// #   horizon: None,
/// #   bound: [1e-8, 1e-28],
/// #   tip_scale: 0.06,
/// #   rates: [0.0, 3141.5928, 0.0],
/// #   cells: [0; 16],
///     // as above, but for
///     coefficients: [[[i32::MAX - 1, 0, 0, 0], [0; 4]]; 2],
/// })
/// .ephemeris()
/// # {
/// #   Ok(ephemeris) => ephemeris,
/// #   Err(_) => panic!("checksum"),
/// # };
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Baked<R: Tabular, const SEGMENTS: usize, const TERMS: usize> {
    /// What the fields mean: [`Baked::FORMAT`].
    pub format: u32,
    /// Of all that is below, of the scalar and of the size.
    pub checksum: u32,
    /// Nutation phase, A and B at tick `i64::MIN`, in units of 2^-64 turns.
    pub first: [u64; 3],
    /// What a tick adds to them, in units of 2^-96 turns: words of 32 bits, the least significant first.
    pub step: [[u32; 3]; 3],
    /// The same in turns, whole ones included, each as the sum of two `f64`: for a part of a tick.
    pub exact_step: [[f64; 2]; 3],
    /// Ticks in a unit of time, as the sum of two `f64`.
    pub ticks_per_time: [f64; 2],
    /// The first and the last tick at which an aperiodic motion still moves.
    pub horizon: Option<[i64; 2]>,
    /// The [`ErrorBound`], rad: constant, and per tick.
    pub bound: [f64; 2],
    /// 2s in m (2 where the tip is held).
    pub tip_scale: R::Wide,
    /// dx/dt on a cell of one segment, and the mean rates of A and B in rad, per unit time.
    pub rates: [R::Wide; 3],
    /// Of each sixteenth of half a period (of each half where SEGMENTS is 2 or 3, and so on), u rising: the number of its first
    /// segment, times 16, and the logarithm to base 2 of how many it has.
    pub cells: [u16; 16],
    /// By segment and power: those of Re α, Im α, Re β and Im β.
    pub coefficients: [[[R::Coefficient; 4]; TERMS]; SEGMENTS],
}

impl<R: Tabular, const SEGMENTS: usize, const TERMS: usize> Baked<R, SEGMENTS, TERMS> {
    /// The format that this version of the crate reads.
    pub const FORMAT: u32 = 2;

    /// The checksum of all but what depends on the scalar.
    const fn head(&self, scalar: u32) -> Checksum {
        let mut sum = Checksum::EMPTY.word(self.format).word(scalar).word(SEGMENTS as u32).word(TERMS as u32);
        let [nutation, a, b] = self.first;
        sum = sum.wide(nutation).wide(a).wide(b);
        let [nutation, a, b] = self.step;
        sum = sum.words(&nutation).words(&a).words(&b);
        let [nutation, a, b] = self.exact_step;
        sum = sum.pair(nutation).pair(a).pair(b).pair(self.ticks_per_time).pair(self.bound);
        let [first, last] = match self.horizon {
            Some(horizon) => horizon,
            None => [0; 2],
        };
        sum = sum.word(self.horizon.is_some() as u32).wide(first as u64).wide(last as u64);
        let mut cells = self.cells.as_slice();
        while let [cell, rest @ ..] = cells {
            sum = sum.word(*cell as u32);
            cells = rest;
        }
        sum
    }

    const fn unpacked(&self) -> Ephemeris<R, SEGMENTS, TERMS> {
        let [nutation, a, b] = self.step;
        let [exact_nutation, exact_a, exact_b] = self.exact_step;
        let [constant, per_tick] = self.bound;
        let mut cells = [Cell::from_bits(0); CELLS];
        let (mut to, mut from): (&mut [Cell], &[u16]) = (&mut cells, &self.cells);
        while let ([cell, rest @ ..], [bits, others @ ..]) = (to, from) {
            *cell = Cell::from_bits(*bits);
            (to, from) = (rest, others);
        }
        Ephemeris {
            table: Table::from_parts(cells, self.coefficients),
            clock: Clock {
                first: self.first,
                step: [Cycle::new(nutation), Cycle::new(a), Cycle::new(b)],
                exact_step: [sum(exact_nutation), sum(exact_a), sum(exact_b)],
                ticks_per_time: sum(self.ticks_per_time),
                horizon: self.horizon,
                tip_scale: self.tip_scale,
                rates: self.rates,
            },
            bound: ErrorBound { constant, per_tick },
        }
    }
}

const fn sum([hi, lo]: [f64; 2]) -> DoubleDouble {
    DoubleDouble::from_parts(hi, lo)
}

/// A scalar whose tables can be literal data.
pub trait Bakeable: Tabular {
    /// The checksum that belongs to these numbers, whatever theirs says.
    fn checksum<const SEGMENTS: usize, const TERMS: usize>(baked: &Baked<Self, SEGMENTS, TERMS>) -> u32;
}

impl<R: Bakeable, const SEGMENTS: usize, const TERMS: usize> Ephemeris<R, SEGMENTS, TERMS> {
    /// As literal data; what is made of it is equal to the bit. The result is as large as the table: not for a chip's stack.
    #[must_use]
    pub fn to_baked(&self) -> Baked<R, SEGMENTS, TERMS> {
        let Clock { first, step, exact_step, ticks_per_time, horizon, tip_scale, rates } = self.clock;
        let parts = |sum: DoubleDouble| [sum.hi(), sum.lo()];
        let mut baked = Baked {
            format: Baked::<R, SEGMENTS, TERMS>::FORMAT,
            checksum: 0,
            first,
            step: step.map(Cycle::words),
            exact_step: exact_step.map(parts),
            ticks_per_time: parts(ticks_per_time),
            horizon,
            bound: [self.bound.constant, self.bound.per_tick],
            tip_scale,
            rates,
            cells: self.table.cells.map(Cell::to_bits),
            coefficients: *self.table.segments(),
        };
        baked.checksum = R::checksum(&baked);
        baked
    }
}

/// A trait cannot promise functions for constants: what must be one stands here once for each scalar, with the number by which
/// checksums tell it from others.
macro_rules! bakeable {
    ($scalar:ty, $number:literal, $scale:ident, $coefficient:ident) => {
        impl Bakeable for $scalar {
            fn checksum<const SEGMENTS: usize, const TERMS: usize>(
                baked: &Baked<Self, SEGMENTS, TERMS>,
            ) -> u32 {
                baked.computed_checksum()
            }
        }

        impl<const SEGMENTS: usize, const TERMS: usize> Baked<$scalar, SEGMENTS, TERMS> {
            const fn computed_checksum(&self) -> u32 {
                let [x, a, b] = self.rates;
                let head = self.head($number).$scale(self.tip_scale).$scale(x).$scale(a).$scale(b);
                let mut sum = head;
                let mut rows = self.coefficients.as_flattened();
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

            /// The ephemeris, if every bit is in its place. Copies the table: for constants.
            ///
            /// # Errors
            /// [`BakedError`]: of another format, or changed.
            pub const fn ephemeris(&self) -> Result<Ephemeris<$scalar, SEGMENTS, TERMS>, BakedError> {
                if self.format != Self::FORMAT {
                    return Err(BakedError::Format { found: self.format });
                }
                let computed = self.computed_checksum();
                if self.checksum != computed {
                    return Err(BakedError::Checksum { stated: self.checksum, computed });
                }
                Ok(self.unpacked())
            }
        }
    };
}

bakeable!(f32, 32, single, signed);
bakeable!(f64, 64, double, double);
#[cfg(feature = "fixed")]
bakeable!(fixed::types::I2F30, 31, single, signed);
#[cfg(feature = "fixed")]
bakeable!(fixed::types::I2F14, 15, single, short);

/// Why literal data make no ephemeris.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum BakedError {
    /// `format`: written by another version.
    Format {
        /// What it says.
        found: u32,
    },
    /// `checksum`: not that of the numbers.
    Checksum {
        /// What it says.
        stated: u32,
        /// That of the numbers.
        computed: u32,
    },
}

impl fmt::Display for BakedError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Format { found } => {
                write!(f, "format: must be {}, not {found}", Baked::<f32, 2, 2>::FORMAT)
            }
            Self::Checksum { stated, computed } => {
                write!(f, "checksum: must be {computed:#010x}, not {stated:#010x}: the data were changed")
            }
        }
    }
}

impl core::error::Error for BakedError {}
