//! Orientation of a motion from a closed form of α and β, adapted to their arguments at t = 0.

use crate::elliptic::elementary::{Wide, angle, of_turns, real, rounded, tanh_sech};
use crate::elliptic::theta::ValueAndSlope;
use toytop::AttitudeState;
use toytop::Complex;
use toytop::Motion;
use toytop::Phase;
use toytop::internal::{NutationVariable, phase_of};
use toytop::scalar::{Extended, Float, Ring};
use toytop::su2::{Orientation, OrientationRate};

/// Constant arguments of α and β, and the rates ±τ/2 of a top with A ≠ C.
///
/// The orientation is Φ(t) = diag(e^{ia}, e^{ib}) Φ_closed(t) diag(e^{iτt/2}, e^{-iτt/2}), with Φ_closed that of a
/// top with A = C.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ConstantArguments {
    /// Angles a and b.
    pub(super) angles: [Phase; 2],
    half_tau: Extended,
}

impl ConstantArguments {
    /// Arguments from α, β and their time derivatives in the closed form at t = 0, for C = A.
    ///
    /// Value and derivative are averaged with weights, so that the argument is well defined also where a parameter is
    /// 0 at t = 0.
    pub(super) fn new(motion: &Motion, closed: [ValueAndSlope; 2]) -> Self {
        let (e, signs) = (motion.exact_branch_points(), motion.signs());
        let (sine, cosine) = match motion.nutation() {
            NutationVariable::Nutating(chi) => of_turns(chi),
            NutationVariable::Aperiodic(v) => {
                let (tanh, sech, _) = tanh_sech(v.into());
                (tanh, sech)
            }
            NutationVariable::Steady => (Extended::ZERO, Extended::ONE),
        };
        let rates = motion.equations().rates(sine, cosine);
        let root = |x: Extended| x.halved().sqrt();
        let (alpha_root, beta_root) = (root(e.one_plus_e2()), root(e.one_minus_e2));
        let axes = [
            [root(e.one_plus_e1), signs.l_plus_n.times(alpha_root)],
            [root(e.one_minus_e1()), signs.l_minus_n.times(beta_root)],
        ];
        let [alpha_axes, beta_axes] = axes;
        let [alpha, beta] = closed;
        let [alpha_phase, beta_phase] = motion.slow_phases();
        let argument =
            |axes, turning, closed| argument(axes, [sine, cosine], [rates.nutation, turning], closed);
        let angles = [
            alpha_phase + argument(alpha_axes, rates.alpha, alpha),
            beta_phase + argument(beta_axes, rates.beta, beta),
        ];
        Self { angles, half_tau: motion.half_tau() }
    }

    /// Attitude state at t, from α, β and their time derivatives in the closed form, and the rotation of α and β over
    /// the whole periods.
    pub(super) fn attitude_state(
        &self,
        t: f64,
        [alpha, beta]: [ValueAndSlope; 2],
        [alpha_turns, beta_turns]: [Phase; 2],
    ) -> AttitudeState<f64> {
        let half_tau_phase = phase_of(self.half_tau * t.into());
        let half_tau = self.half_tau.to_f64();
        let placed = |closed: ValueAndSlope, turns: Phase, tau: f64| {
            let factor = Complex::cis(turns);
            let value = rounded(closed.value) * factor;
            (value, rounded(closed.slope) * factor + value.times_i().scaled(tau))
        };
        let [a, b] = self.angles;
        let alpha = placed(alpha, a + alpha_turns + half_tau_phase, half_tau);
        let beta = placed(beta, b + beta_turns - half_tau_phase, -half_tau);
        AttitudeState {
            orientation: Orientation { alpha: alpha.0, beta: beta.0 },
            rate: OrientationRate { alpha: alpha.1, beta: beta.1 },
        }
    }
}

/// Argument of x cos χ + i y sin χ divided by the closed form's value, from their values and derivatives.
fn argument(
    [x, y]: [Extended; 2],
    [sine, cosine]: [Extended; 2],
    [nutation, turning]: [Extended; 2],
    closed: ValueAndSlope,
) -> Phase {
    let value: Wide = Complex::new(x * cosine, y * sine);
    let along: Wide = Complex::new(-(x * sine), y * cosine);
    let slope = along.scaled(nutation) + value.times_i().scaled(turning);
    let rate_squared = nutation.squared() + turning.squared();
    let sum = value * closed.value.conj() * real(rate_squared) + slope * closed.slope.conj();
    phase_of(angle(sum.im, sum.re))
}
