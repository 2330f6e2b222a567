//! General case as integrals: the curve w² = R(u) with the time integral and the four logarithmic integrals (sections
//! 3.3 and 3.4), and the three elliptic curves to which it degenerates (sections 5.1, 5.3 and 5.4).
//!
//! All four curves have the same form. With R a polynomial in u and T the density of time,
//!
//! ```text
//! dt      = f T(u) du/w
//! dα/α    = (1 + F₋ w₋₁/w) du / (2(u + 1))         F± = T(u)/T(±1)
//! dβ/β    = (1 - F₊ w₊₁/w) du / (2(u - 1))
//! dγ/γ    = (1 + F₊ w₊₁/w) du / (2(u - 1))
//! dδ/δ    = (1 - F₋ w₋₁/w) du / (2(u + 1))
//! w₋₁     = i f T(-1) (l + n)/A,        w₊₁ = i f T(1) (l - n)/A
//! ```
//!
//! | curve | R(u) | T(u) | f (g = 1) | the paper |
//! |---|---|---|---|---|
//! | general | (u-e₁)(u-e₂)(u-e₃)(u²-e₄²) | u²-e₄² | -i√(s/2) | equations (3.9), (3.10) |
//! | e₃ = e₄ | 4(u-e₁)(u-e₂)(u+e₃) | u+e₃ | -i√(2s) | equations (5.1), (5.2) |
//! | e₂ = e₃ = 1 | 4(u-e₁)(u²-e₄²) | (u²-e₄²)/(u-1) | i√(2s) | equations (5.12), (5.13) |
//! | fixed tip | (u-e₁)(u-e₂)(u-e₃) | 1 | √(A/2p) | section 5.4 |
//!
//! Each of w₊₁ and w₋₁ is one of the two values of w over u = ±1; which one depends on the signs that e₁, e₂, e₃
//! leave open. On the general curve sign(w₋₁) = -sign(l + n) and sign(w₊₁) = -sign(l - n), so equal signs mean |l| >
//! |n|. (The first of the two displayed formulas of the paper gives the negatives of these values.)
//!
//! The logarithms are those of a top with C = A; for C ≠ A add ±iτ/2 dt ([`Curve::tau`]).

use crate::complex::Complex;
use crate::constants::{BranchPoints, FirstIntegrals};
use crate::motion::Motion;
use crate::scalar::{Float, Ring};
use crate::su2::quotient;
use crate::top::Top;

/// Kind of curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// Hyperelliptic curve of genus 2, for any motion with a sliding tip.
    General,
    /// Elliptic curve for e₃ = e₄.
    E3EqualsE4,
    /// Elliptic curve for e₂ = e₃ = 1.
    Aperiodic,
    /// Elliptic curve of a top with fixed tip.
    FixedTip,
}

/// Point (u, w) of a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Coordinate u.
    pub u: Complex<f64>,
    /// Coordinate w, one of the two values with w² = R(u).
    pub w: Complex<f64>,
}

impl Point {
    /// Point with the same u on the other sheet.
    #[must_use]
    pub fn other_sheet(&self) -> Self {
        Self { u: self.u, w: -self.w }
    }
}

/// Curve of a motion, with its differentials, in `f64`. Relative error away from the branch points: a few roundings.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Curve {
    form: Form,
    e: BranchPoints,
    /// Square e₄²; not used for a fixed tip.
    e4_squared: f64,
    /// Factor f.
    factor: Complex<f64>,
    /// Factors i(l + n)/A and i(l - n)/A.
    turning: [Complex<f64>; 2],
    tau: f64,
}

impl Curve {
    /// Curve of any motion: [`Form::General`], or [`Form::FixedTip`] for a fixed tip.
    ///
    /// A body without torque has no such curve, because e₃ is infinite; the numbers are then not finite.
    #[must_use]
    pub fn of(motion: &Motion) -> Self {
        match motion.top().e4() {
            Some(_) => Self::new(Form::General, motion),
            None => Self::new(Form::FixedTip, motion),
        }
    }

    /// Elliptic curve of section 5.1; `None` unless |e₃ - e₄| <= 2^-50 e₄. The factor u - e₃ is removed: w of the
    /// general curve is (u - e₃)/2 times w of this one.
    #[must_use]
    pub fn e3_equals_e4(motion: &Motion) -> Option<Self> {
        let e4 = motion.top().e4()?;
        let e3 = motion.branch_points().e3;
        (Float::abs(e3 - e4) <= 4.0 * f64::EPSILON * e4).then(|| Self::new(Form::E3EqualsE4, motion))
    }

    /// Elliptic curve of section 5.3; `None` unless e₂ = e₃ = 1 and the tip slides. The w of the general curve is -(u
    /// - 1)/2 times w of this one.
    #[must_use]
    pub fn aperiodic(motion: &Motion) -> Option<Self> {
        motion.top().e4()?;
        (motion.branch_points().e3_minus_e2 == 0.0).then(|| Self::new(Form::Aperiodic, motion))
    }

    fn new(form: Form, motion: &Motion) -> Self {
        let (top, integrals) = (motion.top(), motion.first_integrals());
        let (a, s, p, g) = (top.transverse_inertia(), top.com_height(), top.mass_moment(), top.gravity());
        let factor = match form {
            Form::General => Complex::new(0.0, -Float::sqrt(0.5 * s / g)),
            Form::E3EqualsE4 => Complex::new(0.0, -Float::sqrt(2.0 * s / g)),
            Form::Aperiodic => Complex::new(0.0, Float::sqrt(2.0 * s / g)),
            Form::FixedTip => Complex::new(Float::sqrt(0.5 * a / (p * g)), 0.0),
        };
        let momenta = [integrals.l_plus_n, integrals.l_minus_n];
        Self {
            form,
            e: motion.branch_points(),
            e4_squared: 1.0 + a / (p * s),
            factor,
            turning: momenta.map(|momentum| Complex::new(0.0, momentum / a)),
            tau: integrals.spin - integrals.n / a,
        }
    }

    /// Kind of this curve.
    #[must_use]
    pub fn form(&self) -> Form {
        self.form
    }

    /// Rate τ = ⟨ω, r⟩ - n/A, rad per unit time, without a rotor (1/C - 1/A) n: for C ≠ A add iτ/2 dt to dα/α and dγ/γ, and -iτ/2 dt to dβ/β and
    /// dδ/δ.
    #[must_use]
    pub fn tau(&self) -> f64 {
        self.tau
    }

    /// Polynomial R(u), the square of w.
    #[must_use]
    pub fn r(&self, u: Complex<f64>) -> Complex<f64> {
        let from = |e: f64| u - real(e);
        let BranchPoints { e1, e2, e3, .. } = self.e;
        let outer = u * u - real(self.e4_squared);
        match self.form {
            Form::General => from(e1) * from(e2) * from(e3) * outer,
            Form::E3EqualsE4 => (from(e1) * from(e2) * from(-e3)).scaled(4.0),
            Form::Aperiodic => (from(e1) * outer).scaled(4.0),
            Form::FixedTip => from(e1) * from(e2) * from(e3),
        }
    }

    /// Density of time T(u).
    fn density(&self, u: Complex<f64>) -> Complex<f64> {
        let outer = u * u - real(self.e4_squared);
        match self.form {
            Form::General => outer,
            Form::E3EqualsE4 => u + real(self.e.e3),
            Form::Aperiodic => over(outer, u - Complex::ONE),
            Form::FixedTip => Complex::ONE,
        }
    }

    /// Point over u whose w has Re w > 0, or Re w = 0 and Im w >= 0.
    #[must_use]
    pub fn point(&self, u: Complex<f64>) -> Point {
        Point { u, w: root(self.r(u)) }
    }

    /// Point over `u` on the sheet of a nearby point, found by the w nearer to the previous one. It is correct if w
    /// rotates by less than a quarter turn on the straight path.
    #[must_use]
    pub fn moved(&self, from: &Point, u: Complex<f64>) -> Point {
        let point = self.point(u);
        if (point.w * from.w.conj()).re < 0.0 { point.other_sheet() } else { point }
    }

    /// Point (u, w) of a motion with this u and u': w = f T(u) u', for which equation (3.9) of the paper gives a time
    /// that increases.
    #[must_use]
    pub fn on_motion(&self, u: f64, udot: f64) -> Point {
        let u = real(u);
        Point { u, w: self.factor * self.density(u).scaled(udot) }
    }

    /// Value w₋₁ of w over u = -1 that corresponds to l + n.
    #[must_use]
    pub fn w_minus_one(&self) -> Complex<f64> {
        let [plus, _] = self.turning;
        plus * self.factor * self.density(-Complex::ONE)
    }

    /// Value w₊₁ of w over u = 1 that corresponds to l - n. On the aperiodic curve l = n, and no value is
    /// distinguished: the result is the one with Re w > 0, or Im w > 0.
    #[must_use]
    pub fn w_plus_one(&self) -> Complex<f64> {
        let [_, minus] = self.turning;
        match self.form {
            Form::Aperiodic => root(self.r(Complex::ONE)),
            _ => minus * self.factor * self.density(Complex::ONE),
        }
    }

    /// Derivative dt/du at a point. It is infinite at the branch points other than ±e₄.
    #[must_use]
    pub fn time(&self, at: &Point) -> Complex<f64> {
        over(self.factor * self.density(at.u), at.w)
    }

    /// Derivatives d log α/du, d log β/du, d log γ/du and d log δ/du at a point, for C = A. They are infinite at
    /// their poles and at branch points.
    #[must_use]
    pub fn logarithms(&self, at: &Point) -> [Complex<f64>; 4] {
        // F∓ w∓₁ = T(u) f i(l ± n)/A; on the aperiodic curve the second is 0
        let time = self.time(at);
        let [plus, minus] = self.turning.map(|turning| turning * time);
        let about = |sum: Complex<f64>, u: Complex<f64>| over(sum, u.scaled(2.0));
        let (above, below) = (at.u + Complex::ONE, at.u - Complex::ONE);
        [
            about(Complex::ONE + plus, above),
            about(Complex::ONE - minus, below),
            about(Complex::ONE + minus, below),
            about(Complex::ONE - plus, above),
        ]
    }

    /// Derivative dφ/du of the tip angle at a point (equation (4.1) of the paper), for any C. It is real on the
    /// motion.
    #[must_use]
    pub fn tip_angle(&self, at: &Point) -> Complex<f64> {
        let time = self.time(at);
        let [plus, minus] = self.turning.map(|turning| turning * time);
        let sum = over(plus, at.u + Complex::ONE) - over(minus, at.u - Complex::ONE);
        sum.scaled(0.5).times_i().scaled(-1.0)
    }

    /// Points where α, β, γ and δ are 0: their logarithmic differentials have residue 1 there and -1 at infinity
    /// (Table 1). On the aperiodic curve β and γ have no zero (Table 2); the result has the two points over u = 1
    /// instead.
    #[must_use]
    pub fn zeros(&self) -> [Point; 4] {
        let alpha = Point { u: -Complex::ONE, w: self.w_minus_one() };
        let gamma = Point { u: Complex::ONE, w: self.w_plus_one() };
        [alpha, gamma.other_sheet(), gamma, alpha.other_sheet()]
    }
}

/// R(u) from l, n and h instead of e₁, e₂, e₃ (equation (3.8) of the paper); `None` for a fixed tip.
///
/// The terms cancel near the branch points. Absolute error: a few roundings of (1 + h/(pg)) e₄².
#[must_use]
pub fn r_of_integrals(top: &Top, integrals: &FirstIntegrals, u: Complex<f64>) -> Option<Complex<f64>> {
    let e4 = top.e4()?;
    let FirstIntegrals { l, n, h, spin, .. } = *integrals;
    let (square, pg) = (u * u, top.mass_moment() * top.gravity());
    let energy = real(h - 0.5 * top.axial_inertia() * spin * spin) - u.scaled(pg);
    let momentum = real(l) - u.scaled(n);
    let cubic = ((Complex::ONE - square) * energy).scaled(1.0 / pg)
        - (momentum * momentum).scaled(0.5 / (top.transverse_inertia() * pg));
    Some((square - real(e4.squared())) * cubic)
}

fn real(x: f64) -> Complex<f64> {
    Complex::new(x, 0.0)
}

/// Quotient a / b; infinite at b = 0.
fn over(a: Complex<f64>, b: Complex<f64>) -> Complex<f64> {
    quotient(a, b).unwrap_or(Complex::new(f64::INFINITY, f64::INFINITY))
}

/// Square root with Re > 0, or Re = 0 and Im >= 0.
fn root(z: Complex<f64>) -> Complex<f64> {
    let modulus = libm::hypot(z.re, z.im);
    let larger = Float::sqrt(0.5 * (modulus + Float::abs(z.re)));
    if larger == 0.0 {
        return Complex::ZERO;
    }
    let smaller = 0.5 * z.im / larger;
    if z.re >= 0.0 {
        Complex::new(larger, smaller)
    } else if z.im < 0.0 {
        Complex::new(-smaller, -larger)
    } else {
        Complex::new(smaller, larger)
    }
}
