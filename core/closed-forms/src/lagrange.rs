//! Lagrange top, whose tip is held at a fixed point: Klein's elliptic solution (section 5.4 of the paper; s = 0).
//!
//! With z = √(pg/2A) t and w² = 4 (u - e₁)(u - e₂)(u - e₃), whose half periods are ω > 0 and ω' imaginary,
//!
//! ```text
//! u = ℘(z + ω') + (e₁ + e₂ + e₃)/3 = e₁ + (e₂ - e₁) sn²(√(e₃ - e₁) z)
//! α = k e^{ζ(a + ω') z} σ(z - a)/σ(z + ω'),   u(a) = -1,   ℘'(a + ω') =  i (l + n) √(2/(A p g))
//! β = k e^{ζ(b + ω') z} σ(z - b)/σ(z + ω'),   u(b) =  1,   ℘'(b + ω') = -i (l - n) √(2/(A p g))
//! ```
//!
//! z increases along the real axis, from u = e₁ at z = 0.

use crate::elliptic::agm::first_kind;
use crate::elliptic::carlson_rf;
use crate::elliptic::elementary::{imaginary, of_turns, real};
use crate::elliptic::lattice::{Lattice, NONE, OMEGA, OMEGA_PRIME};
use crate::elliptic::theta::ValueAndSlope;
use crate::elliptic::theta_quotient::ThetaQuotient;
use crate::orientation::ConstantArguments;
use crate::periods::{Periods, half_turns};
use toytop::AttitudeState;
use toytop::Complex;
use toytop::Motion;
use toytop::Phase;
use toytop::Support;
use toytop::internal::{NutationVariable, ScaledTop};
use toytop::scalar::{Extended, Float, Ring};
use toytop::{BranchPoints, Signs};

/// Nutating Lagrange top as a function of time.
///
/// Error of an orientation: below 1e-15 rad at any time up to 1e9 periods, also where several differences of the
/// branch points are as small as 1e-12. Cost: about 20 theta functions in extended precision for set-up, and four for one
/// time, without iteration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lagrange {
    solution: Solution,
    periods: Periods,
}

/// Solution for α and β within a period.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Solution {
    lattice: Lattice,
    /// Rate of z per unit of time.
    z_rate: Extended,
    alpha: ThetaQuotient,
    beta: ThetaQuotient,
}

impl Lagrange {
    /// Closed form of a motion; `None` unless the tip is fixed and u oscillates, e₁ < e₂ < e₃.
    #[must_use]
    pub fn new(motion: &Motion) -> Option<Self> {
        let NutationVariable::Nutating(chi) = motion.nutation() else { return None };
        if motion.top().support() != Support::Fixed || motion.top().is_torque_free() {
            return None;
        }
        let e = motion.exact_branch_points();
        let (swing, gap) = (e.e2_minus_e1, e.e3_minus_e2);
        let lattice = Lattice::of_gaps(gap, swing);
        let [half, _] = lattice.half_periods();
        let ScaledTop { a, p, g, .. } = motion.scaled_top();
        let z_rate = (p * g / a).halved().sqrt();

        // from u = -1 up to e₁ and from e₂ up to 1, along imaginary z
        let to_e1 = first_kind(
            e.one_plus_e1,
            [Extended::ZERO, swing, e.e3_minus_e1()],
            [e.one_plus_e1, e.one_plus_e2(), e.one_plus_e3()],
        );
        let to_one = first_kind(
            e.one_minus_e2,
            [e.one_minus_e1(), e.one_minus_e2, e.e3_minus_one],
            [swing, Extended::ZERO, gap],
        );
        let Signs { l_plus_n, l_minus_n } = motion.signs();
        let a = imaginary(l_plus_n.times(to_e1.halved()));
        let b = imaginary(l_minus_n.times(to_one.halved()));
        let highest = real(half);
        // |k| from |α| at u = e₂ and from |β| at u = e₁, which are never 0
        let modulus = |x: Extended| x.halved().sqrt();
        let zero = Complex::ZERO;
        let (at_highest, at_lowest) =
            ((highest, modulus(e.one_plus_e2())), (zero, modulus(e.one_minus_e1())));
        let alpha = ThetaQuotient::through(&lattice, [NONE, OMEGA_PRIME], a, zero, at_highest);
        let beta = ThetaQuotient::through(&lattice, [OMEGA, OMEGA_PRIME], b, zero, at_lowest);
        let whole = real(half.doubled());
        let turns = [alpha.turns(&lattice, -highest, whole), beta.turns(&lattice, zero, whole)];

        let solution = Solution { lattice, z_rate, alpha, beta };
        let origin = since_lowest(&e, chi) / z_rate;
        let (period, arguments) =
            (half.doubled() / z_rate, ConstantArguments::new(motion, solution.parameters(origin)));
        Some(Self { solution, periods: Periods { period, turns, origin, arguments } })
    }

    /// Nutation period, 2ω √(2A/(pg)).
    #[must_use]
    pub fn period(&self) -> f64 {
        self.periods.period.to_f64()
    }

    /// Orientation Φ and rate Φ' at t.
    #[must_use]
    pub fn at(&self, t: f64) -> AttitudeState<f64> {
        self.periods.attitude_state(t, |time| self.solution.parameters(time))
    }

    /// Nutation phase at t, whole periods included: 0 at u = e₁, half a turn at u = e₂.
    #[must_use]
    pub fn nutation_phase(&self, t: f64) -> Phase {
        self.periods.phase(t)
    }
}

/// z(0) within half a period of u = e₁: the elliptic integral of χ.
fn since_lowest(e: &BranchPoints<Extended>, chi: Phase) -> Extended {
    let rest = half_turns(chi);
    let rest = if rest > Phase::QUARTER { rest - Phase::HALF } else { rest };
    let (sine, cosine) = of_turns(rest);
    let (squared, length) = (cosine * cosine, e.e3_minus_e1());
    sine * carlson_rf(length * squared, e.e3_minus_e2 + e.e2_minus_e1 * squared, length)
}

impl Solution {
    /// α and β, and their time derivatives, at this time since u = e₁.
    fn parameters(&self, time: Extended) -> [ValueAndSlope; 2] {
        let z = real(self.z_rate * time);
        [self.alpha, self.beta].map(|parameter| parameter.at(&self.lattice, z).by(real(self.z_rate)))
    }
}
