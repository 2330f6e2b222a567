//! Curve of the tip as a function of the tilt (section 4), and the points where its angle changes direction.
//!
//! c = 2sαβ = ρe^{iφ} with ρ = s√(1-u²) and, on the motion, φ' = (l - nu)/(A(1-u²)) (equation (4.1) of the paper) for
//! any C. The angle therefore changes direction where u = l/n, which the paper writes as (u+1)/(u-1) = w₋₁/w₊₁
//! (equation (4.2)): there are loops exactly if l/n is in (e₁, e₂), and cusps if it is e₂. This is equivalent to the
//! paper's criterion (1 - e₁e₂)/(e₂ - e₁) < e₃, which [`TipClass`] uses, but is computed from other numbers.

use crate::constants::{BranchPoints, Regime, TipClass};
use crate::motion::Motion;
use crate::scalar::Float;

/// Tip curve of a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TipCurve {
    regime: Regime,
    e: BranchPoints,
    scale: f64,
    /// Rates (l + n)/(2A) and (l - n)/(2A), rad per unit time.
    rates: [f64; 2],
}

impl TipCurve {
    /// Tip curve of a motion.
    #[must_use]
    pub fn new(motion: &Motion) -> Self {
        let (top, integrals) = (motion.top(), motion.first_integrals());
        let per_a = 0.5 / top.transverse_inertia();
        Self {
            regime: motion.regime(),
            e: motion.branch_points(),
            scale: top.tip_scale(),
            rates: [integrals.l_plus_n * per_a, integrals.l_minus_n * per_a],
        }
    }

    /// Radius ρ = s√(1 - u²), m (without unit for a fixed tip), for u in [-1, 1].
    #[must_use]
    pub fn rho(&self, u: f64) -> f64 {
        self.scale * Float::sqrt((1.0 - u) * (1.0 + u))
    }

    /// Radii of the bounding circles: ρ at e₁ and at e₂, m. Where u passes through 0 between them, both are inner
    /// circles and the outer radius is s.
    #[must_use]
    pub fn bounding_circles(&self) -> [f64; 2] {
        let BranchPoints { one_plus_e1, one_minus_e2, e2_minus_e1, .. } = self.e;
        let radius = |above: f64, below: f64| self.scale * Float::sqrt(above * below);
        [radius(one_plus_e1, one_minus_e2 + e2_minus_e1), radius(one_plus_e1 + e2_minus_e1, one_minus_e2)]
    }

    /// Rate φ' = ((l+n)/(1+u) + (l-n)/(1-u))/(2A) of the tip angle at a tilt, rad per unit time. A term whose
    /// momentum is 0 is 0, also at the vertical.
    #[must_use]
    pub fn rate(&self, u: f64) -> f64 {
        let [plus, minus] = self.rates;
        let part = |rate: f64, distance: f64| if rate == 0.0 { 0.0 } else { rate / distance };
        part(plus, 1.0 + u) + part(minus, 1.0 - u)
    }

    /// Slope dφ/du = φ'/u' at a tilt with the given u', rad.
    #[must_use]
    pub fn slope(&self, u: f64, udot: f64) -> f64 {
        self.rate(u) / udot
    }

    /// Height u = l/n at which the angle would change direction; `None` for n = 0.
    #[must_use]
    pub fn turning_height(&self) -> Option<f64> {
        let [plus, minus] = self.rates;
        let twice_n = plus - minus;
        (twice_n != 0.0).then(|| (plus + minus) / twice_n)
    }

    /// A(1-u²)φ' = l - nu at the two turning points, relative to the magnitude of its terms: ((l+n)(1-u) +
    /// (l-n)(1+u))/2 over the sum of their moduli.
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

    /// Class of the curve by l/n: loops if φ' has different signs at u = e₁ and u = e₂, cusps if it is 0 at e₂ to
    /// rounding. It agrees with [`Motion::tip_class`], which uses e₃, unless the two differ by rounding only.
    #[must_use]
    pub fn class(&self) -> TipClass {
        const ROUNDING: f64 = 16.0 * f64::EPSILON;
        let BranchPoints { one_plus_e1, one_minus_e2, .. } = self.e;
        match self.regime {
            Regime::Aperiodic => TipClass::Spiral,
            Regime::SlowPrecession | Regime::FastPrecession => TipClass::Circle,
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

/// Margin of the paper's condition, e₃ (e₂ - e₁) - (1 - e₁e₂): positive for loops where w₊₁ and w₋₁ have different
/// signs.
///
/// Since 1 - e₁e₂ = (1-e₂)(1+e₁) + (e₂-e₁), the value is (e₃-1)(e₂-e₁) - (1-e₂)(1+e₁), whose terms have no
/// cancellation.
#[must_use]
pub fn loop_margin(e: &BranchPoints) -> f64 {
    e.e3_minus_one * e.e2_minus_e1 - e.one_minus_e2 * e.one_plus_e1
}
