//! The toy top's aperiodic motion in Weierstrass functions, with w² = 4 (u - e₁)(u² - e₄²) and ω₃ where ℘ is the middle
//! root:
//!
//! ```text
//! u = ℘(x - ω₃) + e₁/3,   L = log(-σ(x - b)/σ(x + b)),   u(a) = -1,   u(b) = 1
//! t = i √(2s/g) (-ζ(x - ω₃) - ζ(ω₃) + (1 + e₁/3) x + ((1 - e₄²)/w₊₁)(L + 2 (ζ(ω₃) + ζ(b - ω₃)) x))
//! α = k e^{lx} σ(x - a)/σ(x - ω₃) e^{-pL},   p = w₋₁/(2w₊₁)
//! l = w₋₁/4 - w₋₁/(1 - e₄²) + ζ(a - ω₃) - p (ζ(a + b) - ζ(a - b))
//! ```
//!
//! x runs from 0 along the negative imaginary axis towards b, where L is infinite and u = 1. The print has p with the
//! other sign, ζ(a + b) + ζ(a - b) in l, and ζ(ω₃) - ζ(b - ω₃) in t.
//!
//! The branch of L is real on the whole path; its logarithm of b - x comes from ln(1 - u), which v knows however small
//! 1 - u is.

use super::{Point, Rise};
use crate::complex::Complex;
use crate::exact::agm::{first_kind, first_kind_per_length};
use crate::exact::elementary::{cis, quotient};
use crate::exact::sigma_quotient::{Germ, SigmaQuotient};
use crate::exact::weierstrass::Weierstrass;
use crate::real::Float;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Sliding {
    rise: Rise,
    lattice: Weierstrass,
    /// ω₃.
    middle: Complex<f64>,
    /// e₄, e₄ - 1.
    e4: [f64; 2],
    /// |b|; b = -i|b|.
    b: f64,
    /// √(2s/g).
    time_scale: f64,
    /// What t has of y = ix, besides the ζ's, and of L.
    time_factors: [f64; 2],
    alpha: SigmaQuotient,
    /// ip.
    log_power: f64,
}

/// Where x is on its path.
struct Place {
    /// x = -iy.
    y: f64,
    /// |b| - |y| over 1 - u.
    left_per_below: f64,
}

impl Sliding {
    /// `l_per_a`: l/A.
    pub(super) fn new(rise: &Rise, e4: f64, l_per_a: f64) -> Self {
        let Rise { e1, one_plus_e1, one_minus_e1, a_over_p, s, g } = *rise;
        // e₄² - 1 = A/(ps)
        let spread = a_over_p / s;
        let e4_minus_one = spread / (e4 + 1.0);
        let (below, above) = (one_minus_e1 + e4_minus_one, one_plus_e1 + e4_minus_one); // e₄ ∓ e₁
        let lattice = Weierstrass::of_gaps(below, above);
        let [real, imaginary] = lattice.half_periods();
        let middle = Complex::new(real, imaginary);
        let b = 0.5 * first_kind(one_minus_e1, [one_minus_e1, e4_minus_one, e4 + 1.0], [0.0, below, above]);
        let to_minus_one =
            0.5 * first_kind(one_plus_e1, [0.0, below, above], [one_plus_e1, e4 + 1.0, e4_minus_one]);
        let b_point = Complex::new(0.0, -b);

        let time_scale = Float::sqrt(2.0 * s / g);
        let w_minus = -time_scale * spread * l_per_a;
        // w₊₁ = i |w₊₁| at b = -i|b|
        let w_plus = 2.0 * Float::sqrt(one_minus_e1 * spread);
        let slope = lattice.p_prime(Complex::new(to_minus_one, 0.0) - middle).re;
        let a = Complex::new(if slope * w_minus < 0.0 { -to_minus_one } else { to_minus_one }, 0.0);

        let log_slope = |z: Complex<f64>| lattice.bare(z).log_slope();
        let log_power = 0.5 * w_minus / w_plus;
        let p = Complex::new(0.0, -log_power);
        let excess = Complex::new(0.25 * w_minus + w_minus / spread, 0.0)
            - p * (log_slope(a + b_point) - log_slope(a - b_point));
        let alpha = SigmaQuotient::through(&lattice, [a, middle], excess, (b_point, 1.0));

        let of_log = -spread / w_plus;
        let zetas = (log_slope(middle) + log_slope(b_point - middle)).im;
        let of_y = 1.0 + e1 / 3.0 - 2.0 * lattice.kappa() + 2.0 * of_log * zetas;
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

    /// The linear factors u - e₁, e₄ - u, e₄ + u of -R/4.
    fn factors(&self, point: &Point) -> [f64; 3] {
        let [_, e4_minus_one] = self.e4;
        let above_e1 = self.rise.one_minus_e1 * point.tanh * point.tanh;
        [above_e1, e4_minus_one + point.below, e4_minus_one + point.above]
    }

    fn place(&self, point: &Point) -> Place {
        let [e4, e4_minus_one] = self.e4;
        let Rise { one_minus_e1, one_plus_e1, .. } = self.rise;
        let here = self.factors(point);
        let [above_e1, ..] = here;
        let lowest = [0.0, one_minus_e1 + e4_minus_one, one_plus_e1 + e4_minus_one];
        let y = 0.5 * first_kind(above_e1, here, lowest);
        let left_per_below = first_kind_per_length([one_minus_e1, e4_minus_one, e4 + 1.0], here);
        Place { y: libm::copysign(y, point.v), left_per_below }
    }

    /// L.
    fn log(&self, point: &Point, place: &Place) -> f64 {
        let size = Float::abs(point.v);
        let ln_sech = core::f64::consts::LN_2 - size - libm::log1p(libm::exp(-2.0 * size));
        let ln_below = libm::log(self.rise.one_minus_e1) + 2.0 * ln_sech;
        let left = place.left_per_below * point.below;
        let near = self.lattice.bare_per_z(Complex::new(0.0, left));
        let far = self.lattice.bare(Complex::new(0.0, -Float::abs(place.y) - self.b));
        let modulus = |z: Complex<f64>| libm::hypot(z.re, z.im);
        let log =
            ln_below + libm::log(place.left_per_below * modulus(near) / modulus(far.value)) - far.exponent.re;
        libm::copysign(1.0, point.v) * log
    }

    /// (1 - u) dL/dx, even in x.
    fn log_rate(&self, point: &Point, place: &Place) -> Complex<f64> {
        let left = Complex::new(0.0, place.left_per_below * point.below);
        let far = self.lattice.bare(Complex::new(0.0, -Float::abs(place.y) - self.b)).log_slope();
        // (1 - u)/(x - b) · (x - b) B'(x - b)/B(x - b)
        let near = quotient(self.lattice.bare(left).slope, self.lattice.bare_per_z(left));
        -near.times_i().scaled(1.0 / place.left_per_below) - far.scaled(point.below)
    }

    pub(super) fn time(&self, point: &Point) -> f64 {
        let place = self.place(point);
        let [of_y, of_log] = self.time_factors;
        let x = Complex::new(0.0, -place.y);
        let log_slope = |z: Complex<f64>| self.lattice.bare(z).log_slope().im;
        let zetas = log_slope(x - self.middle) + log_slope(self.middle);
        self.time_scale * (zetas + of_y * place.y + of_log * self.log(point, &place))
    }

    pub(super) fn alpha(&self, point: &Point) -> Germ {
        let place = self.place(point);
        let x = Complex::new(0.0, -place.y);
        let Germ { value, slope } = self.alpha.at(&self.lattice, x);
        // dx/dt = -i (1 - u)/(√(2s/g) (e₄² - u²))
        let [_, from_e4, to_e4] = self.factors(point);
        let speed = Complex::new(0.0, -1.0 / (self.time_scale * from_e4 * to_e4));
        let factor = cis(self.log_power * self.log(point, &place));
        let turning = Complex::new(0.0, self.log_power) * self.log_rate(point, &place) * speed;
        Germ { value: value * factor, slope: (slope * speed.scaled(point.below) + value * turning) * factor }
    }
}
