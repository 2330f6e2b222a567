//! The closed form of a motion, whichever applies.

use super::{Aperiodic, E3EqualsE4, Lagrange, RegularPrecession};
use crate::launch::Motion;
use crate::tick::Pose;
use crate::turns::Turns;
use core::fmt;

/// A motion that elementary or elliptic functions express.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ClosedForm {
    /// e₁ = e₂, or upright: trigonometric functions.
    RegularPrecession(RegularPrecession),
    /// e₂ = e₃ = 1: Weierstrass functions for a sliding tip, elementary ones for a fixed one.
    Aperiodic(Aperiodic),
    /// e₃ = e₄: Weierstrass functions.
    E3EqualsE4(E3EqualsE4),
    /// A fixed tip: Weierstrass functions.
    Lagrange(Lagrange),
}

/// No closed form: the motion needs hyperelliptic integrals.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NoClosedForm {
    /// e₃ of the motion.
    pub e3: f64,
    /// e₄ of the top, which e₃ would have to equal.
    pub e4: f64,
}

impl fmt::Display for NoClosedForm {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { e3, e4 } = self;
        write!(
            f,
            "no closed form: a sliding tip has one only at constant tilt, for e2 = e3 = 1, or for e3 = e4, \
             and here e3 = {e3:.16}, e4 = {e4:.16}"
        )
    }
}

impl core::error::Error for NoClosedForm {}

impl ClosedForm {
    /// The closed form of a motion.
    ///
    /// # Errors
    /// None exists: a nutating toy top whose e₃ is not e₄.
    pub fn of(motion: &Motion) -> Result<Self, NoClosedForm> {
        let steady = || RegularPrecession::new(motion).map(Self::RegularPrecession);
        let rising = || Aperiodic::new(motion).map(Self::Aperiodic);
        let held = || Lagrange::new(motion).map(Self::Lagrange);
        let sliding = || E3EqualsE4::new(motion).map(Self::E3EqualsE4);
        let refusal =
            || NoClosedForm { e3: motion.branch_points().e3, e4: motion.top().e4().unwrap_or(f64::INFINITY) };
        steady().or_else(rising).or_else(held).or_else(sliding).ok_or_else(refusal)
    }

    /// Φ and Φ' at t. A t that is not finite counts as 0.
    #[must_use]
    pub fn at(&self, t: f64) -> Pose<f64> {
        match self {
            Self::RegularPrecession(form) => form.at(t),
            Self::Aperiodic(form) => form.at(t),
            Self::E3EqualsE4(form) => form.at(t),
            Self::Lagrange(form) => form.at(t),
        }
    }

    /// The nutation phase of a motion that nutates, whole periods since some origin included: 0 at u = e₁, half a turn at
    /// u = e₂.
    #[must_use]
    pub fn nutation_phase(&self, t: f64) -> Option<Turns> {
        match self {
            Self::RegularPrecession(_) | Self::Aperiodic(_) => None,
            Self::E3EqualsE4(form) => Some(form.nutation_phase(t)),
            Self::Lagrange(form) => Some(form.nutation_phase(t)),
        }
    }
}
