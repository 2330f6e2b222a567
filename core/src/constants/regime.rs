//! Kind of a motion and of its tip curve (paper, section 4.2).
//!
//! A regular precession whose state is rounded to `f64` nutates, mostly by less than 2^-49 rad. Its [`Regime`] is that of a precession
//! (`nutates_beyond_rounding`), but its motion is computed with the nutation (`is_steady`): without it the error would be up to 7e-13 rad for
//! A/(ps) = 1e-5.

use crate::constants::{BranchPoints, Signs};
use crate::scalar::{Extended, Float, Ring};

/// Kind of motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Regime {
    /// e₁ < e₂ < e₃: u oscillates between e₁ and e₂.
    Nutating,
    /// -1 < e₁ = e₂ < 1 and |l| < |n|: the slower of a fast top's two regular precessions. A nutation below 2^-49 rad, the rounding
    /// of a state, counts as none.
    SlowPrecession,
    /// -1 < e₁ = e₂ < 1 and |l| >= |n|: the faster of a fast top's two regular precessions.
    FastPrecession,
    /// e₁ = e₂ = 1: the axis is upright, and a small push causes a small nutation, except where e₃ = 1 as well.
    SleepingStable,
    /// e₂ = e₃ = 1 and u = 1: the axis is upright, and any push makes the top fall.
    SleepingUnstable,
    /// e₁ = e₂ = -1: the centre of mass is straight below the tip.
    Hanging,
    /// e₂ = e₃ = 1 and u < 1: the axis leaves the vertical and returns to it, in infinite time.
    Aperiodic,
}

impl Regime {
    /// Regime of branch points; `upright` tells whether a motion with e₂ = e₃ = 1 has u = 1.
    pub(crate) fn new(e: &BranchPoints<Extended>, signs: Signs, upright: bool) -> Self {
        let zero = Extended::ZERO;
        if !nutates_beyond_rounding(e) {
            if e.one_minus_e2 == zero {
                Self::SleepingStable
            } else if e.one_plus_e1 == zero {
                Self::Hanging
            } else {
                // e₃ = 1 means l = n, where the sign of l - n does not count
                let fast = signs.l_plus_n == signs.l_minus_n || e.e3_minus_one == zero;
                if fast { Self::FastPrecession } else { Self::SlowPrecession }
            }
        } else if e.e3_minus_e2 == zero {
            if upright { Self::SleepingUnstable } else { Self::Aperiodic }
        } else {
            Self::Nutating
        }
    }

    /// Whether the tilt is constant, to 2^-49 rad, and the axis is not vertical.
    pub fn is_regular_precession(&self) -> bool {
        matches!(self, Self::SlowPrecession | Self::FastPrecession)
    }

    /// Whether the axis stays vertical, so that the tip angle does not exist.
    pub fn is_vertical(&self) -> bool {
        matches!(self, Self::SleepingStable | Self::SleepingUnstable | Self::Hanging)
    }
}

/// Whether u is constant to the last bit. Such a motion has no half phase.
pub(crate) fn is_steady(e: &BranchPoints<Extended>, regime: Regime) -> bool {
    e.e2_minus_e1 == Extended::ZERO || regime == Regime::SleepingUnstable
}

/// Whether the nutation is larger than the rounding of a state, or passes through the vertical.
fn nutates_beyond_rounding(e: &BranchPoints<Extended>) -> bool {
    /// Least change of the tilt beyond the rounding of a state, rad: 2^-49.
    const MIN_SWING: f64 = 1.0 / (1_u64 << 49) as f64;
    let zero = Extended::ZERO;
    let passes_vertical = e.one_minus_e2 == zero || e.one_plus_e1 == zero;
    let sine_squared = e.one_minus_e1() * e.one_plus_e2();
    let visible = e.e2_minus_e1.squared() > Extended::from(MIN_SWING * MIN_SWING) * sine_squared;
    e.e2_minus_e1 > zero && (visible || passes_vertical)
}

/// Class of the curve that the tip draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum TipClass {
    /// The tip angle is monotone in time and the curve has no corner.
    Smooth,
    /// The curve has cusps on the bounding circle of e₂.
    Cusp,
    /// The curve has loops: the tip angle changes direction near u = e₂.
    Loops,
    /// The curve is a circle: regular precession.
    Circle,
    /// The curve passes through the centre: e₁ = -1 or e₂ = 1.
    ThroughOrigin,
    /// The curve of an aperiodic motion: a spiral to the centre, or for e₁ = -1 a straight line.
    Spiral,
    /// The tip stays at the centre.
    Point,
}

impl TipClass {
    /// Class by Proposition 6: with -1 < e₁ < e₂ < 1 < e₃ and different signs there are loops if e₃ (e₂ - e₁) > 1 - e₁e₂, and cusps if both are
    /// equal within 16 `f64` roundings of their terms.
    pub(crate) fn new(regime: Regime, e: &BranchPoints<Extended>, signs: Signs) -> Self {
        let zero = Extended::ZERO;
        match regime {
            Regime::Aperiodic => Self::Spiral,
            Regime::SlowPrecession | Regime::FastPrecession => Self::Circle,
            regime if regime.is_vertical() => Self::Point,
            _ if e.one_plus_e1 == zero || e.one_minus_e2 == zero => Self::ThroughOrigin,
            _ if e.e3_minus_one == zero || signs.l_plus_n == signs.l_minus_n => Self::Smooth,
            // without torque φ' changes its sign where |l| < |n|
            _ if !e.e3.to_f64().is_finite() => Self::Loops,
            _ => {
                let margin = e.e3 * e.e2_minus_e1 - (Extended::ONE - e.e1 * e.e2);
                let rounding = e.e3 * (e.e1.abs() + e.e2.abs()) + Extended::ONE + (e.e1 * e.e2).abs();
                let noise = rounding * Extended::from(16.0 * f64::EPSILON);
                if margin.abs() <= noise {
                    Self::Cusp
                } else if margin > zero {
                    Self::Loops
                } else {
                    Self::Smooth
                }
            }
        }
    }
}
