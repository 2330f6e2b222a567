//! Sections 2.1 and 3.4: R³ as su(2), moving points, and the relations between Cayley-Klein parameters, ω and l, n.

use crate::full::{full_state, full_top};
use toytop::su2::{OrientationRate, Vector, bracket, dot};
use toytop::{Complex, FirstIntegrals, Motion, Orientation, Sign, Signs, Start, State, Stepper};
use toytop_host::full_equations::newton_euler::accelerations;
use toytop_tests::{greater, tolerance, vectors, worst};

type Matrix = [Complex<f64>; 4];

/// Matrix ½ ((i x₃, -x₂ + i x₁), (x₂ + i x₁, -i x₃)) of a vector.
fn matrix([x1, x2, x3]: Vector<f64>) -> Matrix {
    let half = |re: f64, im: f64| Complex::new(0.5 * re, 0.5 * im);
    [half(0.0, x3), half(-x2, x1), half(x2, x1), half(0.0, -x3)]
}

fn product([a, b, c, d]: Matrix, [e, f, g, h]: Matrix) -> Matrix {
    [a * e + b * g, a * f + b * h, c * e + d * g, c * f + d * h]
}

fn far(x: Matrix, y: Matrix) -> f64 {
    worst(x.iter().zip(y).map(|(x, y)| (*x - y).norm_squared().sqrt()))
}

fn of_phi(phi: &Orientation<f64>) -> Matrix {
    [phi.alpha, phi.beta, phi.gamma(), phi.delta()]
}

fn of_rate(rate: &OrientationRate<f64>) -> Matrix {
    [rate.alpha, rate.beta, -rate.beta.conj(), rate.alpha.conj()]
}

fn vector(i: u32) -> Vector<f64> {
    [1.1, 2.3, 3.7].map(|k| (f64::from(i) * k).sin())
}

/// Section 2.1: [x, y] is the cross product, ⟨x, y⟩ = -2 Tr(xy), and Ad_Φ x = ΦxΦ⁻¹, all by matrices.
#[test]
fn r3_is_su2() {
    let mut worst = 0.0_f64;
    for i in 1..100 {
        let (x, y) = (vector(i), vector(i + 31));
        let (xy, yx) = (product(matrix(x), matrix(y)), product(matrix(y), matrix(x)));
        let commutator: Matrix = std::array::from_fn(|k| xy[k] - yx[k]);
        worst = greater(worst, far(commutator, matrix(bracket(x, y))));
        let trace = (xy[0] + xy[3]).scaled(-2.0);
        worst = greater(worst, greater((trace.re - dot(x, y)).abs(), trace.im.abs()));
        let phi = Orientation::exp(vector(i + 57).map(|component| 3.0 * component));
        let turned = product(product(of_phi(&phi), matrix(x)), of_phi(&phi.inverse()));
        worst = greater(worst, far(turned, matrix(phi.adjoint(x))));
        // equations (2.2) and (2.3) with the middle matrices corrected
        let omega = y.map(|component| 2.0 * component);
        let rate = OrientationRate::from_fixed(&phi, omega);
        worst = greater(worst, far(product(of_rate(&rate), of_phi(&phi.inverse())), matrix(omega)));
        let body = rate.omega_body(&phi);
        worst = greater(worst, far(product(of_phi(&phi.inverse()), of_rate(&rate)), matrix(body)));
    }
    tolerance::GROUP.check("su(2)", worst);
    let basis = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    assert_eq!(bracket(basis[0], basis[1]), basis[2]);
}

/// Section 2.1: x' = ΦX'Φ⁻¹ + [ω, x] and X' = Φ⁻¹x'Φ - [Ω, X] of a point that moves in the moving frame.
#[test]
fn moving_points() {
    let motion = vectors::named("generic_AneC").motion().unwrap();
    let (step, point, velocity) = (1e-5, vector(3), vector(8));
    let mut stepper = Stepper::<f64>::new(&motion);
    stepper.step(0.4);
    let at = [-1.0, 0.0, 1.0].map(|side| {
        let mut stepper = stepper;
        stepper.step(side * step);
        let place = std::array::from_fn(|k| point[k] + side * step * velocity[k]);
        (stepper.attitude_state(), stepper.orientation().adjoint(place))
    });
    let ((_, before), (attitude, x), (_, after)) = (at[0], at[1], at[2]);
    let difference: Vector<f64> = std::array::from_fn(|k| (after[k] - before[k]) / (2.0 * step));
    let turned = bracket(attitude.omega(), x);
    let carried = attitude.orientation.adjoint(velocity);
    for k in 0..3 {
        assert!((difference[k] - carried[k] - turned[k]).abs() < 1e-8);
    }
    let back = attitude.orientation.inverse().adjoint(std::array::from_fn(|k| carried[k] + turned[k]));
    let in_body = bracket(attitude.omega_body(), point);
    for k in 0..3 {
        assert!((back[k] - in_body[k] - velocity[k]).abs() < 1e-13);
    }
}

/// Equations (3.13) to (3.17) at generic states.
#[test]
fn eqn_up1um1_to_eqn_omegasum() {
    let mut worst = 0.0_f64;
    let top = vectors::named("generic_AneC").top();
    for i in 1..60 {
        let [x, y, z] = vector(i);
        let phi = Orientation { alpha: Complex::new(x, y), beta: Complex::new(z, 0.3) }.normalised();
        let omega = vector(i + 12).map(|w| 2.0 * w);
        let rate = OrientationRate::from_fixed(&phi, omega);
        let [alpha, beta, gamma, delta] = of_phi(&phi);
        let [alpha_dot, beta_dot, gamma_dot, delta_dot] = of_rate(&rate);
        let (u, udot) = (phi.axis()[2], rate.udot(&phi));
        let mut off = |z: Complex<f64>| worst = greater(worst, z.norm_squared().sqrt());
        let real = |x: f64| Complex::new(x, 0.0);
        // equations (3.13) and (3.14)
        off((alpha * delta).scaled(2.0) - real(1.0 + u));
        off((beta * gamma).scaled(2.0) - real(u - 1.0));
        off((delta * alpha_dot + alpha * delta_dot).scaled(2.0) - real(udot));
        off((gamma * beta_dot + beta * gamma_dot).scaled(2.0) - real(udot));
        // equation (3.15)
        let (fixed, body) = (omega[2], rate.omega_body(&phi)[2]);
        let (sum, difference) = (Complex::new(udot, body + fixed), Complex::new(udot, body - fixed));
        off(sum - (delta * alpha_dot).scaled(4.0));
        off(difference - (gamma * beta_dot).scaled(4.0));
        off(difference.conj() - (beta * gamma_dot).scaled(4.0));
        off(sum.conj() - (alpha * delta_dot).scaled(4.0));
        // equations (3.16) and (3.17)
        let FirstIntegrals { n, l_plus_n, l_minus_n, .. } =
            FirstIntegrals::of(&top, &State::new(phi, omega).unwrap());
        let tau = (1.0 / top.axial_inertia() - 1.0 / top.transverse_inertia()) * n;
        off(real(body + fixed - l_plus_n / top.transverse_inertia() - (u + 1.0) * tau));
        off(real(body - fixed + l_minus_n / top.transverse_inertia() + (u - 1.0) * tau));
    }
    tolerance::EQUATIONS.check("relations of section 3.4", worst);
}

/// Equation (3.6): three numbers e₁, e₂, e₃ have four pairs (l, n): (a, b), (-a, -b), (b, a), (-b, -a), with two
/// energies unless A = C. There are two pairs if one of e₁, e₂, e₃ is ±1, and one, l = n = 0, if e₁ = -1 and e₂ = 1.
/// Each is a motion of the full equations that has a turning point at e₁.
#[test]
fn eqn_constants_four_choices() {
    let top = vectors::named("generic_AneC").top();
    let spherical = toytop::Top::fixed(&toytop::TopParameters {
        transverse_inertia: 1.1,
        axial_inertia: 1.1,
        mass_moment: 0.9,
        gravity: 1.0,
        ..toytop::TopParameters::default()
    })
    .unwrap();
    let signs = [Sign::Plus, Sign::Minus];
    let choices = |top: &toytop::Top, e: [f64; 3]| {
        let mut found: Vec<(f64, f64, f64)> = Vec::new();
        for l_plus_n in signs {
            for l_minus_n in signs {
                let chosen = Signs { l_plus_n, l_minus_n };
                let motion = Motion::from_branch_points(top, e, chosen, &Start::default()).unwrap();
                let FirstIntegrals { l, n, h, .. } = motion.first_integrals();
                found.push((l + 0.0, n + 0.0, h));
            }
        }
        found
    };
    let e = [-0.3, 0.6, 1.4];
    let [(a, b, h), (b2, a2, h2), (mb, ma, h3), (ma2, mb2, h4)] = choices(&top, e).try_into().unwrap();
    assert_eq!((a, b, -a, -b), (a2, b2, ma2, mb2));
    assert_eq!((ma, mb, h, h2), (-a2, -b2, h4, h3));
    assert!((h - h2).abs() > 1e-3);
    let energies: Vec<f64> = choices(&spherical, e).iter().map(|(_, _, h)| *h).collect();
    assert!(energies.iter().all(|h| (h - energies[0]).abs() < 1e-15));
    let count = |e: [f64; 3]| {
        let mut all = choices(&top, e);
        all.sort_by(|x, y| x.partial_cmp(y).unwrap());
        all.dedup();
        all.len()
    };
    assert_eq!(
        [count(e), count([-0.3, 1.0, 1.4]), count([-1.0, 0.4, 1.4]), count([-1.0, 1.0, 1.4])],
        [4, 2, 2, 1]
    );
    for l_minus_n in signs {
        let chosen = Signs { l_plus_n: Sign::Plus, l_minus_n };
        let motion = Motion::from_branch_points(&top, e, chosen, &Start::default()).unwrap();
        let state = Stepper::<f64>::new(&motion).attitude_state().state().unwrap();
        let rise = accelerations(&full_top(&top), &full_state(&state)).height;
        // u'' at e₁ is g (e₂ - e₁)(e₃ - e₁)/D(e₁), from equation (3.3)
        let d = top.transverse_inertia() / top.mass_moment() + top.com_height() * (1.0 - 0.09);
        assert!((rise - top.gravity() * 0.9 * 1.7 / d).abs() < 1e-14);
    }
}
