//! Complex numbers of any scalar as `f64`.

use toytop::Complex;

/// Complex number in `f64`, each part by `to_f64`.
pub fn complex<R>(z: Complex<R>, to_f64: impl Fn(R) -> f64) -> Complex<f64> {
    Complex { re: to_f64(z.re), im: to_f64(z.im) }
}
