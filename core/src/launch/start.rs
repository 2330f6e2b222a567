//! Where a motion is at t = 0: the half phase χ and the slow phases, from a state or from given angles.

use super::BranchPoints;
use super::first_integrals::ReducedPoint;
use crate::cayley_klein::{Bracket, Place};
use crate::complex::Complex;
use crate::real::{DoubleDouble, Float, Ring};
use crate::turns::{Turns, in_turns};

/// Where on its curve a motion given by branch points is at t = 0. All in rad; 0 by default.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Start {
    /// θ(0), the nutation phase: 0 at u = e₁, π at u = e₂, rising between. A number that is the `f64` nearest to a
    /// multiple of π counts as that multiple. Without meaning where u is constant, except that θ = π with e₂ = e₃ = 1
    /// is the sleeping top.
    pub theta: f64,
    /// arg α(0); where α(0) = 0, arg α'(0).
    pub arg_alpha: f64,
    /// arg β(0); where β(0) = 0, arg β'(0).
    pub arg_beta: f64,
}

/// sin χ and cos χ of a point of the reduced curve: √(u - e₁) and ±√(e₂ - u) over √(e₂ - e₁), the sign that of u'
/// (an aperiodic motion has cos χ > 0, and sin χ changes sign instead).
///
/// The smaller of the two differences comes from g₀ = (u - e₁)(e₂ - u)(e₃ - u), not from a subtraction.
pub(super) fn half_phase(
    e: &BranchPoints<DoubleDouble>,
    point: &ReducedPoint<DoubleDouble>,
    g0: DoubleDouble,
    aperiodic: bool,
) -> (f64, f64) {
    let above_e1 = point.one_plus_u - e.one_plus_e1;
    let below_e2 = point.one_minus_u - e.one_minus_e2;
    let below_e3 = point.one_minus_u + e.e3_minus_one;
    let (above_e1, below_e2) = if below_e2 < above_e1 {
        (above_e1, g0 / (below_e3 * above_e1))
    } else {
        (g0 / (below_e3 * below_e2), below_e2)
    };
    let (sine, cosine) = (above_e1.sqrt().to_f64(), below_e2.sqrt().to_f64());
    match (point.udot < DoubleDouble::ZERO, aperiodic) {
        (false, _) => (sine, cosine),
        (true, false) => (sine, -cosine),
        (true, true) => (-sine, cosine),
    }
}

/// χ in [0, 1/2] turn from its sine >= 0 and cosine, with relative precision at 0, at a quarter and at a half.
pub(super) fn chi(sine: f64, cosine: f64) -> Turns {
    let from = |y: f64, x: f64| Turns::from_radians(libm::atan2(y, x));
    if Float::abs(cosine) < sine {
        Turns::QUARTER - from(cosine, sine)
    } else if cosine > 0.0 {
        from(sine, cosine)
    } else {
        Turns::HALF - from(sine, -cosine)
    }
}

/// χ = θ/2; the `f64` nearest to a multiple of π means that multiple.
pub(super) fn half_turns(theta: f64) -> Turns {
    let nearest = libm::round(theta * core::f64::consts::FRAC_1_PI);
    if nearest != 0.0 && nearest * core::f64::consts::PI == theta {
        return Turns::new(0.25 * nearest);
    }
    Turns::of(in_turns(theta.into()) * DoubleDouble::from(0.5))
}

/// The slow phase of a parameter z with rate z': both must be the bracket and its rate, turned by it. Weighed together, so
/// that a parameter that is 0, or nearly, at t = 0 is placed by how it leaves.
pub(super) fn slow_phase(
    bracket: &Bracket<f64>,
    place: &Place<f64>,
    [nutation, turning]: [f64; 2],
    z: [Complex<f64>; 2],
) -> Turns {
    let [value, rate] = z;
    let model = bracket.at(place);
    let model_rate = bracket.along(place).scaled(nutation) + model.times_i().scaled(turning);
    let time = 1.0 / (nutation.squared() + turning.squared());
    let sum = value * model.conj() + (rate * model_rate.conj()).scaled(time);
    Turns::from_radians(sum.arg())
}
