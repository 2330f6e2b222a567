//! Quotient, exponential, logarithm, sine and cosine of complex numbers in `f64`.

use crate::complex::Complex;
use crate::real::Float;

/// a / b, scaled so that nothing overflows that need not; not finite for b = 0.
pub(super) fn quotient(a: Complex<f64>, b: Complex<f64>) -> Complex<f64> {
    let size = Float::abs(b.re).max(Float::abs(b.im));
    let (re, im) = (b.re / size, b.im / size);
    let norm = re * re + im * im;
    (a * Complex::new(re, -im)).scaled(1.0 / norm).scaled(1.0 / size)
}

/// eᶻ.
pub(super) fn exp(z: Complex<f64>) -> Complex<f64> {
    cis(z.im).scaled(libm::exp(z.re))
}

/// e^{ix}, x in rad.
pub(super) fn cis(x: f64) -> Complex<f64> {
    let (im, re) = libm::sincos(x);
    Complex::new(re, im)
}

/// The principal logarithm, its imaginary part in [-π, π].
pub(super) fn ln(z: Complex<f64>) -> Complex<f64> {
    Complex::new(libm::log(libm::hypot(z.re, z.im)), z.arg())
}

/// (sin z, cos z), each relative to its modulus.
pub(super) fn sin_cos(z: Complex<f64>) -> (Complex<f64>, Complex<f64>) {
    let (sine, cosine) = libm::sincos(z.re);
    let (sinh, cosh) = (libm::sinh(z.im), libm::cosh(z.im));
    (Complex::new(sine * cosh, cosine * sinh), Complex::new(cosine * cosh, -sine * sinh))
}

/// z / |z|.
pub(super) fn direction(z: Complex<f64>) -> Complex<f64> {
    z.scaled(1.0 / libm::hypot(z.re, z.im))
}
