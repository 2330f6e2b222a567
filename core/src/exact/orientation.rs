//! How a closed form is fitted to a motion: what it says of α and β holds up to their arguments at t = 0.

use super::elementary::direction;
use super::sigma_quotient::Germ;
use crate::complex::Complex;
use crate::launch::Motion;
use crate::su2::{Phi, PhiRate};
use crate::tick::{Pose, Stepper};
use crate::turns::{Rate, Turns};

/// The constant arguments of α and β, and the drift ±τ/2 of a top with A ≠ C.
///
/// Φ(t) = diag(e^{ia}, e^{ib}) Φ_closed(t) diag(e^{iτt/2}, e^{-iτt/2}) in effect, with Φ_closed that of a spherical top.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Fit {
    alpha: Complex<f64>,
    beta: Complex<f64>,
    drift: Rate,
    half_tau: f64,
}

impl Fit {
    /// Before the arguments are known.
    pub(super) fn none(motion: &Motion) -> Self {
        let (drift, half_tau) = motion.drift();
        Self { alpha: Complex::ONE, beta: Complex::ONE, drift, half_tau }
    }

    /// From the closed form's α and β at t = 0 (and their rates by time), without drift.
    ///
    /// Value and rate are weighed together: a parameter that is 0 at t = 0 is placed by how it leaves.
    pub(super) fn new(motion: &Motion, alpha: Germ, beta: Germ) -> Self {
        let Pose { phi, rate } = Stepper::<f64>::new(motion).pose();
        let unfitted = Self::none(motion);
        let half_tau = unfitted.half_tau;
        let (top, rest) = (motion.top(), |z: Complex<f64>, tau: f64| z.times_i().scaled(tau));
        let time_squared = top.a() / (top.p() * top.g());
        let unit = |truth: [Complex<f64>; 2], closed: Germ| {
            let [value, slope] = truth;
            direction(value * closed.value.conj() + (slope * closed.slope.conj()).scaled(time_squared))
        };
        Self {
            alpha: unit([phi.alpha, rate.alpha - rest(phi.alpha, half_tau)], alpha),
            beta: unit([phi.beta, rate.beta + rest(phi.beta, half_tau)], beta),
            ..unfitted
        }
    }

    /// The pose at t, from α and β there (and their rates by time) and what whole periods have turned them besides.
    pub(super) fn pose(
        &self,
        t: f64,
        [alpha, beta]: [Germ; 2],
        [alpha_turns, beta_turns]: [Turns; 2],
    ) -> Pose<f64> {
        let drift = self.drift.over(t);
        let placed = |germ: Germ, unit: Complex<f64>, turns: Turns, tau: f64| {
            let factor = unit * Complex::cis(turns);
            let value = germ.value * factor;
            (value, germ.slope * factor + value.times_i().scaled(tau))
        };
        let alpha = placed(alpha, self.alpha, alpha_turns + drift, self.half_tau);
        let beta = placed(beta, self.beta, beta_turns - drift, -self.half_tau);
        Pose { phi: Phi { alpha: alpha.0, beta: beta.0 }, rate: PhiRate { alpha: alpha.1, beta: beta.1 } }
    }
}
