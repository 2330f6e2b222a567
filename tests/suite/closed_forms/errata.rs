//! Errata of the paper: every printed formula is wrong and every correction is right, as `toytop errata` says.
//!
//! Formulas are compared with the full equations: Newton's and Euler's at one time, the full solver along a motion. All motions are generic,
//! with numbers near 1, so that a wrong formula has a residual near 1.

use super::{aperiodic, e3_equals_e4};
use crate::motion::full_solver::solver;
use crate::motion::lagrangian::{Lagrangian, newton_euler_rate};
use crate::rotations::cayley_klein::{far, matrix, of_phi, of_rate, product};
use toytop::su2::{OrientationRate, Vector, cross, dot};
use toytop::{FirstIntegrals, Orientation, Signs, State};
use toytop_host::errata::ERRATA;
use toytop_host::full_equations::full_solver::FullState;
use toytop_host::input::random::Random;
use toytop_tests::complex::{C, I, from, to};
use toytop_tests::hyperelliptic::{Curve, Form, residue, residue_at_infinity};
use toytop_tests::{by_branch_points, greater, top_of, worst};

/// Residuals of the printed and of the corrected formula, without unit.
type Residuals = [f64; 2];

#[test]
fn printed_versions_fail_and_corrected_ones_hold() {
    let residuals = [&of_an_instant()[..], &[loops()], &of_e3_equals_e4(), &of_the_aperiodic_case()].concat();
    assert_eq!(residuals.len(), ERRATA.len());
    for (erratum, [printed, corrected]) in ERRATA.iter().zip(residuals) {
        let [stated, bound] = erratum.residuals;
        assert!((printed - stated).abs() <= 0.005_000_1 && printed > 0.1, "{}: {printed}", erratum.place);
        assert!(corrected <= bound && bound <= 1e-14, "{}: {corrected:e}", erratum.place);
        assert_ne!(erratum.printed, erratum.corrected);
    }
}

/// Sections 2.1 to 4.1, at one time of a motion.
fn of_an_instant() -> [Residuals; 8] {
    let top = top_of([1.1, 0.8, 0.6, 0.9], 1.0);
    let (a, c, s, p) = (top.transverse_inertia(), top.axial_inertia(), top.com_height(), top.mass_moment());
    let phi = Orientation { alpha: to(C::new(0.6, 0.3)), beta: to(C::new(-0.2, 0.5)) }.normalised();
    let omega = [0.4, -0.7, 1.3];
    let rate = OrientationRate::from_fixed(&phi, omega);
    let state = State::new(phi, omega).unwrap();
    let body = phi.inverse().adjoint(omega);
    let FirstIntegrals { l, n, .. } = FirstIntegrals::from_state(&top, &state);
    let ([r1, r2, u], udot) = (phi.axis(), rate.udot(&phi));

    let printed = |[x1, x2, x3]: Vector<f64>| {
        [C::new(0.0, x3), C::new(x2, x1), C::new(-x2, x1), C::new(0.0, x3)].map(|z| to(z * 0.5))
    };
    let both = |x: Vector<f64>, truth| [far(printed(x), truth), far(matrix(x), truth)];
    let (turning, inverse) = (of_rate(&rate), of_phi(&phi.inverse()));
    let matrices = [both(omega, product(turning, inverse)), both(body, product(inverse, turning))];

    let lagrangian = Lagrangian::new(&top);
    let (truth, ours) = (newton_euler_rate(&top, &state), lagrangian.momentum_rate(phi.axis(), omega));
    let q = cross(phi.axis(), [0.0, 0.0, 1.0]);
    let derivative = [2.0 * p, 0.0].map(|slip| {
        let off: Vector<f64> = std::array::from_fn(|i| truth[i] - ours[i] - slip * q[i]);
        dot(off, off).sqrt()
    });
    let axial = [1.0 / a - 1.0 / c, 1.0 / c - 1.0 / a];
    let vertical = axial.map(|factor| (l / a + factor * n * u - omega[2]).abs());

    // w on the motion, for which eqn:t is true, and w₋₁ and w₊₁ by the first display
    let e4 = top.e4().unwrap().powi(2);
    let w = I * (0.5 * s).sqrt() * (e4 - u * u) * udot;
    let display = [l + n, l - n].map(|momentum| (0.5 * s).sqrt() / (p * s) * momentum);
    let drift = I * 0.5 * axial[1] * n;
    let (z, z_dot) = (of_phi(&phi).map(from), turning.map(from));
    let logarithms = [1.0, -1.0].map(|sign| {
        let [minus, plus] = display.map(|value| sign * (u * u - e4) / (1.0 - e4) * value / w);
        let sums = [1.0 + minus, 1.0 - plus, 1.0 + plus, 1.0 - minus];
        let ends = [1.0, -1.0, -1.0, 1.0];
        worst((0..4).map(|i| {
            let drift = if i % 2 == 0 { drift } else { -drift };
            (sums[i] * udot / (2.0 * (u + ends[i])) + drift - z_dot[i] / z[i]).norm()
        }))
    });
    let sums = [u, u * u].map(|power| {
        let line =
            |value: f64, factor: f64| -(power - e4) / (1.0 - e4) * value * udot / w + drift * 2.0 * factor;
        let [minus, plus] = display;
        greater(
            (line(minus, u + 1.0) - I * (body[2] + omega[2])).norm(),
            (line(plus, u - 1.0) - I * (omega[2] - body[2])).norm(),
        )
    });
    let curve = Curve::of(&by_branch_points(&top, [-0.3, 0.6, 1.4], Signs::default()));
    let at_infinity = from(residue_at_infinity(&curve, 0.3, |at, _| curve.logarithms(at)[0]));
    let infinity = [1.0, -1.0].map(|claimed| (at_infinity - claimed).norm());
    let tip = [z[1] / z[3], -s * C::new(r1, r2)].map(|curve| (curve - 2.0 * s * z[0] * z[1]).norm());
    let [omega, body] = matrices;
    [omega, body, derivative, vertical, logarithms, sums, infinity, tip]
}

/// Section 4.2: shares of random motions that are classified wrongly.
fn loops() -> Residuals {
    const MOTIONS: u32 = 1000;
    let mut random = Random::new(1, 0);
    let mut wrong = [0_u32; 2];
    for _ in 0..MOTIONS {
        let e1 = random.between(-0.99, 0.95);
        let (e2, e3) = (random.between(e1 + 0.01, 0.99), random.scale(1.01, 20.0));
        // eqn:constants with 2Ap = 1 and different signs; φ' has the sign of l - nu
        let plus = ((1.0 + e1) * (1.0 + e2) * (1.0 + e3)).sqrt();
        let minus = -((1.0 - e1) * (1.0 - e2) * (e3 - 1.0)).sqrt();
        let turning = |u: f64| plus * (1.0 - u) + minus * (1.0 + u);
        let truth = turning(e1) * turning(e2) < 0.0;
        let x = (1.0 + e1) * (1.0 - e2) / ((1.0 - e1) * (1.0 + e2));
        let bound = (e3 - 1.0) / (e3 + 1.0);
        for (count, told) in wrong.iter_mut().zip([bound < x && x < 1.0 / bound, x < bound]) {
            *count += u32::from(told != truth);
        }
    }
    wrong.map(|count| f64::from(count) / f64::from(MOTIONS))
}

/// Integral of √|R| du from a root to an end, which the paper prints in place of that of du/√|R|, with R = 4 (u - root)(u - others), by
/// Simpson's rule in y, u = root ± y².
fn printed_integral(root: f64, end: f64, others: [f64; 2]) -> f64 {
    let h = (end - root).abs().sqrt() / 200.0;
    let node = |i: u32| {
        let square = (h * f64::from(i)).powi(2);
        let u = root + square.copysign(end - root);
        let weight = if i == 200 { 1.0 } else { f64::from(2 + 2 * (i % 2)) };
        4.0 * square * others.map(|other| (u - other).abs().sqrt()).iter().product::<f64>() * weight * h / 3.0
    };
    (1..=200).map(node).sum()
}

/// Section 5.1: the uniformisation and the direction in which x moves.
fn of_e3_equals_e4() -> [Residuals; 3] {
    let paper = e3_equals_e4::Paper::new(-0.3, 0.6, Signs::default());
    let x = I * 0.7;
    let full = solver(&paper.motion).advance_to(paper.t(x).re).unwrap();
    let shift = [paper.u(x + paper.omega2 - paper.omega1), paper.u(x)].map(|u| (u - full.axis()[2]).norm());
    let e3 = e3_equals_e4::E3;
    let to_e1 = printed_integral(paper.e1, -1.0, [paper.e2, -e3]);
    let to_one = C::from(printed_integral(paper.e2, 1.0, [paper.e1, -e3]));
    let ends = [(paper.omega1 + to_e1, to_one), (paper.a, paper.b)]
        .map(|(a, b)| greater((paper.u(a) + 1.0).norm(), (paper.u(b) - 1.0).norm()));
    let rate = full.axis_height_rate() / paper.w(x);
    [shift, ends, [-1.0, 1.0].map(|claimed| (rate / rate.norm() - I * claimed).norm())]
}

/// Section 5.3: the uniformisation, time, and the Cayley-Klein parameters.
fn of_the_aperiodic_case() -> [Residuals; 6] {
    let paper = aperiodic::Paper::new(-0.2, toytop::Sign::Plus);
    let x = paper.b * 0.6;
    // time at which the full solution is at u(x), by Newton's iteration with its u and u'
    let at = |t: f64| -> FullState { solver(&paper.motion).advance_to(t).unwrap() };
    let t = (0..20).fold(1.0, |t, _| {
        let state = at(t);
        t - (state.axis()[2] - paper.u(x).re) / state.axis_height_rate()
    });
    let FullState { alpha: [re, im], beta, .. } = at(t);
    let (alpha, beta) = (C::new(re, im), C::new(beta[0], beta[1]));

    let e4 = aperiodic::E4;
    let [to_e1, to_one] = [-1.0, 1.0].map(|end| printed_integral(paper.e1, end, [e4, -e4]));
    let ends = [(C::from(to_e1), I * to_one), (paper.a, paper.b)]
        .map(|(a, b)| greater((paper.u(a) + 1.0).norm(), (paper.u(b) - 1.0).norm()));
    let time = [-1.0, 1.0].map(|sign| (paper.t(x, sign) - t).norm());
    let exponent = [-1.0, 1.0].map(|sign| (paper.alpha_and_delta(x, sign, -1.0)[0] - alpha).norm());
    let slope = [1.0, -1.0].map(|sign| (paper.alpha_and_delta(x, 1.0, sign)[0] - alpha).norm());
    let curve = Curve::new(Form::Aperiodic, &paper.motion);
    let table = [1, 3].map(|part| {
        let found = residue(&curve, &curve.zeros()[3], 0.1, |at| curve.logarithms(at)[part]);
        (from(found) - 1.0).norm()
    });
    let delta = paper.alpha_and_delta(x, 1.0, -1.0)[1];
    [ends, time, exponent, slope, table, [beta, alpha.conj()].map(|parameter| (delta - parameter).norm())]
}
