//! Times in units of the distance of two nodes, as integers: a chip without a unit for `f64` then needs only one
//! product in `f64` for each measurement.

use crate::phase::{Phase, integer_parts};
use crate::scalar::Float;

/// Fraction bits of a place.
const FRACTION: u32 = 36;
/// Further fraction bits of a length that is multiplied by a count.
const FINER: u32 = 16;
/// Fraction bits of the rate of a phase, in turns per distance. The rate is below 2^18 turns; a thin rod
/// alone may turn faster, and its roll then counts as 0.
const RATE: u32 = 44;

/// Time after the launch in distances of the nodes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Place(i64);

/// Length of a period, in finer units.
#[derive(Clone, Copy, Debug)]
pub(super) struct Length(i64);

/// Rate of a phase per distance of the nodes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rate(i64);

impl Place {
    /// Beginning of the path.
    pub(super) const ZERO: Self = Self(0);

    /// Factor from a time to the argument of [`Place::of_units`].
    pub(super) fn units_per_time(spacing: f64) -> f64 {
        (1_u64 << FRACTION) as f64 / spacing
    }

    /// Place of a time in units. `None` beyond 2^26 nodes and where the time is negative.
    pub(super) fn of_units(units: f64) -> Option<Self> {
        integer(units).filter(|bits| (0..1 << (26 + FRACTION)).contains(bits)).map(Self)
    }

    pub(super) const fn of_node(number: u32) -> Self {
        Self((number as i64) << FRACTION)
    }

    /// Number of the nearest node after the first, and the distance from it in units of a place.
    pub(super) fn nearest_inner(self) -> (usize, i64) {
        let number = ((self.0 + (1 << (FRACTION - 1))) >> FRACTION).max(1);
        (number as usize, self.0 - (number << FRACTION))
    }

    /// Distance, of magnitude up to one and a half nodes, as a number.
    pub(super) fn number<F: Float>(distance: i64) -> F {
        // 31 bits are enough: the error of an interpolation is larger
        const DROPPED: u32 = FRACTION - 30;
        const UNIT: f64 = 1.0 / (1_u64 << 30) as f64;
        F::from_f64(f64::from((distance >> DROPPED) as i32)) * F::from_f64(UNIT)
    }

    pub(super) fn minus(self, other: Self) -> Self {
        Self(self.0 - other.0)
    }
}

impl Length {
    /// Length of a period in units of a place. `None` beyond 2^10 nodes.
    pub(super) fn of_units(units: f64) -> Option<Self> {
        integer(units * (1_u64 << FINER) as f64)
            .filter(|bits| (1..1 << (10 + FRACTION + FINER)).contains(bits))
            .map(Self)
    }

    /// Place at the end of the first period.
    pub(super) fn place(self) -> Place {
        Place(self.0 >> FINER)
    }

    /// Number of whole periods before a place, and their end.
    pub(super) fn whole(self, place: Place) -> (i64, Place) {
        let count = (i128::from(place.0) << FINER).checked_div(i128::from(self.0)).unwrap_or(0);
        (count as i64, Place(((count * i128::from(self.0)) >> FINER) as i64))
    }
}

impl Rate {
    /// Rate of a phase that turns by this angle, in rad, in a distance of the nodes.
    pub(super) fn of(angle: f64) -> Self {
        const UNITS: f64 = (1_u64 << RATE) as f64 * 0.5 * core::f64::consts::FRAC_1_PI;
        Self(integer(angle * UNITS).unwrap_or(0))
    }

    /// Phase at a place.
    pub(super) fn at(self, place: Place) -> Phase {
        const SHIFT: u32 = 96 - RATE - FRACTION;
        Phase::from_bits((i128::from(self.0) * i128::from(place.0)) << SHIFT)
    }
}

/// Number rounded down. `None` from 2^62 on.
fn integer(x: f64) -> Option<i64> {
    let (mantissa, exponent) = integer_parts(x);
    match exponent {
        0..=9 => Some(mantissa << exponent),
        -63..0 => Some(mantissa >> -exponent),
        10.. => None,
        _ => Some(0),
    }
}
