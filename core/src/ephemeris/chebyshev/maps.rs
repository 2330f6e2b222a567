//! Linear maps from the coefficients of a series to those of another one: from powers of x to Chebyshev polynomials, and from an interval
//! to its halves. Each result is an exact sum of products, rounded once.

use crate::ephemeris::chebyshev::{Chebyshev, Coefficient, Wanted, half};
use crate::ephemeris::polynomial::Polynomial;
use crate::law::series::TERMS;
use crate::product::signed_product;

/// Fraction bits of the factors. Those of x^k and of T_k are multiples of 2^-k.
const SCALE: u32 = TERMS as u32 - 1;

/// Coefficients of the T_j(x) in x^k, for j = 0, 2, ..., k or 1, 3, ..., k, and for one k after the other: binomial coefficients over
/// 2^(k-1), and half of that for T_0.
#[allow(clippy::indexing_slicing)] // evaluated by the compiler, which would refuse an index out of range
static CONVERSION: [i32; TERMS / 2 * (TERMS / 2 + 1)] = {
    let mut table = [0; TERMS / 2 * (TERMS / 2 + 1)];
    let (mut k, mut place) = (0, 0);
    while k < TERMS {
        // from j = k down
        let (mut factor, mut m) = (1_i32 << (SCALE + 1) >> k, 0);
        while 2 * m <= k {
            table[place + k / 2 - m] = if 2 * m == k { factor / 2 } else { factor };
            factor = factor * (k - m) as i32 / (m + 1) as i32;
            m += 1;
        }
        (place, k) = (place + k / 2 + 1, k + 1);
    }
    table
};

/// Coefficients of T_0(y) to T_k(y) in T_k((y + 1)/2), for one k after the other.
#[allow(clippy::indexing_slicing)] // evaluated by the compiler, which would refuse an index out of range
static HALVING: [i32; TERMS * (TERMS + 1) / 2] = {
    // the coefficients in T_{k-1} and in T_k
    let (mut before, mut current) = ([0; TERMS + 1], [0; TERMS + 1]);
    (before[0], current[0], current[1]) = (1 << SCALE, 1 << (SCALE - 1), 1 << (SCALE - 1));
    let mut table = [0; TERMS * (TERMS + 1) / 2];
    let (mut k, mut place) = (0, 0);
    while k < TERMS {
        let mut j = 0;
        while j <= k {
            table[place] = before[j];
            (place, j) = (place + 1, j + 1);
        }
        // T_{k+1} = 2 x T_k - T_{k-1}, where 2 x = 1 + y, and y T_j = (T_{j-1} + T_{j+1})/2, but y T_0 = T_1
        let mut next = [0; TERMS + 1];
        j = 0;
        while j < TERMS {
            let lower = if j == 0 { 0 } else { current[j - 1] };
            let neighbours = current[j + 1] + if j == 1 { 2 * lower } else { lower };
            next[j] = current[j] + neighbours / 2 - before[j];
            j += 1;
        }
        (before, current, k) = (current, next, k + 1);
    }
    table
};

/// Sum of products of factors with coefficients: of their upper and of their lower parts.
#[derive(Clone, Copy)]
struct Sum {
    upper: i64,
    lower: i64,
}

impl Sum {
    /// Sum of no products and a quarter of a unit, so that the sum of two of them has the half unit for its rounding. A sum that begins
    /// with zeros would take a chip three times as long to clear.
    const QUARTER: Self = Self { upper: 0, lower: 1 << (SCALE - 2) };

    #[inline(always)]
    fn add(&mut self, factor: i32, c: Coefficient) {
        self.upper += signed_product(c.upper, factor);
        self.lower += signed_product(c.lower, factor);
    }

    #[inline(always)]
    fn plus(self, other: Self) -> Coefficient {
        Self { upper: self.upper + other.upper, lower: self.lower + other.lower }.rounded_down()
    }

    #[inline(always)]
    fn minus(self, other: Self) -> Coefficient {
        let lower = self.lower - other.lower + (1 << (SCALE - 1));
        Self { upper: self.upper - other.upper, lower }.rounded_down()
    }

    #[inline(always)]
    fn rounded_down(self) -> Coefficient {
        let Self { upper, lower } = self;
        Coefficient::of((upper << (Coefficient::LOW_BITS - SCALE)) + (lower >> SCALE))
    }
}

/// Sums for T_0(y), T_1(y), and so on, of the real and of the imaginary part.
type Sums = [[Sum; 2]; TERMS];

/// Adds the products of the factors of a column with the coefficients of the real and of the imaginary part.
#[inline(always)]
fn add(sums: &mut [[Sum; 2]], column: &[i32], [re, im]: [Coefficient; 2]) {
    for ([sum_re, sum_im], factor) in sums.iter_mut().zip(column) {
        sum_re.add(*factor, re);
        sum_im.add(*factor, im);
    }
}

impl Chebyshev {
    /// Replaces the series by that of a polynomial with this number of terms, whose magnitudes add up to less than 4.
    /// Rounding error of a coefficient: a unit, half of which is that of the polynomial's coefficients.
    #[inline(never)] // the stack frames of set-up must not add up
    pub(crate) fn set(&mut self, polynomial: &Polynomial, terms: usize) {
        // of the real and of the imaginary part, for T_0, T_2, ... and for T_1, T_3, ...
        let mut sums = [[[Sum::QUARTER; 2]; TERMS / 2]; 2];
        let mut factors = CONVERSION.as_slice();
        let [re, im] = polynomial;
        for (k, (re, im)) in re.iter().zip(im).enumerate().take(terms) {
            let (column, rest) = factors.split_at_checked(k / 2 + 1).unwrap_or_default();
            factors = rest;
            let [re, im] = [re, im].map(|c| Coefficient::of(half(*c)));
            let Some(sums) = sums.get_mut(k % 2) else { continue };
            add(sums, column, [re, im]);
        }
        let [even, odd] = &sums;
        let sums = even.iter().zip(odd).flat_map(|(even, odd)| [even, odd]);
        let [re, im] = &mut self.parts;
        for ((re, im), [sum_re, sum_im]) in re.iter_mut().zip(im).zip(sums).take(terms) {
            (*re, *im) = (sum_re.plus(Sum::QUARTER), sum_im.plus(Sum::QUARTER));
        }
        (self.terms, self.left_out) = (terms, [0; 2]);
    }

    /// Replaces the series by that on the wanted half of the interval, or by that on the lower half where both are wanted. Rounding
    /// error of a coefficient: half a unit.
    #[inline(never)] // the stack frames of set-up must not add up
    pub(crate) fn halve(&mut self, wanted: Wanted<'_>) {
        // of the real and of the imaginary part, from the T_k of even and of odd k
        let mut sums = [[[Sum::QUARTER; 2]; TERMS]; 2];
        let mut factors = HALVING.as_slice();
        let [re, im] = &self.parts;
        for (k, (re, im)) in re.iter().zip(im).enumerate().take(self.terms) {
            let (column, rest) = factors.split_at_checked(k + 1).unwrap_or_default();
            factors = rest;
            let Some(sums) = sums.get_mut(k % 2) else { continue };
            add(sums, column, [*re, *im]);
        }
        let [value, slope] = self.left_out;
        // the coordinate of a half changes twice as fast
        self.left_out = [value, half(slope)];
        match wanted {
            Wanted::Lower => self.put_lower_half(&sums),
            Wanted::Upper => self.put_upper_half(&sums),
            Wanted::Both(upper) => {
                (upper.terms, upper.left_out) = (self.terms, self.left_out);
                upper.put_upper_half(&sums);
                self.put_lower_half(&sums);
            }
        }
    }

    fn put_upper_half(&mut self, [even, odd]: &[Sums; 2]) {
        let [re, im] = &mut self.parts;
        for ((re, im), (even, odd)) in re.iter_mut().zip(im).take(self.terms).zip(even.iter().zip(odd)) {
            let ([even_re, even_im], [odd_re, odd_im]) = (even, odd);
            (*re, *im) = (even_re.plus(*odd_re), even_im.plus(*odd_im));
        }
    }

    /// On the lower half x = (y - 1)/2, and T_k(x) = (-1)^k T_k(-x).
    fn put_lower_half(&mut self, [even, odd]: &[Sums; 2]) {
        let [re, im] = &mut self.parts;
        let all = re.iter_mut().zip(im).take(self.terms).zip(even.iter().zip(odd));
        for (j, ((re, im), (even, odd))) in all.enumerate() {
            let (same, other) = if j % 2 == 0 { (even, odd) } else { (odd, even) };
            let ([same_re, same_im], [other_re, other_im]) = (same, other);
            (*re, *im) = (same_re.minus(*other_re), same_im.minus(*other_im));
        }
    }
}
