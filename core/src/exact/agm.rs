//! The arithmetic-geometric mean, and Carlson's symmetric integral of the first kind.

use crate::real::Float;

/// The common limit of the arithmetic and the geometric means of x and y, both > 0; 0 where one of them is.
///
/// Error: a few roundings of the type, relative; double-double included. Quadratic convergence: seven steps at
/// y/x = 1e-16, eleven at 1e-300.
///
/// ```
/// let quarter_period = core::f64::consts::FRAC_PI_2 / toytop::exact::agm(1.0, 0.5_f64.sqrt()); // K at m = 1/2
/// assert!((quarter_period - 1.854_074_677_301_372).abs() < 1e-15);
/// ```
#[must_use]
pub fn agm<F: Float>(x: F, y: F) -> F {
    const MOST_STEPS: usize = 24;
    if x <= F::ZERO || y <= F::ZERO {
        return F::ZERO;
    }
    let (mut arithmetic, mut geometric) = (x, y);
    for _ in 0..MOST_STEPS {
        let gap = (arithmetic - geometric).abs();
        // √(xy) as a product of roots: the product itself could leave the range
        let root = arithmetic.sqrt() * geometric.sqrt();
        (arithmetic, geometric) = ((arithmetic + geometric).halved(), root);
        // what is left is a quarter of the square of the relative gap
        if gap <= arithmetic * F::from_f64(1e-17) {
            break;
        }
    }
    arithmetic
}

/// Carlson's R_F(x, y, z) = ½ ∫₀^∞ dt / √((t + x)(t + y)(t + z)), all three >= 0 and at most one of them 0.
///
/// Every elliptic integral of the first kind is one of these. Error: below 1e-15 relative. Cost: some 10 rounds of three
/// square roots.
///
/// ```
/// let k = toytop::exact::carlson_rf(0.0, 0.5, 1.0); // K at m = 1/2
/// assert!((k - 1.854_074_677_301_372).abs() < 1e-15);
/// ```
#[must_use]
pub fn carlson_rf(x: f64, y: f64, z: f64) -> f64 {
    const MOST_STEPS: usize = 40;
    const CLOSE: f64 = 2e-3;
    let [mut x, mut y, mut z] = [x, y, z];
    for _ in 0..MOST_STEPS {
        let mean = (x + y + z) / 3.0;
        let [from_x, from_y] = [(mean - x) / mean, (mean - y) / mean];
        let from_z = -(from_x + from_y);
        if Float::abs(from_x).max(Float::abs(from_y)).max(Float::abs(from_z)) < CLOSE {
            // the elementary symmetric functions of the three, and the Taylor series to the fifth order
            let second = from_x * from_y - from_z * from_z;
            let third = from_x * from_y * from_z;
            let series =
                1.0 - second / 10.0 + third / 14.0 + second * second / 24.0 - 3.0 / 44.0 * second * third;
            return series / Float::sqrt(mean);
        }
        let [root_x, root_y, root_z] = [x, y, z].map(Float::sqrt);
        let shift = root_x * root_y + root_x * root_z + root_y * root_z;
        [x, y, z] = [x, y, z].map(|term| 0.25 * (term + shift));
    }
    f64::NAN
}

/// ∫ dt / √(f₁ f₂ f₃) over an interval of this length, from the values of the three linear factors at its two ends (all
/// >= 0): Carlson's form, which has no cancellation however close the ends are to each other or to a zero.
pub(super) fn first_kind(length: f64, upper: [f64; 3], lower: [f64; 3]) -> f64 {
    if length == 0.0 { 0.0 } else { 2.0 * length * first_kind_per_length(upper, lower) }
}

/// Half the integral over its length; finite where the ends coincide, away from a zero.
pub(super) fn first_kind_per_length(upper: [f64; 3], lower: [f64; 3]) -> f64 {
    let [x1, x2, x3] = upper.map(Float::sqrt);
    let [y1, y2, y3] = lower.map(Float::sqrt);
    let [u, v, w] = [x1 * x2 * y3 + y1 * y2 * x3, x1 * x3 * y2 + y1 * y3 * x2, x2 * x3 * y1 + y2 * y3 * x1];
    carlson_rf(u * u, v * v, w * w)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::real::{DoubleDouble, Ring};

    #[test]
    fn the_mean_in_double_double() {
        // Gauss's constant: agm(1, √2) = 1.19814023473559220743992249228...
        let root = DoubleDouble::from(2.0).sqrt();
        let mean = agm(DoubleDouble::ONE, root);
        let truth = DoubleDouble::new(1.1981402347355923, -7.250663635457894e-17);
        assert!((mean - truth).abs().to_f64() < 1e-30, "{:e}", (mean - truth).to_f64());
        assert_eq!(agm(0.0, 1.0), 0.0);
        assert!((agm(1e200, 1e-200) / agm(1e-200, 1e200) - 1.0).abs() < 1e-15);
    }

    #[test]
    fn an_interval_is_the_sum_of_its_parts() {
        // t (1 - t)(2 - t) from 0.2 to 0.2 + 1e-12 against the integrand, and 0 to 1 in two parts
        let factors = |t: f64| [t, 1.0 - t, 2.0 - t];
        let whole = first_kind(1.0, factors(1.0), factors(0.0));
        let parts =
            first_kind(0.25, factors(0.25), factors(0.0)) + first_kind(0.75, factors(1.0), factors(0.25));
        assert!((whole - parts).abs() < 1e-15 && (whole - 2.622_057_554_292_119).abs() < 1e-15);
        let short = first_kind(1e-12, factors(0.2 + 1e-12), factors(0.2));
        assert!((short / 1e-12 * (0.2 * 0.8 * 1.8_f64).sqrt() - 1.0).abs() < 1e-11);
    }
}
