//! The Lagrange top, its tip held: Klein's elliptic solution (section 5.4 of the paper; s = 0).
//!
//! With z = √(pg/2A) t and w² = 4 (u - e₁)(u - e₂)(u - e₃), whose half periods are ω > 0 and ω' imaginary,
//!
//! ```text
//! u = ℘(z + ω') + (e₁ + e₂ + e₃)/3 = e₁ + (e₂ - e₁) sn²(√(e₃ - e₁) z)
//! α = k e^{ζ(a + ω') z} σ(z - a)/σ(z + ω'),   u(a) = -1,   ℘'(a + ω') =  i (l + n) √(2/(A p g))
//! β = k e^{ζ(b + ω') z} σ(z - b)/σ(z + ω'),   u(b) =  1,   ℘'(b + ω') = -i (l - n) √(2/(A p g))
//! ```
//!
//! z runs along the real axis, from u = e₁ at 0.

use super::agm::{carlson_rf, first_kind};
use super::orientation::Fit;
use super::periods::split;
use super::sigma_quotient::{Germ, SigmaQuotient};
use super::weierstrass::Weierstrass;
use crate::complex::Complex;
use crate::launch::{Motion, Signs};
use crate::real::{Float, Scalar};
use crate::tick::Pose;
use crate::top::Support;
use crate::turns::Turns;

/// A nutating Lagrange top as a function of time.
///
/// Error of an orientation: 1e-14 rad in the first periods, 1e-13 rad where differences of the branch points are as small
/// as 1e-12; and some 3e-15 rad more in every period, from the rounding of the period itself. Cost: set-up some 20 theta functions, a time four; no iteration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lagrange {
    lattice: Weierstrass,
    /// z per unit of time.
    pace: f64,
    alpha: SigmaQuotient,
    beta: SigmaQuotient,
    period: f64,
    /// What a period turns α and β besides the drift.
    turns: [Turns; 2],
    /// The time since u = e₁ at t = 0.
    origin: f64,
    fit: Fit,
}

impl Lagrange {
    /// The closed form of a motion; `None` unless the tip is fixed and u swings, e₁ < e₂ < e₃.
    #[must_use]
    pub fn new(motion: &Motion) -> Option<Self> {
        let (top, e) = (motion.top(), motion.branch_points());
        let chi = motion.nutation_start()?;
        if top.support() != Support::Fixed {
            return None;
        }
        let (swing, gap) = (e.e2_minus_e1, e.e3_minus_e2);
        let lattice = Weierstrass::of_gaps(gap, swing);
        let [real, imaginary] = lattice.half_periods();
        let pace = Float::sqrt(0.5 * top.p() * top.g() / top.a());

        // from u = -1 up to e₁ and from e₂ up to 1, along imaginary z
        let to_e1 = first_kind(
            e.one_plus_e1,
            [0.0, swing, e.e3_minus_e1()],
            [e.one_plus_e1, e.one_plus_e2(), e.one_plus_e3()],
        );
        let to_one =
            first_kind(e.one_minus_e2, [e.one_minus_e1(), e.one_minus_e2, e.e3_minus_one], [swing, 0.0, gap]);
        let Signs { l_plus_n, l_minus_n } = motion.signs();
        let a = Complex::new(0.0, l_plus_n.times(0.5 * to_e1));
        let b = Complex::new(real, l_minus_n.times(0.5 * to_one));
        let (pole, highest) = (Complex::new(0.0, -imaginary), Complex::new(real, 0.0));
        // |k| by |α| at u = e₂, |β| at u = e₁, which never vanish
        let modulus = |x: f64| Float::sqrt(0.5 * x);
        let alpha =
            SigmaQuotient::through(&lattice, [a, pole], Complex::ZERO, (highest, modulus(e.one_plus_e2())));
        let beta = SigmaQuotient::through(
            &lattice,
            [b, pole],
            Complex::ZERO,
            (Complex::ZERO, modulus(e.one_minus_e1())),
        );
        let whole = Complex::new(2.0 * real, 0.0);
        let turns = [alpha.turns(&lattice, -highest, whole), beta.turns(&lattice, Complex::ZERO, whole)];

        // z(0) within half a period of u = e₁: the elliptic integral of χ
        let (_, rest) = chi.halves();
        let rest = if rest > Turns::QUARTER { rest - Turns::HALF } else { rest };
        let (sine, cosine) = f64::sine_cosine(rest);
        let squared = cosine * cosine;
        let start = sine * carlson_rf(e.e3_minus_e1() * squared, gap + swing * squared, e.e3_minus_e1());

        let mut form = Self {
            lattice,
            pace,
            alpha,
            beta,
            period: 2.0 * real / pace,
            turns,
            origin: start / pace,
            fit: Fit::none(motion),
        };
        let [alpha, beta] = form.germs(form.origin);
        form.fit = Fit::new(motion, alpha, beta);
        Some(form)
    }

    /// The nutation period, 2ω √(2A/(pg)).
    #[must_use]
    pub fn period(&self) -> f64 {
        self.period
    }

    /// Φ and Φ' at t.
    #[must_use]
    pub fn at(&self, t: f64) -> Pose<f64> {
        let (periods, rest) = split(self.origin, t, self.period);
        self.fit.pose(t, self.germs(rest), self.turns.map(|turns| turns.times(periods)))
    }

    /// The share of a period that has passed at t, whole periods included: 0 at u = e₁, half a turn at u = e₂.
    #[must_use]
    pub fn nutation_phase(&self, t: f64) -> Turns {
        let (periods, rest) = split(self.origin, t, self.period);
        Turns::ONE.times(periods) + Turns::new(rest / self.period)
    }

    /// α and β at this time since u = e₁, and their rates.
    fn germs(&self, time: f64) -> [Germ; 2] {
        let z = Complex::new(self.pace * time, 0.0);
        let pace = Complex::new(self.pace, 0.0);
        [self.alpha, self.beta].map(|parameter| parameter.at(&self.lattice, z).by(pace))
    }
}
