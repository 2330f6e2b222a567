//! The curve of the tip as a function of the tilt (section 4), and where its angle turns back.
//!
//! c = 2sαβ = ρe^{iφ} with ρ = s√(1-u²) and, on the motion, φ' = (l - nu)/(A(1-u²)) (eqn:dphi), whatever C is. So the
//! angle turns where u = l/n, which the paper writes as (u+1)/(u-1) = w₋₁/w₊₁ (eqn:loopcondition): there are loops
//! exactly if l/n is in (e₁, e₂), cusps if it is e₂. That is the paper's criterion (1 - e₁e₂)/(e₂ - e₁) < e₃ in other
//! words, computed from other numbers; [`TipClass`] uses the paper's.

use crate::launch::{BranchPoints, Motion, Regime, TipClass};
use crate::real::Float;

/// The tip curve of a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TipCurve {
    regime: Regime,
    e: BranchPoints,
    scale: f64,
    /// (l + n)/(2A) and (l - n)/(2A), rad per unit time.
    rates: [f64; 2],
}

impl TipCurve {
    /// Of a motion.
    #[must_use]
    pub fn new(motion: &Motion) -> Self {
        let (top, integrals) = (motion.top(), motion.first_integrals());
        let per_a = 0.5 / top.a();
        Self {
            regime: motion.regime(),
            e: motion.branch_points(),
            scale: top.tip_scale(),
            rates: [integrals.l_plus_n * per_a, integrals.l_minus_n * per_a],
        }
    }

    /// ρ = s√(1 - u²), m (without unit for a fixed tip), for u in [-1, 1].
    #[must_use]
    pub fn rho(&self, u: f64) -> f64 {
        self.scale * Float::sqrt((1.0 - u) * (1.0 + u))
    }

    /// The radii of the circles that the curve lies between and touches: ρ at e₁ and at e₂, m. Where u passes through
    /// 0 in between, both are inner and the outer is s.
    #[must_use]
    pub fn bounding_circles(&self) -> [f64; 2] {
        let BranchPoints { one_plus_e1, one_minus_e2, e2_minus_e1, .. } = self.e;
        let radius = |above: f64, below: f64| self.scale * Float::sqrt(above * below);
        [radius(one_plus_e1, one_minus_e2 + e2_minus_e1), radius(one_plus_e1 + e2_minus_e1, one_minus_e2)]
    }

    /// φ' = ((l+n)/(1+u) + (l-n)/(1-u))/(2A) at a tilt, rad per unit time. A term whose momentum is 0 stays 0 at the
    /// vertical too, where the other is all there is.
    #[must_use]
    pub fn rate(&self, u: f64) -> f64 {
        let [plus, minus] = self.rates;
        let part = |rate: f64, distance: f64| if rate == 0.0 { 0.0 } else { rate / distance };
        part(plus, 1.0 + u) + part(minus, 1.0 - u)
    }

    /// dφ/du = φ'/u' at a tilt with the given u', rad.
    #[must_use]
    pub fn slope(&self, u: f64, udot: f64) -> f64 {
        self.rate(u) / udot
    }

    /// l/n: where the angle would turn if the motion got there. `None` for n = 0.
    #[must_use]
    pub fn turning_height(&self) -> Option<f64> {
        let [plus, minus] = self.rates;
        let twice_n = plus - minus;
        (twice_n != 0.0).then(|| (plus + minus) / twice_n)
    }

    /// A(1-u²)φ' = l - nu in units of its own terms at the two turning points, without cancellation but its own:
    /// ((l+n)(1-u) + (l-n)(1+u))/2 over the sum of the moduli.
    fn turning_signs(&self) -> [f64; 2] {
        let BranchPoints { one_plus_e1, one_minus_e2, e2_minus_e1, .. } = self.e;
        let [plus, minus] = self.rates;
        let relative = |below: f64, above: f64| {
            let (first, second) = (plus * below, minus * above);
            let size = Float::abs(first) + Float::abs(second);
            if size == 0.0 { 0.0 } else { (first + second) / size }
        };
        [relative(one_minus_e2 + e2_minus_e1, one_plus_e1), relative(one_minus_e2, one_plus_e1 + e2_minus_e1)]
    }

    /// The class by l/n: loops if φ' has different signs at u = e₁ and u = e₂, a cusp if it vanishes at e₂ to
    /// rounding. Agrees with [`Motion::tip_class`], which goes by e₃, wherever that is not a matter of rounding.
    #[must_use]
    pub fn class(&self) -> TipClass {
        const ROUNDING: f64 = 16.0 * f64::EPSILON;
        let BranchPoints { one_plus_e1, one_minus_e2, .. } = self.e;
        match self.regime {
            Regime::Aperiodic => TipClass::Spiral,
            Regime::RegularPrecession(_) => TipClass::Circle,
            regime if regime.is_vertical() => TipClass::Point,
            _ if one_plus_e1 == 0.0 || one_minus_e2 == 0.0 => TipClass::ThroughOrigin,
            _ => {
                let [low, high] = self.turning_signs();
                if Float::abs(high) <= ROUNDING {
                    TipClass::Cusp
                } else if low * high < 0.0 {
                    TipClass::Loops
                } else {
                    TipClass::Smooth
                }
            }
        }
    }
}

/// The paper's condition: e₃ (e₂ - e₁) - (1 - e₁e₂), above 0 for loops where w₊₁ and w₋₁ have different signs.
///
/// 1 - e₁e₂ = (1-e₂)(1+e₁) + (e₂-e₁), so the value is (e₃-1)(e₂-e₁) - (1-e₂)(1+e₁), without cancellation in the terms.
#[must_use]
pub fn loop_margin(e: &BranchPoints) -> f64 {
    e.e3_minus_one * e.e2_minus_e1 - e.one_minus_e2 * e.one_plus_e1
}
