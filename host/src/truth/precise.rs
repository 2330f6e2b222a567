//! Arithmetic of the truth, in numbers of 192 bits, independent of core.

use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;

/// Number of 192 bits, if it comes from [`precise`] or [`whole`] or is computed from such numbers.
pub type Precise = FBig<HalfEven>;

/// Complex number, as its real and imaginary part.
pub type ComplexPrecise = [Precise; 2];

/// Number of bits of a [`Precise`], 57 digits. An argument of 2^62 turns has 38 digits after the point.
pub const BITS: usize = 192;

/// Number that equals a finite `f64`; 0 for any other, which every constructor of core refuses.
pub fn precise(x: f64) -> Precise {
    rounded(&Precise::try_from(x).unwrap_or(Precise::ZERO))
}

/// Number that equals an integer.
pub fn whole(n: i64) -> Precise {
    rounded(&Precise::from(n))
}

/// Number of any precision, rounded to [`BITS`].
pub fn rounded(x: &Precise) -> Precise {
    x.clone().with_precision(BITS).value()
}

/// Nearest `f64`.
pub fn to_f64(x: &Precise) -> f64 {
    x.to_f64().value()
}

/// Decimal number with this many significant digits, rounded to nearest.
pub fn decimal(x: &Precise, digits: usize) -> String {
    format!("{:e}", x.clone().with_base_and_precision::<10>(digits).value())
}

/// Nearest integer; `None` beyond 64 bits.
pub fn to_nearest(x: &Precise) -> Option<i64> {
    i64::try_from(x.round().to_int().value()).ok()
}

/// Greatest integer that is at most x; `None` beyond 64 bits.
pub fn to_floor(x: &Precise) -> Option<i64> {
    i64::try_from(x.floor().to_int().value()).ok()
}

/// Square root of a number that is not negative; 0 for a negative one.
pub fn root(x: &Precise) -> Precise {
    if *x > Precise::ZERO { x.sqrt() } else { precise(0.0) }
}

/// Whether x is exactly 0.
pub fn is_zero(x: &Precise) -> bool {
    *x == Precise::ZERO
}

/// Number e^{ix}, by dashu's correctly rounded sine and cosine.
pub fn cis(x: &Precise) -> ComplexPrecise {
    let (sine, cosine) = x.sin_cos();
    [cosine, sine]
}

/// Product of two complex numbers.
pub fn product(a: &ComplexPrecise, b: &ComplexPrecise) -> ComplexPrecise {
    [&a[0] * &b[0] - &a[1] * &b[1], &a[0] * &b[1] + &a[1] * &b[0]]
}

/// Conjugate of a complex number.
pub fn conjugate([re, im]: &ComplexPrecise) -> ComplexPrecise {
    [re.clone(), -im]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sines_of_large_arguments_keep_their_digits() {
        // e^{ix} of x = 2^64 and of its half: one is the square of the other
        let x = precise(64_f64.exp2());
        let half = cis(&precise(63_f64.exp2()));
        let off: f64 = product(&half, &half).iter().zip(cis(&x)).map(|(a, b)| to_f64(&(a - b)).abs()).sum();
        assert!(off < 1e-55, "{off:e}");
        // sin 1 to 32 digits
        let sine = precise(0.841_470_984_807_896_5) + precise(1.776_845_092_935_536e-18);
        assert!(to_f64(&(&cis(&precise(1.0))[1] - sine)).abs() < 1e-32);
        assert_eq!(cis(&precise(0.0)).map(|x| to_f64(&x)), [1.0, 0.0]);
    }

    #[test]
    fn integers() {
        assert_eq!(to_floor(&precise(-0.5)), Some(-1));
        assert_eq!(to_nearest(&(whole(i64::MAX) - precise(0.25))), Some(i64::MAX));
        assert_eq!(to_nearest(&(whole(i64::MAX) + precise(1.0))), None);
    }
}
