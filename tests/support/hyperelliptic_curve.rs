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

use num_complex::Complex64 as C;
use toytop::Motion;

/// Imaginary unit.
pub const I: C = C::new(0.0, 1.0);

/// Kind of curve.
#[derive(Clone, Copy, PartialEq)]
pub enum Form {
    /// Sliding tip: genus 2.
    General,
    /// Sliding tip with e₃ = e₄.
    E3EqualsE4,
    /// Sliding tip with e₂ = e₃ = 1.
    Aperiodic,
    /// Fixed tip.
    FixedTip,
}

/// Point (u, w) of a curve.
#[derive(Clone, Copy)]
pub struct Point {
    /// Coordinate u.
    pub u: C,
    /// Square root w of R(u).
    pub w: C,
}

impl Point {
    /// Point (u, -w).
    pub fn other_sheet(self) -> Self {
        Self { w: -self.w, ..self }
    }
}

/// Curve of a motion, with its differentials.
pub struct Curve {
    /// Kind.
    pub form: Form,
    /// Finite branch points, the zeros of R.
    pub branch_points: Vec<f64>,
    /// Coefficient of the highest power of u in R.
    leading: f64,
    e4: f64,
    /// Factor f.
    factor: C,
    /// Factors i(l + n)/A and i(l - n)/A.
    turning: [C; 2],
    /// Rate τ = ⟨ω, r⟩ - n/A: for C ≠ A add iτ/2 dt to dα/α and dγ/γ, and -iτ/2 dt to dβ/β and dδ/δ.
    pub tau: f64,
}

impl Curve {
    /// Curve of a form that the motion has. The w of the general curve is (u - e₃)/2 times w for e₃ = e₄, and -(u - 1)/2 times w for
    /// e₂ = e₃ = 1.
    pub fn new(form: Form, motion: &Motion) -> Self {
        let (top, integrals, e) = (motion.top(), motion.first_integrals(), motion.branch_points());
        let (a, s, g) = (top.transverse_inertia(), top.com_height(), top.gravity());
        let e4 = top.e4().unwrap_or_default();
        let (factor, leading, branch_points) = match form {
            Form::General => (-I * (0.5 * s / g).sqrt(), 1.0, vec![e.e1, e.e2, e.e3, e4, -e4]),
            Form::E3EqualsE4 => (-I * (2.0 * s / g).sqrt(), 4.0, vec![e.e1, e.e2, -e4]),
            Form::Aperiodic => (I * (2.0 * s / g).sqrt(), 4.0, vec![e.e1, e4, -e4]),
            Form::FixedTip => {
                (C::from((0.5 * a / (top.mass_moment() * g)).sqrt()), 1.0, vec![e.e1, e.e2, e.e3])
            }
        };
        let turning = [integrals.l_plus_n, integrals.l_minus_n].map(|momentum| I * momentum / a);
        Self { form, branch_points, leading, e4, factor, turning, tau: integrals.spin - integrals.n / a }
    }

    /// Polynomial R(u), the square of w.
    pub fn r(&self, u: C) -> C {
        self.branch_points.iter().map(|e| u - e).product::<C>() * self.leading
    }

    fn density(&self, u: C) -> C {
        let outer = u * u - self.e4 * self.e4;
        match self.form {
            Form::General => outer,
            Form::E3EqualsE4 => u + self.e4,
            Form::Aperiodic => outer / (u - 1.0),
            Form::FixedTip => C::from(1.0),
        }
    }

    /// Point over u with Re w >= 0.
    pub fn point(&self, u: C) -> Point {
        Point { u, w: self.r(u).sqrt() }
    }

    /// Point over `u` on the sheet of a nearby point, if w rotates by less than a quarter turn in between.
    fn moved(&self, from: Point, u: C) -> Point {
        let point = self.point(u);
        if (point.w * from.w.conj()).re < 0.0 { point.other_sheet() } else { point }
    }

    /// Point (u, w) of a motion with this u and u': w = f T(u) u' (equation (3.9)).
    pub fn on_motion(&self, u: f64, udot: f64) -> Point {
        let u = C::from(u);
        Point { u, w: self.factor * self.density(u) * udot }
    }

    /// Value w₋₁ of w over u = -1 that corresponds to l + n.
    pub fn w_minus_one(&self) -> C {
        self.turning[0] * self.factor * self.density(C::from(-1.0))
    }

    /// Value w₊₁ of w over u = 1 that corresponds to l - n; one of the two on the aperiodic curve, where l = n.
    pub fn w_plus_one(&self) -> C {
        match self.form {
            Form::Aperiodic => self.r(C::from(1.0)).sqrt(),
            _ => self.turning[1] * self.factor * self.density(C::from(1.0)),
        }
    }

    /// Derivative dt/du at a point.
    pub fn time(&self, at: Point) -> C {
        self.factor * self.density(at.u) / at.w
    }

    /// Derivatives d log α/du, d log β/du, d log γ/du and d log δ/du at a point, for C = A.
    pub fn logarithms(&self, at: Point) -> [C; 4] {
        // F∓ w∓₁ = T(u) f i(l ± n)/A; on the aperiodic curve the second is 0
        let [plus, minus] = self.turning.map(|turning| turning * self.time(at));
        let (above, below) = ((at.u + 1.0) * 2.0, (at.u - 1.0) * 2.0);
        [(1.0 + plus) / above, (1.0 - minus) / below, (1.0 + minus) / below, (1.0 - plus) / above]
    }

    /// Derivative dφ/du of the tip angle at a point (equation (4.1)), for any C.
    pub fn tip_angle(&self, at: Point) -> C {
        let [plus, minus] = self.turning.map(|turning| turning * self.time(at));
        (plus / (at.u + 1.0) - minus / (at.u - 1.0)) * -0.5 * I
    }

    /// Points where α, β, γ and δ are 0 (Table 1); for β and γ on the aperiodic curve the points over u = 1 (Table 2).
    pub fn zeros(&self) -> [Point; 4] {
        let alpha = Point { u: C::from(-1.0), w: self.w_minus_one() };
        let gamma = Point { u: C::from(1.0), w: self.w_plus_one() };
        [alpha, gamma.other_sheet(), gamma, alpha.other_sheet()]
    }

    /// Integral (1/2πi) ∮ f(point, v) du once around 0 in the parameter v of a place.
    pub fn around(&self, place: Place, f: impl Fn(Point, C) -> C) -> C {
        const NODES: u32 = 512;
        let radius = if matches!(place, Place::Ellipse) { 1.0 } else { 0.3 };
        // v, u and du/(i dθ)
        let path = |node: u32| {
            let v = C::from_polar(radius, std::f64::consts::TAU * f64::from(node) / f64::from(NODES));
            let (u, along) = match place {
                Place::Over(Point { u, .. }) => (u + v / 3.0, v / 3.0),
                Place::BranchPoint(e) => (e + v * v, 2.0 * v * v),
                Place::Infinity => (1.0 / (v * v), -2.0 / (v * v)),
                Place::Ellipse => (0.6 * v + 0.1 / v, 0.6 * v - 0.1 / v),
            };
            (v, u, along)
        };
        let (_, first, _) = path(0);
        let mut point = match place {
            Place::Over(point) => self.moved(point, first),
            _ => self.point(first),
        };
        let terms = (0..NODES).map(|node| {
            let (v, u, along) = path(node);
            point = self.moved(point, u);
            f(point, v) * along
        });
        terms.sum::<C>() / f64::from(NODES)
    }
}

/// Points that a contour surrounds. The branch points are at least 0.09 from each other and from ±1.
#[derive(Clone, Copy)]
pub enum Place {
    /// A point that is no branch point: u + v/3.
    Over(Point),
    /// A branch point: e + v².
    BranchPoint(f64),
    /// Infinity: 1/v².
    Infinity,
    /// The ellipse with the half axes 0.7 and 0.5.
    Ellipse,
}
