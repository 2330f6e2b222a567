//! Gudermannian function, by which the half phase of an aperiodic motion is χ = gd v.

use crate::complex::Complex;
use crate::scalar::Real;

/// Unit complex number e^{iχ} = sech v + i tanh v, for χ the Gudermannian of v.
pub(crate) fn gudermannian<R: Real>(v: R) -> Complex<R> {
    // q = e^-|v| and 1 - q from one function, which saves flash
    let growth = v.abs().exp_minus_one();
    let q = R::ONE / (R::ONE + growth);
    let one_minus_q = if q > R::ZERO { growth * q } else { R::ONE };
    let per_sum = R::ONE / (R::ONE + q.squared());
    let tanh = one_minus_q * (R::ONE + q) * per_sum;
    Complex::new(q.doubled() * per_sum, if v < R::ZERO { -tanh } else { tanh })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_gudermannian_keeps_its_digits_at_both_ends() {
        for v in [1e-20, 3e-9, 0.1, 2.0, 30.0, 700.0_f64] {
            let cis_chi = gudermannian(v);
            let Complex { re: sech, im: tanh } = cis_chi;
            assert!((tanh / libm::tanh(v) - 1.0).abs() < 5e-16, "{v}: {tanh:e}");
            assert!((sech * libm::cosh(v) - 1.0).abs() < 5e-16, "{v}: {sech:e}");
            assert_eq!(gudermannian(-v), cis_chi.conj());
            let inverse = libm::asinh(tanh / sech);
            assert!((inverse / v - 1.0).abs() < 5e-16, "{v}: {inverse:e}");
        }
    }
}
