//! Aperiodic motion of the toy top in Weierstrass functions, with w² = 4 (u - e₁)(u² - e₄²) and the half period ω₃ at
//! which ℘ has its middle root:
//!
//! ```text
//! u = ℘(x - ω₃) + e₁/3,   L = log(-σ(x - b)/σ(x + b)),   u(a) = -1,   u(b) = 1
//! t = i √(2s/g) (-ζ(x - ω₃) - ζ(ω₃) + (1 + e₁/3) x + ((1 - e₄²)/w₊₁)(L + 2 (ζ(ω₃) + ζ(b - ω₃)) x))
//! α = k e^{lx} σ(x - a)/σ(x - ω₃) e^{-pL},   p = w₋₁/(2w₊₁)
//! l = w₋₁/4 - w₋₁/(1 - e₄²) + ζ(a - ω₃) - p (ζ(a + b) - ζ(a - b))
//! ```
//!
//! The values of w at u = 1 and at u = -1 are w₊₁ = 2i √((1 - e₁) A/(ps)) and w₋₁ = -√(2s/g) l/(ps), where l is the first integral.
//! x runs from 0 along the negative imaginary axis to b, where L is infinite and u = 1. The paper prints the opposite
//! sign of p, ζ(a + b) + ζ(a - b) in l, and ζ(ω₃) - ζ(b - ω₃) in t.
//!
//! In the code x = -iy with a real y, so that the coefficients of t, L and arg α are real; w₊₁ is i times `w_plus`.
//!
//! The branch of L is real on the whole path. Its term ln(b - x) is computed from ln(1 - u), a function of v with
//! full relative precision for any 1 - u.

use crate::aperiodic::constants::{AperiodicConstants, AperiodicValues};
use crate::elliptic::carlson::{first_kind, first_kind_per_length};
use crate::elliptic::elementary::{ValueAndSlope, WideComplex, angle, cis, imaginary, ln, real};
use crate::elliptic::lattice::{Lattice, LatticeHalfPeriod};
use crate::theta_quotient::ThetaQuotient;
use toytop::Complex;
use toytop::scalar::{Extended, Float, Ring};

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Sliding {
    /// Linear factors u - e₁, e₄ - u and e₄ + u at u = e₁ and at u = 1.
    lowest: [Extended; 3],
    upright: [Extended; 3],
    /// Modulus |b|; b = -i|b|.
    b_modulus: Extended,
    /// Time √(2s/g).
    time_scale: Extended,
    /// Coefficients in t of y = ix and of L.
    time_factors: [Extended; 2],
    alpha: ThetaQuotient,
    /// Real number ip.
    i_times_p: Extended,
}

/// Position of x on its path.
struct PathPosition {
    /// Coordinate y, with x = -iy.
    y: Extended,
    /// Quotient (|b| - |y|)/(1 - u) of the distance from b.
    distance_per_one_minus_u: Extended,
}

impl Sliding {
    /// Solution for a motion; `l_per_a` is l/A, rad per unit time.
    pub(super) fn new(constants: &AperiodicConstants, l_per_a: Extended) -> Self {
        let AperiodicConstants { e1, one_plus_e1, one_minus_e1, a_over_p, s, g } = *constants;
        let zero = Extended::ZERO;
        let one = Extended::ONE;
        // e₄² - 1 = A/(ps)
        let a_over_ps = a_over_p / s;
        let e4 = (one + a_over_ps).sqrt();
        let e4_minus_one = a_over_ps / (e4 + one);
        let e4_minus_e1 = one_minus_e1 + e4_minus_one;
        let e4_plus_e1 = one_plus_e1 + e4_minus_one;
        let lattice = Lattice::from_gaps(e4_minus_e1, e4_plus_e1);
        let [real_half, imaginary_half] = lattice.half_periods;
        let lowest = [zero, e4_minus_e1, e4_plus_e1];
        let upright = [one_minus_e1, e4_minus_one, e4 + one];
        let b_modulus = first_kind(one_minus_e1, upright, lowest).halved();
        let a_modulus = first_kind(one_plus_e1, lowest, [one_plus_e1, e4 + one, e4_minus_one]).halved();
        let b = imaginary(-b_modulus);

        let time_scale = (s.doubled() / g).sqrt();
        let w_minus = -(time_scale * a_over_ps * l_per_a);
        // w₊₁ = i |w₊₁| at b = -i|b|
        let w_plus = (one_minus_e1 * a_over_ps).sqrt().doubled();
        let omega_3 = Complex::new(real_half, imaginary_half);
        let p_prime_at_a = lattice.p_prime(real(a_modulus) - omega_3).re;
        let a = real(if p_prime_at_a * w_minus < zero { -a_modulus } else { a_modulus });

        let i_times_p = (w_minus / w_plus).halved();
        let p = imaginary(-i_times_p);
        let rate_offset = real(w_minus.halved().halved() + w_minus / a_over_ps)
            - p * (lattice.log_slope(LatticeHalfPeriod::Origin, a + b)
                - lattice.log_slope(LatticeHalfPeriod::Origin, a - b));
        let alpha = ThetaQuotient::through(
            &lattice,
            [LatticeHalfPeriod::Origin, LatticeHalfPeriod::Sum],
            a,
            rate_offset,
            (b, one),
        );

        let log_coefficient = -(a_over_ps / w_plus);
        let zetas = lattice.log_slope(LatticeHalfPeriod::Sum, b).im;
        let y_coefficient =
            one + e1 / 3.0.into() - lattice.sigma_exponent.doubled() + log_coefficient.doubled() * zetas;
        Self {
            lowest,
            upright,
            b_modulus,
            time_scale,
            time_factors: [y_coefficient, log_coefficient],
            alpha,
            i_times_p,
        }
    }

    /// Linear factors u - e₁, e₄ - u and e₄ + u of -R/4.
    fn factors(&self, point: &AperiodicValues) -> [Extended; 3] {
        let [one_minus_e1, e4_minus_one, _] = self.upright;
        let above_e1 = one_minus_e1 * point.tanh.squared();
        [above_e1, e4_minus_one + point.one_minus_u, e4_minus_one + point.one_plus_u]
    }

    fn position(&self, point: &AperiodicValues) -> PathPosition {
        let here = self.factors(point);
        let [above_e1, ..] = here;
        let y = first_kind(above_e1, here, self.lowest).halved();
        let distance_per_one_minus_u = first_kind_per_length(self.upright, here);
        PathPosition { y: point.with_sign_of_v(y), distance_per_one_minus_u }
    }

    /// |ϑ(x - b)|/|x - b|, and (x - b) ϑ'(x - b)/ϑ(x - b), at a distance from b.
    fn near(&self, distance: Extended) -> (Extended, WideComplex) {
        // below this distance the theta function is linear to all digits
        const TINY: f64 = 1e-40;
        let at = |distance: Extended| {
            (self.alpha.lattice.theta(LatticeHalfPeriod::Origin, imaginary(distance)), distance)
        };
        let (theta, distance) = at(if distance.to_f64() < TINY { TINY.into() } else { distance });
        (theta.value.modulus() / distance, theta.log_slope() * imaginary(distance))
    }

    /// Logarithm L, and (1 - u) dL/dx, an even function of x.
    fn log(&self, point: &AperiodicValues, position: &PathPosition) -> (Extended, WideComplex) {
        let &PathPosition { y, distance_per_one_minus_u } = position;
        let [one_minus_e1, ..] = self.upright;
        let (near, near_slope) = self.near(distance_per_one_minus_u * point.one_minus_u);
        let far = self.alpha.lattice.theta(LatticeHalfPeriod::Origin, imaginary(-(y.abs() + self.b_modulus)));
        let log_ratio = ln(distance_per_one_minus_u * near / far.value.modulus());
        let log = ln(one_minus_e1) + point.ln_sech.doubled() + log_ratio;
        // (1 - u)/(x - b) · (x - b) ϑ'(x - b)/ϑ(x - b)
        let slope = -near_slope.times_i().scaled(Extended::ONE / distance_per_one_minus_u)
            - far.log_slope().scaled(point.one_minus_u);
        (point.with_sign_of_v(log), slope)
    }

    pub(super) fn time(&self, point: &AperiodicValues) -> Extended {
        let position = self.position(point);
        let [y_coefficient, log_coefficient] = self.time_factors;
        let zeta = self.alpha.lattice.log_slope(LatticeHalfPeriod::Sum, imaginary(-position.y)).im;
        self.time_scale * (zeta + y_coefficient * position.y + log_coefficient * self.log(point, &position).0)
    }

    /// Argument of α minus that at u = e₁; 0 for e₁ = -1. The quotient of theta functions rotates by less than a right angle.
    pub(super) fn argument(&self, point: &AperiodicValues) -> Extended {
        let position = self.position(point);
        let x = imaginary(-position.y);
        let [here, lowest] = [x, Complex::ZERO]
            .map(|x| self.alpha.lattice.theta(LatticeHalfPeriod::Origin, x - self.alpha.zero).value);
        let ratio = here * lowest.conj();
        let log = self.i_times_p * self.log(point, &position).0;
        (self.alpha.rate * x).im + angle(ratio.im, ratio.re) + log
    }

    pub(super) fn alpha(&self, point: &AperiodicValues) -> ValueAndSlope {
        let position = self.position(point);
        let ValueAndSlope { value, slope } = self.alpha.at(imaginary(-position.y));
        // dx/dt = -i (1 - u)/(√(2s/g) (e₄² - u²))
        let [_, from_e4, to_e4] = self.factors(point);
        let speed = imaginary(-(Extended::ONE / (self.time_scale * from_e4 * to_e4)));
        let (log, log_slope) = self.log(point, &position);
        let factor = cis(self.i_times_p * log);
        let log_rate = imaginary(self.i_times_p) * log_slope * speed;
        ValueAndSlope {
            value: value * factor,
            slope: (slope * speed.scaled(point.one_minus_u) + value * log_rate) * factor,
        }
    }
}
