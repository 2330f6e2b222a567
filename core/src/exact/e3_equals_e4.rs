//! The toy top with e₃ = e₄: elliptic functions instead of hyperelliptic ones (section 5.1 of the paper).
//!
//! With w² = 4 (u - e₁)(u - e₂)(u + e₃), whose half periods are ω₂ > 0 and ω₁ imaginary,
//!
//! ```text
//! u = ℘(x - ω₂) + (e₁ + e₂ - e₃)/3
//! t = i √(2s/g) [ζ(x - ω₂) + ζ(ω₂) - (e₁ + e₂ + 2e₃) x/3]
//! α = k₁ e^{ l₁x} σ(x - a)/σ(x - ω₂),   l₁ = w₋₁/(2(e₃ - 1)) + ζ(a - ω₂),   u(a) = -1
//! β = k₂ e^{-l₃x} σ(x + b)/σ(x + ω₂),   l₃ = w₊₁/(2(e₃ + 1)) + ζ(b - ω₂),   u(b) = 1
//! ```
//!
//! and x runs upwards along the imaginary axis, from u = e₂ at 0. The print has √R for 1/√R in a and b, ω₁ for ω₂ in the
//! shift, and x running the other way.

use super::agm::{carlson_rf, first_kind};
use super::orientation::Fit;
use super::periods::{solve_rising, split};
use super::sigma_quotient::{Germ, SigmaQuotient};
use super::weierstrass::Weierstrass;
use crate::complex::Complex;
use crate::launch::{BranchPoints, Motion, Signs};
use crate::real::{Float, Scalar};
use crate::tick::Pose;
use crate::turns::Turns;

/// A nutating toy top with e₃ = e₄, as a function of time.
///
/// Error of an orientation: 1e-14 rad in the first periods, 1e-13 rad where differences of the branch points are as small
/// as 1e-12; and some 3e-15 rad more in every period, from the rounding of the period itself. Cost: set-up some 30 theta functions, a time some 15.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct E3EqualsE4 {
    e: BranchPoints,
    lattice: Weierstrass,
    /// ω₂ and |ω₁|.
    half_periods: [f64; 2],
    /// √(2s/g).
    time_scale: f64,
    alpha: SigmaQuotient,
    beta: SigmaQuotient,
    period: f64,
    /// What a period turns α and β besides the drift.
    turns: [Turns; 2],
    /// t(x) at t = 0.
    origin: f64,
    fit: Fit,
}

impl E3EqualsE4 {
    /// Units in the last place that e₃ and e₄ may differ by: √(1 + A/(ps)) is rarely an `f64`.
    pub const TOLERANCE_ULP: f64 = 4.0;

    /// The closed form of a motion; `None` unless the tip slides, e₁ < e₂ and |e₃ - e₄| <= 2^-50 e₄.
    #[must_use]
    pub fn new(motion: &Motion) -> Option<Self> {
        let (top, e) = (motion.top(), motion.branch_points());
        let e4 = top.e4()?;
        let apart = Float::abs(e.e3 - e4) > Self::TOLERANCE_ULP * f64::EPSILON * e4;
        let chi = motion.nutation_start()?;
        if apart || e.e3_minus_one <= 0.0 {
            return None;
        }
        let (e2_plus_e3, e1_plus_e3) = (e.one_plus_e3() - e.one_minus_e2, e.one_plus_e1 + e.e3_minus_one);
        let lattice = Weierstrass::of_gaps(e.e2_minus_e1, e1_plus_e3);
        let half_periods @ [real, imaginary] = lattice.half_periods();
        let time_scale = Float::sqrt(2.0 * top.s() / top.g());

        // a and b, where u is -1 and 1
        let to_minus_one = first_kind(
            e.one_plus_e1,
            [0.0, e.e2_minus_e1, e1_plus_e3],
            [e.one_plus_e1, e.one_plus_e2(), e.e3_minus_one],
        );
        let to_one = first_kind(
            e.one_minus_e2,
            [e.one_minus_e1(), e.one_minus_e2, e.one_plus_e3()],
            [e.e2_minus_e1, 0.0, e2_plus_e3],
        );
        let Signs { l_plus_n, l_minus_n } = motion.signs();
        let a = Complex::new(-l_plus_n.times(0.5 * to_minus_one), imaginary);
        let b = Complex::new(l_minus_n.times(0.5 * to_one), 0.0);

        // w₋₁/(2(e₃ - 1)) = √(s/2g) (l + n)/A, w₊₁ alike; |k₁| and |k₂| by |α| at u = e₂, |β| at u = e₁, which never vanish
        let integrals = motion.first_integrals();
        let excess = |momentum: f64| Complex::new(0.5 * time_scale * momentum / top.a(), 0.0);
        let (shift, lowest) = (Complex::new(real, 0.0), Complex::new(0.0, -imaginary));
        let alpha = SigmaQuotient::through(
            &lattice,
            [a, shift],
            excess(integrals.l_plus_n),
            (Complex::ZERO, Float::sqrt(0.5 * e.one_plus_e2())),
        );
        let beta = SigmaQuotient::through(
            &lattice,
            [-b, -shift],
            -excess(integrals.l_minus_n),
            (lowest, Float::sqrt(0.5 * e.one_minus_e1())),
        );
        let whole = Complex::new(0.0, 2.0 * imaginary);
        let turns = [alpha.turns(&lattice, Complex::ZERO, whole), beta.turns(&lattice, lowest, whole)];

        // y(0): cos²χ = sn²(√(e₂ + e₃) y), within half a period of u = e₂
        let (_, rest) = chi.halves();
        let (sine, cosine) = f64::sine_cosine(rest - Turns::QUARTER);
        let middle = e1_plus_e3 + e.e2_minus_e1 * cosine * cosine;
        let start = sine * carlson_rf(e2_plus_e3 * cosine * cosine, middle, e2_plus_e3);

        let mut form = Self {
            e,
            lattice,
            half_periods,
            time_scale,
            alpha,
            beta,
            period: 0.0,
            turns,
            origin: 0.0,
            fit: Fit::none(motion),
        };
        form.period = 2.0 * form.time(imaginary).0;
        form.origin = form.time(start).0;
        let [alpha, beta] = form.germs(start);
        form.fit = Fit::new(motion, alpha, beta);
        Some(form)
    }

    /// The nutation period, |t(2ω₁)|.
    #[must_use]
    pub fn period(&self) -> f64 {
        self.period
    }

    /// Φ and Φ' at t.
    #[must_use]
    pub fn at(&self, t: f64) -> Pose<f64> {
        let (periods, rest) = split(self.origin, t, self.period);
        let [_, half] = self.half_periods;
        let y = solve_rising(rest, [-half, half], 2.0 * half * rest / self.period, |y| self.time(y));
        self.fit.pose(t, self.germs(y), self.turns.map(|turns| turns.times(periods)))
    }

    /// The share of a period that has passed at t, whole periods included: 0 at u = e₁, half a turn at u = e₂.
    #[must_use]
    pub fn nutation_phase(&self, t: f64) -> Turns {
        let (periods, rest) = split(self.origin, t, self.period);
        Turns::ONE.times(periods) + Turns::HALF + Turns::new(rest / self.period)
    }

    /// t and dt/dy at x = iy.
    fn time(&self, y: f64) -> (f64, f64) {
        let [real, _] = self.half_periods;
        let x = Complex::new(-real, y);
        let BranchPoints { e1, e2, e3, .. } = self.e;
        let zetas = self.lattice.bare(x).log_slope().im;
        let linear = 2.0 * self.lattice.kappa() - (e1 + e2 + 2.0 * e3) / 3.0;
        let [_, _, u_plus_e3] = self.lattice.differences(x);
        (-self.time_scale * (zetas + linear * y), self.time_scale * u_plus_e3.re)
    }

    /// α and β at x = iy, and their rates by time.
    fn germs(&self, y: f64) -> [Germ; 2] {
        let (_, per_y) = self.time(y);
        let x = Complex::new(0.0, y);
        [self.alpha, self.beta].map(|parameter| {
            let germ = parameter.at(&self.lattice, x);
            germ.by(Complex::new(0.0, 1.0 / per_y))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::top::{Heaviness, Top};

    /// √(1 + A/(ps)) = 3/2 exactly, and a few units beside it.
    #[test]
    fn four_units_in_the_last_place_are_accepted() {
        let top = Top::sliding(1.25, 1.0, 1.0, Heaviness::MassMoment(1.0), 1.0).unwrap();
        let form = |e3: f64| {
            let motion =
                Motion::from_branch_points(&top, [-0.2, 0.7, e3], Signs::default(), &Default::default());
            E3EqualsE4::new(&motion.unwrap())
        };
        assert!(form(1.5).is_some() && form(1.5 + 4.0 * f64::EPSILON).is_some());
        assert!(form(1.5 + 8.0 * f64::EPSILON).is_none() && form(1.6).is_none());
    }
}
