//! Closed form of a motion, of whichever kind applies.

use crate::aperiodic::Aperiodic;
use crate::elliptic_nutation::{EllipticNutation, e3_minus_e4};
use crate::free_body::FreeBody;
use crate::regular_precession::RegularPrecession;
use core::fmt;
use toytop::{AttitudeState, Motion, Phase, Support};

/// Motion that elementary or elliptic functions express.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(clippy::large_enum_variant)] // without allocation the largest cannot be boxed
pub enum ClosedForm {
    /// Trigonometric functions: no torque acts.
    FreeBody(FreeBody),
    /// Trigonometric functions: e₁ = e₂, or the axis is upright.
    RegularPrecession(RegularPrecession),
    /// Weierstrass functions for a sliding tip, elementary functions for a fixed one: e₂ = e₃ = 1.
    Aperiodic(Aperiodic),
    /// Weierstrass functions: e₃ = e₄.
    E3EqualsE4(EllipticNutation),
    /// Weierstrass functions: the tip is fixed.
    Lagrange(EllipticNutation),
}

/// Error of [`ClosedForm::from_motion`]: the motion needs hyperelliptic functions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NoClosedForm {
    /// Branch point e₃ of the motion.
    pub e3: f64,
    /// Branch point e₄ of the top, which e₃ would have to equal.
    pub e4: f64,
    /// Difference e₃ - e₄ with full relative precision. It is compared with e₃ - 1 and e₃ - e₂, which may be small
    /// too.
    pub e3_minus_e4: f64,
}

impl fmt::Display for NoClosedForm {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { e3, e4, e3_minus_e4 } = self;
        write!(
            f,
            "no closed form: a sliding tip has one only at constant tilt, for e2 = e3 = 1, or for e3 = e4, \
             and here e3 = {e3:.16}, e4 = {e4:.16}, e3 - e4 = {e3_minus_e4:.1e}"
        )
    }
}

impl core::error::Error for NoClosedForm {}

impl ClosedForm {
    /// Closed form of a motion.
    ///
    /// # Errors
    /// [`NoClosedForm`]: the motion is a nutating toy top with e₃ ≠ e₄.
    pub fn from_motion(motion: &Motion) -> Result<Self, NoClosedForm> {
        let is_sliding = motion.top().support() == Support::Sliding;
        let elliptic = if is_sliding { Self::E3EqualsE4 } else { Self::Lagrange };
        FreeBody::new(motion)
            .map(Self::FreeBody)
            .or_else(|| RegularPrecession::new(motion).map(Self::RegularPrecession))
            .or_else(|| Aperiodic::new(motion).map(Self::Aperiodic))
            .or_else(|| EllipticNutation::new(motion).map(elliptic))
            .ok_or_else(|| NoClosedForm {
                e3: motion.branch_points().e3,
                e4: motion.top().e4().unwrap_or(f64::INFINITY),
                e3_minus_e4: e3_minus_e4(motion),
            })
    }

    /// Orientation Φ and rate Φ' at t. A t that is not finite counts as 0.
    #[must_use]
    pub fn at(&self, t: f64) -> AttitudeState<f64> {
        match self {
            Self::FreeBody(form) => form.at(t),
            Self::RegularPrecession(form) => form.at(t),
            Self::Aperiodic(form) => form.at(t),
            Self::E3EqualsE4(form) | Self::Lagrange(form) => form.at(t),
        }
    }

    /// Nutation phase, whole periods included: 0 at u = e₁, half a turn at u = e₂. `None` unless the motion nutates.
    #[must_use]
    pub fn nutation_phase(&self, t: f64) -> Option<Phase> {
        match self {
            Self::FreeBody(form) => form.nutation_phase(t),
            Self::RegularPrecession(_) | Self::Aperiodic(_) => None,
            Self::E3EqualsE4(form) | Self::Lagrange(form) => Some(form.nutation_phase(t)),
        }
    }
}
