//! Hyperelliptic curve w² = R(u) of the general case, with the time integral and the four logarithmic integrals (sections 3.3 and 3.4), and
//! the three elliptic curves to which it degenerates (sections 5.1, 5.3 and 5.4). Contour integrals on them, by the trapezoid rule.
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
//! Each of w₊₁ and w₋₁ is one of the two values of w over u = ±1. On the general curve sign(w₋₁) = -sign(l + n) and
//! sign(w₊₁) = -sign(l - n). (The first of the two displayed formulas of the paper gives the negatives of these values.)

use toytop::{BranchPoints, Complex, Motion};

/// Number of nodes of a contour.
const NODES: u32 = 512;

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
    pub fn other_sheet(&self) -> Self {
        Self { u: self.u, w: -self.w }
    }
}

/// Curve of a motion, with its differentials.
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
    pub fn of(motion: &Motion) -> Self {
        match motion.top().e4() {
            Some(_) => Self::new(Form::General, motion),
            None => Self::new(Form::FixedTip, motion),
        }
    }

    /// Curve of a form that the motion has. The w of the general curve is (u - e₃)/2 times w for e₃ = e₄, and -(u - 1)/2 times w for
    /// e₂ = e₃ = 1.
    pub fn new(form: Form, motion: &Motion) -> Self {
        let (top, integrals) = (motion.top(), motion.first_integrals());
        let (a, s, p, g) = (top.transverse_inertia(), top.com_height(), top.mass_moment(), top.gravity());
        let factor = match form {
            Form::General => Complex::new(0.0, -(0.5 * s / g).sqrt()),
            Form::E3EqualsE4 => Complex::new(0.0, -(2.0 * s / g).sqrt()),
            Form::Aperiodic => Complex::new(0.0, (2.0 * s / g).sqrt()),
            Form::FixedTip => Complex::new((0.5 * a / (p * g)).sqrt(), 0.0),
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
    pub fn form(&self) -> Form {
        self.form
    }

    /// Rate τ = ⟨ω, r⟩ - n/A: for C ≠ A add iτ/2 dt to dα/α and dγ/γ, and -iτ/2 dt to dβ/β and dδ/δ.
    pub fn tau(&self) -> f64 {
        self.tau
    }

    /// Polynomial R(u), the square of w.
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

    fn density(&self, u: Complex<f64>) -> Complex<f64> {
        let outer = u * u - real(self.e4_squared);
        match self.form {
            Form::General => outer,
            Form::E3EqualsE4 => u + real(self.e.e3),
            Form::Aperiodic => over(outer, u - Complex::ONE),
            Form::FixedTip => Complex::ONE,
        }
    }

    /// Point over u with the w of [`root`].
    pub fn point(&self, u: Complex<f64>) -> Point {
        Point { u, w: root(self.r(u)) }
    }

    /// Point over `u` on the sheet of a nearby point, if w rotates by less than a quarter turn in between.
    pub fn moved(&self, from: &Point, u: Complex<f64>) -> Point {
        let point = self.point(u);
        if (point.w * from.w.conj()).re < 0.0 { point.other_sheet() } else { point }
    }

    /// Point (u, w) of a motion with this u and u': w = f T(u) u' (equation (3.9)).
    pub fn on_motion(&self, u: f64, udot: f64) -> Point {
        let u = real(u);
        Point { u, w: self.factor * self.density(u).scaled(udot) }
    }

    /// Value w₋₁ of w over u = -1 that corresponds to l + n.
    pub fn w_minus_one(&self) -> Complex<f64> {
        let [plus, _] = self.turning;
        plus * self.factor * self.density(-Complex::ONE)
    }

    /// Value w₊₁ of w over u = 1 that corresponds to l - n; one of the two on the aperiodic curve, where l = n.
    pub fn w_plus_one(&self) -> Complex<f64> {
        let [_, minus] = self.turning;
        match self.form {
            Form::Aperiodic => root(self.r(Complex::ONE)),
            _ => minus * self.factor * self.density(Complex::ONE),
        }
    }

    /// Derivative dt/du at a point.
    pub fn time(&self, at: &Point) -> Complex<f64> {
        over(self.factor * self.density(at.u), at.w)
    }

    /// Derivatives d log α/du, d log β/du, d log γ/du and d log δ/du at a point, for C = A.
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

    /// Derivative dφ/du of the tip angle at a point (equation (4.1)), for any C.
    pub fn tip_angle(&self, at: &Point) -> Complex<f64> {
        let time = self.time(at);
        let [plus, minus] = self.turning.map(|turning| turning * time);
        let sum = over(plus, at.u + Complex::ONE) - over(minus, at.u - Complex::ONE);
        sum.scaled(0.5).times_i().scaled(-1.0)
    }

    /// Points where α, β, γ and δ are 0 (Table 1); for β and γ on the aperiodic curve the points over u = 1 (Table 2).
    pub fn zeros(&self) -> [Point; 4] {
        let alpha = Point { u: -Complex::ONE, w: self.w_minus_one() };
        let gamma = Point { u: Complex::ONE, w: self.w_plus_one() };
        [alpha, gamma.other_sheet(), gamma, alpha.other_sheet()]
    }
}

fn real(x: f64) -> Complex<f64> {
    Complex::new(x, 0.0)
}

/// Quotient a / b; infinite at b = 0.
fn over(a: Complex<f64>, b: Complex<f64>) -> Complex<f64> {
    let norm = b.norm_squared();
    if norm > 0.0 { (a * b.conj()).scaled(1.0 / norm) } else { Complex::new(f64::INFINITY, f64::INFINITY) }
}

/// Square root with Re > 0, or Re = 0 and Im >= 0; -0 in z counts as 0.
fn root(z: Complex<f64>) -> Complex<f64> {
    let root = num_complex::Complex64::new(z.re, z.im + 0.0).sqrt();
    Complex::new(root.re, root.im)
}

/// Unit complex number e^{iθ}.
pub fn cis(angle: f64) -> Complex<f64> {
    Complex::new(angle.cos(), angle.sin())
}

/// Integral (1/2πi) ∮ f du anticlockwise around a point that is no branch point, on a circle of this radius in u.
pub fn residue(
    curve: &Curve,
    centre: &Point,
    radius: f64,
    f: impl Fn(&Point) -> Complex<f64>,
) -> Complex<f64> {
    let offset = |angle: f64| cis(angle).scaled(radius);
    let start = curve.moved(centre, centre.u + offset(0.0));
    circle(curve, start, |angle| (centre.u + offset(angle), offset(angle)), f)
}

/// Integral (1/2πi) ∮ f du anticlockwise around a branch point e in its local parameter ξ, u = e + ξ²: twice around in u.
pub fn residue_at_branch_point(
    curve: &Curve,
    e: f64,
    radius: f64,
    f: impl Fn(&Point) -> Complex<f64>,
) -> Complex<f64> {
    let place = |angle: f64| {
        let xi = cis(angle).scaled(radius);
        let square = xi * xi;
        (Complex::new(e, 0.0) + square, square.scaled(2.0))
    };
    circle(curve, curve.point(place(0.0).0), place, f)
}

/// Integral (1/2πi) ∮ f(point, v) du anticlockwise around v = 0, u = 1/v²: twice around infinity.
pub fn residue_at_infinity(
    curve: &Curve,
    radius: f64,
    f: impl Fn(&Point, Complex<f64>) -> Complex<f64>,
) -> Complex<f64> {
    let u = |angle: f64| cis(-2.0 * angle).scaled(1.0 / (radius * radius));
    let mut point = curve.point(u(0.0));
    mean(|angle| {
        point = curve.moved(&point, u(angle));
        // du = -2 v⁻³ dv and dv = i v dθ
        f(&point, cis(angle).scaled(radius)) * point.u.scaled(-2.0)
    })
}

/// Integral (1/2πi) ∮ f du along a closed path u(θ), given with u'(θ)/i.
fn circle(
    curve: &Curve,
    start: Point,
    place: impl Fn(f64) -> (Complex<f64>, Complex<f64>),
    f: impl Fn(&Point) -> Complex<f64>,
) -> Complex<f64> {
    let mut point = start;
    mean(|angle| {
        let (u, along) = place(angle);
        point = curve.moved(&point, u);
        f(&point) * along
    })
}

/// Integral (1/2πi) ∮ f du once around the ellipse with these half axes, from its right end, where w has Re w > 0.
pub fn around_ellipse(
    curve: &Curve,
    centre: f64,
    [a, b]: [f64; 2],
    f: impl Fn(&Point) -> Complex<f64>,
) -> Complex<f64> {
    let place = |angle: f64| {
        let (sine, cosine) = angle.sin_cos();
        (Complex::new(centre + a * cosine, b * sine), Complex::new(b * cosine, a * sine))
    };
    circle(curve, curve.point(place(0.0).0), place, f)
}

fn mean(mut f: impl FnMut(f64) -> Complex<f64>) -> Complex<f64> {
    let angles = (0..NODES).map(|i| 2.0 * std::f64::consts::PI * f64::from(i) / f64::from(NODES));
    angles.fold(Complex::ZERO, |sum, angle| sum + f(angle)).scaled(1.0 / f64::from(NODES))
}
