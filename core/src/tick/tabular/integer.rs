//! `f32`, and fixed point of 32 bits: sums and rotations in integers, the same bits on every chip.
//!
//! A coefficient of x^k is held as c·2^(31+k): the upper word of a product with x·2^31 halves the scale, which brings it to
//! that of the next lower coefficient. So a step of Horner's rule is one product and one sum. What must hold is that
//! the sum of the |c_j| from j = k on is below 2^-k for k >= 1; then no step overflows, and set-up counts what is beyond as
//! an error of the table. The last sum, |α| <= 1, saturates: a polynomial may exceed 1 by its error.

use super::{Place, Tabular};
use crate::complex::Complex;
use crate::real::{high_product, sine_cosine_q31};

/// 2^-30: the unit of what [`alpha_beta`] gives.
const UNIT: f64 = 1.0 / (1_u64 << 30) as f64;

/// Error of [`alpha_beta`], as an orientation error: the phases lose up to 3 units to 32 bits, the sines are good to 4, the
/// sums and the rotations round off up to 5.
pub(super) const ERROR: f64 = 12.0 * UNIT;

/// Some thousand roundings of a coefficient.
pub(super) const MARGIN: f64 = 1e-6;

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

/// By how much a polynomial is beyond what keeps the sums in range, with a margin for what the coefficients round off.
pub(super) fn excess(polynomial: &[f64], margin: f64) -> f64 {
    let mut sum = 0.0;
    let mut excess = 0.0_f64;
    for (power, value) in polynomial.iter().enumerate().skip(1).rev() {
        sum += libm::fabs(*value);
        excess = excess.max(sum - (1.0 - margin) / (1_u64 << power) as f64);
    }
    excess
}

/// Re α, Im α, Re β and Im β in units of 2^-30.
#[inline(always)]
pub(super) fn alpha_beta(terms: &[[i32; 4]], place: Place) -> [i32; 4] {
    let x = (place.x >> 32) as i32;
    let [constant, higher @ ..] = terms else { return [0; 4] };
    let mut sums = [0; 4];
    let mut backwards = higher.iter().rev();
    if let Some(&highest) = backwards.next() {
        sums = highest;
    }
    for coefficients in backwards {
        for (sum, &c) in sums.iter_mut().zip(coefficients) {
            *sum = c + high_product(*sum, x);
        }
    }
    for (sum, &c) in sums.iter_mut().zip(constant) {
        *sum = c.saturating_add(high_product(*sum, x));
    }
    let [re_alpha, im_alpha, re_beta, im_beta] = sums;
    // a sum is half a unit low, so that its complement is what its negative would be
    let mask = -i32::from(place.mirrored);
    let sign = |y: i32| y ^ mask;
    let [a, b] = place.slow.map(|phase| sine_cosine_q31((phase >> 32) as u32));
    let [re_alpha, im_alpha] = rotated([re_alpha, sign(im_alpha)], a);
    let [re_beta, im_beta] = rotated([re_beta, sign(im_beta)], b);
    [re_alpha, im_alpha, re_beta, im_beta]
}

/// From units of 2^-31 to units of 2^-30, which leaves room for √2.
#[inline(always)]
fn rotated([re, im]: [i32; 2], (sine, cosine): (i32, i32)) -> [i32; 2] {
    [high_product(re, cosine) - high_product(im, sine), high_product(re, sine) + high_product(im, cosine)]
}

impl Tabular for f32 {
    type Coefficient = i32;
    type Wide = Self;

    const NOTHING: i32 = 0;
    /// The integers, and the results rounded to `f32`: each by 2^-24 of itself.
    const TICK_ERROR: f64 = ERROR + f32::EPSILON as f64;

    fn coefficient(value: f64, power: usize) -> i32 {
        coefficient(value, power)
    }

    fn excess(polynomial: &[f64]) -> f64 {
        excess(polynomial, MARGIN)
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
            alpha_beta(terms, place).map(|value| value as Self * UNIT as Self);
        [Complex::new(re_alpha, im_alpha), Complex::new(re_beta, im_beta)]
    }

    #[inline(always)]
    fn tip(product: Complex<Self>, scale: Self) -> Complex<Self> {
        product.scaled(scale)
    }
}
