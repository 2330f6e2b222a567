//! Class of the tip curve, by the paper's criteria (section 4.2).

use crate::constants::{BranchPoints, Regime, Signs};
use crate::scalar::{Extended, Float, Ring};

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
    /// The curve passes through the centre once or twice a period: e₁ = -1 or e₂ = 1.
    ThroughOrigin,
    /// The curve of an aperiodic motion tends to the centre: a spiral, or for e₁ = -1 a straight line.
    Spiral,
    /// The tip stays at the centre, because the axis is vertical.
    Point,
}

impl TipClass {
    /// Class by Proposition 6 of the paper: with -1 < e₁ < e₂ < 1 < e₃ and different signs of l + n
    /// and l - n there are loops if e₃ (e₂ - e₁) > 1 - e₁e₂, and cusps if both sides are equal to the rounding of `f64`.
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
