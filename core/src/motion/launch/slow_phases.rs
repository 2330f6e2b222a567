//! Slow phases at t = 0.

use crate::body::State;
use crate::motion::Motion;
use crate::motion::cayley_klein::Ellipses;
use crate::motion::phase_equations::{PhaseEquations, PhaseRates};
use crate::phase::Phase;
use crate::scalar::Float;
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
        let cis_chi = self.cis_chi();
        let PhaseRates { half_phase, psi_alpha, psi_beta } = equations.rates(cis_chi.im, cis_chi.re);
        let (half_tau, Ellipses { alpha, beta }) = (self.half_tau.to_f64(), &self.ellipses);
        self.slow_phases = [
            alpha.slow_phase(cis_chi, [half_phase, psi_alpha + half_tau], [phi.alpha, rate.alpha]),
            beta.slow_phase(cis_chi, [half_phase, psi_beta - half_tau], [phi.beta, rate.beta]),
        ]
        .map(|z| Phase::from_radians(z.arg()));
    }
}

/// Orientation of a state and its rate, computed in extended precision.
#[inline(never)]
pub(super) fn attitude(state: &State) -> AttitudeState<f64> {
    let (phi, omega) = state.in_extended();
    let AttitudeState { orientation, rate } = AttitudeState::from_fixed(phi.normalised(), omega);
    AttitudeState {
        orientation: orientation.map(Float::to_f64),
        rate: OrientationRate { alpha: rate.alpha.map(Float::to_f64), beta: rate.beta.map(Float::to_f64) },
    }
}
