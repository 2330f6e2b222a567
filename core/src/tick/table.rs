//! The table of an ephemeris, its tick, and what can be said of its error.

use super::tabular::Tabular;
use crate::error::{LaunchError, require};
use crate::launch::{CELLS, Cell, Fineness, Motion, Polynomial, Rates, Tabulated, tabulate};
use crate::real::{DoubleDouble, Float, Scalar};
use crate::turns::Turns;
use core::fmt;

/// A tick as an exact fraction of a second (of the motion's unit of time).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Tick {
    ticks: u32,
    seconds: u32,
}

impl Tick {
    /// So many ticks a second.
    ///
    /// # Errors
    /// `tick`: no ticks at all.
    pub fn hertz(frequency: u32) -> Result<Self, LaunchError> {
        Self::ratio(frequency, 1)
    }

    /// `ticks` ticks in `seconds` seconds: (44100, 2) is 44100/2 Hz.
    ///
    /// # Errors
    /// `tick`: one of the two is 0.
    pub fn ratio(ticks: u32, seconds: u32) -> Result<Self, LaunchError> {
        require(
            ticks > 0 && seconds > 0,
            "tick",
            "a positive number of ticks in a positive number of seconds",
        )?;
        Ok(Self { ticks, seconds })
    }

    /// Its length in units of time.
    pub(super) fn length(self) -> DoubleDouble {
        DoubleDouble::from(f64::from(self.seconds)) / DoubleDouble::from(f64::from(self.ticks))
    }

    /// Ticks in a unit of time.
    pub(super) fn rate(self) -> DoubleDouble {
        DoubleDouble::from(f64::from(self.ticks)) / DoubleDouble::from(f64::from(self.seconds))
    }
}

/// The polynomials, lowest power first: the coefficients of Re α, Im α, Re β and Im β side by side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Table<C, const SEGMENTS: usize, const TERMS: usize> {
    pub(super) cells: [Cell; CELLS],
    segments: [[[C; 4]; TERMS]; SEGMENTS],
}

/// Where a table is to be read.
pub(super) struct Spot<'a, C> {
    /// The coefficients that count.
    pub(super) terms: &'a [[C; 4]],
    /// The place on the segment, x·2^63 with x in [-1, 1).
    pub(super) x: i64,
    /// The same times 2^31, from 32 bits of the share of the cell: rounded down to 2^level.
    pub(super) short_x: i32,
    /// 2^level segments make a cell.
    pub(super) level: u32,
}

impl<C: Copy, const SEGMENTS: usize, const TERMS: usize> Table<C, SEGMENTS, TERMS> {
    /// Checked when the type is used.
    const SIZE_IS_VALID: () =
        assert!(SEGMENTS >= 2 && SEGMENTS <= Cell::MOST_SEGMENTS && TERMS >= 2 && TERMS <= 16);
    /// As many cells, as a power of two.
    pub(super) const CELL_BITS: u32 = Cell::bits_for(SEGMENTS);

    /// All coefficients the same.
    pub(super) const fn of(coefficient: C) -> Self {
        Self::from_parts([Cell::new(0, 0); CELLS], [[[coefficient; 4]; TERMS]; SEGMENTS])
    }

    pub(super) const fn from_parts(cells: [Cell; CELLS], segments: [[[C; 4]; TERMS]; SEGMENTS]) -> Self {
        let () = Self::SIZE_IS_VALID;
        Self { cells, segments }
    }

    /// By segment and power.
    pub(super) fn segments(&self) -> &[[[C; 4]; TERMS]; SEGMENTS] {
        &self.segments
    }

    /// Tabulates a motion.
    ///
    /// # Errors
    /// [`NoFit`].
    pub(super) fn fill<R: Tabular<Coefficient = C>>(
        &mut self,
        motion: &Motion,
        rates: &Rates,
        allowed: f64,
    ) -> Result<Tabulated, NoFit> {
        // a quarter of the error where there is room for it
        for (allowed, most) in [(0.25 * allowed, SEGMENTS), (allowed, Cell::MOST_SEGMENTS)] {
            let fineness = Fineness { cell_bits: Self::CELL_BITS, terms: TERMS, allowed, most };
            let tabulated =
                tabulate(motion, rates, fineness, |segment, which, part| self.put::<R>(segment, which, part));
            match tabulated {
                Some(tabulated) if tabulated.segments <= SEGMENTS => {
                    self.cells = tabulated.cells;
                    let unused = self.segments.get_mut(tabulated.segments..).unwrap_or_default();
                    unused.fill([[R::NOTHING; 4]; TERMS]);
                    return Ok(tabulated);
                }
                Some(Tabulated { segments, .. }) => {
                    return Err(NoFit { truncation: allowed, segments: Some(segments as u32) });
                }
                None => {}
            }
        }
        Err(NoFit { truncation: allowed, segments: None })
    }

    /// Keeps the polynomial of α (`which` = 0) or of β (1) on a segment, if there is room for it; returns what the coefficients
    /// cannot hold of it, as an orientation error.
    fn put<R: Tabular<Coefficient = C>>(
        &mut self,
        segment: usize,
        which: usize,
        parts: Polynomial<'_>,
    ) -> f64 {
        let place = self.segments.get_mut(segment).map_or(&mut [][..], |terms| terms);
        let mut largest = 0.0;
        for (column, part) in (2 * which..).zip(parts) {
            for (power, (four, &value)) in place.iter_mut().zip(part.iter()).enumerate() {
                if let Some(coefficient) = four.get_mut(column) {
                    *coefficient = R::coefficient(value, power);
                }
            }
            let excess = R::excess(part.get(..TERMS).unwrap_or(part));
            largest = if excess > largest { excess } else { largest };
        }
        4.0 * largest
    }

    /// What belongs to a share of half a period, given as 64 bits.
    #[inline(always)]
    pub(super) fn find(&self, share: u64) -> Spot<'_, C> {
        let number = (share >> (u64::BITS - Self::CELL_BITS)) as usize;
        let cell = self.cells.get(number).copied().unwrap_or_default();
        let level = cell.level();
        // what is left of the share, and 32 bits of it
        let (share, short) = (share << Self::CELL_BITS, (share >> (32 - Self::CELL_BITS)) as u32);
        // the upper `level` bits are the segment's number in the cell; two shifts, because none of 32 is allowed
        let segment = cell.first() + (short >> 1 >> (31 - level)) as usize;
        // no cell leads beyond the last segment; with another one in its place no branch is needed to say so
        let terms = self.segments.get(segment).or(self.segments.first());
        // [0, 1) to [-1, 1): the upper bit changes sides
        let (x, short_x) = ((share << level) ^ (1 << 63), (short << level) ^ (1 << 31));
        Spot { terms: terms.map_or(&[], |terms| terms), x: x as i64, short_x: short_x as i32, level }
    }
}

/// How far an orientation from an ephemeris can be from the truth of the very numbers it was launched from, in rad
/// (2 √(|Δα|² + |Δβ|²)): at tick n at most `constant + |n| per_tick`, [`ErrorBound::after`].
///
/// The roundings in it are counted, not proved. All of 100 000 random motions of every regime keep it (`toytop study --motions
/// 100000 --seed 3`), and of a million launches towards every degenerate corner the 9822 that were held against the truth
/// (`toytop study --corners`): the greatest error there was 0.83 of the bound in `f64` and 0.67 in `f32`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ErrorBound {
    /// What the polynomials leave, what set-up rounds off, and what a tick rounds off.
    pub constant: f64,
    /// The rounding of the rates and of the increments.
    pub per_tick: f64,
}

impl ErrorBound {
    /// So many ticks from tick 0, whole or not, either way: rad.
    #[must_use]
    pub fn after(&self, ticks: f64) -> f64 {
        self.constant + self.per_tick * Float::abs(ticks)
    }

    pub(super) fn of<R: Tabular>(
        rates: &Rates,
        tabulated: &Tabulated,
        cells: u32,
        turns_per_tick: [f64; 3],
    ) -> Self {
        const TURN: f64 = 2.0 * core::f64::consts::PI;
        /// Roundings of a set-up, all in f64: the march, the start on it, and more for a motion that takes many segments,
        /// some of them in the same sense.
        const SET_UP_ROUNDINGS: f64 = 5.0;
        /// Of the haste: roundings on the way delay what follows.
        const DELAYS: f64 = 0.5;
        let segments = tabulated.segments as f64;
        let march = 0.5 * libm::sqrt(segments) + segments / 64.0;
        let roundings = SET_UP_ROUNDINGS + march + DELAYS * tabulated.haste;
        let set_up = roundings * <f64 as Scalar>::ROUNDING;
        let place = 2.0 * R::PLACE_ROUNDING * tabulated.haste / f64::from(cells);
        let increments = 3.0 * TURN * Turns::RESOLUTION;
        let turning: f64 = turns_per_tick.iter().map(|&turns| TURN * Float::abs(turns)).sum();
        Self {
            constant: tabulated.truncation + tabulated.defect + R::TICK_ERROR + place + set_up,
            per_tick: increments + rates.relative_error * turning,
        }
    }
}

/// Polynomials of this number and degree cannot follow the motion as closely as they should.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct NoFit {
    /// How closely they should: the error allowed, rad.
    pub truncation: f64,
    /// How many segments of as many terms would do; `None` if 4096 would not.
    pub segments: Option<u32>,
}

impl fmt::Display for NoFit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the table cannot follow the motion to within {:.1e} rad; ", self.truncation)?;
        match self.segments {
            Some(segments) => write!(f, "{segments} segments of this degree would fit"),
            None => write!(f, "not even {} segments of this degree would fit", Cell::MOST_SEGMENTS),
        }
    }
}

impl core::error::Error for NoFit {}
