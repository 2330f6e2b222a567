//! The table of an ephemeris, its tick, and what can be said of its error.

use super::tabular::Tabular;
use crate::error::{LaunchError, require};
use crate::launch::{Motion, Polynomials, Rates, Tabulated, tabulate};
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
    segments: [[[C; 4]; TERMS]; SEGMENTS],
}

impl<C: Copy, const SEGMENTS: usize, const TERMS: usize> Table<C, SEGMENTS, TERMS> {
    /// Checked when the type is used.
    const SIZE_IS_VALID: () = assert!(SEGMENTS >= 2 && SEGMENTS <= 1 << 16 && TERMS >= 2 && TERMS <= 16);

    /// All coefficients the same.
    pub(super) const fn of(coefficient: C) -> Self {
        let () = Self::SIZE_IS_VALID;
        Self { segments: [[[coefficient; 4]; TERMS]; SEGMENTS] }
    }

    pub(super) const fn from_segments(segments: [[[C; 4]; TERMS]; SEGMENTS]) -> Self {
        let () = Self::SIZE_IS_VALID;
        Self { segments }
    }

    /// By segment and power.
    pub(super) fn segments(&self) -> &[[[C; 4]; TERMS]; SEGMENTS] {
        &self.segments
    }

    /// Keeps the polynomials of a segment; returns what the coefficients cannot hold of them.
    pub(super) fn put<R: Tabular<Coefficient = C>>(
        &mut self,
        segment: usize,
        polynomials: &Polynomials,
    ) -> f64 {
        if let Some(place) = self.segments.get_mut(segment) {
            for (power, four) in place.iter_mut().enumerate() {
                for (value, polynomial) in four.iter_mut().zip(polynomials) {
                    *value = R::coefficient(polynomial.get(power).copied().unwrap_or(0.0), power);
                }
            }
        }
        excess::<R>(polynomials, TERMS)
    }

    /// The coefficients for a share of half a period, given as the 64 bits of the share, and the place among them, x·2^63
    /// with x in [-1, 1).
    #[inline(always)]
    pub(super) fn find(&self, share: u64) -> (&[[C; 4]], i64) {
        // both words of the share, so that a size that is no power of two costs two products, and one that is two shifts
        let (upper, lower) = (share >> 32, share & 0xffff_ffff);
        let count = SEGMENTS as u64;
        let segment = (upper * count + ((lower * count) >> 32)) >> 32;
        // [0, 1) to [-1, 1): the upper bit changes sides
        let x = share.wrapping_mul(count) ^ (1 << 63);
        (self.segments.get(segment as usize).map_or(&[], |terms| terms), x as i64)
    }
}

/// What the coefficients of a table cannot hold of a segment's polynomials, as an orientation error: there is no saying where
/// a sum may go beyond its integers.
fn excess<R: Tabular>(polynomials: &Polynomials, terms: usize) -> f64 {
    let largest = polynomials.iter().fold(0.0, |largest, polynomial| {
        let excess = R::excess(polynomial.get(..terms).unwrap_or(polynomial));
        if excess > largest { excess } else { largest }
    });
    if largest > 0.0 { f64::INFINITY } else { 0.0 }
}

/// How far an orientation from an ephemeris can be from the truth of the very numbers it was launched from, in rad
/// (2 √(|Δα|² + |Δβ|²)): at tick n at most `constant + |n| per_tick`.
///
/// The roundings in it are counts, calibrated on 800 random motions of every regime and held by 25 000 more: the greatest
/// error was 0.75 of the bound in `f64` and 0.87 in `f32`. `toytop study` repeats that.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ErrorBound {
    /// What the polynomials leave, what set-up rounds off, and what a tick rounds off.
    pub constant: f64,
    /// The rounding of the rates and of the increments.
    pub per_tick: f64,
}

impl ErrorBound {
    pub(super) fn of<R: Tabular>(
        rates: &Rates,
        tabulated: &Tabulated,
        turns_per_tick: [f64; 3],
        segments: usize,
    ) -> Self {
        const TURN: f64 = 2.0 * core::f64::consts::PI;
        /// Roundings of a set-up, all in f64: the march, the start on it, and more for a motion that takes many segments.
        const SET_UP_ROUNDINGS: f64 = 5.0;
        let set_up = (SET_UP_ROUNDINGS + 0.5 * libm::sqrt(segments as f64)) * <f64 as Scalar>::ROUNDING;
        let increments = 3.0 * TURN * Turns::RESOLUTION;
        let turning: f64 = turns_per_tick.iter().map(|&turns| TURN * Float::abs(turns)).sum();
        Self {
            constant: tabulated.truncation + tabulated.defect + R::TICK_ERROR + set_up,
            per_tick: increments + rates.relative_error * turning,
        }
    }
}

/// The polynomials of this size miss the motion by more than is allowed.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct NoFit {
    /// By how much, rad; infinite where nothing bounds it, which no allowance accepts.
    pub truncation: f64,
    /// How many segments of as many terms would do; `None` if 4096 would not.
    pub segments: Option<u32>,
}

impl NoFit {
    const MOST_SEGMENTS: usize = 4096;

    pub(super) fn check<R: Tabular>(
        motion: &Motion,
        rates: &Rates,
        tabulated: &Tabulated,
        [segments, terms]: [usize; 2],
        allowed: f64,
    ) -> Result<(), Self> {
        // what has no bound fits no allowance
        if tabulated.truncation <= allowed && tabulated.truncation < f64::INFINITY {
            return Ok(());
        }
        let mut more = segments;
        let fits = loop {
            more *= 2;
            if more > Self::MOST_SEGMENTS {
                break None;
            }
            let held = |_, polynomials: &Polynomials| excess::<R>(polynomials, terms);
            if tabulate(motion, rates, more, terms, held).truncation <= allowed {
                break Some(more as u32);
            }
        };
        Err(Self { truncation: tabulated.truncation, segments: fits })
    }
}

impl fmt::Display for NoFit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.truncation < f64::INFINITY {
            write!(f, "the table misses the motion by {:.1e} rad; ", self.truncation)?;
        } else {
            write!(f, "the table cannot hold the motion; ")?;
        }
        match self.segments {
            Some(segments) => write!(f, "{segments} segments of this degree would fit"),
            None => write!(f, "not even {} segments of this degree would fit", Self::MOST_SEGMENTS),
        }
    }
}

impl core::error::Error for NoFit {}
