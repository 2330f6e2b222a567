//! Quotient, exponential, logarithm, sine and cosine of complex numbers in extended precision.

use super::transcendental::{exp as real_exp, ln as real_ln};
use crate::complex::Complex;
use crate::elliptic::transcendental::angle;
use crate::elliptic::transcendental::{sine_cosine, sinh_cosh};
use crate::scalar::{Extended, Float, Ring};

/// Complex number in extended precision, the number type of the closed forms.
pub(crate) type Wide = Complex<Extended>;

/// Complex number in extended precision from one in `f64`, exact.
pub(crate) fn widened(z: Complex<f64>) -> Wide {
    Complex::new(z.re.into(), z.im.into())
}

/// Complex number rounded to `f64`.
pub(crate) fn rounded(z: Wide) -> Complex<f64> {
    Complex::new(z.re.to_f64(), z.im.to_f64())
}

/// Real number as a complex number.
pub(crate) fn real(x: Extended) -> Wide {
    Complex::new(x, Extended::ZERO)
}

/// Imaginary number ix as a complex number.
pub(crate) fn imaginary(x: Extended) -> Wide {
    Complex::new(Extended::ZERO, x)
}

fn size(z: Wide) -> Extended {
    if z.re.abs() > z.im.abs() { z.re.abs() } else { z.im.abs() }
}

/// Modulus |z|: the larger part in magnitude, times a factor between 1 and √2, so that no intermediate result
/// overflows.
pub(crate) fn modulus(z: Wide) -> Extended {
    let size = size(z);
    if size == Extended::ZERO {
        return size;
    }
    Complex::new(z.re / size, z.im / size).norm_squared().sqrt() * size
}

/// Quotient a / b, scaled so that intermediate results overflow only where the result does; not finite for b = 0.
pub(crate) fn quotient(a: Wide, b: Wide) -> Wide {
    let size = size(b);
    let (re, im) = (b.re / size, b.im / size);
    let per_norm = Extended::ONE / (re * re + im * im);
    (a * Complex::new(re, -im)).scaled(per_norm).scaled(Extended::ONE / size)
}

/// Exponential function eᶻ.
pub(crate) fn exp(z: Wide) -> Wide {
    cis(z.im).scaled(real_exp(z.re))
}

/// Unit complex number e^{ix}, x in rad.
pub(crate) fn cis(x: Extended) -> Wide {
    let (im, re) = sine_cosine(x);
    Complex::new(re, im)
}

/// Principal logarithm, with imaginary part in [-π, π].
pub(crate) fn ln(z: Wide) -> Wide {
    Complex::new(real_ln(modulus(z)), angle(z.im, z.re))
}

/// Sine and cosine of z, with errors relative to their modulus.
pub(crate) fn sin_cos(z: Wide) -> (Wide, Wide) {
    let (sine, cosine) = sine_cosine(z.re);
    let (sinh, cosh) = sinh_cosh(z.im);
    (Complex::new(sine * cosh, cosine * sinh), Complex::new(cosine * cosh, -(sine * sinh)))
}
