//! Sections 2.1 and 3.4: rotations and rates are compared with products of matrices of su(2), and with the relations to l and n.

use toytop::su2::{AttitudeState, OrientationRate, Vector, cross, dot};
use toytop::{Complex, FirstIntegrals, Orientation, State, Top};
use toytop_tests::{SIGNS, apart, by_branch_points, check, greater, tolerance, top_of, vectors, worst};

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
    worst(x.iter().zip(y).map(|(x, y)| (*x - y).modulus()))
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
        worst = greater(worst, far(commutator, matrix(cross(x, y))));
        let trace = (xy[0] + xy[3]).scaled(-2.0);
        worst = greater(worst, greater((trace.re - dot(x, y)).abs(), trace.im.abs()));
        let phi = Orientation::exp(vector(i + 57).map(|component| 3.0 * component));
        let psi = Orientation::exp(vector(i + 5));
        worst = greater(worst, far(product(of_phi(&phi), of_phi(&psi)), of_phi(&phi.compose(&psi))));
        worst = greater(
            worst,
            far(product(of_phi(&phi), of_phi(&phi.inverse())), of_phi(&Orientation::IDENTITY)),
        );
        worst = greater(worst, apart(phi.axis(), phi.adjoint([0.0, 0.0, 1.0])));
        let turned = product(product(of_phi(&phi), matrix(x)), of_phi(&phi.inverse()));
        worst = greater(worst, far(turned, matrix(phi.adjoint(x))));
        // equations (2.2) and (2.3) with the middle matrices corrected
        let omega = y.map(|component| 2.0 * component);
        let attitude = AttitudeState::from_fixed(phi, omega);
        let rate = attitude.rate;
        worst = greater(worst, far(product(of_rate(&rate), of_phi(&phi.inverse())), matrix(omega)));
        let turning = cross(omega, phi.axis());
        let body = attitude.omega_body();
        let again = AttitudeState::from_body(phi, body).rate;
        worst = greater(worst, far(of_rate(&again), of_rate(&rate)));
        worst = greater(worst, apart(phi.axis_rate(body), turning));
        worst = greater(worst, (attitude.udot() - turning[2]).abs());
        worst = greater(worst, far(product(of_phi(&phi.inverse()), of_rate(&rate)), matrix(body)));
    }
    check("su(2)", worst, tolerance::CAYLEY_KLEIN_SU_2);
}

/// Equations (3.13) to (3.17) at generic states.
#[test]
fn eqn_up1um1_to_eqn_omegasum_hold() {
    let mut worst = 0.0_f64;
    let top = vectors::named("generic_AneC").top();
    for i in 1..60 {
        let [x, y, z] = vector(i);
        let phi = Orientation { alpha: Complex::new(x, y), beta: Complex::new(z, 0.3) }.normalised();
        let omega = vector(i + 12).map(|w| 2.0 * w);
        let attitude = AttitudeState::from_fixed(phi, omega);
        let rate = attitude.rate;
        let [alpha, beta, gamma, delta] = of_phi(&phi);
        let [alpha_dot, beta_dot, gamma_dot, delta_dot] = of_rate(&rate);
        let (u, udot) = (phi.axis()[2], attitude.udot());
        let mut off = |z: Complex<f64>| worst = greater(worst, z.modulus());
        let real = |x: f64| Complex::new(x, 0.0);
        // equations (3.13) and (3.14)
        off((alpha * delta).scaled(2.0) - real(1.0 + u));
        off((beta * gamma).scaled(2.0) - real(u - 1.0));
        off((delta * alpha_dot + alpha * delta_dot).scaled(2.0) - real(udot));
        off((gamma * beta_dot + beta * gamma_dot).scaled(2.0) - real(udot));
        // equation (3.15)
        let (fixed, body) = (omega[2], attitude.omega_body()[2]);
        let (sum, difference) = (Complex::new(udot, body + fixed), Complex::new(udot, body - fixed));
        off(sum - (delta * alpha_dot).scaled(4.0));
        off(difference - (gamma * beta_dot).scaled(4.0));
        off(difference.conj() - (beta * gamma_dot).scaled(4.0));
        off(sum.conj() - (alpha * delta_dot).scaled(4.0));
        // equations (3.16) and (3.17)
        let FirstIntegrals { n, l_plus_n, l_minus_n, .. } =
            FirstIntegrals::from_state(&top, &State::new(phi, omega).unwrap());
        let tau = (1.0 / top.axial_inertia() - 1.0 / top.transverse_inertia()) * n;
        off(real(body + fixed - l_plus_n / top.transverse_inertia() - (u + 1.0) * tau));
        off(real(body - fixed + l_minus_n / top.transverse_inertia() + (u - 1.0) * tau));
    }
    check("relations of section 3.4", worst, tolerance::CAYLEY_KLEIN_RELATIONS_OF_SECTION_3_4);
}

/// Equation (3.6): three numbers e₁, e₂, e₃ have four pairs (l, n): (a, b), (-a, -b), (b, a), (-b, -a), with two
/// energies unless A = C. There are two pairs if one of e₁, e₂, e₃ is ±1, and one, l = n = 0, if e₁ = -1 and e₂ = 1.
#[test]
fn eqn_constants_has_four_solutions() {
    let top = vectors::named("generic_AneC").top();
    let spherical = top_of([1.1, 1.1, 0.0, 0.9], 1.0);
    let choices = |top: &Top, e: [f64; 3]| {
        SIGNS.map(|signs| {
            let FirstIntegrals { l, n, h, .. } = by_branch_points(top, e, signs).first_integrals();
            (l + 0.0, n + 0.0, h)
        })
    };
    let e = [-0.3, 0.6, 1.4];
    let [(a, b, h), (b2, a2, h2), (mb, ma, h3), (ma2, mb2, h4)] = choices(&top, e);
    assert_eq!((a, b, -a, -b), (a2, b2, ma2, mb2));
    assert_eq!((ma, mb, h, h2), (-a2, -b2, h4, h3));
    assert!((h - h2).abs() > 1e-3);
    let energies = choices(&spherical, e).map(|(_, _, h)| h);
    assert!(energies.iter().all(|h| (h - energies[0]).abs() < 1e-15));
    for (e, count) in [(e, 4), ([-0.3, 1.0, 1.4], 2), ([-1.0, 0.4, 1.4], 2), ([-1.0, 1.0, 1.4], 1)] {
        let mut all = choices(&top, e).to_vec();
        all.sort_by(|x, y| x.partial_cmp(y).unwrap());
        all.dedup();
        assert_eq!(all.len(), count, "{e:?}");
    }
}
