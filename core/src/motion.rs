//! Motion: regime, constants and start of one launch, independent of time.

pub(crate) mod start;

mod construction;

mod launch;

pub use launch::Launch;
pub use start::Start;

use crate::cayley_klein::{Brackets, PhaseDirections};
use crate::complex::Complex;
use crate::constants::{BranchPoints, Conditioning, FirstIntegrals, Regime, Signs, TipClass, normal_force};
use crate::law::{Law, gudermannian};
use crate::mean_motion::{MeanMotion, PeriodAdvance};
use crate::phase::{Phase, TurnRate};
use crate::scalar::{Extended, Float, RateNumber, Ring, Scalar};
use crate::top::{Quantities, Support, Top};

/// Motion of one launch: regime, constants and state at t = 0. It is immutable; any number of steppers and ephemerides
/// can be made from it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion {
    top: Top,
    signs: Signs,
    e: BranchPoints<Extended>,
    integrals: FirstIntegrals<Extended>,
    /// Half of τ: see [`Motion::half_tau`].
    half_tau: Extended,
    brackets: Brackets<f64>,
    regime: Regime,
    nutation: NutationVariable,
    /// Slow phases A and B, of α and β, at t = 0.
    phases: [Phase; 2],
    /// Rounding errors of the constants.
    conditioning: Conditioning,
    /// Mean motion; `None` where the motion has no nutation period.
    mean: Option<MeanMotion>,
}

/// Variable of the nutation with its value at t = 0, by kind of motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum NutationVariable {
    /// No variable, because u is constant; A and B have these constant rates.
    Steady([TurnRate; 2]),
    /// Half phase χ.
    Nutating(Phase),
    /// Variable v of an aperiodic motion, with χ = gd v (Gudermannian).
    Aperiodic(f64),
}

impl Motion {
    /// Top of the motion.
    #[must_use]
    pub fn top(&self) -> &Top {
        &self.top
    }

    /// Kind of motion.
    #[must_use]
    pub fn regime(&self) -> Regime {
        self.regime
    }

    /// Class of the curve that the tip draws.
    #[must_use]
    pub fn tip_class(&self) -> TipClass {
        TipClass::of(self.regime, &self.e, self.signs)
    }

    /// First integrals l, n and h.
    #[must_use]
    pub fn first_integrals(&self) -> FirstIntegrals {
        self.integrals.as_given(&self.top)
    }

    /// Axial rate ⟨ω, r⟩ of the body, rad per unit time. Without a rotor it is the quotient of the rounded n and C, on
    /// which the bits of the rates from a table depend.
    pub(crate) fn axial_rate(&self) -> f64 {
        let (FirstIntegrals { n, spin, .. }, c) = (self.first_integrals(), self.top.axial_inertia());
        if self.top.rotor_momentum() == 0.0 && c > 0.0 { n / c } else { spin }
    }

    /// Branch points e₁, e₂, e₃ and their differences.
    #[must_use]
    pub fn branch_points(&self) -> BranchPoints {
        self.e.to_f64()
    }

    /// Signs of l + n and l - n.
    #[must_use]
    pub fn signs(&self) -> Signs {
        self.signs
    }

    /// Nutation period, and advance of α and β over it. Where u is constant, these are the values of the small
    /// nutation that a push would start. `None` where no motion nearby is periodic: aperiodic, sleeping unstable, and
    /// the border of stability (e₁ = e₂ = e₃ = 1).
    ///
    /// It is computed once, when the motion is launched.
    #[must_use]
    pub fn period_advance(&self) -> Option<PeriodAdvance> {
        self.mean.map(|mean| mean.advance.to_f64())
    }

    /// Nutation period in extended precision; `None` where there is none.
    pub(crate) fn exact_period(&self) -> Option<Extended> {
        self.mean.map(|mean| mean.advance.period)
    }

    /// Winding numbers of the brackets of α and β around 0: see [`MeanMotion::winding`]. They are 1 for a steady
    /// motion, whose brackets are constant.
    pub(crate) fn windings(&self) -> [i32; 2] {
        if self.is_steady() {
            return [1; 2];
        }
        Brackets::windings(&self.e, self.signs)
    }

    /// Tip angle at t = 0, in (-1/2, 1/2] turn.
    pub(crate) fn tip_angle_at_start(&self) -> Phase {
        let (directions, Brackets { alpha, beta }) = (self.directions_at_start(), self.brackets::<f64>());
        let [a, b] = self.phases;
        (a + b + alpha.argument(&directions) + beta.argument(&directions)).principal()
    }

    /// Mean motion in extended precision; `None` where the motion has no nutation period.
    pub(crate) fn mean_motion(&self) -> Option<&MeanMotion> {
        self.mean.as_ref()
    }

    /// Greatest transverse part of the angular velocity, rad per unit time, at u = e₁, where the kinetic energy is greatest:
    /// √(p g/(2A)) |s₊ √((1 - e₁)(1 + e₂)(1 + e₃)) + s₋ √((1 + e₁)(1 - e₂)(e₃ - 1))|. Rounded up; infinite without torque.
    pub(crate) fn greatest_transverse_rate(&self) -> f64 {
        if self.top.is_torque_free() {
            return f64::INFINITY;
        }
        let Quantities { a, p, g, .. } = Quantities::<f64>::of(&self.top);
        let e = self.branch_points();
        let plus = Float::sqrt(e.one_minus_e1() * e.one_plus_e2() * e.one_plus_e3());
        let minus = Float::sqrt(e.one_plus_e1 * e.one_minus_e2 * e.e3_minus_one);
        let Signs { l_plus_n, l_minus_n } = self.signs;
        let sum = Float::abs(l_plus_n.times(plus) + l_minus_n.times(minus));
        Float::sqrt(p * g / (a + a)) * (sum + 16.0 * f64::EPSILON * (plus + minus))
    }

    /// Least normal force over the motion, N = 1 + s u''/g in units of the weight. Its relative error is one `f64`
    /// rounding, unless it is within 1e-14 of 0; a magnitude below 1e-20 counts as 0. Where it is negative, a real
    /// top leaves the plane and does not follow the computed motion. `None` for a fixed tip, whose support can also
    /// pull, and for a free body.
    #[must_use]
    pub fn min_normal_force(&self) -> Option<f64> {
        (self.top.support() == Support::Sliding).then(|| {
            if self.is_steady() {
                return 1.0;
            }
            let Quantities { a, p, s, .. } = self.quantities();
            normal_force::minimum(&self.e, a / p / s)
        })
    }

    pub(crate) fn quantities(&self) -> Quantities<Extended> {
        Quantities::of(&self.top)
    }

    /// Half of τ = ⟨ω, r⟩ - n/A, rad per unit time; without a rotor τ = (1/C - 1/A) n. The slow phases have the additional
    /// rates ±τ/2, compared with C = A and K = 0.
    pub(crate) fn half_tau(&self) -> Extended {
        self.half_tau
    }

    /// Rate τ/2 for the slow phases: in turns, and in rad, per unit time.
    pub(crate) fn half_tau_rates(&self) -> (TurnRate, f64) {
        (rate_in_turns(self.half_tau()), self.half_tau().to_f64())
    }

    /// Law of the nutation, computed in a number type.
    #[inline(never)] // set-up needs it in several places
    pub(crate) fn law<N: RateNumber>(&self) -> Law<N> {
        let e = self.e.map(N::from);
        if self.top.is_torque_free() {
            let period = self.mean.map(|mean| mean.advance.period);
            let chi_rate = period.map_or(Extended::ZERO, |period| Extended::TWO_PI.halved() / period);
            return Law::uniform(chi_rate.into(), &e);
        }
        Law::new(&self.top, &e, self.integrals.l_plus_n.into(), self.signs)
    }

    pub(crate) fn brackets<R: Float>(&self) -> Brackets<R> {
        self.brackets.cast()
    }

    pub(crate) fn exact_branch_points(&self) -> &BranchPoints<Extended> {
        &self.e
    }

    pub(crate) fn exact_integrals(&self) -> &FirstIntegrals<Extended> {
        &self.integrals
    }

    pub(crate) fn conditioning(&self) -> &Conditioning {
        &self.conditioning
    }

    pub(crate) fn nutation(&self) -> NutationVariable {
        self.nutation
    }

    /// Half phase χ at t = 0; `None` unless the motion nutates.
    pub(crate) fn nutation_start(&self) -> Option<Phase> {
        match self.nutation {
            NutationVariable::Nutating(chi) => Some(chi),
            NutationVariable::Steady(_) | NutationVariable::Aperiodic(_) => None,
        }
    }

    pub(crate) fn phases(&self) -> [Phase; 2] {
        self.phases
    }

    /// Rates of A and B where u is constant, rad per unit time: ((l ± n)/(A (1 ± u)) ± τ)/2, with the upper signs for
    /// A; 0 for a parameter that is 0.
    pub(crate) fn steady_rates(&self) -> [Extended; 2] {
        let twice_a = self.quantities().a.doubled();
        let (one_plus_u, one_minus_u) = steady_tilt(&self.e, self.regime);
        let rate = |momentum: Extended, complement: Extended, half_tau: Extended| {
            if complement > Extended::ZERO {
                momentum / (twice_a * complement) + half_tau
            } else {
                Extended::ZERO
            }
        };
        [
            rate(self.integrals.l_plus_n, one_plus_u, self.half_tau()),
            rate(self.integrals.l_minus_n, one_minus_u, -self.half_tau()),
        ]
    }

    /// Whether the motion is steady, that is, u is constant; known once the nutation variable is.
    pub(crate) fn is_steady(&self) -> bool {
        matches!(self.nutation, NutationVariable::Steady(_))
    }

    fn steady_nutation(&self) -> NutationVariable {
        NutationVariable::Steady(self.steady_rates().map(rate_in_turns))
    }

    /// Nutation direction at t = 0, with both slow phases 0.
    fn directions_at_start(&self) -> PhaseDirections<f64> {
        let (sine, cosine) = match self.nutation {
            NutationVariable::Steady(_) => (0.0, 1.0),
            NutationVariable::Nutating(chi) => f64::sine_cosine(chi),
            NutationVariable::Aperiodic(v) => gudermannian(v),
        };
        PhaseDirections { sine, cosine, alpha: Complex::ONE, beta: Complex::ONE }
    }
}

/// Rate in turns, from one in rad per unit time.
fn rate_in_turns(radians: Extended) -> TurnRate {
    let turns = radians.in_turns();
    let [leading, rest] = turns.parts();
    TurnRate::new(leading, rest)
}

/// Whether u is exactly constant. An oscillation that is too small to count in the regime has its own mean rates,
/// which differ from those at a constant u.
fn stands_still(e: &BranchPoints<Extended>, regime: Regime) -> bool {
    e.e2_minus_e1 == Extended::ZERO || regime == Regime::SleepingUnstable
}

/// 1 + u and 1 - u of a steady motion.
fn steady_tilt(e: &BranchPoints<Extended>, regime: Regime) -> (Extended, Extended) {
    if regime == Regime::SleepingUnstable {
        (Extended::from(2.0), Extended::ZERO)
    } else {
        (e.one_plus_e1, e.one_minus_e2)
    }
}
