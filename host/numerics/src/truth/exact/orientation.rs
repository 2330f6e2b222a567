//! Orientation Φ at a time.

use super::{Exact, Place};
use crate::truth::law::End;
use crate::truth::precise::{Precise, cis, is_zero, precise, product, root, to_f64};
use toytop::{Complex, Orientation};

/// Orientation: α and β, each as its real and imaginary part.
#[derive(Clone, Debug)]
pub struct PreciseOrientation {
    /// Cayley-Klein parameter α.
    pub alpha: [Precise; 2],
    /// Cayley-Klein parameter β.
    pub beta: [Precise; 2],
}

impl PreciseOrientation {
    /// Distance 2 √(|Δα|² + |Δβ|²) from an orientation whose numbers are taken as exact, rad.
    #[must_use]
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
    #[must_use]
    pub fn apart(&self, other: &Self) -> f64 {
        let square = |a: &Precise, b: &Precise| to_f64(&(a - b)).powi(2);
        let squares = |a: &[Precise; 2], b: &[Precise; 2]| square(&a[0], &b[0]) + square(&a[1], &b[1]);
        2.0 * (squares(&self.alpha, &other.alpha) + squares(&self.beta, &other.beta)).sqrt()
    }

    /// Orientation rounded to `f64`.
    #[must_use]
    pub fn to_f64(&self) -> Orientation<f64> {
        let narrow = |[re, im]: &[Precise; 2]| Complex::new(to_f64(re), to_f64(im));
        Orientation { alpha: narrow(&self.alpha), beta: narrow(&self.beta) }
    }
}

impl Exact {
    /// Orientation Φ at a time after the start, which is taken as exact.
    #[must_use]
    pub fn at(&self, t: &Precise) -> PreciseOrientation {
        let (complements, turned, signs) = match &self.passage {
            None => {
                // u is e₂, both if u is constant and for the upright top
                let complements = self.law.complements(End::Upper, &precise(0.0));
                let turned = [0, 1].map(|i| match &self.law.momenta[i] {
                    momentum if is_zero(momentum) || is_zero(&complements[i]) => precise(0.0),
                    momentum => momentum / &complements[i] * t,
                });
                (complements, turned, [1.0, 1.0])
            }
            Some(passage) => {
                let (place, [_, alpha, beta]) = passage.at(&self.law, &self.coarse, &(&passage.start[0] + t));
                let complements = self.law.complements(End::of(place.quarter), &place.beyond);
                (complements, [alpha - &passage.start[1], beta - &passage.start[2]], self.passes(&place))
            }
        };
        let [alpha_turned, beta_turned] = turned;
        let drift = &self.half_tau * t;
        let parameter = |i: usize, angle: Precise| {
            let modulus = root(&(complements[i].clone() >> 1)) * precise(signs[i]);
            let direction = product(&self.directions[i], &cis(&angle));
            direction.map(|part| part * &modulus)
        };
        PreciseOrientation {
            alpha: parameter(0, alpha_turned + &drift),
            beta: parameter(1, beta_turned - drift),
        }
    }

    /// Signs of α and β: -1 for a parameter that has passed through 0 an odd number of times since the start, otherwise 1.
    fn passes(&self, now: &Place) -> [f64; 2] {
        let ([sine, cosine], [sine_then, cosine_then]) = (now.signs(), self.start.signs());
        let sign = |x: f64| if x < 0.0 { -1.0 } else { 1.0 };
        // the direction of a parameter that is 0 at the start is that of its derivative
        let alpha = if sine_then == 0.0 { cosine_then } else { sine_then };
        let beta = if cosine_then == 0.0 { -sine_then } else { cosine_then };
        let passes = |passes: bool, now: f64, then: f64| if passes { sign(now) * sign(then) } else { 1.0 };
        [
            passes(is_zero(&self.law.one_plus_e1), sine, alpha),
            passes(is_zero(&self.law.one_minus_e2), cosine, beta),
        ]
    }
}
