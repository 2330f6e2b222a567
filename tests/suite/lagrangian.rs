//! Section 3.1: T, V, L, m, DL and Proposition 1, by numerical differentiation, by the laws of Newton and Euler, and
//! along the full solution.

use crate::full::{full_state, full_top, solver};
use toytop::exact::lagrangian::Lagrangian;
use toytop::scalar::{Extended, Float, Ring};
use toytop::su2::{OrientationRate, Vector, bracket, dot};
use toytop::{Complex, FirstIntegrals, Orientation, Sign, Signs, Start, State, Stepper, Top};
use toytop_host::full_equations::newton_euler::accelerations;
use toytop_tests::{greater, tolerance, vectors};

/// Fixed pseudo-random states with a tilted axis.
fn states() -> impl Iterator<Item = State> {
    (1..60_u32).map(|i| {
        let wave = |k: f64| (f64::from(i) * k).sin();
        let raw = Orientation {
            alpha: Complex::new(wave(1.1) + 0.2, wave(2.3)),
            beta: Complex::new(wave(0.7), wave(3.1) - 0.3),
        };
        State::new(raw.normalised(), [3.0 * wave(1.9), 2.0 * wave(2.9), 4.0 * wave(0.5)]).unwrap()
    })
}

fn tops() -> [Top; 2] {
    ["generic_AneC", "lagrange_exact"].map(|name| vectors::named(name).top())
}

fn lifted(state: &State) -> (Orientation<Extended>, Vector<Extended>) {
    let lift = |z: Complex<f64>| Complex::new(z.re.into(), z.im.into());
    let phi = Orientation { alpha: lift(state.orientation().alpha), beta: lift(state.orientation().beta) };
    (phi.normalised(), state.omega().map(Extended::from))
}

fn distance<F: Float>(x: Vector<F>, y: Vector<F>) -> f64 {
    let difference: Vector<F> = std::array::from_fn(|i| x[i] - y[i]);
    dot(difference, difference).sqrt().to_f64()
}

/// Central difference of f at 0, in extended precision; its error is about 1e-20.
fn slope(f: impl Fn(Extended) -> Extended) -> Extended {
    let step = Extended::from(1e-10);
    (f(step) - f(-step)) / step.doubled()
}

fn unit(i: usize) -> Vector<Extended> {
    std::array::from_fn(|j| if i == j { Extended::ONE } else { Extended::ZERO })
}

/// Kinetic energy (section 3.1): the rotation about the centre of mass plus M (s u')²/2; V is the weight times the
/// height.
#[test]
fn eqn_kinetic_and_potential() {
    let mut worst = 0.0_f64;
    for (top, state) in states().map(|state| (tops()[0], state)) {
        let lagrangian = Lagrangian::<f64>::new(&top);
        let (phi, omega) = (state.orientation(), state.omega());
        let axial = dot(omega, phi.axis());
        let across = dot(omega, omega) - axial * axial;
        let rise = OrientationRate::from_fixed(&phi, omega).udot(&phi);
        let mass = top.mass_moment() / top.com_height();
        let kinetic = 0.5
            * (top.transverse_inertia() * across
                + top.axial_inertia() * axial * axial
                + mass * (top.com_height() * rise).powi(2));
        let size = kinetic.max(1.0);
        worst = greater(worst, (lagrangian.kinetic(&phi, omega) - kinetic).abs() / size);
        let potential = mass * top.gravity() * top.com_height() * phi.axis()[2];
        worst = greater(worst, (lagrangian.potential(&phi) - potential).abs());
        let value = lagrangian.value(&phi, omega);
        worst = greater(worst, (value - (kinetic - potential)).abs() / size);
    }
    tolerance::GROUP.check("T and V", worst);
}

/// m = ∂L/∂ω by differences of L, and the inverse, ω from m.
#[test]
fn momentum_is_the_derivative_by_omega() {
    let (mut worst, mut inverse) = (0.0_f64, 0.0_f64);
    for top in tops() {
        let lagrangian = Lagrangian::<Extended>::new(&top);
        for state in states() {
            let (phi, omega) = lifted(&state);
            let along = |i: usize| {
                slope(|step| {
                    let moved = std::array::from_fn(|j| omega[j] + step * unit(i)[j]);
                    lagrangian.value(&phi, moved)
                })
            };
            let m = lagrangian.momentum(&phi, omega);
            worst = greater(worst, distance(m, [0, 1, 2].map(along)));
            inverse = greater(inverse, distance(omega, lagrangian.omega(&phi, m)));
        }
    }
    tolerance::DIFFERENCES_OF_SQUARES.check("m", worst);
    assert!(inverse < 1e-29 && inverse > 0.0, "{inverse:e}");
}

/// DL by differences of L(e^{εη}Φ, ω): the last term is -p [r, k], printed with +.
#[test]
fn dl_is_the_derivative_by_phi() {
    let mut worst = 0.0_f64;
    for top in tops() {
        let lagrangian = Lagrangian::<Extended>::new(&top);
        for state in states() {
            let (phi, omega) = lifted(&state);
            let along = |i: usize| {
                slope(|step| {
                    // 1 + εη, normalised: it has the tangent of e^{εη}, and is odd in ε likewise
                    let [x1, x2, x3] = unit(i).map(|x| (x * step).halved());
                    let near_one =
                        Orientation { alpha: Complex::new(Extended::ONE, x3), beta: Complex::new(-x2, x1) };
                    lagrangian.value(&near_one.compose(&phi).normalised(), omega)
                })
            };
            worst = greater(worst, distance(lagrangian.derivative(&phi, omega), [0, 1, 2].map(along)));
        }
    }
    tolerance::DIFFERENCES.check("DL", worst);
}

/// Equation (3.1) against the laws of Newton and Euler: m' = ∂m/∂ω ω' + ∂m/∂Φ Φ', with ω' from the contact force.
#[test]
fn eqn_motion_is_newton_and_euler() {
    let mut worst = 0.0_f64;
    for top in tops() {
        let lagrangian = Lagrangian::<f64>::new(&top);
        for state in states() {
            let (phi, omega) = (state.orientation(), state.omega());
            let truth = accelerations(&full_top(&top), &full_state(&state));
            let (r, k) = (phi.axis(), [0.0, 0.0, 1.0]);
            let (q, turn) = (bracket(r, k), bracket(omega, r));
            let q_dot = bracket(turn, k);
            let (axial, ps) = (
                (top.axial_inertia() - top.transverse_inertia()) * dot(omega, r),
                top.mass_moment() * top.com_height(),
            );
            let m_dot: Vector<f64> = std::array::from_fn(|i| {
                top.transverse_inertia() * truth.omega[i]
                    + axial * turn[i]
                    + ps * (truth.height * q[i] + dot(omega, q) * q_dot[i])
            });
            let size = dot(m_dot, m_dot).sqrt().max(1.0);
            worst = greater(worst, distance(lagrangian.momentum_rate(&phi, omega), m_dot) / size);
        }
    }
    tolerance::EQUATIONS.check("eqn:motion", worst);
}

/// Proposition 1: l = ⟨m, k⟩, n = ⟨m, r⟩ and h = T + V are constant along the full solution, and equal those of the
/// launch.
#[test]
fn prop_1_first_integrals_are_conserved() {
    let mut worst = 0.0_f64;
    for vector in vectors::all() {
        let motion = vector.motion().unwrap();
        let (top, mut path) = (*motion.top(), solver(&motion));
        let lagrangian = Lagrangian::<f64>::new(&top);
        let integrals = motion.first_integrals();
        let scale = integrals
            .l
            .abs()
            .max(integrals.n.abs())
            .max((top.transverse_inertia() * top.mass_moment() * top.gravity()).sqrt());
        let energy = integrals.h.abs().max(top.mass_moment() * top.gravity());
        for i in 0..40 {
            let state = path.advance_to(0.25 * f64::from(i)).unwrap();
            let phi = Orientation { alpha: complex(state.alpha), beta: complex(state.beta) };
            let m = lagrangian.momentum(&phi, state.omega);
            let drifts = [
                (m[2] - integrals.l) / scale,
                (dot(m, phi.axis()) - integrals.n) / scale,
                (lagrangian.energy(&phi, state.omega) - integrals.h) / energy,
            ];
            worst = drifts.map(f64::abs).into_iter().fold(worst, greater);
        }
    }
    tolerance::FULL_INTEGRALS.check("l, n, h along the full solution", worst);
}

fn complex([re, im]: [f64; 2]) -> Complex<f64> {
    Complex::new(re, im)
}

/// Proof of Proposition 1: ⟨ω, k⟩ with the sign corrected, ω in the basis (r, k, [r, k]), and equation (3.2).
#[test]
fn prop_1_eqn_reduced() {
    let mut worst = 0.0_f64;
    let top = tops()[0];
    let (a, c, s, p, g) =
        (top.transverse_inertia(), top.axial_inertia(), top.com_height(), top.mass_moment(), top.gravity());
    for state in states() {
        let (phi, omega) = (state.orientation(), state.omega());
        let FirstIntegrals { l, n, h, .. } = FirstIntegrals::of(&top, &state);
        let (r, k) = (phi.axis(), [0.0, 0.0, 1.0]);
        let (u, q, udot) = (r[2], bracket(r, k), OrientationRate::from_fixed(&phi, omega).udot(&phi));
        let size = dot(omega, omega).max(1.0);
        worst = greater(worst, (omega[2] - (l / a + (1.0 / c - 1.0 / a) * n * u)).abs() / size);
        worst = greater(worst, (dot(omega, q) - udot).abs() / size);
        let basis: Vector<f64> = std::array::from_fn(|i| {
            ((1.0 - u * u) * n / c - (l - n * u) * u / a) * r[i] + (l - n * u) / a * k[i] + udot * q[i]
        });
        worst = greater(worst, distance(basis, omega.map(|w| (1.0 - u * u) * w)) / size);
        let left = 0.5 * s * (a / (p * s) + 1.0 - u * u) * udot * udot / g;
        let right = (1.0 - u * u) * (h - n * n / (2.0 * c) - p * g * u) / (p * g)
            - (l - n * u).powi(2) / (2.0 * a * p * g);
        worst = greater(worst, (left - right).abs() / size);
    }
    tolerance::EQUATIONS.check("eqn:reduced", worst);
}

/// Section 3.2: at a simple zero of the cubic, u = const solves the reduced equation but not the full ones (u'' ≠ 0),
/// so u has a turning point. At a double zero u = const solves both.
#[test]
fn eqn_reduced2_at_a_turning_point() {
    let top = tops()[0];
    let signs = Signs { l_plus_n: Sign::Plus, l_minus_n: Sign::Minus };
    let height_acceleration = |e: [f64; 3], theta: f64| {
        let start = Start { theta, ..Start::default() };
        let motion = toytop::Motion::from_branch_points(&top, e, signs, &start).unwrap();
        let attitude = Stepper::<f64>::new(&motion).attitude_state();
        assert!(attitude.udot().abs() < 1e-15, "the reduced equation lets it stay");
        accelerations(&full_top(&top), &full_state(&attitude.state().unwrap())).height
    };
    let pi = std::f64::consts::PI;
    assert!(height_acceleration([0.2, 0.7, 1.9], 0.0) > 0.1);
    assert!(height_acceleration([0.2, 0.7, 1.9], pi) < -0.1);
    assert!(height_acceleration([0.7, 0.7, 1.9], 0.0).abs() < 1e-14);
    assert!(height_acceleration([0.2, 1.0, 1.9], pi) < -0.1, "through the vertical and back");
}

/// Sections 3.2 and 5.2: at e₂ = e₃ = 1 two motions have the same l, n and h, and u' = 0 at u = 1 for both. One stays
/// there; the other descends to e₁ and returns in infinite time. The full equations distinguish them by their states,
/// the reduced equation cannot.
#[test]
fn at_a_double_root_u_may_stay_or_leave() {
    let top = tops()[0];
    let motion = |theta: f64| {
        let start = Start { theta, ..Start::default() };
        toytop::Motion::from_branch_points(&top, [0.2, 1.0, 1.0], Signs::default(), &start).unwrap()
    };
    let (sleeping, falling) = (motion(std::f64::consts::PI), motion(0.0));
    assert_eq!(sleeping.first_integrals(), falling.first_integrals());
    assert_eq!(sleeping.branch_points(), falling.branch_points());
    let ends = [&sleeping, &falling].map(|motion| {
        let heights = [0.0, 12.0].map(|t| solver(motion).advance_to(t).unwrap().axis()[2]);
        for t in [0.0, 1.0, 12.0] {
            // equation (3.3) holds along both
            let state = solver(motion).advance_to(t).unwrap();
            let (u, udot) = (state.axis()[2], state.axis_height_rate());
            let d = top.transverse_inertia() / top.mass_moment() + top.com_height() * (1.0 - u * u);
            let cubic = (u - 0.2) * (1.0 - u) * (1.0 - u);
            assert!((0.5 * d * udot * udot / top.gravity() - cubic).abs() < 1e-9, "{t}");
        }
        heights
    });
    assert!(ends[0].iter().all(|u| (u - 1.0).abs() < 1e-15), "{ends:?}");
    assert!((ends[1][0] - 0.2).abs() < 1e-15 && ends[1][1] > 0.999 && ends[1][1] < 1.0, "{ends:?}");
}
