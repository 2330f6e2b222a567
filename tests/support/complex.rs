//! Complex numbers with all operations, for writing the paper's formulas as they are printed.

pub use num_complex::Complex64 as C;
use toytop::Complex;

/// Imaginary unit.
pub const I: C = C::new(0.0, 1.0);

/// Complex number as the type of core.
pub fn to(z: C) -> Complex<f64> {
    Complex::new(z.re, z.im)
}

/// Complex number from the type of core.
pub fn from(z: Complex<f64>) -> C {
    C::new(z.re, z.im)
}
