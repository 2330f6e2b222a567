//! Complex numbers with all operations, to write the paper's formulas down as they stand.

pub use num_complex::Complex64 as C;
use toytop::Complex;

/// i.
pub const I: C = C::new(0.0, 1.0);

/// As core has it.
pub fn to(z: C) -> Complex<f64> {
    Complex::new(z.re, z.im)
}

/// From core.
pub fn from(z: Complex<f64>) -> C {
    C::new(z.re, z.im)
}
