//! Launch of a motion: from a state, or from branch points and phases.

use crate::body::{ParameterError, State, Top, check, check_range};
use crate::complex::Complex;
use crate::constants::{BranchPoints, FirstIntegrals, ReducedPoint, Regime, Signs, is_steady};
use crate::motion::ellipses::Ellipses;
use crate::motion::half_phase::half_phase_at;
use crate::motion::phase_equations::{PhaseEquations, PhaseRates};
use crate::motion::{LaunchRounding, Motion, steady_tilt};
use crate::phase::Phase;
use crate::scalar::{Extended, Float, Ring};
use crate::su2::{AttitudeState, OrientationRate};

/// Angles at t = 0 of a motion given by branch points, in rad; 0 by default.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct InitialAngles {
    /// Nutation angle θ(0) = 2χ(0): 0 at u = e₁, π at u = e₂, with u rising in between.
    ///
    /// A rounded multiple of π counts as that multiple. With e₂ = e₃ = 1, θ = π is the upright top, u = 1.
    pub theta: f64,
    /// Argument of α(0); where α(0) = 0, the argument of α'(0).
    pub arg_alpha: f64,
    /// Argument of β(0); where β(0) = 0, the argument of β'(0).
    pub arg_beta: f64,
}

impl Motion {
    /// Motion from a state.
    ///
    /// # Errors
    /// `omega`: so large that e₃ would exceed 1e14.
    pub fn launch(top: &Top, state: &State) -> Result<Self, ParameterError> {
        Self::launch_with_pauses(top, state, &mut || {})
    }

    /// Motion from a state, with pauses for other work.
    ///
    /// * `pause`: called at least every 50 000 cycles of a Cortex-M4F, and every 200 000 of a Cortex-M0+
    ///
    /// ```
    /// use toytop::{Motion, Release, State, Top, TopParameters};
    /// # let top = Top::sliding(&TopParameters::TOY)?;
    /// # let state = State::from_release(&Release { tilt: 0.35, spin: 150.0, ..Release::default() })?;
    /// let mut fed = 0;
    /// let motion = Motion::launch_with_pauses(&top, &state, &mut || fed += 1)?;
    /// assert!(motion == Motion::launch(&top, &state)? && fed > 5);
    /// # Ok::<(), toytop::ParameterError>(())
    /// ```
    ///
    /// # Errors
    /// See [`launch`](Self::launch).
    #[inline(never)]
    pub fn launch_with_pauses(
        top: &Top,
        state: &State,
        pause: &mut dyn FnMut(),
    ) -> Result<Self, ParameterError> {
        let (integrals, point) = FirstIntegrals::from_state_with_point(top, state, pause);
        pause();
        let e = BranchPoints::from_reduced_point(top, &integrals, &point, pause);
        // by reference: a copy takes 280 bytes of stack
        let e = e.as_ref().map_err(|error| *error)?;
        pause();
        let signs = integrals.signs();
        let regime = Regime::new(e, signs, point.is_sleeping());
        let half_tau = top.half_tau(integrals.spin);
        pause();
        let rounding = LaunchRounding::new(top, &integrals, &point, e, state);
        pause();
        let torque_free_rate = chi_rate_without_torque(top, &integrals, &point);
        let half_phase =
            (!is_steady(e, regime)).then(|| half_phase_at(top, e, regime, torque_free_rate, &point));
        let ellipses = ellipses_of(e, signs, half_phase, regime);
        pause();
        let at_start = orientation_and_rate(state);
        pause();
        let slow_phases = match half_phase {
            None => [at_start.orientation.alpha, at_start.orientation.beta].map(argument),
            Some(chi) => {
                let equations = rounded_equations(top, e, integrals.l_plus_n, signs, torque_free_rate);
                pause();
                slow_phases_of(&equations, &ellipses, half_tau.to_f64(), chi, &at_start)
            }
        };
        Ok(Self {
            top: *top,
            signs,
            branch_points: *e,
            integrals,
            half_tau,
            ellipses,
            regime,
            half_phase,
            slow_phases,
            rounding,
            torque_free_rate,
        })
    }

    /// Motion from branch points -1 <= e₁ <= e₂ <= 1 <= e₃, which count as exact, and its phases at t = 0.
    ///
    /// # Errors
    /// * `e1`, `e2`, `e3`: not finite or not in this order, or e₃ above 1e14
    /// * `theta`, `arg_alpha`, `arg_beta`: not finite or beyond ±1e6 rad
    /// * `top`: no torque acts; branch points then determine no rate
    /// * `e3`: the axial rate (n - K)/C exceeds 1e24 per unit of time, or C = 0 and n is not K
    pub fn from_branch_points(
        top: &Top,
        e: [f64; 3],
        signs: Signs,
        angles: &InitialAngles,
    ) -> Result<Self, ParameterError> {
        check(
            !top.is_torque_free(),
            "top",
            "one with torque: without it branch points tell no rate; give a state or a release",
        )?;
        let e = BranchPoints::from_roots(e)?;
        let InitialAngles { theta, arg_alpha, arg_beta } = *angles;
        for (name, angle) in [("theta", theta), ("arg_alpha", arg_alpha), ("arg_beta", arg_beta)] {
            check_range(-1e6..=1e6, name, angle, "between -1e6 and 1e6 rad")?;
        }
        let integrals = e.extended_integrals(top, signs);
        let FirstIntegrals { n, spin, l_plus_n, l_minus_n, .. } = integrals;
        let Top { c, k, .. } = *top;
        let rounding = (l_plus_n.abs() + l_minus_n.abs() + k.abs()) * Extended::from(f64::EPSILON);
        check(
            if c > Extended::ZERO { spin.abs() <= 1e24.into() } else { (n - k).abs() <= rounding },
            "e3",
            "such that (n - rotor_momentum)/axial_inertia is at most 1e24 rad/s, and n = rotor_momentum for a rod",
        )?;
        let chi = half_phase_of_theta(theta);
        let (_, remainder) = chi.split_half_turns();
        let regime = Regime::new(&e, signs, remainder == Phase::QUARTER);
        let half_phase = (!is_steady(&e, regime)).then_some(chi);
        let ellipses = ellipses_of(&e, signs, half_phase, regime);
        let [alpha, beta] = match half_phase {
            None => [Phase::ZERO; 2],
            Some(chi) => ellipses.arguments(Complex::cis(chi)),
        };
        Ok(Self {
            top: *top,
            signs,
            branch_points: e,
            integrals,
            half_tau: top.half_tau(spin),
            ellipses,
            regime,
            half_phase,
            slow_phases: [phase_of_angle(arg_alpha) - alpha, phase_of_angle(arg_beta) - beta],
            rounding: LaunchRounding::default(),
            torque_free_rate: Extended::ZERO,
        })
    }
}

/// Phase of an angle in rad, without a rounding of `f64`.
fn phase_of_angle(angle: f64) -> Phase {
    Extended::from(angle).radians_to_turns().to_phase()
}

/// Half phase χ = θ/2; a quarter turn, or a multiple of one, if the rounding of θ explains the difference.
fn half_phase_of_theta(theta: f64) -> Phase {
    const ROUNDING: f64 = 0.5 * f64::EPSILON;
    let chi = phase_of_angle(0.5 * theta);
    let (_, difference) = chi.quadrant();
    let is_rounding = difference.to_turns().abs() <= ROUNDING * chi.to_turns().abs();
    if is_rounding { chi - difference } else { chi }
}

/// Ellipses of α and β.
fn ellipses_of(
    e: &BranchPoints<Extended>,
    signs: Signs,
    half_phase: Option<Phase>,
    regime: Regime,
) -> Ellipses<f64> {
    match half_phase {
        Some(_) => Ellipses::oscillating(e, signs, Extended::to_f64),
        None => Ellipses::steady(steady_tilt(e, regime)),
    }
}

/// Rate χ' of a motion without torque, rad/s; otherwise 0. The axis rotates about the angular momentum m at the rate |m|/A.
fn chi_rate_without_torque(
    top: &Top,
    integrals: &FirstIntegrals<Extended>,
    point: &ReducedPoint,
) -> Extended {
    if top.is_torque_free() { (point.momentum(top.a, integrals.n) / top.a).halved() } else { Extended::ZERO }
}

/// Orientation of a state and its rate, computed in extended precision.
#[inline(never)]
fn orientation_and_rate(state: &State) -> AttitudeState<f64> {
    let (phi, omega) = state.to_extended();
    let AttitudeState { orientation, rate } = AttitudeState::from_fixed(phi.normalised(), omega);
    AttitudeState {
        orientation: orientation.map(Float::to_f64),
        rate: OrientationRate { alpha: rate.alpha.map(Float::to_f64), beta: rate.beta.map(Float::to_f64) },
    }
}

/// Phase equations, rounded.
#[inline(never)]
fn rounded_equations(
    top: &Top,
    e: &BranchPoints<Extended>,
    l_plus_n: Extended,
    signs: Signs,
    torque_free_rate: Extended,
) -> PhaseEquations<f64> {
    PhaseEquations::new(top, e, l_plus_n, signs, torque_free_rate).map(Float::to_f64)
}

/// Slow phases of an orientation and its rate, from the half phase.
#[inline(never)]
fn slow_phases_of(
    equations: &PhaseEquations<f64>,
    Ellipses { alpha, beta }: &Ellipses<f64>,
    half_tau: f64,
    chi: Phase,
    AttitudeState { orientation: phi, rate }: &AttitudeState<f64>,
) -> [Phase; 2] {
    let cis_chi = Complex::cis(chi);
    let PhaseRates { chi: chi_rate, psi_alpha, psi_beta } = equations.rates(cis_chi.im, cis_chi.re);
    [
        alpha.slow_phase(cis_chi, [chi_rate, psi_alpha + half_tau], [phi.alpha, rate.alpha]),
        beta.slow_phase(cis_chi, [chi_rate, psi_beta - half_tau], [phi.beta, rate.beta]),
    ]
    .map(argument)
}

fn argument(z: Complex<f64>) -> Phase {
    Phase::from_radians(z.arg())
}
