//! Motions at constant tilt: regular precession, sleep, hanging (e₁ = e₂; section 5.2 of the paper), and how to find them.
//!
//! At u = e the body turns with ω = ψ' r + φ' k, where A e φ'² - n φ' + p g = 0 and ψ' = n/C - e φ'; so
//!
//! ```text
//! φ' = √(pg/2A) [s₊ √(e₃ + 1) + s₋ √(e₃ - 1)]
//! α = α(0) e^{i(φ' + ψ')t/2},   β = β(0) e^{i(φ' - ψ')t/2}
//! ```
//!
//! Equal signs give the fast precession, unequal ones the slow; at the same e and e₃ their product is pg/A.

use crate::complex::Complex;
use crate::error::{LaunchError, finite, require};
use crate::launch::{Motion, Regime, Signs};
use crate::real::Float;
use crate::su2::{Phi, PhiRate};
use crate::tick::{Pose, Stepper};
use crate::top::Top;
use crate::turns::Rate;

/// A motion at constant tilt as a function of time.
///
/// Error of an orientation: 1e-14 rad, and 1e-15 rad more for every rad that the body turns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RegularPrecession {
    regime: Regime,
    /// φ', ψ'.
    rates: [f64; 2],
    stability: Stability,
    start: Phi<f64>,
    /// Rates of arg α and arg β, rad per unit time.
    turning: [f64; 2],
}

/// What a small push does to a motion at constant tilt.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stability {
    /// u swings about its value with √(2 g (e₃ - e)/D(e)), D(e) = A/p + s (1 - e²).
    Stable {
        /// The frequency of small nutations, rad per unit time.
        frequency: f64,
    },
    /// Sleeping too slowly, n² < 4 A p g: the tilt grows like e^{λt} with λ = √(4 A p g - n²)/(2A).
    Unstable {
        /// λ, per unit time.
        growth_rate: f64,
    },
    /// e₁ = e₂ = e₃ = 1, n² = 4 A p g: neither, to first order.
    Marginal,
}

impl RegularPrecession {
    /// The closed form of a motion; `None` unless u is constant (to 2^-49 rad of tilt).
    #[must_use]
    pub fn new(motion: &Motion) -> Option<Self> {
        let regime = motion.regime();
        if matches!(regime, Regime::Nutating | Regime::Aperiodic) {
            return None;
        }
        let (top, e) = (motion.top(), motion.branch_points());
        let falls = regime == Regime::SleepingUnstable;
        let one_minus_u = if falls { 0.0 } else { e.one_minus_e2 + 0.5 * e.e2_minus_e1 };
        let one_plus_u = if falls { 2.0 } else { e.one_plus_e1 + 0.5 * e.e2_minus_e1 };

        let precession = precession_of(top, e.e3_minus_one, motion.signs());
        let axial = motion.first_integrals().n / top.c();
        let u = if one_minus_u < one_plus_u { 1.0 - one_minus_u } else { one_plus_u - 1.0 };
        // φ' ± ψ' with ψ' = n/C - u φ'
        let turning =
            [precession * one_minus_u + axial, precession * one_plus_u - axial].map(|rate| 0.5 * rate);

        let (a, p, g) = (top.a(), top.p(), top.g());
        let stability = if falls {
            // 4 A p g - n² = 2 A p g (1 - e₁)
            Stability::Unstable { growth_rate: Float::sqrt(0.5 * p * g * e.one_minus_e1() / a) }
        } else if e.e3_minus_e2 > 0.0 {
            let d = a / p + top.s() * one_minus_u * one_plus_u;
            Stability::Stable { frequency: Float::sqrt(2.0 * g * e.e3_minus_e2 / d) }
        } else {
            Stability::Marginal
        };
        let rates = [precession, axial - u * precession];
        Some(Self { regime, rates, stability, start: Stepper::<f64>::new(motion).phi(), turning })
    }

    /// Which of the motions at constant tilt.
    #[must_use]
    pub fn regime(&self) -> Regime {
        self.regime
    }

    /// φ' about the vertical and ψ' about the axis, rad per unit time; `None` where the two are one.
    #[must_use]
    pub fn rates(&self) -> Option<[f64; 2]> {
        (!self.regime.is_vertical()).then_some(self.rates)
    }

    /// What a small push does.
    #[must_use]
    pub fn stability(&self) -> Stability {
        self.stability
    }

    /// Φ and Φ' at t.
    #[must_use]
    pub fn at(&self, t: f64) -> Pose<f64> {
        let turned = |z: Complex<f64>, rate: f64| {
            let turns = Rate::new(rate * (0.5 * core::f64::consts::FRAC_1_PI), 0.0).over(t);
            let value = z * Complex::cis(turns);
            (value, value.times_i().scaled(rate))
        };
        let [alpha_rate, beta_rate] = self.turning;
        let (alpha, beta) = (turned(self.start.alpha, alpha_rate), turned(self.start.beta, beta_rate));
        Pose { phi: Phi { alpha: alpha.0, beta: beta.0 }, rate: PhiRate { alpha: alpha.1, beta: beta.1 } }
    }
}

/// φ' = √(pg/2A) [s₊ √(e₃ + 1) + s₋ √(e₃ - 1)]; with unequal signs 2/(√(e₃ + 1) + √(e₃ - 1)) for the difference.
fn precession_of(top: &Top, e3_minus_one: f64, signs: Signs) -> f64 {
    let scale = Float::sqrt(0.5 * top.p() * top.g() / top.a());
    let sum = Float::sqrt(2.0 + e3_minus_one) + Float::sqrt(e3_minus_one);
    let pace = if signs.l_plus_n == signs.l_minus_n { sum } else { 2.0 / sum };
    signs.l_plus_n.times(scale * pace)
}

/// The steady precessions of a top at one tilt and one spin: the roots of A e φ'² - n φ' + p g = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SteadyPrecession {
    /// None: above the horizontal the top spins too slowly, or the axis is horizontal and it does not spin at all.
    None {
        /// The least |spin| at which there is one, √(4 A e p g)/C, rad per unit time; 0 for a horizontal axis, where any
        /// spin but 0 will do.
        least_spin: f64,
    },
    /// One: the axis is horizontal, φ' = p g/n, or the spin is exactly the least.
    One {
        /// φ', rad per unit time.
        rate: f64,
    },
    /// Two. Below the horizontal they go round in opposite senses.
    Two {
        /// The φ' of smaller size: a fast top's p g/n, nearly.
        slow: f64,
        /// The φ' of larger size: a fast top's n/(A e), nearly.
        fast: f64,
    },
}

impl SteadyPrecession {
    /// Of a top, from its tilt (rad from the upward vertical, strictly between 0 and π) and its spin ω·r = n/C.
    ///
    /// Release it with this tilt and spin, the φ' found as `precession`, and no nutation: the tilt stays. Error: a few
    /// roundings of each rate, but for the one that the difference from the least spin has.
    ///
    /// ```
    /// use toytop::{Heaviness, Top, exact::SteadyPrecession};
    /// let top = Top::sliding(3.0e-5, 2.0e-5, 0.03, Heaviness::Mass(0.05), 9.81)?;
    /// let SteadyPrecession::Two { slow, fast } = SteadyPrecession::new(&top, 0.5, 150.0)? else { panic!() };
    /// assert!(slow > 5.0 && slow < 9.0 && fast > 90.0);
    /// let SteadyPrecession::None { least_spin } = SteadyPrecession::new(&top, 0.5, 50.0)? else { panic!() };
    /// assert!(least_spin > 60.0);
    /// # Ok::<(), toytop::LaunchError>(())
    /// ```
    ///
    /// # Errors
    /// `tilt`: not strictly between 0 and π; `spin`: above 1e11 in size; either not finite.
    pub fn new(top: &Top, tilt: f64, spin: f64) -> Result<Self, LaunchError> {
        finite("tilt", tilt)?;
        finite("spin", spin)?;
        require(tilt > 0.0 && tilt < core::f64::consts::PI, "tilt", "strictly between 0 and pi")?;
        require(Float::abs(spin) <= 1e11, "spin", "at most 1e11 rad/s")?;
        let (a, n) = (top.a(), top.c() * spin);
        let weight = top.p() * top.g();
        // the f64 nearest to π/2 means a horizontal axis
        let e = if tilt == core::f64::consts::FRAC_PI_2 { 0.0 } else { libm::cos(tilt) };
        let least = Float::sqrt(4.0 * a * e * weight);
        let above_least = Float::abs(n) - least;
        if e >= 0.0 && (above_least < 0.0 || n == 0.0) {
            return Ok(Self::None { least_spin: least / top.c() });
        }
        let root = if e > 0.0 {
            Float::sqrt(above_least * (Float::abs(n) + least))
        } else {
            Float::sqrt(n * n - 4.0 * a * e * weight)
        };
        let half_sum = libm::copysign(0.5 * (Float::abs(n) + root), n);
        let slow = weight / half_sum;
        if e == 0.0 || root == 0.0 {
            return Ok(Self::One { rate: slow });
        }
        Ok(Self::Two { slow, fast: half_sum / (a * e) })
    }
}
