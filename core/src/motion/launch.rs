//! Launch of a motion: from a state, or from branch points and phases.

mod half_phase;

mod slow_phases;

use self::half_phase::half_phase_of_angle;
use self::slow_phases::attitude;
use crate::body::{ParameterError, State, Top, check, check_range};
use crate::constants::{BranchPoints, FirstIntegrals, Regime, Signs};
use crate::motion::cayley_klein::Ellipses;
use crate::motion::{LaunchRounding, Motion};
use crate::phase::Phase;
use crate::scalar::{Extended, Float, Ring};

/// Angles at t = 0 of a motion given by branch points, in rad; 0 by default.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct InitialAngles {
    /// Nutation angle θ(0) = 2χ(0): 0 at u = e₁, π at u = e₂, with u rising in between.
    ///
    /// The `f64` nearest to a multiple of π counts as that multiple. With e₂ = e₃ = 1, θ = π is the upright top, u = 1.
    pub theta: f64,
    /// Argument of α(0); where α(0) = 0, that of α'(0).
    pub arg_alpha: f64,
    /// Argument of β(0); where β(0) = 0, that of β'(0).
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
    /// * `pause`: called at least every 50 000 cycles of a Cortex-M4F
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
        let (integrals, point) = FirstIntegrals::with_reduced_point(top, state);
        pause();
        let e = BranchPoints::from_reduced_point(top, &integrals, &point, pause);
        // by reference: a copy takes 280 bytes of stack
        let e = e.as_ref().map_err(|error| *error)?;
        pause();
        let mut motion = Self::with_constants(top, &integrals, e, integrals.signs(), point.is_sleeping());
        pause();
        motion.rounding = LaunchRounding::new(top, &integrals, &point, e, state);
        pause();
        motion.set_torque_free_rate(&point);
        motion.start_half_phase(&point);
        pause();
        motion.start_slow_phases(&attitude(state), pause);
        Ok(motion)
    }

    /// Motion from branch points -1 <= e₁ <= e₂ <= 1 <= e₃, which count as exact, and its phases at t = 0.
    ///
    /// # Errors
    /// * `e1`, `e2`, `e3`: not finite or not in this order
    /// * `theta`, `arg_alpha`, `arg_beta`: not finite or beyond ±1e6 rad
    /// * `top`: no torque acts, so that branch points determine no rate
    /// * `e3`: the axial rate (n - K)/C exceeds 1e24 per unit of time, or C = 0 and n is not K
    pub fn from_branch_points(
        top: &Top,
        e: [f64; 3],
        signs: Signs,
        start: &InitialAngles,
    ) -> Result<Self, ParameterError> {
        check(
            !top.is_torque_free(),
            "top",
            "one with torque: without it branch points tell no rate; give a state or a release",
        )?;
        let e = BranchPoints::from_roots(e)?;
        let InitialAngles { theta, arg_alpha, arg_beta } = *start;
        for (name, angle) in [("theta", theta), ("arg_alpha", arg_alpha), ("arg_beta", arg_beta)] {
            check_range(-1e6..=1e6, name, angle, "between -1e6 and 1e6 rad")?;
        }
        let integrals = e.unrounded_integrals(top, signs);
        let (FirstIntegrals { n, spin, l_plus_n, l_minus_n, .. }, Top { c, k, .. }) = (integrals, *top);
        let rounding = (l_plus_n.abs() + l_minus_n.abs() + k.abs()) * Extended::from(f64::EPSILON);
        check(
            if c > Extended::ZERO { spin.abs() <= 1e24.into() } else { (n - k).abs() <= rounding },
            "e3",
            "such that (n - rotor_momentum)/axial_inertia is at most 1e24 rad/s, and n = rotor_momentum for a rod",
        )?;
        let chi = half_phase_of_angle(theta);
        let (_, remainder) = chi.split_half_turns();
        let mut motion = Self::with_constants(top, &integrals, &e, signs, remainder == Phase::QUARTER);
        motion.slow_phases = [arg_alpha, arg_beta].map(|angle| Extended::from(angle).in_turns().to_phase());
        if motion.is_steady() {
            return Ok(motion);
        }
        motion.half_phase = Some(chi);
        let arguments = motion.ellipses.arguments(motion.cis_chi());
        for (phase, argument) in motion.slow_phases.iter_mut().zip(arguments) {
            *phase = *phase - argument;
        }
        Ok(motion)
    }

    /// Motion with these constants, without its start.
    ///
    /// * `upright`: whether a motion with e₂ = e₃ = 1 has u = 1
    #[inline(never)]
    fn with_constants(
        top: &Top,
        integrals: &FirstIntegrals<Extended>,
        e: &BranchPoints<Extended>,
        signs: Signs,
        upright: bool,
    ) -> Self {
        let Top { a, c, k, .. } = *top;
        let regime = Regime::new(e, signs, upright);
        // a swing below the threshold of the regime still has a period
        let is_steady = e.e2_minus_e1 == Extended::ZERO || regime == Regime::SleepingUnstable;
        let mut motion = Self {
            top: *top,
            signs,
            e: *e,
            integrals: *integrals,
            half_tau: ((a - c) / a * integrals.spin - k / a).halved(),
            ellipses: Ellipses::oscillating(e, signs, Extended::to_f64),
            regime,
            half_phase: (!is_steady).then_some(Phase::ZERO),
            slow_phases: [Phase::ZERO; 2],
            rounding: LaunchRounding::default(),
            torque_free_rate: Extended::ZERO,
        };
        if is_steady {
            motion.ellipses = Ellipses::steady(motion.steady_complements());
        }
        motion
    }
}
