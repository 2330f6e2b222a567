//! Double-double: an unevaluated sum of two `f64`, about 31 significant digits.
//!
//! Set-up computes in this type, so that small differences that the `f64` input determines exactly (1e-12 between two
//! branch points, or the rounding of the product mass × height) keep their digits in the rates. The algorithms are
//! the error-free transformations of Dekker and Knuth. A product is split (17 operations) instead of using a fused
//! multiply-add, so that chip and host give the same bits.

use crate::phase::Phase;
use crate::scalar::{Float, Ring};
use core::cmp::Ordering;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// Number hi + lo with |lo| <= ulp(hi)/2. Relative error of one operation: below 2^-102.
///
/// Range: results between 1e-290 and 1e290 in magnitude, or 0; [`crate::Top`] and [`crate::State`] admit only numbers
/// whose results stay inside.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DoubleDouble {
    hi: f64,
    lo: f64,
}

/// Sum s of a and b and its rounding error e: a + b = s + e exactly (Knuth).
#[inline]
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    let from_b = s - a;
    (s, (a - (s - from_b)) + (b - from_b))
}

/// Sum s of a and b and its rounding error e for |a| >= |b|: a + b = s + e exactly (Dekker).
#[inline]
fn quick_two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    (s, b - (s - a))
}

/// Upper and lower 26 bits of a (Veltkamp).
#[inline]
fn split(a: f64) -> (f64, f64) {
    const SPLITTER: f64 = 134_217_729.0; // 2^27 + 1
    let t = SPLITTER * a;
    let hi = t - (t - a);
    (hi, a - hi)
}

/// Product p of a and b and its rounding error e: a b = p + e exactly (Dekker).
#[inline]
fn two_product(a: f64, b: f64) -> (f64, f64) {
    let p = a * b;
    let (a_hi, a_lo) = split(a);
    let (b_hi, b_lo) = split(b);
    (p, ((a_hi * b_hi - p) + a_hi * b_lo + a_lo * b_hi) + a_lo * b_lo)
}

impl DoubleDouble {
    /// Upper bound on the relative error of one sum (3·2^-106) or product (5·2^-106) (Joldes, Muller and Popescu
    /// 2017).
    pub(crate) const ROUNDING: f64 = 1.0 / (1_u128 << 103) as f64;

    /// 2π to 32 digits.
    pub(crate) const TWO_PI: Self = Self { hi: 2.0 * core::f64::consts::PI, lo: 2.4492935982947064e-16 };

    /// Angle in turns, from an angle in rad.
    pub(crate) fn in_turns(self) -> Self {
        self / Self::TWO_PI
    }

    /// Phase of this number of turns, modulo 2^32 turns.
    #[must_use]
    pub fn to_phase(self) -> Phase {
        Phase::new(self.hi) + Phase::new(self.lo)
    }

    /// Sum of any two `f64`, exact.
    #[must_use]
    pub fn new(hi: f64, lo: f64) -> Self {
        let (hi, lo) = two_sum(hi, lo);
        Self { hi, lo }
    }

    /// Number from its two parts, [`DoubleDouble::hi`] and [`DoubleDouble::lo`].
    pub(crate) const fn from_parts(hi: f64, lo: f64) -> Self {
        Self { hi, lo }
    }

    /// Product of two `f64`, exact.
    #[must_use]
    pub fn product(a: f64, b: f64) -> Self {
        let (hi, lo) = two_product(a, b);
        Self { hi, lo }
    }

    /// Largest whole number not above this one, as the sum of two whole `f64`, and the remainder in [0, 1).
    pub(crate) fn floor_and_rest(self) -> ([f64; 2], Self) {
        let (whole, low_whole) = (libm::floor(self.hi), libm::floor(self.lo));
        let rest = Self::new(self.hi - whole, self.lo - low_whole);
        if rest < Self::ONE {
            ([whole, low_whole], rest)
        } else {
            ([whole, low_whole + 1.0], rest - Self::ONE)
        }
    }

    /// Leading part: the nearest `f64`.
    #[must_use]
    pub fn hi(self) -> f64 {
        self.hi
    }

    /// Second part: the number minus its leading part.
    #[must_use]
    pub fn lo(self) -> f64 {
        self.lo
    }
}

impl From<f64> for DoubleDouble {
    fn from(x: f64) -> Self {
        Self { hi: x, lo: 0.0 }
    }
}

impl Add for DoubleDouble {
    type Output = Self;
    #[inline(never)]
    fn add(self, other: Self) -> Self {
        let (s, e) = two_sum(self.hi, other.hi);
        let (t, f) = two_sum(self.lo, other.lo);
        let (s, e) = quick_two_sum(s, e + t);
        let (hi, lo) = quick_two_sum(s, e + f);
        Self { hi, lo }
    }
}

impl Neg for DoubleDouble {
    type Output = Self;
    fn neg(self) -> Self {
        Self { hi: -self.hi, lo: -self.lo }
    }
}

impl Sub for DoubleDouble {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for DoubleDouble {
    type Output = Self;
    // a call: inlined into every formula of a launch it costs a chip without a floating-point unit its flash
    #[inline(never)]
    fn mul(self, other: Self) -> Self {
        let (p, e) = two_product(self.hi, other.hi);
        let (hi, lo) = quick_two_sum(p, e + (self.hi * other.lo + self.lo * other.hi));
        Self { hi, lo }
    }
}

impl Div for DoubleDouble {
    type Output = Self;
    // a call: inlined into every formula of a launch it costs a chip without a floating-point unit its flash
    #[inline(never)]
    fn div(self, other: Self) -> Self {
        // Long division: three quotients of 53 bits each.
        let first = self.hi / other.hi;
        let rest = self - other * first.into();
        let second = rest.hi / other.hi;
        let rest = rest - other * second.into();
        let third = rest.hi / other.hi;
        let (hi, lo) = quick_two_sum(first, second);
        Self { hi, lo } + third.into()
    }
}

impl PartialOrd for DoubleDouble {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        match self.hi.partial_cmp(&other.hi) {
            Some(Ordering::Equal) => self.lo.partial_cmp(&other.lo),
            order => order,
        }
    }
}

impl Ring for DoubleDouble {
    const ZERO: Self = Self { hi: 0.0, lo: 0.0 };
    const ONE: Self = Self { hi: 1.0, lo: 0.0 };
}

impl Float for DoubleDouble {
    fn from_f64(x: f64) -> Self {
        x.into()
    }

    fn to_f64(self) -> f64 {
        self.hi
    }

    fn sqrt(self) -> Self {
        if self.hi <= 0.0 {
            return Self::ZERO;
        }
        // two steps of Heron's method: each correction is half the residual divided by the root
        let root = Self::from(libm::sqrt(self.hi));
        let root = root + Self::from((self - root * root).hi / (2.0 * root.hi));
        root + Self::from((self - root * root).hi / (2.0 * root.hi))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TINY: f64 = 1e-31;

    #[test]
    fn a_third_times_three_is_one_to_31_digits() {
        let third = DoubleDouble::ONE / 3.0.into();
        let defect = (third * 3.0.into() - DoubleDouble::ONE).abs();
        assert!(defect.to_f64() < TINY);
        assert!(third.lo() != 0.0, "the second half carries digits");
    }

    #[test]
    fn a_root_squares_back() {
        for x in [2.0, 1e-20, 12345.678, 9.81] {
            let x = DoubleDouble::from(x);
            let root = x.sqrt();
            assert!(((root * root - x) / x).abs().to_f64() < TINY);
        }
        assert_eq!(DoubleDouble::from(-1e-300).sqrt(), DoubleDouble::ZERO);
    }

    #[test]
    fn a_small_difference_survives() {
        let big = DoubleDouble::new(1.0, 1e-25);
        assert_eq!((big - DoubleDouble::ONE).to_f64(), 1e-25);
        assert_eq!((DoubleDouble::product(0.1, 3.0) - DoubleDouble::from(0.1) * 3.0.into()).to_f64(), 0.0);
        assert!(big > DoubleDouble::ONE);
    }
}
