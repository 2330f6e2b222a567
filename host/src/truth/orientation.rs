//! Orientation in numbers of 192 bits.

use super::precise::{ComplexPrecise, Precise, precise, to_f64};
use toytop::{Complex, Orientation};

/// Orientation: α and β, each as its real and imaginary part.
pub struct PreciseOrientation {
    /// Cayley-Klein parameter α.
    pub alpha: ComplexPrecise,
    /// Cayley-Klein parameter β.
    pub beta: ComplexPrecise,
}

impl PreciseOrientation {
    /// Cosine of the tilt.
    pub(super) fn u(&self) -> Precise {
        let norm = |z: &ComplexPrecise| z[0].sqr() + z[1].sqr();
        norm(&self.alpha) - norm(&self.beta)
    }

    /// Distance 2 √(|Δα|² + |Δβ|²) from an orientation whose numbers are taken as exact, rad.
    pub fn distance(&self, found: &Orientation<f64>) -> f64 {
        let Orientation { alpha, beta } = found;
        // for a number that is not finite, the distance is the greatest one
        if ![alpha.re, alpha.im, beta.re, beta.im].iter().all(|x| x.is_finite()) {
            return f64::INFINITY;
        }
        let lift = |z: &Complex<f64>| [precise(z.re), precise(z.im)];
        self.apart(&Self { alpha: lift(alpha), beta: lift(beta) })
    }

    /// Distance 2 √(|Δα|² + |Δβ|²) of two orientations, rad.
    pub fn apart(&self, other: &Self) -> f64 {
        let pairs = [(&self.alpha, &other.alpha), (&self.beta, &other.beta)];
        let squares = pairs.map(|(x, y)| to_f64(&(&x[0] - &y[0])).powi(2) + to_f64(&(&x[1] - &y[1])).powi(2));
        2.0 * (squares[0] + squares[1]).sqrt()
    }

    /// Orientation rounded to `f64`.
    pub fn to_f64(&self) -> Orientation<f64> {
        let narrow = |[re, im]: &ComplexPrecise| Complex::new(to_f64(re), to_f64(im));
        Orientation { alpha: narrow(&self.alpha), beta: narrow(&self.beta) }
    }
}
