//! Contour quadrature on the paper's curves by the trapezoid rule on circles, which converges geometrically.

use toytop::Complex;
use toytop::exact::hyperelliptic::{Curve, Point};

/// Number of nodes on a circle.
const NODES: u32 = 512;

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
