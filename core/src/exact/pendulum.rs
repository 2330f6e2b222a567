//! Planar pendulum: a top with a fixed tip and l = n = 0, by Jacobi's functions.
//!
//! Its lowest position is straight down, e₁ = -1. With z = 0 there,
//!
//! ```text
//! swing      e₃ = 1:  α = √m sn z,  β = dn z,  m = (1 + e₂)/2,    z = √(pg/A) t
//! rotation   e₂ = 1:  α = sn z,     β = cn z,  m = 2/(1 + e₃),    z = √(pg (1 + e₃)/2A) t
//! ```
//!
//! up to constant arguments and the rotation τt/2 of a body that turns about its axis, τ = ⟨ω, r⟩. The separatrix, e₂ = e₃ = 1,
//! is [`Aperiodic`](crate::exact::Aperiodic).

use crate::attitude_state::AttitudeState;
use crate::elliptic::elementary::real;
use crate::elliptic::jacobi::{Jacobi, JacobiValues};
use crate::exact::lagrange::since_lowest;
use crate::exact::orientation::ConstantArguments;
use crate::exact::periods::Periods;
use crate::exact::sigma_quotient::ValueAndSlope;
use crate::motion::Motion;
use crate::phase::Phase;
use crate::scalar::{Extended, Float, Ring};
use crate::top::{Quantities, Support};

/// Planar pendulum as a function of time, swinging or rotating.
///
/// Error of an orientation: below 2e-15 rad at any time up to 1e9 periods.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pendulum {
    solution: Solution,
    periods: Periods,
}

/// Solution for α and β within a period.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Solution {
    jacobi: Jacobi,
    /// Rate of z per unit of time.
    z_rate: f64,
    /// Parameter m.
    parameter: f64,
    goes_over: bool,
}

impl Pendulum {
    /// Closed form of a motion; `None` unless the tip is fixed, gravity acts, and the axis moves in a vertical plane.
    #[must_use]
    pub fn new(motion: &Motion) -> Option<Self> {
        let (e, chi) = (motion.exact_branch_points(), motion.nutation_start()?);
        let zero = Extended::ZERO;
        let (goes_over, swings) = (e.one_minus_e2 == zero, e.e3_minus_one == zero);
        let planar = e.one_plus_e1 == zero && (goes_over || swings);
        if motion.top().support() != Support::Fixed || motion.top().is_torque_free() || !planar {
            return None;
        }
        let length = e.e3_minus_e1();
        let [parameter, complement] = [e.e2_minus_e1 / length, e.e3_minus_e2 / length].map(Float::to_f64);
        let jacobi = Jacobi::new(parameter, complement).ok()?;
        let Quantities { a, p, g, .. } = motion.quantities();
        let weierstrass_rate = (p * g / a).halved().sqrt();
        let z_rate = (length.sqrt() * weierstrass_rate).to_f64();
        let solution = Solution { jacobi, z_rate, parameter, goes_over };
        let origin = since_lowest(e, chi) / weierstrass_rate;
        let arguments = ConstantArguments::new(motion, solution.parameters(origin.to_f64()));
        let turns = [Phase::HALF, if goes_over { Phase::HALF } else { Phase::ZERO }];
        let period = motion.exact_period()?;
        Some(Self { solution, periods: Periods { period, turns, origin, arguments } })
    }

    /// Time between two passages through the lowest position.
    #[must_use]
    pub fn period(&self) -> f64 {
        self.periods.period.to_f64()
    }

    /// Orientation Φ and rate Φ' at t.
    #[must_use]
    pub fn at(&self, t: f64) -> AttitudeState<f64> {
        self.periods.attitude_state(t, |time| self.solution.parameters(time.to_f64()))
    }

    /// Nutation phase at t, whole periods included: 0 at u = e₁, half a turn at u = e₂.
    #[must_use]
    pub fn nutation_phase(&self, t: f64) -> Phase {
        self.periods.phase(t)
    }
}

impl Solution {
    /// α and β, and their time derivatives, at this time since the lowest position.
    fn parameters(&self, time: f64) -> [ValueAndSlope; 2] {
        let JacobiValues { sn, cn, dn, .. } = self.jacobi.at(self.z_rate * time);
        let with = |value: f64, slope: f64| ValueAndSlope {
            value: real(value.into()),
            slope: real((slope * self.z_rate).into()),
        };
        if self.goes_over {
            [with(sn, cn * dn), with(cn, -sn * dn)]
        } else {
            let root = Float::sqrt(self.parameter);
            [with(root * sn, root * cn * dn), with(dn, -self.parameter * sn * cn)]
        }
    }
}
