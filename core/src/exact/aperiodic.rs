//! The aperiodic motion, e₂ = e₃ = 1: the axis comes from the vertical and rises to it again, each in infinite time
//! (section 5.3 of the paper).
//!
//! In the variable v with sn → tanh the form is elementary,
//!
//! ```text
//! u = e₁ + (1 - e₁) tanh² v,   β = √((1 - e₁)/2) sech v e^{i(b₀ - τt/2)},   dt/dv = √(2 D(u)/(g (1 - e₁)))
//! ```
//!
//! and only t(v) and the argument of α are not: for a sliding tip they are [Weierstrass functions](sliding), for a fixed
//! one elementary too.

mod fixed;
mod sliding;

use super::orientation::Fit;
use super::periods::solve_rising;
use super::sigma_quotient::Germ;
use crate::complex::Complex;
use crate::launch::{BranchPoints, Course, Motion};
use crate::nutation::gudermannian;
use crate::real::Float;
use crate::tick::Pose;
use crate::turns::Turns;
use fixed::Fixed;
use sliding::Sliding;

/// An aperiodic motion as a function of time, for any t: where 1 - u has no more digits the axis is upright and α turns
/// on at its constant rate.
///
/// Error of an orientation: 1e-14 rad, and 1e-15 rad more for every rad that α turns. Cost: set-up some 20 theta
/// functions, a time some 20 for a sliding tip, three exponentials and two arctangents for a fixed one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aperiodic {
    point: Rise,
    form: Form,
    /// v at t = 0, and t(v) there.
    start: [f64; 2],
    fit: Fit,
}

/// What t and arg α are made of.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(clippy::large_enum_variant, reason = "there is no heap to box it into")]
enum Form {
    Sliding(Sliding),
    Fixed(Fixed),
}

/// u and what depends on it alone, as functions of v.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Rise {
    e1: f64,
    one_plus_e1: f64,
    one_minus_e1: f64,
    a_over_p: f64,
    s: f64,
    g: f64,
}

/// One v.
#[derive(Clone, Copy, Debug)]
struct Point {
    v: f64,
    tanh: f64,
    sech: f64,
    /// 1 - u.
    below: f64,
    /// 1 + u.
    above: f64,
    /// dt/dv.
    slowness: f64,
}

impl Rise {
    fn at(&self, v: f64) -> Point {
        let (tanh, sech) = gudermannian(v);
        let below = self.one_minus_e1 * sech * sech;
        let above = self.one_plus_e1 + self.one_minus_e1 * tanh * tanh;
        let d = self.a_over_p + self.s * below * above;
        Point { v, tanh, sech, below, above, slowness: Float::sqrt(2.0 * d / (self.g * self.one_minus_e1)) }
    }

    /// The bounds that dt/dv puts on v at this t.
    fn bracket(&self, t: f64) -> [f64; 2] {
        let slowness = |d: f64| Float::sqrt(2.0 * d / (self.g * self.one_minus_e1));
        let (fast, slow) = (t / slowness(self.a_over_p), t / slowness(self.a_over_p + self.s));
        let (low, high) = (fast.min(slow), fast.max(slow));
        // and a rounding beyond, on either side
        let room = 1e-13 * Float::abs(fast);
        [low - room, high + room]
    }
}

impl Form {
    fn time(&self, point: &Point) -> f64 {
        match self {
            Self::Sliding(form) => form.time(point),
            Self::Fixed(_) => point.v * point.slowness,
        }
    }

    /// α and its rate by time, without drift.
    fn alpha(&self, point: &Point) -> Germ {
        match self {
            Self::Sliding(form) => form.alpha(point),
            Self::Fixed(form) => form.alpha(point),
        }
    }
}

impl Aperiodic {
    /// The closed form of a motion; `None` unless e₂ = e₃ = 1 and u < 1.
    #[must_use]
    pub fn new(motion: &Motion) -> Option<Self> {
        let Course::Aperiodic(v) = motion.course() else { return None };
        let (top, e) = (motion.top(), motion.branch_points());
        let BranchPoints { e1, one_plus_e1, .. } = e;
        let (a_over_p, s, g) = (top.a() / top.p(), top.s(), top.g());
        let point = Rise { e1, one_plus_e1, one_minus_e1: e.one_minus_e1(), a_over_p, s, g };
        let form = match top.e4() {
            Some(e4) => Form::Sliding(Sliding::new(&point, e4, motion.first_integrals().l / top.a())),
            None => Form::Fixed(Fixed::new(&point, motion.signs().l_plus_n)),
        };
        let start = point.at(v);
        let fit = Fit::new(motion, form.alpha(&start), point.beta(&start));
        Some(Self { point, form, start: [v, form.time(&start)], fit })
    }

    /// Φ and Φ' at t.
    #[must_use]
    pub fn at(&self, t: f64) -> Pose<f64> {
        let point = self.point.at(self.v(t));
        self.fit.pose(t, [self.form.alpha(&point), self.point.beta(&point)], [Turns::ZERO; 2])
    }

    /// v at t, so that u = e₁ + (1 - e₁) tanh² v.
    #[must_use]
    pub fn v(&self, t: f64) -> f64 {
        let [start, origin] = self.start;
        if t == 0.0 || !t.is_finite() {
            return start;
        }
        let target = origin + t;
        let function = |v: f64| {
            let point = self.point.at(v);
            (self.form.time(&point), point.slowness)
        };
        let bracket @ [low, high] = self.point.bracket(target);
        solve_rising(target, bracket, 0.5 * (low + high), function)
    }
}

impl Rise {
    /// β with argument 0, and its rate by time.
    fn beta(&self, point: &Point) -> Germ {
        let value = Float::sqrt(0.5 * self.one_minus_e1) * point.sech;
        Germ {
            value: Complex::new(value, 0.0),
            slope: Complex::new(-value * point.tanh / point.slowness, 0.0),
        }
    }
}
