//! `f32`, and fixed point of 32 bits: sums and rotations in integers, the same bits on every chip.
//!
//! A coefficient of x^k is held as c·2^(31+k): the upper word of a product with x·2^31 halves the scale, which brings it to
//! that of the next lower coefficient. So a step of Horner's rule is one product and one sum. What must hold is that
//! the sum of the |c_j| from j = k on is below 2^-k for k >= 1; then no step overflows, and set-up counts what is beyond as
//! an error of the table. The last sum, |α| <= 1, saturates: a polynomial may exceed 1 by its error.
//!
//! The upper half of the powers is so small, where a table is as exact as 2^-31, that 16 bits of x will do for them: on the
//! smallest chip less than half the work. Set-up holds every table to that too.

use super::{Place, Tabular};
use crate::complex::Complex;
use crate::real::{high_product, high_product_of_less, short_product, sine_cosine_q26};

/// 2^-30: the unit of what [`alpha_beta`] gives.
const UNIT: f64 = 1.0 / (1_u64 << 30) as f64;

/// Error of [`alpha_beta`], as an orientation error: the phases lose up to 3 units to 32 bits, the sines are good to 4, the
/// sums and the rotations round off up to 5, and the short products up to 2.
pub(super) const ERROR: f64 = 14.0 * UNIT;

/// What [`Place::short_x`] rounds off.
pub(super) const PLACE_ROUNDING: f64 = 1.0 / (1_u64 << 32) as f64;

/// What the short products may lose of a polynomial before set-up counts it as an error of the table.
const SHORT_ERROR: f64 = 0.5 * UNIT;

/// 2^-15, and some thousand roundings of a coefficient.
pub(super) const MARGIN: f64 = 3.2e-5;

/// The nearest coefficient of x^power, and half a unit more to make up for the product that will be added, rounded down.
/// Not for the constant: a last sum half a unit low is what [`alpha_beta`] can mirror without a carry.
pub(super) fn coefficient(value: f64, power: usize) -> i32 {
    let rounding = if power == 0 { 0.5 } else { 1.0 };
    libm::floor(value * (1_u64 << (31 + power)) as f64 + rounding) as i32
}

/// What [`coefficient`] holds.
pub(super) fn number(coefficient: i32, power: usize) -> f64 {
    f64::from(coefficient) / (1_u64 << (31 + power)) as f64
}

/// Whether 16 bits of x will do for a sum that is multiplied to this power of it.
#[inline(always)]
const fn is_short(power: usize, terms: usize) -> bool {
    2 * power > terms
}

/// By how much more than [`SHORT_ERROR`] a polynomial can lose to short products: x loses up to 2^-15.
pub(super) fn shortfall(polynomial: &[f64]) -> f64 {
    let mut sum = 0.0;
    let mut sums = 0.0;
    for (power, value) in polynomial.iter().enumerate().rev() {
        sum += libm::fabs(*value);
        if is_short(power, polynomial.len()) {
            sums += sum;
        }
    }
    (sums / 32768.0 - SHORT_ERROR).max(0.0)
}

/// Infinite where a polynomial is beyond what keeps the sums in range, with a margin for what the coefficients round off: there
/// is no saying how wrong a sum may be that leaves it.
pub(super) fn excess(polynomial: &[f64], margin: f64) -> f64 {
    let mut sum = 0.0;
    let mut excess = 0.0_f64;
    for (power, value) in polynomial.iter().enumerate().skip(1).rev() {
        sum += libm::fabs(*value);
        excess = excess.max(sum - (1.0 - margin) / (1_u64 << power) as f64);
    }
    if excess > 0.0 { f64::INFINITY } else { 0.0 }
}

/// Re α, Im α, Re β and Im β in units of 2^-30, by sines in units of 2^-31.
#[inline(always)]
pub(super) fn alpha_beta(
    terms: &[[i32; 4]],
    place: Place,
    sine_cosine: impl Fn(u32) -> (i32, i32),
) -> [i32; 4] {
    let x = place.short_x;
    let mask = -i32::from(place.mirrored);
    let [a, b] = place.slow.map(|phase| (phase >> 32) as u32);
    let turned = |[re, im]: [i32; 2], phase| rotated([re, im ^ mask], sine_cosine(phase));
    let ([re_alpha, im_alpha], [re_beta, im_beta]) = if FOUR_AT_A_TIME {
        let [re_alpha, im_alpha, re_beta, im_beta] = sums(terms, x, |four| *four);
        (turned([re_alpha, im_alpha], a), turned([re_beta, im_beta], b))
    } else {
        let beta = turned(sums(terms, x, |&[_, _, re, im]| [re, im]), b);
        (turned(sums(terms, x, |&[re, im, _, _]| [re, im]), a), beta)
    };
    [re_alpha, im_alpha, re_beta, im_beta]
}

/// Sums side by side suit the vectors of large processors; for four of them the smallest chip has too few registers.
const FOUR_AT_A_TIME: bool = cfg!(target_pointer_width = "64");

/// Polynomials by Horner's rule. (A row of coefficients is borrowed because the compiler then sees a vector in it.)
#[inline(always)]
fn sums<const N: usize>(terms: &[[i32; 4]], x: i32, of: impl Fn(&[i32; 4]) -> [i32; N]) -> [i32; N] {
    let [constant, higher @ ..] = terms else { return [0; N] };
    let mut sums = [0; N];
    for (power, coefficients) in higher.iter().enumerate().map(|(below, four)| (below + 2, four)).rev() {
        let short = is_short(power, terms.len());
        for (sum, c) in sums.iter_mut().zip(&of(coefficients)) {
            *sum = c + if short { short_product(*sum, x) } else { high_product_of_less(*sum, x) };
        }
    }
    for (sum, c) in sums.iter_mut().zip(of(constant)) {
        *sum = c.saturating_add(high_product_of_less(*sum, x));
    }
    sums
}

/// From units of 2^-31 to units of 2^-30, which leaves room for √2. (A sum is half a unit low, so that its complement is what
/// its negative would be.)
#[inline(always)]
fn rotated([re, im]: [i32; 2], (sine, cosine): (i32, i32)) -> [i32; 2] {
    [high_product(re, cosine) + high_product(!im, sine), high_product(re, sine) + high_product(im, cosine)]
}

impl Tabular for f32 {
    type Coefficient = i32;
    type Wide = Self;

    const NOTHING: i32 = 0;
    /// The integers, the sines' error of 1.2e-8, and the results rounded to `f32`: each by 2^-24 of itself.
    const TICK_ERROR: f64 = ERROR + 2.4e-8 + f32::EPSILON as f64;
    const PLACE_ROUNDING: f64 = PLACE_ROUNDING;

    fn coefficient(value: f64, power: usize) -> i32 {
        coefficient(value, power)
    }

    fn excess(polynomial: &[f64]) -> f64 {
        excess(polynomial, MARGIN) + shortfall(polynomial)
    }

    fn number(held: i32, power: usize) -> Self {
        number(held, power) as Self
    }

    fn widened(self) -> Self {
        self
    }

    #[inline(always)]
    fn alpha_beta(terms: &[[i32; 4]], place: Place) -> [Complex<Self>; 2] {
        let [re_alpha, im_alpha, re_beta, im_beta] =
            alpha_beta(terms, place, sine_cosine_q26).map(|value| value as Self * UNIT as Self);
        [Complex::new(re_alpha, im_alpha), Complex::new(re_beta, im_beta)]
    }

    #[inline(always)]
    fn tip(product: Complex<Self>, scale: Self) -> Complex<Self> {
        product.scaled(scale)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of six terms the products to the fourth and the fifth power are short, and the lower one's sum holds both.
    #[test]
    fn what_short_products_lose() {
        assert_eq!(shortfall(&[9.0, 9.0, 9.0, 9.0, -300.0, 500.0]), 1300.0 / 32768.0 - SHORT_ERROR);
        assert_eq!(shortfall(&[1.0, 0.5, 0.25, 0.1, 0.0, 1e-9]), 0.0);
        // in range, and yet not short: what f32 cannot hold
        let steep = [0.0, 0.0, 0.0, 0.0, 0.02, 0.01];
        assert_eq!(<f32 as Tabular>::excess(&steep), 0.04 / 32768.0 - SHORT_ERROR);
    }

    #[test]
    fn sums_stay_below_their_powers_by_a_margin() {
        assert_eq!(excess(&[9.0, 0.4994, 0.0], 1e-3), 0.0);
        assert_eq!(excess(&[9.0, 0.4996, 0.0], 1e-3), f64::INFINITY);
        assert_eq!(excess(&[9.0, 0.2, -0.2499, 0.0], 1e-3), f64::INFINITY);
    }
}
