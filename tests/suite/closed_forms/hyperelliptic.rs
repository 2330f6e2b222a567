//! Sections 3.3, 3.4, 5: the curves, the integrals on them and their poles, by contour quadrature and against the
//! full solution.

use crate::motion::full_solver::solver;
use toytop::{Complex, FirstIntegrals, Motion, Orientation, Sign, Signs, Top};
use toytop_tests::hyperelliptic::{Curve, Form, Point, around_ellipse};
use toytop_tests::{by_branch_points, greater, tolerance, top_of};

pub(super) fn size(z: Complex<f64>) -> f64 {
    z.norm_squared().sqrt()
}

pub(super) fn real(x: f64) -> Complex<f64> {
    Complex::new(x, 0.0)
}

const CHOICES: [Signs; 4] = {
    use Sign::{Minus, Plus};
    [
        Signs { l_plus_n: Plus, l_minus_n: Plus },
        Signs { l_plus_n: Plus, l_minus_n: Minus },
        Signs { l_plus_n: Minus, l_minus_n: Plus },
        Signs { l_plus_n: Minus, l_minus_n: Minus },
    ]
};

/// Top with C ≠ A and g ≠ 1.
pub(super) fn top() -> Top {
    top_of([1.1, 0.8, 0.6, 0.9], 1.3)
}

fn motion(top: &Top, e: [f64; 3], signs: Signs) -> Motion {
    by_branch_points(top, e, signs)
}

/// Motion on each of the four curves, for each choice of signs.
pub(super) fn curves() -> Vec<(Motion, Curve)> {
    let (sliding, spherical) = (top(), top_of([1.1, 1.1, 0.6, 0.9], 1.3));
    let fixed = top_of([1.1, 0.8, 0.0, 0.9], 1.3);
    let e4 = sliding.e4().unwrap();
    let mut curves = Vec::new();
    for signs in CHOICES {
        for top in [&sliding, &spherical, &fixed] {
            let motion = motion(top, [-0.3, 0.6, 1.4], signs);
            curves.push((motion, Curve::of(&motion)));
        }
        let equal = motion(&sliding, [-0.3, 0.6, e4], signs);
        curves.push((equal, Curve::new(Form::E3EqualsE4, &equal)));
        let aperiodic = motion(&sliding, [-0.3, 1.0, 1.0], signs);
        curves.push((aperiodic, Curve::new(Form::Aperiodic, &aperiodic)));
    }
    curves
}

/// Equation (3.8): R from l, n, h equals R from e₁, e₂, e₃, at complex u and for all four pairs (l, n).
#[test]
fn eqn_r_with_l_n_h() {
    let mut worst = 0.0_f64;
    for signs in CHOICES {
        let motion = motion(&top(), [-0.3, 0.6, 1.4], signs);
        let curve = Curve::of(&motion);
        for i in 0..50 {
            let x = f64::from(i);
            let u = Complex::new(2.0 * (0.9 * x).sin(), 2.0 * (1.7 * x).cos());
            let ours = r_of_integrals(&motion, u);
            worst = greater(worst, size(ours - curve.r(u)) / size(curve.r(u)).max(1.0));
        }
    }
    tolerance::EQUATIONS.check("R(u)", worst);
}

/// R(u) from l, n and h.
fn r_of_integrals(motion: &Motion, u: Complex<f64>) -> Complex<f64> {
    let (top, FirstIntegrals { l, n, h, spin, .. }) = (motion.top(), motion.first_integrals());
    let (square, pg) = (u * u, top.mass_moment() * top.gravity());
    let energy = real(h - 0.5 * top.axial_inertia() * spin * spin) - u.scaled(pg);
    let momentum = real(l) - u.scaled(n);
    let cubic = ((Complex::ONE - square) * energy).scaled(1.0 / pg)
        - (momentum * momentum).scaled(0.5 / (top.transverse_inertia() * pg));
    (square - real(top.e4().unwrap().powi(2))) * cubic
}

/// Equations (3.9), (3.10) and (4.1) (and their degenerate forms) at instants of the full solution: w² = R, dt/du u'
/// = 1, and the logarithmic rates of α, β, γ, δ, with iτ/2 where C ≠ A.
#[test]
fn eqn_t_and_eqn_abgdints_on_the_full_solution() {
    let (mut curve_worst, mut rate_worst) = (0.0_f64, 0.0_f64);
    for (motion, curve) in curves() {
        let mut path = solver(&motion);
        for i in 1..12 {
            let state = path.advance_to(0.23 * f64::from(i)).unwrap();
            let complex = |[re, im]: [f64; 2]| Complex::new(re, im);
            let phi = Orientation { alpha: complex(state.alpha), beta: complex(state.beta) };
            let rate = toytop::su2::OrientationRate::from_fixed(&phi, state.omega);
            let (u, udot) = (phi.u(), rate.udot(&phi));
            if udot.abs() < 0.05 {
                continue; // at a turning point the integrands are infinite
            }
            let at = curve.on_motion(u, udot);
            curve_worst =
                greater(curve_worst, size(at.w * at.w - curve.r(at.u)) / size(curve.r(at.u)).max(1.0));
            curve_worst = greater(curve_worst, size(curve.time(&at).scaled(udot) - Complex::ONE));
            let over = |a: Complex<f64>, b: Complex<f64>| (a * b.conj()).scaled(1.0 / b.norm_squared());
            let (gamma, delta) = (-rate.beta.conj(), rate.alpha.conj());
            let truth = [
                over(rate.alpha, phi.alpha),
                over(rate.beta, phi.beta),
                over(gamma, phi.gamma()),
                over(delta, phi.delta()),
            ];
            let tau = Complex::new(0.0, 0.5 * curve.tau());
            let drift = [tau, -tau, tau, -tau];
            for ((ours, drift), truth) in curve.logarithms(&at).into_iter().zip(drift).zip(truth) {
                let ours = ours.scaled(udot) + drift;
                rate_worst = greater(rate_worst, size(ours - truth) / size(truth).max(1.0));
            }
            // equation (4.1)
            let tip = over(phi.alpha * rate.beta + rate.alpha * phi.beta, phi.alpha * phi.beta).im;
            let ours = curve.tip_angle(&at).scaled(udot);
            rate_worst =
                greater(rate_worst, greater((ours.re - tip).abs(), ours.im.abs()) / tip.abs().max(1.0));
            let (integrals, a) = (motion.first_integrals(), motion.top().transverse_inertia());
            let reduced = (integrals.l - integrals.n * u) / (a * (1.0 - u * u));
            rate_worst = greater(rate_worst, (reduced - tip).abs() / tip.abs().max(1.0));
        }
    }
    tolerance::CURVE_ON_PATH.check("w and dt", curve_worst);
    tolerance::EQUATIONS.check("d log and dφ", rate_worst);
}

/// Equations (3.7) and (3.9): the integral of dt around the cut [e₁, e₂] is a nutation period, and those of d log α
/// and d log β are the advances of α and β over it.
#[test]
fn eqn_tint0_around_the_cut() {
    let mut worst = 0.0_f64;
    for signs in CHOICES {
        for top in [top(), top_of([1.1, 0.8, 0.0, 0.9], 1.3)] {
            let motion = motion(&top, [-0.4, 0.4, 1.7], signs);
            let (curve, averages) = (Curve::of(&motion), motion.period_advance().unwrap());
            let ellipse = |f: &dyn Fn(&Point) -> Complex<f64>| {
                around_ellipse(&curve, 0.0, [0.7, 0.5], f).scaled(2.0 * std::f64::consts::PI).times_i()
            };
            let time = ellipse(&|at| curve.time(at));
            // the contour has the direction of the motion or the opposite one
            let sense = time.re.signum();
            worst = greater(worst, size(time - real(sense * averages.period)) / averages.period);
            let tau = Complex::new(0.0, 0.5 * curve.tau() * averages.period);
            for (part, tau, turns) in [(0, tau, averages.alpha_turns), (1, -tau, averages.beta_turns)] {
                let turn = ellipse(&|at| curve.logarithms(at)[part]).scaled(sense) + tau;
                let angle = 2.0 * std::f64::consts::PI * turns;
                worst = greater(worst, size(turn - Complex::new(0.0, angle)) / angle.abs().max(1.0));
            }
        }
    }
    tolerance::CONTOUR.check("around the cut", worst);
}
