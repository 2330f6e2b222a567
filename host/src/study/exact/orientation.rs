//! Φ at a place.

use super::{Dd, Exact, Point};
use crate::study::trigonometry::cis;
use toytop::real::{Float, Ring};
use toytop::{Complex, Phi};

impl Exact<'_> {
    /// Φ at a time so close to the point that what is between is linear.
    #[must_use]
    pub fn phi(&self, point: &Point, t: f64) -> Phi<Dd> {
        let ahead = Dd::from(t) - point.t;
        let Complex { re: cosine, im: sine } = cis(point.chi);
        let [one_plus_u, one_minus_u, slowness] = self.law(point.chi);
        let chi_step = ahead / slowness;
        let rise = self.e2_minus_e1 * sine * cosine * chi_step; // half of what u rises
        let place = |complement: Dd, rise: Dd, turned: Dd, momentum: Dd, drift: Dd| {
            let modulus = complement.halved().sqrt();
            // where it vanishes so does its momentum, and the other parameter's change is all there is
            let (grown, turning) = if complement > Dd::ZERO {
                (modulus + modulus * rise / complement, momentum / complement)
            } else {
                (modulus, Dd::ZERO)
            };
            cis(turned + turning * ahead + drift * Dd::from(t)).scaled(grown)
        };
        let ([alpha, beta], [alpha_turned, beta_turned]) = (self.momenta, point.turned);
        let [alpha_from, beta_from] = self.directions;
        let alpha = alpha_from * place(one_plus_u, rise, alpha_turned, alpha, self.half_tau);
        let beta = beta_from * place(one_minus_u, -rise, beta_turned, beta, -self.half_tau);
        let [alpha_sign, beta_sign] = self.signs(sine, cosine);
        Phi { alpha: alpha.scaled(alpha_sign), beta: beta.scaled(beta_sign) }
    }

    /// -1 for a parameter that has passed through 0 an odd number of times.
    fn signs(&self, sine: Dd, cosine: Dd) -> [Dd; 2] {
        let sign = |x: Dd| Dd::from(if x < Dd::ZERO { -1.0 } else { 1.0 });
        let from = cis(self.start().chi);
        let small = |x: Dd| x.abs() < Dd::from(1e-15);
        // a parameter that is 0 at the start has its direction from its derivative
        let alpha = if small(from.im) { from.re } else { from.im };
        let beta = if small(from.re) { -from.im } else { from.re };
        let passes = |passes: bool, now: Dd, then: Dd| if passes { sign(now) * sign(then) } else { Dd::ONE };
        [
            passes(self.one_plus_e1 == Dd::ZERO, sine, alpha),
            passes(self.one_minus_e2 == Dd::ZERO, cosine, beta),
        ]
    }

    /// Φ of a motion in which u is constant.
    #[must_use]
    pub fn steady_phi(&self, t: f64, one_plus_u: Dd, one_minus_u: Dd) -> Phi<Dd> {
        let place = |complement: Dd, momentum: Dd, drift: Dd| {
            if complement == Dd::ZERO {
                return Complex::ZERO;
            }
            cis((momentum / complement + drift) * Dd::from(t)).scaled(complement.halved().sqrt())
        };
        let ([alpha, beta], [alpha_from, beta_from]) = (self.momenta, self.directions);
        Phi {
            alpha: alpha_from * place(one_plus_u, alpha, self.half_tau),
            beta: beta_from * place(one_minus_u, beta, -self.half_tau),
        }
    }

    /// 1 + u and 1 - u of a motion in which u is e₂.
    #[must_use]
    pub fn at_e2(&self) -> [Dd; 2] {
        [self.one_plus_e1 + self.e2_minus_e1, self.one_minus_e2]
    }
}
