//! Aperiodic motion, e₂ = e₃ = 1: the axis leaves the vertical and returns to it, in infinite time
//! (section 5.3 of the paper).
//!
//! In the variable v, for which sn becomes tanh, these quantities are elementary:
//!
//! ```text
//! u = e₁ + (1 - e₁) tanh² v,   β = √((1 - e₁)/2) sech v e^{i(b₀ - τt/2)},   dt/dv = √(2 D(u)/(g (1 - e₁)))
//! ```
//!
//! The time t(v) and the argument of α are [Weierstrass functions](sliding) for a sliding tip, and elementary
//! functions for a fixed one.

mod constants;

mod fixed_tip;

mod sliding;

use crate::elliptic::elementary::{ValueAndSlope, rounded};
use crate::inverse::solve_increasing;
use crate::orientation::ArgumentOffsets;
use constants::{AperiodicConstants, AperiodicValues};
use fixed_tip::FixedTip;
use sliding::Sliding;
use toytop::internal::ExtendedConstants;
use toytop::scalar::{Extended, Float, Ring};
use toytop::{AttitudeState, Complex, Motion, Phase, Support};

/// Aperiodic motion as a function of time, for any t. Where 1 - u is below the smallest number, the axis is upright
/// and α rotates at a constant rate.
///
/// ```
/// use toytop::{InitialAngles, Motion, Signs, Top, TopParameters};
/// use toytop_closed_forms::Aperiodic;
/// let parameters = TopParameters { transverse_inertia: 1.25, axial_inertia: 0.75, com_height: 0.5, mass_moment: 1.5, gravity: 3.0, ..TopParameters::default() };
/// let top = Top::sliding(&parameters)?;
/// let motion = Motion::from_branch_points(&top, [-0.4, 1.0, 1.0], Signs::default(), &InitialAngles::default())?;
/// let form = Aperiodic::new(&motion).expect("e2 = e3 = 1");
/// let orientation = form.at(2.5).orientation;
/// let (tip, angle) = (form.tip(2.5), form.tip_angle(2.5)); // the angle counts whole turns
/// assert!((orientation.norm_squared() - 1.0).abs() < 1e-14);
/// assert!((tip.arg() - angle.principal().to_radians()).abs() < 1e-14);
/// # Ok::<(), toytop::ParameterError>(())
/// ```
///
/// Cost: about 10 theta functions in extended precision for set-up; for one time about 30 for a sliding tip, a few
/// exponentials and two arctangents for a fixed one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aperiodic {
    constants: AperiodicConstants,
    form: Form,
    /// Variable v at t = 0, and t(v) there.
    start: [Extended; 2],
    arguments: ArgumentOffsets,
    /// Length s, m; 1 for a fixed tip.
    tip_scale: f64,
    /// Tip angle minus the argument of α in the closed form.
    tip_origin: Phase,
}

/// Solution for t and arg α, by support of the tip.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(clippy::large_enum_variant, reason = "there is no heap to box it into")]
enum Form {
    Sliding(Sliding),
    FixedTip(FixedTip),
}

impl Form {
    fn time(&self, point: &AperiodicValues) -> Extended {
        match self {
            Self::Sliding(form) => form.time(point),
            Self::FixedTip(_) => point.v * point.dt_dv,
        }
    }

    /// α and its time derivative for C = A.
    fn alpha(&self, point: &AperiodicValues) -> ValueAndSlope {
        match self {
            Self::Sliding(form) => form.alpha(point),
            Self::FixedTip(form) => form.alpha(point),
        }
    }

    /// Argument of α, continuous in v, minus that at u = e₁; 0 where α passes through 0.
    fn argument(&self, point: &AperiodicValues) -> Phase {
        let angle = match self {
            Self::Sliding(form) => form.argument(point),
            Self::FixedTip(form) => form.argument(point),
        };
        angle.radians_to_turns().to_phase()
    }
}

impl Aperiodic {
    /// Largest |t| that is used, s; a larger one is limited to it. The phases lose all correct digits long before.
    const MAX_TIME: f64 = 1e200;

    /// Closed form of a motion; `None` unless e₂ = e₃ = 1 and u < 1.
    #[must_use]
    pub fn new(motion: &Motion) -> Option<Self> {
        let ExtendedConstants { a, s, p, g, e, integrals, aperiodic_v, .. } = motion.into();
        let v = Extended::from(aperiodic_v?);
        let one_minus_e1 = e.one_minus_e1();
        let constants =
            AperiodicConstants { e1: e.e1, one_plus_e1: e.one_plus_e1, one_minus_e1, a_over_p: a / p, s, g };
        let form = match motion.top().support() {
            Support::Sliding => Form::Sliding(Sliding::new(&constants, integrals.l / a)),
            // the axis of a free body does not rise to the vertical
            Support::Fixed | Support::Free => {
                Form::FixedTip(FixedTip::new(&constants, motion.signs().l_plus_n))
            }
        };
        let point = constants.at(v);
        let alpha = form.alpha(&point);
        let arguments = ArgumentOffsets::new(motion, [alpha, constants.beta(&point)]);
        let [alpha_offset, beta_offset] = arguments.angles;
        let at_start = form.argument(&point);
        // the argument of α at u = e₁ in the closed form
        let lowest =
            if e.one_plus_e1 > Extended::ZERO { form.alpha(&constants.at(Extended::ZERO)) } else { alpha };
        let origin = Phase::from_radians(rounded(lowest.value).arg());
        let tip_origin = (alpha_offset + beta_offset + origin + at_start).principal() - at_start;
        let tip_scale = motion.top().tip_scale();
        Some(Self { constants, form, start: [v, form.time(&point)], arguments, tip_scale, tip_origin })
    }

    /// Orientation Φ and rate Φ' at t. A t that is not finite counts as 0.
    #[must_use]
    pub fn at(&self, t: f64) -> AttitudeState<f64> {
        let point = self.constants.at(self.exact_v(t));
        self.arguments.attitude_state(
            t,
            [self.form.alpha(&point), self.constants.beta(&point)],
            [Phase::ZERO; 2],
        )
    }

    /// Position c of the tip at t, m; 2αβ, without unit, for a fixed tip.
    #[must_use]
    pub fn tip(&self, t: f64) -> Complex<f64> {
        self.at(t).orientation.tip_over_s().scaled(self.tip_scale)
    }

    /// Angle of the tip at t, continuous in time; at t = 0 in (-1/2, 1/2] turn. Where the curve passes through the centre (e₁ = -1) the
    /// angle is constant, and the radius changes its sign.
    #[must_use]
    pub fn tip_angle(&self, t: f64) -> Phase {
        self.tip_origin + self.form.argument(&self.constants.at(self.exact_v(t)))
    }

    /// Bound on the error of an orientation, rad, at any |t| up to 1e15 times the shortest time of the motion: 2e-15, and the rounding
    /// of v at t = 0 as a shift in time.
    #[must_use]
    pub fn error_bound(&self) -> f64 {
        let [v, _] = self.start.map(Float::to_f64);
        let ps_over_a = (self.constants.s / self.constants.a_over_p).to_f64();
        2e-15 + 5e-16 * Float::abs(v) * Float::sqrt(1.0 + ps_over_a)
    }

    /// Variable v at t, with u = e₁ + (1 - e₁) tanh² v.
    #[must_use]
    pub fn v(&self, t: f64) -> f64 {
        self.exact_v(t).to_f64()
    }

    fn exact_v(&self, t: f64) -> Extended {
        let [start, origin] = self.start;
        if t == 0.0 || !t.is_finite() {
            return start;
        }
        let target = origin + t.clamp(-Self::MAX_TIME, Self::MAX_TIME).into();
        let function = |v: Extended| {
            let point = self.constants.at(v);
            (self.form.time(&point), point.dt_dv)
        };
        let bounds @ [low, high] = self.constants.bounds(target);
        solve_increasing(target, bounds, (low + high).halved(), function)
    }
}
