//! Numbers of 640 bits, and orientations in them. Their arithmetic is independent of core.

use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;
use toytop::{Complex, Orientation};

/// Number of 640 bits. Only [`from_f64`] and [`from_i64`] make one; other constructors give fewer bits.
pub type Float640 = FBig<HalfEven>;

/// Complex number, as its real and imaginary part.
pub type Complex640 = [Float640; 2];

/// Number of bits of a [`Float640`]: 192 digits. A double root of a cubic has half of them.
const BITS: usize = 640;

/// Number that equals a finite `f64`; 0 for any other, which every constructor of core refuses.
pub fn from_f64(x: f64) -> Float640 {
    Float640::try_from(x).unwrap_or(Float640::ZERO).with_precision(BITS).value()
}

/// Number that equals an integer.
pub fn from_i64(n: i64) -> Float640 {
    Float640::from(n).with_precision(BITS).value()
}

/// Nearest `f64`.
pub fn to_f64(x: &Float640) -> f64 {
    x.to_f64().value()
}

/// Decimal number with this many significant digits, rounded to nearest.
pub fn decimal(x: &Float640, digits: usize) -> String {
    format!("{:e}", x.clone().with_base_and_precision::<10>(digits).value())
}

/// Nearest integer; `None` beyond 64 bits.
pub fn to_i64(x: &Float640) -> Option<i64> {
    i64::try_from(x.round().to_int().value()).ok()
}

/// Square root of a number that is not negative; 0 for a negative one.
pub fn square_root(x: &Float640) -> Float640 {
    if *x > Float640::ZERO { x.sqrt() } else { from_i64(0) }
}

/// Whether x is exactly 0.
pub fn is_zero(x: &Float640) -> bool {
    *x == Float640::ZERO
}

/// Number e^{ix}.
pub fn cis(x: &Float640) -> Complex640 {
    let (sine, cosine) = x.sin_cos();
    [cosine, sine]
}

/// Product of two complex numbers.
pub fn product(a: &Complex640, b: &Complex640) -> Complex640 {
    [&a[0] * &b[0] - &a[1] * &b[1], &a[0] * &b[1] + &a[1] * &b[0]]
}

/// Conjugate of a complex number.
pub fn conjugate([re, im]: &Complex640) -> Complex640 {
    [re.clone(), -im]
}

/// Square of the absolute value of a complex number.
pub fn norm_squared([re, im]: &Complex640) -> Float640 {
    re.sqr() + im.sqr()
}

/// Orientation: α and β, each as its real and imaginary part.
pub struct Orientation640 {
    /// Cayley-Klein parameter α.
    pub alpha: Complex640,
    /// Cayley-Klein parameter β.
    pub beta: Complex640,
}

impl Orientation640 {
    /// Cosine of the tilt.
    pub(super) fn u(&self) -> Float640 {
        norm_squared(&self.alpha) - norm_squared(&self.beta)
    }

    /// Inverse Φ⁻¹.
    pub(super) fn inverse(&self) -> Self {
        Self { alpha: conjugate(&self.alpha), beta: self.beta.each_ref().map(|part| -part) }
    }

    /// Half of the rotation vector of Φ Φ₀⁻¹, for a small rotation.
    pub(super) fn half_rotation_from(&self, Self { alpha, beta }: &Self) -> [Float640; 3] {
        let ([a1, a2], [b1, b2]) = (product(&self.beta, alpha), product(&self.alpha, beta));
        let axial = [(&self.alpha, alpha), (&self.beta, beta)]
            .map(|(to, from)| &to[1] * &from[0] - &to[0] * &from[1]);
        let [c1, c2] = axial;
        [a2 - b2, b1 - a1, c1 + c2]
    }

    /// Error 2 √(|Δα|² + |Δβ|²) of an orientation in `f64`, rad; infinite if it is not finite.
    pub fn error_of(&self, found: &Orientation<f64>) -> f64 {
        let Orientation { alpha, beta } = found;
        if ![alpha.re, alpha.im, beta.re, beta.im].iter().all(|x| x.is_finite()) {
            return f64::INFINITY;
        }
        let lift = |z: &Complex<f64>| [from_f64(z.re), from_f64(z.im)];
        self.distance(&Self { alpha: lift(alpha), beta: lift(beta) })
    }

    /// Distance 2 √(|Δα|² + |Δβ|²) of two orientations, rad.
    pub fn distance(&self, other: &Self) -> f64 {
        let pairs = [(&self.alpha, &other.alpha), (&self.beta, &other.beta)];
        let squares = pairs.map(|(x, y)| to_f64(&norm_squared(&[&x[0] - &y[0], &x[1] - &y[1]])));
        2.0 * (squares[0] + squares[1]).sqrt()
    }

    /// Orientation rounded to `f64`.
    pub fn to_f64(&self) -> Orientation<f64> {
        let narrow = |[re, im]: &Complex640| Complex::new(to_f64(re), to_f64(im));
        Orientation { alpha: narrow(&self.alpha), beta: narrow(&self.beta) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sines_of_large_arguments_keep_their_digits() {
        // e^{ix} of x = 2^64 and of its half: one is the square of the other
        let x = from_f64(64_f64.exp2());
        let half = cis(&from_f64(63_f64.exp2()));
        let off: f64 = product(&half, &half).iter().zip(cis(&x)).map(|(a, b)| to_f64(&(a - b)).abs()).sum();
        assert!(off < 1e-55, "{off:e}");
        // sin 1 to 32 digits
        let sine = from_f64(0.841_470_984_807_896_5) + from_f64(1.776_845_092_935_536e-18);
        assert!(to_f64(&(&cis(&from_f64(1.0))[1] - sine)).abs() < 1e-32);
        assert_eq!(cis(&from_f64(0.0)).map(|x| to_f64(&x)), [1.0, 0.0]);
    }

    #[test]
    fn integers() {
        assert_eq!(to_i64(&(from_i64(i64::MAX) - from_f64(0.25))), Some(i64::MAX));
        assert_eq!(to_i64(&(from_i64(i64::MAX) + from_f64(1.0))), None);
    }
}
