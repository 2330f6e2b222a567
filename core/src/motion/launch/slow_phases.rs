//! Slow phases at t = 0.

use crate::body::State;
use crate::complex::Complex;
use crate::motion::Motion;
use crate::motion::cayley_klein::{Ellipse, Ellipses};
use crate::motion::phase_equations::{PhaseEquations, PhaseRates};
use crate::phase::Phase;
use crate::scalar::{Float, Ring};
use crate::su2::{AttitudeState, OrientationRate};

impl Motion {
    /// Sets the slow phases at an attitude, whose half phase is known.
    #[inline(never)]
    pub(super) fn start_slow_phases(
        &mut self,
        AttitudeState { orientation: phi, rate }: &AttitudeState<f64>,
        pause: &mut dyn FnMut(),
    ) {
        if self.is_steady() {
            self.slow_phases = [phi.alpha, phi.beta].map(|z| Phase::from_radians(z.arg()));
            return;
        }
        let equations: PhaseEquations<f64> = self.equations().cast();
        pause();
        let chi = self.direction();
        let PhaseRates { nutation, slow_alpha, slow_beta } = equations.rates(chi.im, chi.re);
        let half_tau = self.half_tau.to_f64();
        let Ellipses { alpha: alpha_ellipse, beta: beta_ellipse } = &self.ellipses;
        self.slow_phases = [
            slow_phase(alpha_ellipse, chi, [nutation, slow_alpha + half_tau], [phi.alpha, rate.alpha]),
            slow_phase(beta_ellipse, chi, [nutation, slow_beta - half_tau], [phi.beta, rate.beta]),
        ];
    }
}

/// Orientation of a state and its rate, computed in extended precision.
#[inline(never)]
pub(super) fn attitude(state: &State) -> AttitudeState<f64> {
    let (phi, omega) = state.in_extended();
    let AttitudeState { orientation, rate } = AttitudeState::from_fixed(phi.normalised(), omega);
    AttitudeState {
        orientation: orientation.cast(),
        rate: OrientationRate { alpha: rate.alpha.cast(), beta: rate.beta.cast() },
    }
}

/// Slow phase of a parameter: the least-squares rotation of the ellipse and its rate to z and z'.
fn slow_phase(ellipse: &Ellipse<f64>, chi: Complex<f64>, rates: [f64; 2], z: [Complex<f64>; 2]) -> Phase {
    let [value, rate] = z;
    let (model, model_rate) = (ellipse.at(chi), ellipse.rate(chi, rates));
    let [nutation, slow] = rates;
    let time = 1.0 / (nutation.squared() + slow.squared());
    let sum = value * model.conj() + (rate * model_rate.conj()).scaled(time);
    Phase::from_radians(sum.arg())
}
