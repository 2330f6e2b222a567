//! Evaluation in `f64`: four polynomials by Horner's rule and two rotations.
//!
//! With α = a e^{iA} and β = b e^{iB}, where a and b are tabulated, Ω = Φ⁻¹Φ' has the transverse part
//!
//! ```text
//! Ω₁ + iΩ₂ = -2i (ᾱβ' - βᾱ') = -2i e^{i(B-A)} N,    N = x' (ā db/dx - b dā/dx) + i (A' + B') ā b
//! ```
//!
//! Where u falls, N becomes -N̄. The axial part Ω₃ = (n - K)/C is constant.

use crate::complex::Complex;
use crate::scalar::{Scalar, fraction_of_word, sine_cosine_f64};
use crate::su2::{Orientation, Vector};
use crate::table::scalar::{Coefficient, EphemerisScalar, EvaluationErrors, SegmentPoint};
use crate::table::series::expansion::TABLE_UNIT;

impl EphemerisScalar for f64 {
    type Coefficient = Self;
    type Segment = [[Self; 4]; 11];
    type Quantity = Self;

    const TERMS: usize = 11;
    const RATE_WORDS: usize = 2;
    const ZERO_SEGMENT: Self::Segment = [[0.0; 4]; 11];
    const CODE: u32 = 64;
    /// The random roundings of a tick are counted with those of set-up. Those of the rotation of the angular velocity are five standard
    /// deviations of one rounding.
    const ERRORS: EvaluationErrors = EvaluationErrors {
        tick: 0.0,
        slope: 0.0,
        rate: 0.0,
        relative_rate: 5.0 * <Self as Scalar>::ROUNDING,
    };

    #[inline(always)]
    fn rounded(number: Self) -> Self {
        number
    }
}

impl Coefficient for f64 {
    type Number = Self;
    type Quantity = Self;

    fn nearest(value: i64, _: usize) -> (Self, i64) {
        let nearest = value as f64;
        (nearest * TABLE_UNIT, (nearest as i64).saturating_sub(value))
    }

    fn error(_: &[i64]) -> f32 {
        0.0
    }

    fn value(self, _: usize) -> f64 {
        self
    }

    #[inline(always)]
    fn orientation(terms: &[[Self; 4]], point: SegmentPoint, slow: [u64; 2]) -> Orientation<Self> {
        let [values, _] = at_point(terms, point.x);
        rotated(values, point.mirrored, slow.map(direction))
    }

    #[inline(always)]
    fn orientation_and_rates(
        terms: &[[Self; 4]],
        point: SegmentPoint,
        slow: [u64; 2],
        [x, mean, axial]: [Self; 3],
    ) -> (Orientation<Self>, Vector<Self>, i32) {
        let polynomials = at_point(terms, point.x);
        let [a, b] = slow.map(direction);
        let orientation = rotated(polynomials[0], point.mirrored, [a, b]);
        let rates = [x * Self::from(1_u16 << point.level), mean, axial];
        (orientation, omega_body(polynomials, point.mirrored, a.conj() * b, rates), 0)
    }

    #[inline(always)]
    fn wide(number: Self) -> Self {
        number
    }

    #[inline(always)]
    fn rate(number: Self, _: i32) -> Self {
        number
    }
}

/// e^{iA} from the leading bits of A.
#[inline(always)]
fn direction(phase: u64) -> Complex<f64> {
    let (sine, cosine) = sine_cosine_f64(phase);
    Complex::new(cosine, sine)
}

#[inline(always)]
fn at_point(terms: &[[f64; 4]], x: i64) -> [[f64; 4]; 2] {
    values_and_slopes(terms.iter().rev().copied(), 2.0 * fraction_of_word(x))
}

/// Four polynomials at x and their derivatives, from rows of coefficients, the highest power first.
#[inline(always)]
pub(crate) fn values_and_slopes(mut rows: impl Iterator<Item = [f64; 4]>, x: f64) -> [[f64; 4]; 2] {
    let (mut sums, mut slopes) = (rows.next().unwrap_or_default(), [0.0; 4]);
    for coefficients in rows {
        for ((sum, slope), c) in sums.iter_mut().zip(&mut slopes).zip(coefficients) {
            *slope = *slope * x + *sum;
            *sum = *sum * x + c;
        }
    }
    [sums, slopes]
}

/// Orientation from the tabulated values, e^{iA} and e^{iB}.
#[inline(always)]
fn rotated(
    [re_a, im_a, re_b, im_b]: [f64; 4],
    mirrored: bool,
    [a, b]: [Complex<f64>; 2],
) -> Orientation<f64> {
    let sign = |y: f64| if mirrored { -y } else { y };
    Orientation { alpha: Complex::new(re_a, sign(im_a)) * a, beta: Complex::new(re_b, sign(im_b)) * b }
}

/// Angular velocity Ω from values and derivatives, e^{i(B-A)}, and the rates of x, of A + B and about the axis.
#[inline(always)]
pub(super) fn omega_body(
    polynomials: [[f64; 4]; 2],
    mirrored: bool,
    turn: Complex<f64>,
    [x, mean, axial]: [f64; 3],
) -> Vector<f64> {
    let pair = |[re_a, im_a, re_b, im_b]: [f64; 4]| [Complex::new(re_a, im_a), Complex::new(re_b, im_b)];
    let [[a, b], [a_slope, b_slope]] = polynomials.map(pair);
    let change = (a.conj() * b_slope - b * a_slope.conj()).scaled(x);
    let n = change + (a.conj() * b).times_i().scaled(mean);
    let n = if mirrored { -n.conj() } else { n } * turn;
    [2.0 * n.im, -2.0 * n.re, axial]
}
