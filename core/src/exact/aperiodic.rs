//! Aperiodic motion, e₂ = e₃ = 1: the axis descends from the vertical and rises to it again, each in infinite time
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

mod fixed;
mod sliding;

use crate::attitude_state::AttitudeState;
use crate::elliptic::elementary::real;
use crate::elliptic::transcendental::tanh_sech;
use crate::exact::orientation::ConstantArguments;
use crate::exact::periods::solve_rising;
use crate::exact::sigma_quotient::ValueAndSlope;
use crate::motion::{Motion, NutationVariable};
use crate::phase::Phase;
use crate::scalar::{Extended, Float, Ring};
use crate::top::{Quantities, Support};
use fixed::Fixed;
use sliding::Sliding;

/// Aperiodic motion as a function of time, for any t. Where 1 - u is below the smallest number, the axis is upright
/// and α rotates at a constant rate.
///
/// Error of an orientation: below 1e-15 rad, also after α has rotated by 1e5 rad and for e₁ as close to ±1 as 2^-50.
/// Cost: about 20 theta functions in extended precision for set-up; for one time about 60 for a sliding tip, a few
/// exponentials and two arctangents for a fixed one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aperiodic {
    point: Rise,
    form: Form,
    /// Variable v at t = 0, and t(v) there.
    start: [Extended; 2],
    arguments: ConstantArguments,
}

/// Solution for t and arg α, by support of the tip.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(clippy::large_enum_variant, reason = "there is no heap to box it into")]
enum Form {
    Sliding(Sliding),
    Fixed(Fixed),
}

/// Constants of the quantities that depend on u alone, as functions of v.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Rise {
    e1: Extended,
    one_plus_e1: Extended,
    one_minus_e1: Extended,
    a_over_p: Extended,
    s: Extended,
    g: Extended,
}

/// Values at one v.
#[derive(Clone, Copy, Debug)]
struct RiseValues {
    v: Extended,
    tanh: Extended,
    sech: Extended,
    ln_sech: Extended,
    /// Difference 1 - u.
    below: Extended,
    /// Sum 1 + u.
    above: Extended,
    /// Derivative dt/dv.
    dt_dv: Extended,
}

impl RiseValues {
    /// Value of an odd function at v, from its value at |v|.
    fn with_sign_of_v(&self, value: Extended) -> Extended {
        if self.v < Extended::ZERO { -value } else { value }
    }
}

impl Rise {
    fn at(&self, v: Extended) -> RiseValues {
        let (tanh, sech, ln_sech) = tanh_sech(v);
        let below = self.one_minus_e1 * sech.squared();
        let above = self.one_plus_e1 + self.one_minus_e1 * tanh.squared();
        let dt_dv = self.dt_dv(self.a_over_p + self.s * below * above);
        RiseValues { v, tanh, sech, ln_sech, below, above, dt_dv }
    }

    /// Derivative dt/dv for a value of D.
    fn dt_dv(&self, d: Extended) -> Extended {
        (d.doubled() / (self.g * self.one_minus_e1)).sqrt()
    }

    /// Bounds on v at a given t, from the bounds on dt/dv.
    fn bracket(&self, t: Extended) -> [Extended; 2] {
        let (fast, slow) = (t / self.dt_dv(self.a_over_p), t / self.dt_dv(self.a_over_p + self.s));
        // widened by a margin on either side
        let margin = fast.abs() * Extended::from(1e-13);
        if fast < slow { [fast - margin, slow + margin] } else { [slow - margin, fast + margin] }
    }
}

impl Form {
    fn time(&self, point: &RiseValues) -> Extended {
        match self {
            Self::Sliding(form) => form.time(point),
            Self::Fixed(_) => point.v * point.dt_dv,
        }
    }

    /// α and its time derivative for C = A.
    fn alpha(&self, point: &RiseValues) -> ValueAndSlope {
        match self {
            Self::Sliding(form) => form.alpha(point),
            Self::Fixed(form) => form.alpha(point),
        }
    }
}

impl Aperiodic {
    /// Largest |t| that is used, s; a larger one is limited to it. The phases lose all correct digits long before.
    const FURTHEST: f64 = 1e200;

    /// Closed form of a motion; `None` unless e₂ = e₃ = 1 and u < 1.
    #[must_use]
    pub fn new(motion: &Motion) -> Option<Self> {
        let NutationVariable::Aperiodic(v) = motion.nutation() else { return None };
        let (e, Quantities { a, p, s, g, .. }) = (motion.exact_branch_points(), motion.quantities());
        let one_minus_e1 = e.one_minus_e1();
        let point = Rise { e1: e.e1, one_plus_e1: e.one_plus_e1, one_minus_e1, a_over_p: a / p, s, g };
        let form = match motion.top().support() {
            Support::Sliding => Form::Sliding(Sliding::new(&point, motion.exact_integrals().l / a)),
            // the axis of a free body does not rise to the vertical
            Support::Fixed | Support::Free => Form::Fixed(Fixed::new(&point, motion.signs().l_plus_n)),
        };
        let v = Extended::from(v);
        let start = point.at(v);
        let arguments = ConstantArguments::new(motion, [form.alpha(&start), point.beta(&start)]);
        Some(Self { point, form, start: [v, form.time(&start)], arguments })
    }

    /// Orientation Φ and rate Φ' at t.
    #[must_use]
    pub fn at(&self, t: f64) -> AttitudeState<f64> {
        let point = self.point.at(self.exact_v(t));
        self.arguments.attitude_state(t, [self.form.alpha(&point), self.point.beta(&point)], [Phase::ZERO; 2])
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
        let target = origin + t.clamp(-Self::FURTHEST, Self::FURTHEST).into();
        let function = |v: Extended| {
            let point = self.point.at(v);
            (self.form.time(&point), point.dt_dv)
        };
        let bracket @ [low, high] = self.point.bracket(target);
        solve_rising(target, bracket, (low + high).halved(), function)
    }
}

impl Rise {
    /// β with argument 0, and its time derivative.
    fn beta(&self, point: &RiseValues) -> ValueAndSlope {
        let value = self.one_minus_e1.halved().sqrt() * point.sech;
        ValueAndSlope { value: real(value), slope: real(-(value * point.tanh / point.dt_dv)) }
    }
}
