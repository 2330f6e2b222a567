//! Sections 3.3, 3.4, 5: the curves, the integrals on them and their poles, by contour quadrature and against the
//! full solution.

mod poles;

use crate::full::solver;
use toytop::exact::hyperelliptic::{Curve, Form, Point, r_of_integrals};
use toytop::exact::tip_curve::TipCurve;
use toytop::{Complex, Motion, Orientation, Regime, Sign, Signs, Start, Top, TopParameters};
use toytop_host::errata::contour::around_ellipse;
use toytop_tests::{greater, tolerance};

fn size(z: Complex<f64>) -> f64 {
    z.norm_squared().sqrt()
}

fn real(x: f64) -> Complex<f64> {
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
fn top() -> Top {
    Top::sliding(&TopParameters {
        transverse_inertia: 1.1,
        axial_inertia: 0.8,
        com_height: 0.6,
        mass_moment: 0.9,
        gravity: 1.3,
        ..TopParameters::default()
    })
    .unwrap()
}

fn motion(top: &Top, e: [f64; 3], signs: Signs) -> Motion {
    Motion::from_branch_points(top, e, signs, &Start::default()).unwrap()
}

/// Motion on each of the four curves, for each choice of signs.
fn curves() -> Vec<(Motion, Curve)> {
    let (sliding, spherical) = (
        top(),
        Top::sliding(&TopParameters {
            transverse_inertia: 1.1,
            axial_inertia: 1.1,
            com_height: 0.6,
            mass_moment: 0.9,
            gravity: 1.3,
            ..TopParameters::default()
        })
        .unwrap(),
    );
    let fixed = Top::fixed(&TopParameters {
        transverse_inertia: 1.1,
        axial_inertia: 0.8,
        mass_moment: 0.9,
        gravity: 1.3,
        ..TopParameters::default()
    })
    .unwrap();
    let e4 = sliding.e4().unwrap();
    let mut curves = Vec::new();
    for signs in CHOICES {
        for top in [&sliding, &spherical, &fixed] {
            let motion = motion(top, [-0.3, 0.6, 1.4], signs);
            curves.push((motion, Curve::of(&motion)));
        }
        let equal = motion(&sliding, [-0.3, 0.6, e4], signs);
        curves.push((equal, Curve::e3_equals_e4(&equal).unwrap()));
        let aperiodic = motion(&sliding, [-0.3, 1.0, 1.0], signs);
        curves.push((aperiodic, Curve::aperiodic(&aperiodic).unwrap()));
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
            let ours = r_of_integrals(motion.top(), &motion.first_integrals(), u).unwrap();
            worst = greater(worst, size(ours - curve.r(u)) / size(curve.r(u)).max(1.0));
        }
    }
    tolerance::EQUATIONS.check("R(u)", worst);
    assert_eq!(
        r_of_integrals(
            &Top::fixed(&TopParameters {
                transverse_inertia: 1.0,
                axial_inertia: 1.0,
                mass_moment: 1.0,
                gravity: 1.0,
                ..TopParameters::default()
            })
            .unwrap(),
            &motion(&top(), [0.1, 0.2, 3.0], CHOICES[0]).first_integrals(),
            real(0.5)
        ),
        None
    );
}

/// Proof of Proposition 3: w₊₁ and w₋₁ are values of w over u = ±1. On the general curve they equal the paper's
/// second displayed formula, √(s/2)(1-e₄²)(l ∓ n)/A, and the negative of the first; their signs are opposite to those
/// of l ∓ n.
#[test]
fn w_plus_and_minus_one() {
    let mut worst = 0.0_f64;
    for (motion, curve) in curves() {
        for (w, u) in [(curve.w_minus_one(), -1.0), (curve.w_plus_one(), 1.0)] {
            worst = greater(worst, size(w * w - curve.r(real(u))) / size(curve.r(real(u))));
        }
        if curve.form() != Form::General {
            continue;
        }
        let (top, integrals) = (motion.top(), motion.first_integrals());
        let (a, s, p) = (top.transverse_inertia(), top.com_height(), top.mass_moment());
        for (w, momentum, sign) in [
            (curve.w_minus_one(), integrals.l_plus_n, motion.signs().l_plus_n),
            (curve.w_plus_one(), integrals.l_minus_n, motion.signs().l_minus_n),
        ] {
            let momentum = momentum / top.gravity().sqrt();
            let second = (s / 2.0).sqrt() * (1.0 - top.e4().unwrap().powi(2)) * momentum / a;
            let first = (s / 2.0).sqrt() * momentum / (p * s);
            worst = greater(worst, greater(size(w - real(second)), size(w + real(first))) / size(w));
            assert_eq!(Sign::of(w.re), Sign::of(-f64::from(sign.factor())));
        }
        // equal signs: |l| > |n|
        let same = Sign::of(curve.w_minus_one().re) == Sign::of(curve.w_plus_one().re);
        assert_eq!(same, integrals.l.abs() > integrals.n.abs());
    }
    tolerance::EQUATIONS.check("w over u = ±1", worst);
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
            let reduced = TipCurve::new(&motion).slope(u, udot) * udot;
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
        for top in [
            top(),
            Top::fixed(&TopParameters {
                transverse_inertia: 1.1,
                axial_inertia: 0.8,
                mass_moment: 0.9,
                gravity: 1.3,
                ..TopParameters::default()
            })
            .unwrap(),
        ] {
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

/// Equations (5.1), (5.2), (5.12), (5.13): with the common factor of w and u² - e₄² removed, the integrands are those
/// of the general curve.
#[test]
fn eqn_zander_and_eqn_aperabgdints_are_the_general_ones() {
    let mut worst = 0.0_f64;
    for (motion, curve) in curves() {
        let factor = |u: Complex<f64>| match curve.form() {
            Form::E3EqualsE4 => Some((u - real(motion.branch_points().e3)).scaled(0.5)),
            Form::Aperiodic => Some((u - Complex::ONE).scaled(-0.5)),
            _ => None,
        };
        for i in 0..40 {
            let x = f64::from(i);
            let u = Complex::new(1.5 * (0.8 * x).sin(), 0.4 + 1.1 * (1.3 * x).cos().abs());
            let Some(factor) = factor(u) else { continue };
            let (at, general) = (curve.point(u), Curve::of(&motion));
            let lifted = Point { u, w: at.w * factor };
            worst = greater(worst, size(lifted.w * lifted.w - general.r(u)) / size(general.r(u)).max(1.0));
            worst = greater(worst, size(curve.time(&at) - general.time(&lifted)));
            for (ours, theirs) in curve.logarithms(&at).into_iter().zip(general.logarithms(&lifted)) {
                worst = greater(worst, size(ours - theirs));
            }
        }
    }
    tolerance::EQUATIONS.check("degenerate integrands", worst);
    let plain = motion(&top(), [-0.3, 0.6, 1.4], CHOICES[0]);
    assert_eq!((Curve::e3_equals_e4(&plain), Curve::aperiodic(&plain)), (None, None));
}

/// Section 5.4: as e₄ grows at fixed A/p, dt and the logarithms converge to Klein's on the elliptic curve, at the
/// rate e₄⁻².
#[test]
fn lagrange_top_as_limit() {
    let at = |spread: f64| {
        // A/p = 1.1/0.9 for every s
        let s = 1.1 / 0.9 / spread;
        let top = Top::sliding(&TopParameters {
            transverse_inertia: 1.1,
            axial_inertia: 0.8,
            com_height: s,
            mass_moment: 0.9,
            gravity: 1.3,
            ..TopParameters::default()
        })
        .unwrap();
        let (slides, held) = (motion(&top, [-0.3, 0.6, 1.4], CHOICES[1]), {
            let top = Top::fixed(&TopParameters {
                transverse_inertia: 1.1,
                axial_inertia: 0.8,
                mass_moment: 0.9,
                gravity: 1.3,
                ..TopParameters::default()
            })
            .unwrap();
            motion(&top, [-0.3, 0.6, 1.4], CHOICES[1])
        });
        let (curve, limit) = (Curve::of(&slides), Curve::of(&held));
        assert_eq!((slides.regime(), limit.form()), (Regime::Nutating, Form::FixedTip));
        // over u = 0.2, on the sheet where u increases with time
        let place = |curve: &Curve| {
            let point = curve.point(real(0.2));
            if curve.time(&point).re > 0.0 { point } else { point.other_sheet() }
        };
        let (sliding, fixed) = (place(&curve), place(&limit));
        let mut parts = vec![size(curve.time(&sliding) - limit.time(&fixed))];
        let pairs = curve.logarithms(&sliding).into_iter().zip(limit.logarithms(&fixed));
        parts.extend(pairs.map(|(ours, theirs)| size(ours - theirs)));
        parts.into_iter().map(|part| part * (1.0 + spread)).collect::<Vec<_>>()
    };
    let (near, far) = (at(1e4), at(1e6));
    for (near, far) in near.into_iter().zip(far) {
        assert!(near > 0.01 && (near / far - 1.0).abs() < 1e-3, "{near} {far}");
    }
}
