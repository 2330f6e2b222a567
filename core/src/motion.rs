//! Motion of one launch: its kind, its constants, and its phases at t = 0.

pub(crate) mod phase_equations;

pub(crate) mod ellipses;

pub(crate) mod period;

pub(crate) mod normal_force;

mod launch_rounding;

mod half_phase;

mod launch;

pub(crate) mod internals;

pub use launch::InitialAngles;
pub(crate) use launch_rounding::LaunchRounding;

use crate::body::{Support, Top};
use crate::complex::Complex;
use crate::constants::{BranchPoints, FirstIntegrals, Regime, Signs, TipClass};
use crate::motion::ellipses::Ellipses;
use crate::motion::period::{Period, PeriodAdvance};
use crate::motion::phase_equations::{PhaseEquations, PhaseRates};
use crate::phase::Phase;
use crate::scalar::{Extended, Float, Ring};
use crate::su2::AttitudeState;

/// Motion of one launch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion {
    top: Top,
    signs: Signs,
    pub(crate) branch_points: BranchPoints<Extended>,
    pub(crate) integrals: FirstIntegrals<Extended>,
    /// Half of τ = ⟨ω, r⟩ - n/A, rad/s.
    pub(crate) half_tau: Extended,
    pub(crate) ellipses: Ellipses<f64>,
    regime: Regime,
    /// Half phase χ at t = 0; `None` for a steady motion.
    pub(crate) half_phase: Option<Phase>,
    /// Slow phases of α and β at t = 0.
    pub(crate) slow_phases: [Phase; 2],
    pub(crate) rounding: LaunchRounding,
    /// Rate χ' without torque, rad/s; otherwise 0.
    torque_free_rate: Extended,
}

impl Motion {
    /// Top of the motion.
    pub fn top(&self) -> &Top {
        &self.top
    }

    /// Kind of motion.
    pub fn regime(&self) -> Regime {
        self.regime
    }

    /// Class of the curve that the tip draws.
    pub fn tip_class(&self) -> TipClass {
        TipClass::new(self.regime, &self.branch_points, self.signs)
    }

    /// First integrals l, n and h, and numbers that follow from them.
    pub fn first_integrals(&self) -> FirstIntegrals {
        self.integrals.map(Float::to_f64)
    }

    /// Branch points e₁, e₂, e₃ and their differences, each with the relative error of one `f64` rounding.
    pub fn branch_points(&self) -> BranchPoints {
        self.branch_points.map(Float::to_f64)
    }

    /// Signs of l + n and l - n.
    pub fn signs(&self) -> Signs {
        self.signs
    }

    /// Nutation period, and the advances over it. A steady motion has those of an infinitesimal nutation. `None` if e₂ = e₃, and
    /// for a body without torque and angular momentum.
    ///
    /// Cost: one integration.
    pub fn period_advance(&self) -> Option<PeriodAdvance> {
        let windings = Ellipses::oscillating(&self.branch_points, self.signs, Extended::to_f64).windings();
        let period = self.period::<Extended>(&self.equations(), &mut || {})?;
        Some(PeriodAdvance::new(&period, self.half_tau, windings))
    }

    /// Nutation period, integrated in numbers of type `F`.
    pub(crate) fn period<F: Float>(
        &self,
        equations: &PhaseEquations<Extended>,
        pause: &mut dyn FnMut(),
    ) -> Option<Period> {
        if self.top.is_torque_free() {
            let half_turn = Extended::TWO_PI.halved();
            return (self.torque_free_rate > Extended::ZERO)
                .then(|| Period::torque_free(half_turn / self.torque_free_rate));
        }
        (self.branch_points.e3_minus_e2 > Extended::ZERO)
            .then(|| Period::integrated(&equations.map(F::from_extended), pause))
    }

    /// Winding numbers of the ellipses of α and β; 1 for a steady motion.
    pub(crate) fn windings(&self) -> [i32; 2] {
        if self.is_steady() { [1; 2] } else { self.ellipses.windings() }
    }

    /// Number e^{iχ} at t = 0; 1 for a steady motion.
    pub(crate) fn cis_chi(&self) -> Complex<f64> {
        self.half_phase.map_or(Complex::ONE, Complex::cis)
    }

    /// Variable v = asinh(tan χ) at t = 0 of an aperiodic motion, which has χ = gd v; `None` for another motion.
    pub(crate) fn aperiodic_v(&self) -> Option<f64> {
        (self.regime == Regime::Aperiodic).then(|| {
            let Complex { re: cosine, im: sine } = self.cis_chi();
            libm::asinh(sine / cosine)
        })
    }

    /// Tip angle at t = 0, in (-1/2, 1/2] turn.
    pub(crate) fn tip_angle_at_launch(&self) -> Phase {
        self.ellipses.tip_angle(self.cis_chi(), self.slow_phases)
    }

    /// Orientation and its rate at t = 0.
    pub fn attitude_at_launch(&self) -> AttitudeState<f64> {
        self.attitude_with(self.constant_rates())
    }

    /// Orientation at t = 0, and its rate with these constant parts of the rates of the slow phases, rad/s.
    fn attitude_with(&self, constant_rates: [Extended; 2]) -> AttitudeState<f64> {
        let cis_chi = self.cis_chi();
        let PhaseRates { chi, psi_alpha, psi_beta } = if self.is_steady() {
            PhaseRates::ZERO
        } else {
            self.equations().map(Float::to_f64).rates(cis_chi.im, cis_chi.re)
        };
        let [alpha, beta] = constant_rates.map(Float::to_f64);
        self.ellipses.attitude_state(cis_chi, self.slow_phases, [chi, psi_alpha + alpha, psi_beta + beta])
    }

    /// Least normal force over the weight; `None` unless the tip slides. Where it is negative, a real top leaves the plane.
    pub fn min_normal_force(&self) -> Option<f64> {
        (self.top.support() == Support::Sliding).then(|| {
            if self.is_steady() {
                1.0
            } else {
                normal_force::minimum(&self.branch_points, self.top.a_over_ps())
            }
        })
    }

    /// Constant parts of the rates of the slow phases, rad/s: ±τ/2, or the whole rates of a steady motion.
    pub(crate) fn constant_rates(&self) -> [Extended; 2] {
        if self.is_steady() { self.steady_rates() } else { [self.half_tau, -self.half_tau] }
    }

    /// Rates ((l ± n)/(A (1 ± u)) ± τ)/2 of the slow phases of a steady motion, rad/s; 0 for a parameter that is 0.
    pub(crate) fn steady_rates(&self) -> [Extended; 2] {
        let twice_a = self.top.a.doubled();
        let zero = Extended::ZERO;
        let rate = |momentum: Extended, complement: Extended, half_tau: Extended| {
            if complement > zero { momentum / (twice_a * complement) + half_tau } else { zero }
        };
        let [one_plus_u, one_minus_u] = steady_tilt(&self.branch_points, self.regime);
        let half_tau = self.half_tau;
        let FirstIntegrals { l_plus_n, l_minus_n, .. } = self.integrals;
        [rate(l_plus_n, one_plus_u, half_tau), rate(l_minus_n, one_minus_u, -half_tau)]
    }

    /// Whether u is constant to the last bit.
    pub(crate) fn is_steady(&self) -> bool {
        self.half_phase.is_none()
    }

    /// Phase equations of the motion.
    pub(crate) fn equations(&self) -> PhaseEquations<Extended> {
        PhaseEquations::new(
            &self.top,
            &self.branch_points,
            self.integrals.l_plus_n,
            self.signs,
            self.torque_free_rate,
        )
    }
}

/// Numbers 1 + u and 1 - u of a steady motion.
fn steady_tilt(e: &BranchPoints<Extended>, regime: Regime) -> [Extended; 2] {
    match regime {
        Regime::SleepingUnstable => [Extended::from(2.0), Extended::ZERO],
        _ => [e.one_plus_e1, e.one_minus_e2],
    }
}

/// Regime, tip class and bounds of u.
#[cfg(feature = "defmt")]
impl defmt::Format for Motion {
    fn format(&self, f: defmt::Formatter<'_>) {
        let e = self.branch_points();
        defmt::write!(f, "{} (tip {}), u from {=f64} to {=f64}", self.regime(), self.tip_class(), e.e1, e.e2);
    }
}
