//! Sections 3.3, 3.4 and 5: the integrands on the curves are compared with the full solution, and contour integrals with periods and advances.

use num_complex::Complex64 as C;
use toytop::su2::AttitudeState;
use toytop::{Complex, FirstIntegrals, Motion, Orientation, Top};
use toytop_tests::full_solver::solver;
use toytop_tests::hyperelliptic_curve::{Curve, Form, I, Place};
use toytop_tests::{SIGNS, by_branch_points, check, greater, tolerance, top_of, worst};

/// Top with C ≠ A and g ≠ 1.
fn top() -> Top {
    top_of([1.1, 0.8, 0.6, 0.9], 1.3)
}

/// Motion on each of the four curves, for each choice of signs.
pub(super) fn curves() -> Vec<(Motion, Curve)> {
    let e4 = top().e4().unwrap();
    let cases = SIGNS.into_iter().flat_map(|signs| {
        [
            (Form::General, [1.1, 0.8, 0.6, 0.9], [0.6, 1.4]),
            (Form::General, [1.1, 1.1, 0.6, 0.9], [0.6, 1.4]),
            (Form::FixedTip, [1.1, 0.8, 0.0, 0.9], [0.6, 1.4]),
            (Form::E3EqualsE4, [1.1, 0.8, 0.6, 0.9], [0.6, e4]),
            (Form::Aperiodic, [1.1, 0.8, 0.6, 0.9], [1.0, 1.0]),
        ]
        .map(|(form, top, [e2, e3])| {
            let motion = by_branch_points(&top_of(top, 1.3), [-0.3, e2, e3], signs);
            (motion, Curve::new(form, &motion))
        })
    });
    cases.collect()
}

/// Equation (3.8): R from l, n, h equals R from e₁, e₂, e₃, at complex u and for all four pairs (l, n).
#[test]
fn eqn_r_with_l_n_h_equals_r_of_the_roots() {
    let errors = SIGNS.into_iter().flat_map(|signs| {
        let motion = by_branch_points(&top(), [-0.3, 0.6, 1.4], signs);
        let curve = Curve::new(Form::General, &motion);
        (0..50).map(f64::from).map(move |x| {
            let u = C::new((0.9 * x).sin(), (1.7 * x).cos()) * 2.0;
            (r_of_integrals(&motion, u) - curve.r(u)).norm() / curve.r(u).norm().max(1.0)
        })
    });
    check("R(u)", worst(errors), tolerance::HYPERELLIPTIC_R_U);
}

/// R(u) from l, n and h.
fn r_of_integrals(motion: &Motion, u: C) -> C {
    let (top, FirstIntegrals { l, n, h, spin, .. }) = (motion.top(), motion.first_integrals());
    let pg = top.mass_moment() * top.gravity();
    let energy = h - 0.5 * top.axial_inertia() * spin * spin - u * pg;
    let momentum = l - u * n;
    let cubic = (1.0 - u * u) * energy / pg - momentum * momentum * 0.5 / (top.transverse_inertia() * pg);
    (u * u - top.e4().unwrap().powi(2)) * cubic
}

/// Equations (3.9), (3.10) and (4.1) (and their degenerate forms) at instants of the full solution: w² = R, dt/du u'
/// = 1, and the logarithmic rates of α, β, γ, δ, with iτ/2 where C ≠ A.
#[test]
fn eqn_t_and_eqn_abgdints_hold_on_the_full_solution() {
    let (mut curve_worst, mut rate_worst) = (0.0_f64, 0.0_f64);
    for (motion, curve) in curves() {
        let mut path = solver(&motion);
        for i in 1..12 {
            let state = path.advance_to(0.23 * f64::from(i)).unwrap();
            let [alpha, beta] = [state.alpha, state.beta].map(|[re, im]| Complex::new(re, im));
            let phi = Orientation { alpha, beta };
            let attitude = AttitudeState::from_fixed(phi, state.omega);
            let (u, udot) = (phi.u(), attitude.udot());
            if udot.abs() < 0.05 {
                continue; // at a turning point the integrands are infinite
            }
            let at = curve.on_motion(u, udot);
            let r = curve.r(at.u);
            let off = [(at.w * at.w - r).norm() / r.norm().max(1.0), (curve.time(at) * udot - 1.0).norm()];
            curve_worst = off.into_iter().fold(curve_worst, greater);
            let wide = |z: Complex<f64>| C::new(z.re, z.im);
            let [a, b] = [wide(attitude.rate.alpha) / wide(alpha), wide(attitude.rate.beta) / wide(beta)];
            let tau = I * 0.5 * curve.tau;
            let drift = [tau, -tau, tau, -tau];
            for (k, truth) in [a, b, b.conj(), a.conj()].into_iter().enumerate() {
                let ours = curve.logarithms(at)[k] * udot + drift[k];
                rate_worst = greater(rate_worst, (ours - truth).norm() / truth.norm().max(1.0));
            }
            // equation (4.1)
            let tip = (a + b).im;
            let (integrals, inertia) = (motion.first_integrals(), motion.top().transverse_inertia());
            let reduced = (integrals.l - integrals.n * u) / (inertia * (1.0 - u * u));
            for ours in [curve.tip_angle(at) * udot, C::from(reduced)] {
                rate_worst = greater(rate_worst, (ours - tip).norm() / tip.abs().max(1.0));
            }
        }
    }
    check("w and dt", curve_worst, tolerance::HYPERELLIPTIC_W_AND_DT);
    check("d log and dφ", rate_worst, tolerance::HYPERELLIPTIC_D_LOG_AND_DPHI);
}

/// Equations (3.7) and (3.9): the integral of dt around the cut [e₁, e₂] is a nutation period, and those of d log α
/// and d log β are the advances of α and β over it.
#[test]
fn eqn_tint0_is_the_period_around_the_cut() {
    let mut worst = 0.0_f64;
    for signs in SIGNS {
        for (form, s) in [(Form::General, 0.6), (Form::FixedTip, 0.0)] {
            let motion = by_branch_points(&top_of([1.1, 0.8, s, 0.9], 1.3), [-0.4, 0.4, 1.7], signs);
            let (curve, advance) = (Curve::new(form, &motion), motion.period_advance().unwrap());
            let turn = I * std::f64::consts::TAU;
            let time = curve.around(Place::Ellipse, |at, _| curve.time(at)) * turn;
            // the contour has the direction of the motion or the opposite one
            let sense = time.re.signum();
            worst = greater(worst, (time * sense - advance.period).norm() / advance.period);
            let tau = I * 0.5 * curve.tau * advance.period;
            for (part, tau, turns) in [(0, tau, advance.alpha_turns), (1, -tau, advance.beta_turns)] {
                let found = curve.around(Place::Ellipse, |at, _| curve.logarithms(at)[part]) * turn * sense;
                let angle = turn * turns;
                worst = greater(worst, (found + tau - angle).norm() / angle.norm().max(1.0));
            }
        }
    }
    check("around the cut", worst, tolerance::HYPERELLIPTIC_AROUND_THE_CUT);
}
