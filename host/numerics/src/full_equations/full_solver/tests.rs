use super::equations::cross;
use super::*;

const TOP: FullTop = FullTop { a: 1.3, c: 0.7, s: 0.8, p: 1.1, g: 1.0, k: 0.0 };
const START: FullState = FullState { alpha: [0.48, 0.64], beta: [0.36, -0.48], omega: [0.4, -0.3, 2.1] };

fn at(top: FullTop, state: FullState, t: f64) -> FullState {
    FullSolver::new(top, state, FULL_SOLVER_TOLERANCE).advance_to(t).unwrap()
}

/// Distance of two orientations, 2 sqrt(|d alpha|^2 + |d beta|^2), rad.
fn angle(x: FullState, y: FullState) -> f64 {
    let gap = |x: [f64; 2], y: [f64; 2]| (x[0] - y[0]).hypot(x[1] - y[1]);
    2.0 * gap(x.alpha, y.alpha).hypot(gap(x.beta, y.beta))
}

/// State with this tilt, azimuth and roll, and omega = precession k + spin r.
fn precessing(tilt: f64, azimuth: f64, roll: f64, precession: f64, spin: f64) -> FullState {
    let polar = |size: f64, angle: f64| [size * angle.cos(), size * angle.sin()];
    let alpha = polar((tilt / 2.0).cos(), (azimuth + roll) / 2.0);
    let beta = polar(-(tilt / 2.0).sin(), (azimuth - roll) / 2.0);
    let still = FullState { alpha, beta, omega: [0.0, 0.0, precession] };
    let r = still.axis();
    FullState { omega: core::array::from_fn(|i| still.omega[i] + spin * r[i]), ..still }
}

#[test]
fn regular_precession() {
    // A e f^2 - n f + p g = 0 with n = C (f e + spin) keeps the tilt acos e at the precession f; e = 1
    // sleeps.
    for (g, s, e, t) in [(1.0, 0.8, 0.6, -20.0), (9.81, 0.03, 0.6_f64, 20.0), (9.81, 0.0, 1.0, 20.0)] {
        let (top, f) = (FullTop { g, s, ..TOP }, 1.7 * f64::sqrt(g));
        let spin = (top.a * e * f * f + top.p * g) / (f * top.c) - f * e;
        let exact = precessing(e.acos(), 0.3 + f * t, -0.2 + spin * t, f, spin);
        assert!(angle(at(top, precessing(e.acos(), 0.3, -0.2, f, spin), t), exact) < 1e-12, "e {e}, g {g}");
    }
}

#[test]
fn first_integrals_and_there_and_back() {
    // The second top is the first in other units (inertia 2.3e-5, time 1/9.7).
    let toy = FullTop {
        a: TOP.a * 2.3e-5,
        c: TOP.c * 2.3e-5,
        s: TOP.s * 0.023,
        p: TOP.p * 1e-3,
        g: 2.16407,
        ..TOP
    };
    for (top, rate) in [(TOP, 1.0), (toy, 9.7)] {
        let start = FullState { omega: START.omega.map(|w| w * rate), ..START };
        let mut solver = FullSolver::new(top, start, FULL_SOLVER_TOLERANCE);
        let (l, n, h) = solver.first_integrals();
        solver.advance_to(50.0 / rate).unwrap();
        let (l2, n2, h2) = solver.first_integrals();
        assert!([l2 / l, n2 / n, h2 / h].iter().all(|x| (x - 1.0).abs() < 5e-14), "{l2} {n2} {h2}");
        assert!(angle(solver.advance_to(0.0).unwrap(), start) < 1e-12);
    }
}

#[test]
fn the_torque_is_the_lagrangians() {
    // omega x m + DL by the variational principle, against the simplified form that is integrated.
    let equations = Equations::of(&TOP, &START);
    let (r, w, k) = (START.axis(), START.omega, [0.0, 0.0, 1.0]);
    let m = equations.momentum(&START);
    let (gyro, tip, rk) = (cross(r, w), cross(r, cross(k, w)), cross(r, k));
    let y = [0.48, 0.64, 0.36, -0.48, m[0], m[1], m[2]];
    for i in 0..3 {
        let lagrangian =
            cross(w, m)[i] + (TOP.c - TOP.a) * dot(w, r) * gyro[i] + equations.ps * dot(w, rk) * tip[i]
                - equations.pg * rk[i];
        assert!((lagrangian - equations.derivative(&y)[4 + i]).abs() < 2e-15);
        assert!((equations.state(&y).omega[i] - w[i]).abs() < 1e-15);
    }
}

#[test]
fn unusable_input_is_an_error() {
    let run = |top, state, t| FullSolver::new(top, state, 1e-12).with_evaluation_limit(5000).advance_to(t);
    for a in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-320] {
        assert!(run(FullTop { a, ..TOP }, START, 1.0).is_err(), "{a}");
    }
    assert!(run(TOP, FullState { alpha: [1.0, 0.0], ..START }, 1.0).is_err());
    assert!(run(TOP, FullState { omega: [f64::NAN; 3], ..START }, 1.0).is_err());
    assert!(matches!(run(TOP, START, 1e300), Err(FullSolverError::EvaluationLimit { limit: 5000, .. })));
}
