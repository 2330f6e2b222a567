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
//! x runs from 0 along the negative imaginary axis to b, where L is infinite and u = 1. The paper prints the opposite
//! sign of p, ζ(a + b) + ζ(a - b) in l, and ζ(ω₃) - ζ(b - ω₃) in t.
//!
//! The branch of L is real on the whole path. Its term ln(b - x) is computed from ln(1 - u), a function of v with
//! full relative precision for any 1 - u.

use crate::complex::Complex;
use crate::elliptic::agm::{first_kind, first_kind_per_length};
use crate::elliptic::elementary::{Wide, cis, imaginary, modulus, quotient, real};
use crate::elliptic::lattice::Lattice;
use crate::elliptic::transcendental::ln;
use crate::exact::aperiodic::{Rise, RiseValues};
use crate::exact::sigma_quotient::{SigmaQuotient, ValueAndSlope};
use crate::scalar::{Extended, Float, Ring};

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Sliding {
    rise: Rise,
    lattice: Lattice,
    /// Half period ω₃.
    middle: Wide,
    /// Branch point e₄, and e₄ - 1.
    e4: [Extended; 2],
    /// Modulus |b|; b = -i|b|.
    b: Extended,
    /// Time √(2s/g).
    time_scale: Extended,
    /// Coefficients in t of y = ix and of L.
    time_factors: [Extended; 2],
    alpha: SigmaQuotient,
    /// Real number ip.
    log_power: Extended,
}

/// Position of x on its path.
struct PathPosition {
    /// Coordinate y, with x = -iy.
    y: Extended,
    /// Quotient (|b| - |y|)/(1 - u).
    left_per_below: Extended,
}

impl Sliding {
    /// Solution for a motion; `l_per_a` is l/A, rad per unit time.
    pub(super) fn new(rise: &Rise, l_per_a: Extended) -> Self {
        let Rise { e1, one_plus_e1, one_minus_e1, a_over_p, s, g } = *rise;
        let (zero, one) = (Extended::ZERO, Extended::ONE);
        // e₄² - 1 = A/(ps)
        let spread = a_over_p / s;
        let e4 = (one + spread).sqrt();
        let e4_minus_one = spread / (e4 + one);
        let (below, above) = (one_minus_e1 + e4_minus_one, one_plus_e1 + e4_minus_one); // e₄ ∓ e₁
        let lattice = Lattice::of_gaps(below, above);
        let [across, up] = lattice.half_periods();
        let middle = Complex::new(across, up);
        let lowest = [zero, below, above];
        let b = first_kind(one_minus_e1, [one_minus_e1, e4_minus_one, e4 + one], lowest).halved();
        let to_minus_one = first_kind(one_plus_e1, lowest, [one_plus_e1, e4 + one, e4_minus_one]).halved();
        let b_point = imaginary(-b);

        let time_scale = (s.doubled() / g).sqrt();
        let w_minus = -(time_scale * spread * l_per_a);
        // w₊₁ = i |w₊₁| at b = -i|b|
        let w_plus = (one_minus_e1 * spread).sqrt().doubled();
        let slope = lattice.p_prime(real(to_minus_one) - middle).re;
        let a = real(if slope * w_minus < zero { -to_minus_one } else { to_minus_one });

        let log_slope = |z: Wide| lattice.sigma_factor(z).log_slope();
        let log_power = (w_minus / w_plus).halved();
        let p = imaginary(-log_power);
        let rate_offset = real(w_minus.halved().halved() + w_minus / spread)
            - p * (log_slope(a + b_point) - log_slope(a - b_point));
        let alpha = SigmaQuotient::through(&lattice, [a, middle], rate_offset, (b_point, one));

        let of_log = -(spread / w_plus);
        let zetas = (log_slope(middle) + log_slope(b_point - middle)).im;
        let of_y = one + e1 / 3.0.into() - lattice.kappa().doubled() + of_log.doubled() * zetas;
        Self {
            rise: *rise,
            lattice,
            middle,
            e4: [e4, e4_minus_one],
            b,
            time_scale,
            time_factors: [of_y, of_log],
            alpha,
            log_power,
        }
    }

    /// Linear factors u - e₁, e₄ - u and e₄ + u of -R/4.
    fn factors(&self, point: &RiseValues) -> [Extended; 3] {
        let [_, e4_minus_one] = self.e4;
        let above_e1 = self.rise.one_minus_e1 * point.tanh.squared();
        [above_e1, e4_minus_one + point.below, e4_minus_one + point.above]
    }

    fn position(&self, point: &RiseValues) -> PathPosition {
        let [e4, e4_minus_one] = self.e4;
        let Rise { one_minus_e1, one_plus_e1, .. } = self.rise;
        let here = self.factors(point);
        let [above_e1, ..] = here;
        let lowest = [Extended::ZERO, one_minus_e1 + e4_minus_one, one_plus_e1 + e4_minus_one];
        let y = first_kind(above_e1, here, lowest).halved();
        let left_per_below = first_kind_per_length([one_minus_e1, e4_minus_one, e4 + Extended::ONE], here);
        PathPosition { y: point.with_sign_of_v(y), left_per_below }
    }

    /// Logarithm L.
    fn log(&self, point: &RiseValues, position: &PathPosition) -> Extended {
        let ln_below = ln(self.rise.one_minus_e1) + point.ln_sech.doubled();
        let left = position.left_per_below * point.below;
        let near = self.lattice.sigma_factor_per_z(imaginary(left));
        let far = self.lattice.sigma_factor(imaginary(-(position.y.abs() + self.b)));
        let quotient = position.left_per_below * modulus(near) / modulus(far.value);
        point.with_sign_of_v(ln_below + ln(quotient) - far.exponent.re)
    }

    /// Derivative (1 - u) dL/dx, an even function of x.
    fn log_rate(&self, point: &RiseValues, position: &PathPosition) -> Wide {
        let left = imaginary(position.left_per_below * point.below);
        let far = self.lattice.sigma_factor(imaginary(-(position.y.abs() + self.b))).log_slope();
        // (1 - u)/(x - b) · (x - b) B'(x - b)/B(x - b)
        let near = quotient(self.lattice.sigma_factor(left).slope, self.lattice.sigma_factor_per_z(left));
        -near.times_i().scaled(Extended::ONE / position.left_per_below) - far.scaled(point.below)
    }

    pub(super) fn time(&self, point: &RiseValues) -> Extended {
        let position = self.position(point);
        let [of_y, of_log] = self.time_factors;
        let x = imaginary(-position.y);
        let log_slope = |z: Wide| self.lattice.sigma_factor(z).log_slope().im;
        let zetas = log_slope(x - self.middle) + log_slope(self.middle);
        self.time_scale * (zetas + of_y * position.y + of_log * self.log(point, &position))
    }

    pub(super) fn alpha(&self, point: &RiseValues) -> ValueAndSlope {
        let position = self.position(point);
        let x = imaginary(-position.y);
        let ValueAndSlope { value, slope } = self.alpha.at(&self.lattice, x);
        // dx/dt = -i (1 - u)/(√(2s/g) (e₄² - u²))
        let [_, from_e4, to_e4] = self.factors(point);
        let speed = imaginary(-(Extended::ONE / (self.time_scale * from_e4 * to_e4)));
        let factor = cis(self.log_power * self.log(point, &position));
        let turning = imaginary(self.log_power) * self.log_rate(point, &position) * speed;
        ValueAndSlope {
            value: value * factor,
            slope: (slope * speed.scaled(point.below) + value * turning) * factor,
        }
    }
}
