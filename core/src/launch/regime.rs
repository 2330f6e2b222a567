//! Which kind of motion it is, and which kind of curve its tip draws: decided once, by the paper's criteria.

use super::{BranchPoints, Signs};
use crate::real::{DoubleDouble, Float, Ring};

/// The two regular precessions with the same e₁ = e₂ and e₃.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Pace {
    /// |l| < |n|: the slow one, which a toy top shows.
    Slow,
    /// |l| >= |n|: the fast one.
    Fast,
}

/// The kind of motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Regime {
    /// e₁ < e₂ and e₂ < e₃: u swings between e₁ and e₂.
    Nutating,
    /// e₁ = e₂ within ±1: u constant. The tilt may swing by less than 2^-49 rad, which is what the rounding of a state does.
    RegularPrecession(Pace),
    /// e₁ = e₂ = 1: upright, and a push only makes it nutate a little.
    SleepingStable,
    /// e₂ = e₃ = 1 and u = 1: upright, but any push makes it fall.
    SleepingUnstable,
    /// e₁ = e₂ = -1: the centre of mass straight below the tip's plane.
    Hanging,
    /// e₂ = e₃ = 1 and u < 1: rises to the vertical in infinite time.
    Aperiodic,
}

impl Regime {
    /// The regime of exact branch points; `upright` says whether an e₂ = e₃ = 1 motion stands at u = 1.
    pub(super) fn of(e: &BranchPoints<DoubleDouble>, signs: Signs, upright: bool) -> Self {
        let zero = DoubleDouble::ZERO;
        if !swings(e) {
            if e.one_minus_e2 == zero {
                Self::SleepingStable
            } else if e.one_plus_e1 == zero {
                Self::Hanging
            } else {
                let fast = signs.l_plus_n == signs.l_minus_n;
                Self::RegularPrecession(if fast { Pace::Fast } else { Pace::Slow })
            }
        } else if e.e3_minus_e2 == zero {
            if upright { Self::SleepingUnstable } else { Self::Aperiodic }
        } else {
            Self::Nutating
        }
    }

    /// Whether the axis is vertical for ever: then the tip angle does not exist.
    #[must_use]
    pub fn is_vertical(&self) -> bool {
        matches!(self, Self::SleepingStable | Self::SleepingUnstable | Self::Hanging)
    }
}

/// Whether the tilt swings enough to be seen. Through the vertical any swing is a motion.
fn swings(e: &BranchPoints<DoubleDouble>) -> bool {
    const STILL: f64 = 1.0 / (1_u64 << 49) as f64;
    let zero = DoubleDouble::ZERO;
    let passes_vertical = e.one_minus_e2 == zero || e.one_plus_e1 == zero;
    let sine_squared = e.one_minus_e1() * e.one_plus_e2();
    let visible = e.e2_minus_e1.squared() > DoubleDouble::from(STILL * STILL) * sine_squared;
    e.e2_minus_e1 > zero && (visible || passes_vertical)
}

/// The kind of curve that the tip draws between its two bounding circles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum TipClass {
    /// The tip angle is monotone and the curve has no corner.
    Smooth,
    /// Cusps on the circle of e₂.
    Cusp,
    /// Loops: the tip angle runs back around u = e₂.
    Loops,
    /// Regular precession.
    Circle,
    /// e₁ = -1 or e₂ = 1: through the centre, once or twice a period.
    ThroughOrigin,
    /// Aperiodic: into the centre. In a plane (e₁ = -1) without a turn, and once through it before.
    Spiral,
    /// The axis is vertical: the tip rests at the centre.
    Point,
}

impl TipClass {
    /// By the paper's proposition on the tip: with -1 < e₁ < e₂ < 1 < e₃ and l ± n of different signs there are loops
    /// exactly if e₃ (e₂ - e₁) > 1 - e₁e₂, cusps if equal; otherwise the curve is smooth.
    ///
    /// Equality is judged to what the rounding of three `f64` can do to it: a top let go at rest has cusps.
    pub(super) fn of(regime: Regime, e: &BranchPoints<DoubleDouble>, signs: Signs) -> Self {
        let zero = DoubleDouble::ZERO;
        match regime {
            Regime::Aperiodic => Self::Spiral,
            Regime::RegularPrecession(_) => Self::Circle,
            regime if regime.is_vertical() => Self::Point,
            _ if e.one_plus_e1 == zero || e.one_minus_e2 == zero => Self::ThroughOrigin,
            _ if e.e3_minus_one == zero || signs.l_plus_n == signs.l_minus_n => Self::Smooth,
            _ => {
                let margin = e.e3 * e.e2_minus_e1 - (DoubleDouble::ONE - e.e1 * e.e2);
                let rounding = e.e3 * (e.e1.abs() + e.e2.abs()) + DoubleDouble::ONE + (e.e1 * e.e2).abs();
                let noise = rounding * DoubleDouble::from(16.0 * f64::EPSILON);
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
