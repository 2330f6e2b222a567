//! Carlson's symmetric integral of the first kind, and the arithmetic-geometric mean.

use crate::elliptic::elementary::half_pi;
use toytop::scalar::Float;

/// Carlson's R_F(x, y, z) = ½ ∫₀^∞ dt / √((t + x)(t + y)(t + z)), for x, y, z >= 0 of which at most one is 0; other arguments
/// give an undefined number.
///
/// Every elliptic integral of the first kind can be expressed by it. Relative error: a few roundings of the number
/// type, also in extended precision. Cost: about 15 iterations of three square roots.
///
/// ```
/// let k: f64 = toytop_closed_forms::elliptic::carlson_rf(0.0, 0.5, 1.0); // K at m = 1/2
/// assert!((k - 1.854_074_677_301_372).abs() < 1e-15);
/// ```
#[must_use]
pub fn carlson_rf<F: Float>(x: F, y: F, z: F) -> F {
    const MAX_STEPS: usize = 64;
    /// Relative distance of the arguments at which the series is used; its error is of the sixth order in this
    /// distance.
    const CLOSE: f64 = 4e-6;
    let number = F::from_f64;
    let [mut x, mut y, mut z] = [x, y, z];
    for _ in 0..MAX_STEPS {
        let mean = (x + y + z) / number(3.0);
        let [from_x, from_y] = [(mean - x) / mean, (mean - y) / mean];
        let from_z = -(from_x + from_y);
        if [from_x, from_y, from_z].into_iter().all(|from| from.abs() < number(CLOSE)) {
            // elementary symmetric functions of the three distances, and the Taylor series to the fifth order
            let second = from_x * from_y - from_z * from_z;
            let third = from_x * from_y * from_z;
            let low = third / number(14.0) - second / number(10.0);
            let high = second * second / number(24.0) - number(3.0) / number(44.0) * second * third;
            return (F::ONE + low + high) / mean.sqrt();
        }
        let [root_x, root_y, root_z] = [x, y, z].map(Float::sqrt);
        let shift = root_x * root_y + root_x * root_z + root_y * root_z;
        [x, y, z] = [x, y, z].map(|term| (term + shift) * number(0.25));
    }
    number(f64::NAN)
}

/// Elliptic integral ∫ dt / √(f₁ f₂ f₃) over an interval of this length, from the values of the three linear factors
/// at both ends (all >= 0). Carlson's formula has no cancellation, even if the ends are close to each other or to a
/// zero of a factor.
pub(crate) fn first_kind<F: Float>(length: F, upper: [F; 3], lower: [F; 3]) -> F {
    if length == F::ZERO { F::ZERO } else { length.doubled() * first_kind_per_length(upper, lower) }
}

/// Half of the integral of [`first_kind`], divided by the length of the interval; finite for an interval of length 0
/// that is not at a zero.
pub(crate) fn first_kind_per_length<F: Float>(upper: [F; 3], lower: [F; 3]) -> F {
    let [x1, x2, x3] = upper.map(Float::sqrt);
    let [y1, y2, y3] = lower.map(Float::sqrt);
    let [u, v, w] = [x1 * x2 * y3 + y1 * y2 * x3, x1 * x3 * y2 + y1 * y3 * x2, x2 * x3 * y1 + y2 * y3 * x1];
    carlson_rf(u * u, v * v, w * w)
}

/// Arithmetic-geometric mean of x and y: the common limit of their arithmetic and geometric means, for x, y > 0; 0
/// where one of them is 0.
///
/// Relative error: a few roundings of the number type, also in extended precision. Cost: one value of [`carlson_rf`].
///
/// ```
/// let quarter_period = core::f64::consts::FRAC_PI_2 / toytop_closed_forms::elliptic::agm(1.0, 0.5_f64.sqrt()); // K at m = 1/2
/// assert!((quarter_period - 1.854_074_677_301_372).abs() < 1e-15);
/// ```
#[must_use]
pub fn agm<F: Float>(x: F, y: F) -> F {
    if x <= F::ZERO || y <= F::ZERO {
        return F::ZERO;
    }
    // R_F(0, x², y²) = π/2 / agm(x, y); x² and y² could overflow, but not the quotients of the means after one step
    let [arithmetic, geometric] = [(x + y).halved(), x.sqrt() * y.sqrt()];
    let of_means = carlson_rf(F::ZERO, arithmetic / geometric, geometric / arithmetic);
    arithmetic.sqrt() * geometric.sqrt() * F::from_extended(half_pi()) / of_means
}

#[cfg(test)]
mod tests {
    use super::*;
    use toytop::scalar::{Extended, Ring};

    #[test]
    fn the_mean_in_extended() {
        // Gauss's constant: agm(1, √2) = 1.19814023473559220743992249228...
        let root = Extended::from(2.0).sqrt();
        let mean = agm(Extended::ONE, root);
        let truth = Extended::from_f64_pair([1.1981402347355923, -7.250663635457894e-17]);
        assert!((mean - truth).abs().to_f64() < 1e-30, "{:e}", (mean - truth).to_f64());
        assert_eq!(agm(0.0, 1.0), 0.0);
        assert!((agm(1e200, 1e-200) / agm(1e-200, 1e200) - 1.0).abs() < 1e-15);
        // π/2 / ln(4x/y) for x far above y
        let far_apart =
            1e200 * core::f64::consts::FRAC_PI_2 / (4_f64.ln() + 400.0 * core::f64::consts::LN_10);
        assert!((agm(1e200, 1e-200) / far_apart - 1.0).abs() < 1e-15);
    }

    #[test]
    fn an_interval_is_the_sum_of_its_parts() {
        // The integral of 1/√(t (1 - t)(2 - t)): from 0.2 to 0.2 + 1e-12 it is compared with the integrand, and from
        // 0 to 1 with the sum of two parts.
        let factors = |t: f64| [t, 1.0 - t, 2.0 - t];
        let whole = first_kind(1.0, factors(1.0), factors(0.0));
        let parts =
            first_kind(0.25, factors(0.25), factors(0.0)) + first_kind(0.75, factors(1.0), factors(0.25));
        assert!((whole - parts).abs() < 1e-15 && (whole - 2.622_057_554_292_119).abs() < 1e-15);
        let short = first_kind(1e-12, factors(0.2 + 1e-12), factors(0.2));
        assert!((short / 1e-12 * (0.2 * 0.8 * 1.8_f64).sqrt() - 1.0).abs() < 1e-11);
    }
}
