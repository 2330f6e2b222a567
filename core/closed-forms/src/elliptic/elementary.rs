//! Elementary functions of real and of complex numbers in extended precision.
//!
//! The arguments are reduced to an interval around 0, where power series are used. Relative error: below 2e-30, also near the
//! argument 0 of an odd function; near the other zeros of a sine or cosine the error is absolute. The logarithm and the angle take one step of Newton's method from their `f64`
//! values, which squares the relative error.

use toytop::Complex;
use toytop::internal::{exact_sine_cosine, rotate_quarter_turns, sine_cosine_series};
use toytop::scalar::{Extended, Float, Ring};

/// Constant ln 2.
fn ln_two() -> Extended {
    Extended::from_f64_pair([core::f64::consts::LN_2, 2.3190468138462996e-17])
}

/// Constant π/2.
pub(crate) fn half_pi() -> Extended {
    Extended::TWO_PI * Extended::from(0.25)
}

/// Exponential function eˣ. It is 0 below x = -1e6, and e^1e6 above x = 1e6.
pub(crate) fn exp(x: Extended) -> Extended {
    const LARGEST: f64 = 1e6;
    if x.to_f64() < -LARGEST {
        return Extended::ZERO;
    }
    let x = if x.to_f64() > LARGEST { Extended::from(LARGEST) } else { x };
    let twos = libm::round(x.to_f64() / core::f64::consts::LN_2);
    let remainder = x - ln_two() * twos.into();
    (Extended::ONE + growth_series(remainder)).ldexp(twos as i32)
}

/// Growth eˣ - 1 for |x| <= 1/2, by its power series.
fn growth_series(x: Extended) -> Extended {
    const TERMS: u32 = 28;
    let sum = |sum, n| Extended::ONE + x * sum / Extended::from(f64::from(n));
    x * (2..=TERMS).rev().fold(Extended::ONE, sum)
}

/// Natural logarithm of x > 0. The error is absolute near x = 1.
pub(crate) fn ln(x: Extended) -> Extended {
    const ROOTS: u32 = 12;
    let mut x = x;
    let mut times = Extended::ONE;
    // into the range of `f64`
    for _ in 0..ROOTS {
        if (1e-300..1e300).contains(&x.to_f64()) {
            break;
        }
        (x, times) = (x.sqrt(), times.doubled());
    }
    let guess = Extended::from(libm::log(x.to_f64()));
    (guess + (x * exp(-guess) - Extended::ONE)) * times
}

/// (sin x, cos x), x in rad. The absolute error is about 1e-31 (1 + |x|) below 2^20 rad, and 4e-29 rad beyond.
pub(crate) fn sine_cosine(x: Extended) -> (Extended, Extended) {
    const FAR: f64 = (1 << 20) as f64;
    if Float::abs(x.to_f64()) > FAR {
        return exact_sine_cosine(x.radians_to_turns().to_phase());
    }
    let quadrant = libm::round(x.to_f64() * core::f64::consts::FRAC_2_PI);
    let remainder = x - half_pi() * quadrant.into();
    rotate_quarter_turns(quadrant as i32 as u32, sine_cosine_series(remainder, &mut || {}))
}

/// (sinh x, cosh x).
pub(crate) fn sinh_cosh(x: Extended) -> (Extended, Extended) {
    let size = x.abs();
    let growth = if size.to_f64() <= 0.5 { growth_series(size) } else { exp(size) - Extended::ONE };
    let grown = Extended::ONE + growth;
    let sinh = (growth + growth / grown).halved();
    (if x.to_f64() < 0.0 { -sinh } else { sinh }, (grown + Extended::ONE / grown).halved())
}

/// (tanh x, sech x, ln sech x).
pub(crate) fn tanh_sech(x: Extended) -> (Extended, Extended, Extended) {
    let q = exp(-x.abs());
    let sum = Extended::ONE + q.squared();
    let tanh = if Float::abs(x.to_f64()) <= 0.5 {
        let (sinh, cosh) = sinh_cosh(x.abs());
        sinh / cosh
    } else {
        (Extended::ONE - q.squared()) / sum
    };
    let tanh = if x.to_f64() < 0.0 { -tanh } else { tanh };
    (tanh, q.doubled() / sum, ln_two() - x.abs() - ln(sum))
}

/// Angle of the point (x, y) in rad, in [-π, π]; 0 at the origin. Relative error: about 1e-31.
pub(crate) fn angle(y: Extended, x: Extended) -> Extended {
    let guess = Extended::from(libm::atan2(y.to_f64(), x.to_f64()));
    let (sine, cosine) = sine_cosine(guess);
    let along = x * cosine + y * sine;
    let normal = y * cosine - x * sine;
    if along > Extended::ZERO { guess + normal / along } else { guess }
}

/// Complex number in extended precision, the number type of the closed forms.
pub(crate) type WideComplex = Complex<Extended>;

/// Complex number in extended precision from one in `f64`, exact.
pub(crate) fn widened(z: Complex<f64>) -> WideComplex {
    z.map(Into::into)
}

/// Complex number rounded to `f64`.
pub(crate) fn rounded(z: WideComplex) -> Complex<f64> {
    z.map(Float::to_f64)
}

/// Real number as a complex number.
pub(crate) fn real(x: Extended) -> WideComplex {
    Complex::new(x, Extended::ZERO)
}

/// Imaginary number ix as a complex number.
pub(crate) fn imaginary(x: Extended) -> WideComplex {
    Complex::new(Extended::ZERO, x)
}

/// Quotient a / b; larger than every `f64` for b = 0.
pub(crate) fn quotient(a: WideComplex, b: WideComplex) -> WideComplex {
    (a * b.conj()).scaled(Extended::ONE / b.norm_squared())
}

/// Unit complex number e^{ix}, x in rad.
pub(crate) fn cis(x: Extended) -> WideComplex {
    let (im, re) = sine_cosine(x);
    Complex::new(re, im)
}

/// Exponential function eᶻ.
pub(crate) fn complex_exp(z: WideComplex) -> WideComplex {
    cis(z.im).scaled(exp(z.re))
}

/// Principal logarithm, with imaginary part in [-π, π].
pub(crate) fn complex_ln(z: WideComplex) -> WideComplex {
    Complex::new(ln(z.modulus()), angle(z.im, z.re))
}

/// Sine and cosine of z, with errors relative to their modulus.
pub(crate) fn complex_sine_cosine(z: WideComplex) -> (WideComplex, WideComplex) {
    let (sine, cosine) = sine_cosine(z.re);
    let (sinh, cosh) = sinh_cosh(z.im);
    (Complex::new(sine * cosh, cosine * sinh), Complex::new(cosine * cosh, -(sine * sinh)))
}

/// Value and derivative of a function.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ValueAndSlope {
    pub(crate) value: WideComplex,
    pub(crate) slope: WideComplex,
}

impl ValueAndSlope {
    /// Value and derivative with respect to another variable; `rate` is the derivative of the previous variable with
    /// respect to it.
    pub(crate) fn by(self, rate: WideComplex) -> Self {
        Self { slope: self.slope * rate, ..self }
    }

    /// Logarithmic derivative.
    pub(crate) fn log_slope(self) -> WideComplex {
        quotient(self.slope, self.value)
    }

    pub(crate) fn add(&mut self, value: WideComplex, slope: WideComplex) {
        (self.value, self.slope) = (self.value + value, self.slope + slope);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(ours: Extended, truth: [f64; 2]) {
        within(2e-30, ours, truth);
    }

    fn within(allowed: f64, ours: Extended, [hi, lo]: [f64; 2]) {
        let truth = Extended::from_f64_pair([hi, lo]);
        let error = ((ours - truth) / truth).abs().to_f64();
        assert!(error < allowed, "{ours:?} for {truth:?}: {error:e}");
    }
    /// Expected values by mpmath with 60 digits.
    #[test]
    #[allow(clippy::approx_constant)] // e is one of the values
    fn every_function_has_31_digits() {
        near(exp(Extended::from(0.1)), [1.1051709180756477, -8.149523913327619e-17]);
        near(exp(Extended::from(-0.3)), [0.7408182206817179, -1.805530505953e-18]);
        near(exp(Extended::from(1.0)), [2.718281828459045, 1.4456468917292502e-16]);
        near(exp(Extended::from(-20.5)), [1.2501528663867426e-09, 6.448235878237776e-26]);
        near(exp(Extended::from(300.25)), [2.4941248615349213e+130, -6.154945403062824e+113]);
        near(exp(Extended::from(-600.0)), [2.6503965530043108e-261, 6.377342817491395e-278]);
        near(ln(Extended::from(0.1)), [-2.3025850929940455, -1.7150243628057985e-16]);
        near(ln(Extended::from(3.0)), [1.0986122886681098, -9.07129723500153e-17]);
        near(ln(Extended::from(1e-30)), [-69.07755278982137, -2.286179106246918e-15]);
        near(ln(Extended::from(1e+200)), [460.51701859880916, -2.2129109272629473e-14]);
        near(sine_cosine(Extended::from(1e-09)).0, [1e-09, -1.6666666666666669e-28]);
        near(sine_cosine(Extended::from(1e-09)).1, [1.0, -5e-19]);
        near(sine_cosine(Extended::from(0.7)).0, [0.644217687237691, 2.8740567927338755e-18]);
        near(sine_cosine(Extended::from(0.7)).1, [0.7648421872844885, -4.013780434022238e-17]);
        near(sine_cosine(Extended::from(0.8)).0, [0.7173560908995228, 1.1851419720716684e-18]);
        near(sine_cosine(Extended::from(0.8)).1, [0.6967067093471654, 1.9275818349860986e-18]);
        near(sine_cosine(Extended::from(-2.5)).0, [-0.5984721441039565, 5.521403334082375e-17]);
        near(sine_cosine(Extended::from(-2.5)).1, [-0.8011436155469337, -1.8674742705085553e-17]);
        near(sine_cosine(Extended::from(4.5)).0, [-0.977530117665097, -4.619499329500834e-17]);
        near(sine_cosine(Extended::from(4.5)).1, [-0.2107957994307797, -1.036476988089257e-17]);
        // the reduction of a large angle is as exact as π
        within(2e-29, sine_cosine(Extended::from(1000.0)).0, [0.8268795405320025, 3.867581909641312e-17]);
        within(2e-29, sine_cosine(Extended::from(1000.0)).1, [0.5623790762907029, 5.1611423543848204e-17]);
        near(sinh_cosh(Extended::from(1e-09)).0, [1e-09, 1.6666666666666669e-28]);
        near(sinh_cosh(Extended::from(1e-09)).1, [1.0, 5e-19]);
        near(sinh_cosh(Extended::from(-0.4)).0, [-0.4107523258028155, -2.2564035584726803e-17]);
        near(sinh_cosh(Extended::from(-0.4)).1, [1.0810723718384547, 9.190483192482217e-17]);
        near(sinh_cosh(Extended::from(0.6)).0, [0.6366535821482412, 5.203896601858732e-17]);
        near(sinh_cosh(Extended::from(0.6)).1, [1.1854652182422676, 1.0748819439096445e-16]);
        near(sinh_cosh(Extended::from(-30.0)).0, [-5343237290762.231, 0.0003718172657214174]);
        near(sinh_cosh(Extended::from(-30.0)).1, [5343237290762.231, -0.0003718172656278412]);
        near(tanh_sech(Extended::from(1e-09)).0, [1e-09, -3.3333333333333338e-28]);
        near(tanh_sech(Extended::from(1e-09)).1, [1.0, -5e-19]);
        near(tanh_sech(Extended::from(-0.4)).0, [-0.3799489622552249, -6.3008573143723185e-18]);
        near(tanh_sech(Extended::from(-0.4)).1, [0.9250074519057551, -4.549752045597913e-17]);
        near(tanh_sech(Extended::from(-0.4)).2, [-0.07795348538783242, -3.15424482797149e-18]);
        near(tanh_sech(Extended::from(0.6)).0, [0.5370495669980353, -2.923064398544366e-17]);
        near(tanh_sech(Extended::from(0.6)).1, [0.8435506876218066, 2.4189212411592058e-17]);
        near(tanh_sech(Extended::from(0.6)).2, [-0.17013528677808587, 2.350647847311811e-18]);
        near(tanh_sech(Extended::from(-30.0)).0, [-1.0, 1.751302152539304e-26]);
        near(tanh_sech(Extended::from(-30.0)).1, [1.871524593768035e-13, -4.234029256168084e-30]);
        near(tanh_sech(Extended::from(-30.0)).2, [-29.306852819440056, 1.6885250050674413e-15]);
        near(angle(Extended::from(1e-12), Extended::from(1.0)), [1e-12, -3.333333333333333e-37]);
        near(angle(Extended::from(0.3), Extended::from(0.4)), [0.6435011087932844, -2.857413593356198e-17]);
        near(
            angle(Extended::from(1.0), Extended::from(-1e-09)),
            [1.5707963277948966, -2.1508030979774455e-17],
        );
        near(angle(Extended::from(-2.0), Extended::from(-3.0)), [-2.5535900500422257, 3.5886651473917e-17]);
        assert_eq!(angle(Extended::ZERO, Extended::ZERO), Extended::ZERO);
        assert_eq!(exp(Extended::from(-1e7)), Extended::ZERO);
        assert!(
            (exp(Extended::from(-1e4)) * exp(Extended::from(1e4)) - Extended::ONE).abs().to_f64() < 1e-27
        );
    }
}
