//! Motions at constant tilt (e₁ = e₂; section 5.2 of the paper): regular precession, sleeping and hanging.
//!
//! At u = e the angular velocity is ω = ψ' r + φ' k, where A e φ'² - n φ' + p g = 0 and ψ' = ⟨ω, r⟩ - e φ'. Therefore
//!
//! ```text
//! φ' = √(pg/2A) [s₊ √(e₃ + 1) + s₋ √(e₃ - 1)]
//! α = α(0) e^{i(φ' + ψ')t/2},   β = β(0) e^{i(φ' - ψ')t/2}
//! ```
//!
//! Equal signs give the fast precession, different signs the slow one; at the same e and e₃ their product is pg/A.

use toytop::internal::ExtendedConstants;
use toytop::scalar::{Extended, Float, Ring};
use toytop::su2::{Orientation, OrientationRate};
use toytop::{AttitudeState, Complex, Motion, Regime, Signs};

/// Motion at constant tilt as a function of time.
///
/// Error of an orientation: below 1e-15 rad where u is exactly constant. An oscillation of the tilt of up to 2^-49
/// rad is neglected; it may add 1e-15 rad for every rad of the body's rotation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RegularPrecession {
    regime: Regime,
    /// Rates φ' and ψ', rad per unit time.
    rates: [f64; 2],
    stability: Stability,
    start: Orientation<f64>,
    /// Rates of arg α and arg β, rad per unit time.
    argument_rates: [Extended; 2],
}

/// Stability of a motion at constant tilt under a small push.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stability {
    /// Stable: u oscillates about its value with the angular frequency √(2 g (e₃ - e)/D(e)), D(e) = A/p + s (1 - e²).
    Stable {
        /// Angular frequency of small nutations, rad per unit time.
        frequency: f64,
    },
    /// Unstable: sleeping with n² < 4 A p g. The tilt grows like e^{λt} with λ = √(4 A p g - n²)/(2A).
    Unstable {
        /// Growth rate λ, per unit time.
        growth_rate: f64,
    },
    /// On the border, e₁ = e₂ = e₃ = 1, n² = 4 A p g: neither stable nor unstable to first order.
    Marginal,
}

impl RegularPrecession {
    /// Closed form of a motion; `None` unless u is constant (to 2^-49 rad of tilt), and for a body without torque, whose
    /// closed form is [`FreeBody`](crate::FreeBody).
    #[must_use]
    pub fn new(motion: &Motion) -> Option<Self> {
        let regime = motion.regime();
        if matches!(regime, Regime::Nutating | Regime::Aperiodic) || motion.top().is_torque_free() {
            return None;
        }
        let ExtendedConstants { a, s, p, g, e, integrals, .. } = motion.into();
        let falls = regime == Regime::SleepingUnstable;
        let zero = Extended::ZERO;
        let one = Extended::ONE;
        let swing = e.e2_minus_e1.halved();
        let one_minus_u = if falls { zero } else { e.one_minus_e2 + swing };
        let one_plus_u = if falls { one.doubled() } else { e.one_plus_e1 + swing };

        let sum = (one.doubled() + e.e3_minus_one).sqrt() + e.e3_minus_one.sqrt();
        let Signs { l_plus_n, l_minus_n } = motion.signs();
        // for different signs √(e₃ + 1) - √(e₃ - 1), without cancellation
        let roots = if l_plus_n == l_minus_n { sum } else { one.doubled() / sum };
        let precession = l_plus_n.times((p * g / a).halved().sqrt() * roots);
        let axial = integrals.spin;
        let u = if one_minus_u < one_plus_u { one - one_minus_u } else { one_plus_u - one };
        // φ' ± ψ' with ψ' = ⟨ω, r⟩ - u φ'
        let argument_rates =
            [precession * one_minus_u + axial, precession * one_plus_u - axial].map(Float::halved);

        let stability = if falls {
            // 4 A p g - n² = 2 A p g (1 - e₁)
            Stability::Unstable { growth_rate: (p * g * e.one_minus_e1() / a).halved().sqrt().to_f64() }
        } else if e.e3_minus_e2 > zero {
            let d = a / p + s * (one_minus_u * one_plus_u);
            Stability::Stable { frequency: (g.doubled() * e.e3_minus_e2 / d).sqrt().to_f64() }
        } else {
            Stability::Marginal
        };
        let rates = [precession, axial - u * precession].map(Float::to_f64);
        Some(Self {
            regime,
            rates,
            stability,
            start: motion.attitude_at_launch().orientation,
            argument_rates,
        })
    }

    /// Regime of the motion, one of those at constant tilt.
    #[must_use]
    pub fn regime(&self) -> Regime {
        self.regime
    }

    /// Rate φ' about the vertical and ψ' about the axis, rad per unit time; `None` where the two axes coincide.
    #[must_use]
    pub fn rates(&self) -> Option<[f64; 2]> {
        (!self.regime.is_vertical()).then_some(self.rates)
    }

    /// Stability under a small push.
    #[must_use]
    pub fn stability(&self) -> Stability {
        self.stability
    }

    /// Orientation Φ and rate Φ' at t.
    #[must_use]
    pub fn at(&self, t: f64) -> AttitudeState<f64> {
        let rotated = |z: Complex<f64>, rate: Extended| {
            let value = z * Complex::cis((rate * t.into()).radians_to_turns().to_phase());
            (value, value.times_i().scaled(rate.to_f64()))
        };
        let [alpha_argument_rate, beta_argument_rate] = self.argument_rates;
        let (alpha, alpha_rate) = rotated(self.start.alpha, alpha_argument_rate);
        let (beta, beta_rate) = rotated(self.start.beta, beta_argument_rate);
        let rate = OrientationRate { alpha: alpha_rate, beta: beta_rate };
        AttitudeState { orientation: Orientation { alpha, beta }, rate }
    }
}
