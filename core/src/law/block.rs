//! Power series with integer coefficients of a common exponent, and their products.
//!
//! A sum of products is exact and costs a 32-bit processor four multiplications for each pair of coefficients, where
//! emulated `f64` arithmetic costs 150 instructions. The coefficients of a converging series do not grow, so that all
//! of them share the exponent of the first ones.

/// Largest number of terms of a series; fewer are computed where the terms fall below the resolution of the scalar.
/// The segments of a table are short compared with the radius of convergence: where degree 5 leaves an error of 3e-8,
/// sixteen terms leave 1e-10; where degree 9 or more leaves 1e-16, they leave only rounding.
pub(crate) const TERMS: usize = 16;

/// Number of bits of a coefficient of the expected magnitude. A coefficient may be four times as large: then a sum of
/// 16 products and its three parts stay in range.
pub(crate) const BITS: i32 = 56;

/// Largest magnitude of a coefficient.
const LIMIT: i64 = 1 << (BITS + 2);

/// Bits of the lower part of a coefficient.
const LOW_BITS: u32 = 30;

/// Integer as high · 2^30 + low, with low in [0, 2^30): the parts of which products are made.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Split {
    high: i32,
    low: i32,
}

impl Split {
    pub(crate) const ZERO: Self = Self { high: 0, low: 0 };

    pub(crate) const fn of(value: i64) -> Self {
        Self { high: (value >> LOW_BITS) as i32, low: value as i32 & ((1 << LOW_BITS) - 1) }
    }

    #[inline(always)]
    pub(crate) const fn value(self) -> i64 {
        ((self.high as i64) << LOW_BITS) + self.low as i64
    }
}

/// Exact sum of the products of pairs, at most 16 of them.
#[inline(always)]
pub(crate) fn inner<'a>(pairs: impl Iterator<Item = (&'a Split, &'a Split)>) -> i128 {
    if cfg!(target_pointer_width = "64") {
        return pairs.fold(0, |sum, (a, b)| sum + i128::from(a.value()) * i128::from(b.value()));
    }
    let long = |a: i32, b: i32| i64::from(a) * i64::from(b);
    let (upper, across, lower) = pairs.fold((0_i64, 0_i64, 0_u64), |(upper, across, lower), (a, b)| {
        (
            upper + long(a.high, b.high),
            across + long(a.high, b.low) + long(a.low, b.high),
            lower + long(a.low, b.low) as u64,
        )
    });
    (i128::from(upper) << (2 * LOW_BITS)) + (i128::from(across) << LOW_BITS) + i128::from(lower)
}

/// Sum divided by 2^shift, rounded to the nearest; a quotient beyond the range becomes the largest that is not a
/// coefficient.
pub(crate) fn rounded(sum: i128, shift: i32) -> i64 {
    const BEYOND: i128 = 2 * LIMIT as i128;
    match shift {
        127.. => 0,
        1.. => (((sum >> (shift - 1)) + 1) >> 1).clamp(-BEYOND, BEYOND) as i64,
        _ => (sum.signum() * BEYOND) as i64,
    }
}

/// Product of two integers divided by 2^shift, rounded to the nearest.
pub(crate) fn scaled_product(a: Split, b: Split, shift: i32) -> i64 {
    rounded(inner([(&a, &b)].into_iter()), shift)
}

/// The number itself; `None` if it is too large for a coefficient, so that the series does not converge.
pub(crate) fn in_range(value: i64) -> Option<i64> {
    (value.abs() <= LIMIT).then_some(value)
}

/// Constant factor between two series, as an integer and a number of bits to drop from the product.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Factor {
    mantissa: Split,
    shift: i32,
}

impl Factor {
    /// Factor from a series with the exponent `from` to one with the exponent `to`. The expected magnitude of the
    /// second is at least that of the product.
    pub(crate) fn new(factor: f64, from: i32, to: i32) -> Self {
        let exponent = exponent(factor) - BITS;
        let mantissa = Split::of(scaled(factor, exponent));
        Self { mantissa, shift: to - from - exponent }
    }

    /// Factor mantissa/2^shift.
    pub(crate) const fn of_parts(mantissa: i64, shift: i32) -> Self {
        Self { mantissa: Split::of(mantissa), shift }
    }

    pub(crate) fn times(&self, value: i64) -> i64 {
        scaled_product(self.mantissa, Split::of(value), self.shift)
    }
}

/// Integral of a term c y^k: the quotient c/(k + 1), rounded to the nearest. A product costs much less than a division
/// on a chip without a divider.
pub(crate) fn integrated(c: i64, k: usize) -> i64 {
    #[allow(clippy::indexing_slicing)]
    static INVERSES: [Factor; TERMS] = {
        let mut inverses = [Factor::of_parts(0, 0); TERMS];
        let mut k = 0;
        while k < TERMS {
            // 1/(k + 1), rounded
            let divisor = k as i64 + 1;
            inverses[k] = Factor::of_parts(((1 << BITS) + divisor / 2) / divisor, BITS);
            k += 1;
        }
        inverses
    };
    INVERSES.get(k).map_or(0, |inverse| inverse.times(c))
}

/// Least e with |x| <= 2^e; very small for 0.
pub(crate) fn exponent(x: f64) -> i32 {
    ((x.to_bits() >> 52) & 0x7ff) as i32 - 1022
}

/// 2^exponent, for an exponent in the range of `f64`; 0 below it.
pub(crate) const fn power_of_two(exponent: i32) -> f64 {
    let field = match exponent {
        ..-1022 => 0,
        1023.. => 2046,
        _ => exponent + 1023,
    };
    f64::from_bits((field as u64) << 52)
}

/// Integer nearest to x / 2^exponent, for a quotient below 2^62.
pub(crate) fn scaled(x: f64, exponent: i32) -> i64 {
    // in two steps, because 2^-exponent may be beyond the range of f64
    let first = -exponent / 2;
    libm::round(x * power_of_two(first) * power_of_two(-exponent - first)) as i64
}

/// Coefficients of 1, x, x², ..., in units of 2^exponent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Block {
    coefficients: [Split; TERMS],
    pub(crate) exponent: i32,
}

impl Block {
    pub(crate) const ZERO: Self = Self { coefficients: [Split::ZERO; TERMS], exponent: -BITS };

    /// Removes all coefficients; those to come are expected to be at most `magnitude`.
    pub(crate) fn clear(&mut self, magnitude: f64) {
        self.clear_to(exponent(magnitude).max(-900) - BITS);
    }

    /// Removes all coefficients and sets the exponent of those to come.
    pub(crate) fn clear_to(&mut self, exponent: i32) {
        *self = Self { exponent, ..Self::ZERO };
    }

    pub(crate) fn get(&self, k: usize) -> i64 {
        self.coefficients.get(k).map_or(0, |coefficient| coefficient.value())
    }

    /// Stores a coefficient. Returns whether it is in range; otherwise the series does not converge.
    #[must_use]
    pub(crate) fn put(&mut self, k: usize, value: i64) -> bool {
        if let Some(coefficient) = self.coefficients.get_mut(k) {
            *coefficient = Split::of(value);
        }
        in_range(value).is_some()
    }

    /// Coefficient in `f64`.
    pub(crate) fn number(&self, k: usize) -> f64 {
        self.get(k) as f64 * self.unit()
    }

    /// Value of 1 in units of the coefficients' unit.
    pub(crate) fn unit(&self) -> f64 {
        power_of_two(self.exponent)
    }

    /// Exact coefficient of x^k of a product of two series, from the terms `first` to `last` of the first one, in units
    /// of 2^(sum of both exponents).
    #[inline(never)] // a call: set-up multiplies series in a dozen places
    pub(crate) fn product(&self, other: &Self, first: usize, last: usize, k: usize) -> i128 {
        let ours = self.coefficients.get(first..=last).unwrap_or_default();
        let theirs =
            other.coefficients.get(k.saturating_sub(last)..=k.saturating_sub(first)).unwrap_or_default();
        inner(ours.iter().zip(theirs.iter().rev()))
    }

    /// Sum Σ c yʲ⁻¹ over the coefficients j from 1 to `terms` - 1, for y = `quarters`/4, or of their magnitudes; `None`
    /// where it leaves the range.
    pub(crate) fn at_quarters(&self, quarters: i64, terms: usize, part: fn(i64) -> i64) -> Option<i64> {
        let coefficients = self.coefficients.get(1..terms)?;
        coefficients.iter().rev().try_fold(0_i64, |sum, c| {
            let next = ((sum * quarters + 2) >> 2) + part(c.value());
            (next.abs() <= LIMIT).then_some(next)
        })
    }
}
