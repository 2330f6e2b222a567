//! Sine and cosine in double-double.

use toytop::Complex;
use toytop::real::{DoubleDouble, Float, Ring};

/// π/2 to 32 digits.
#[must_use]
pub fn quarter_turn() -> DoubleDouble {
    DoubleDouble::new(std::f64::consts::FRAC_PI_2, 6.123_233_995_736_766e-17)
}

/// Terms of each series: the first left out is below 1e-33 up to π/4.
const TERMS: u32 = 14;

/// e^{ix}, to some 1e-31 and 1e-32 |x|.
#[must_use]
pub fn cis(x: DoubleDouble) -> Complex<DoubleDouble> {
    let quarters = (x / quarter_turn()).to_f64().round();
    let rest = x - quarter_turn() * quarters.into();
    let square = -rest.squared();
    // both series from their last term: 1 - x²/(k (k-1)) (1 - ...)
    let series = |odd: u32| {
        (1..=TERMS).rev().fold(DoubleDouble::ONE, |sum, term| {
            let k = f64::from(2 * term + odd);
            DoubleDouble::ONE + square * sum / (k * (k - 1.0)).into()
        })
    };
    let (sine, cosine) = (rest * series(1), series(0));
    match quarters.rem_euclid(4.0) as u32 {
        0 => Complex::new(cosine, sine),
        1 => Complex::new(-sine, cosine),
        2 => Complex::new(-cosine, -sine),
        _ => Complex::new(sine, -cosine),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_values_and_the_sum_rule() {
        // sin 1, cos 1 to 32 digits
        let one = cis(DoubleDouble::ONE);
        let sine = DoubleDouble::new(0.841_470_984_807_896_5, 1.776_845_092_935_536e-18);
        assert!((one.im - sine).to_f64().abs() < 1e-30, "{:?}", one.im);
        for x in [-1e4, -3.3, 0.0, 1e-9, 0.7, 0.8, 2.0, 100.0, 12345.678] {
            let (a, b) = (cis(x.into()), cis(DoubleDouble::from(x) + 0.3.into()));
            let c = a * cis(0.3.into()) - b;
            assert!(c.norm_squared().to_f64() < 1e-54, "{x}");
            assert!((a.norm_squared() - DoubleDouble::ONE).to_f64().abs() < 1e-30);
            assert!((a.re.to_f64() - x.cos()).abs() < 2e-16 && (a.im.to_f64() - x.sin()).abs() < 2e-16);
        }
    }
}
