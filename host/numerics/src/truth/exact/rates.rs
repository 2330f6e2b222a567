//! Rate Φ' at a time by central differences of Φ, without a formula of the rates.

use super::{Exact, PreciseOrientation};
use crate::motion::ephemeris::RateSample;
use crate::truth::precise::{Precise, precise, product, to_f64};

/// Half the time between the two orientations, as a share of the unit of time. The relative error of the rates, its square times a third
/// derivative, is below 1e-20, and as many digits of the difference remain.
const SHARE: f64 = 1.0 / (1_u64 << 60) as f64;

/// Greatest angle in the unit of time, rad.
const GREATEST_TURN: f64 = 1e8;

impl Exact {
    /// Rates at a time after the start, which is taken as exact.
    ///
    /// * `unit`: a time, such as the period; a shorter one is taken where the body rotates by more than 10^8 rad in it
    #[must_use]
    pub fn rates(&self, t: &Precise, unit: f64) -> RateSample {
        let rates = self.difference(t, unit);
        // if the two orientations are far apart, the difference gives a speed that is too low, but still above this limit
        let shorter = GREATEST_TURN / rates.speed();
        if shorter < 0.5 * unit { self.rates(t, shorter) } else { rates }
    }

    /// Quotient of the difference of two orientations by their distance in time.
    fn difference(&self, t: &Precise, unit: f64) -> RateSample {
        let step = precise(unit) * precise(SHARE);
        let (before, after) = (self.at(&(t - &step)), self.at(&(t + &step)));
        let double_step = step << 1;
        let rate = |x: &[Precise; 2], y: &[Precise; 2]| [0, 1].map(|i| (&y[i] - &x[i]) / &double_step);
        let rates = [rate(&before.alpha, &after.alpha), rate(&before.beta, &after.beta)];
        // the mean of both orientations is Φ to second order in the step, which saves a third evaluation
        let mean = |x: &[Precise; 2], y: &[Precise; 2]| [0, 1].map(|i| (&x[i] + &y[i]) >> 1);
        let phi = PreciseOrientation {
            alpha: mean(&before.alpha, &after.alpha),
            beta: mean(&before.beta, &after.beta),
        };
        of_rates(&phi, &rates)
    }
}

/// Rates ω = Φ'Φ⁻¹ and Ω = Φ⁻¹Φ', whose components are twice the parts of the diagonal and of the upper entry of the matrix, and
/// u' = 2 Re(ᾱα' - β̄β').
fn of_rates(phi: &PreciseOrientation, [alpha_rate, beta_rate]: &[[Precise; 2]; 2]) -> RateSample {
    let PreciseOrientation { alpha, beta } = phi;
    let conj = |[re, im]: &[Precise; 2]| [re.clone(), -im];
    let twice = |x: Precise| 2.0 * to_f64(&x);
    let [stretched, turned] = product(&conj(alpha), alpha_rate);
    let [beta_stretched, beta_turned] = product(&conj(beta), beta_rate);
    let difference = |x: [Precise; 2], y: [Precise; 2]| [&x[0] - &y[0], &x[1] - &y[1]];
    let [fixed_re, fixed_im] = difference(product(beta_rate, alpha), product(alpha_rate, beta));
    let [body_re, body_im] = difference(product(&conj(alpha), beta_rate), product(beta, &conj(alpha_rate)));
    RateSample {
        omega: [twice(fixed_im), -twice(fixed_re), twice(&turned + &beta_turned)],
        omega_body: [twice(body_im), -twice(body_re), twice(turned - beta_turned)],
        udot: twice(stretched - beta_stretched),
    }
}
