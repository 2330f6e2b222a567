//! Section 3.1: T, V, m and DL are compared with the laws of Newton and Euler, and l, n and h with their values along the full solution.
//!
//! The tangent space is trivialised by right multiplication, Φ' = ωΦ, so that ω and m are vectors of the fixed frame. With r = ΦkΦ⁻¹ and
//! q = r × k:
//!
//! ```text
//! T  = A⟨ω, ω⟩/2 + (C - A)⟨ω, r⟩²/2 + ps⟨q, ω⟩²/2        V = pg⟨r, k⟩
//! m  = Aω + (C - A)⟨ω, r⟩ r + ps⟨q, ω⟩ q
//! DL = (C - A)⟨ω, r⟩ r × ω + ps⟨q, ω⟩ r × (k × ω) - pg q
//! m' = ω × m + DL                                        (equation (3.1))
//! ```

use toytop::su2::{Vector, cross, dot};
use toytop::{Complex, FirstIntegrals, Orientation, State, Top, TopParameters};
use toytop_host::motion::full_solver::{Equations, FULL_SOLVER_TOLERANCE, FullSolver, FullState};
use toytop_tests::full_solver::solver;
use toytop_tests::{check, greater, length, tolerance, top_of, vectors};

const UP: Vector<f64> = [0.0, 0.0, 1.0];

/// Lagrangian of a top. A fixed tip is the case s = 0, with moments of inertia about the tip.
struct Lagrangian {
    a: f64,
    /// C - A.
    axial: f64,
    ps: f64,
    pg: f64,
}

impl Lagrangian {
    fn new(top: &Top) -> Self {
        let (a, p) = (top.transverse_inertia(), top.mass_moment());
        Self { a, axial: top.axial_inertia() - a, ps: p * top.com_height(), pg: p * top.gravity() }
    }

    fn kinetic(&self, r: Vector<f64>, omega: Vector<f64>) -> f64 {
        let (axial, rise) = (dot(omega, r), dot(cross(r, UP), omega));
        0.5 * (self.a * dot(omega, omega) + self.axial * axial * axial + self.ps * rise * rise)
    }

    fn momentum(&self, r: Vector<f64>, omega: Vector<f64>) -> Vector<f64> {
        let q = cross(r, UP);
        let (axial, rising) = (self.axial * dot(omega, r), self.ps * dot(q, omega));
        std::array::from_fn(|i| self.a * omega[i] + axial * r[i] + rising * q[i])
    }

    fn derivative(&self, r: Vector<f64>, omega: Vector<f64>) -> Vector<f64> {
        let q = cross(r, UP);
        let (axial, rising) = (self.axial * dot(omega, r), self.ps * dot(q, omega));
        let (turning, lifting) = (cross(r, omega), cross(r, cross(UP, omega)));
        std::array::from_fn(|i| axial * turning[i] + rising * lifting[i] - self.pg * q[i])
    }

    fn momentum_rate(&self, r: Vector<f64>, omega: Vector<f64>) -> Vector<f64> {
        let (turn, derivative) = (cross(omega, self.momentum(r, omega)), self.derivative(r, omega));
        std::array::from_fn(|i| turn[i] + derivative[i])
    }
}

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

/// Accelerations ω' and u'' of a top with a sliding or, for s = 0, a fixed tip, by Newton's equation for the centre of mass and Euler's
/// for the rotation about it, with the unknown force N of the plane. They use neither the Lagrangian nor m.
///
/// ```text
/// M s u'' = N - M g        d/dt (A ω + ((C - A) ⟨ω, r⟩ + K) r) = (-s r) × (N k) = -s N q
/// ```
///
/// The axial part is ⟨ω, r⟩' = 0; the part along q, with u' = ⟨ω, q⟩, is one linear equation for u''.
fn accelerations(top: &Top, state: &FullState) -> (Vector<f64>, f64) {
    let (a, c, k) = (top.transverse_inertia(), top.axial_inertia(), top.rotor_momentum());
    let (s, p, g) = (top.com_height(), top.mass_moment(), top.gravity());
    let (r, omega) = (state.axis(), state.omega);
    let (q, turn) = (cross(r, UP), cross(omega, r));
    let axial = (c - a) * dot(omega, r) + k;
    // u'' = ⟨ω', q⟩ + ⟨ω, r' × k⟩ and A ω' = -p (g + s u'') q - axial r'
    let bend = a * dot(omega, cross(turn, UP));
    let height = (bend - p * g * dot(q, q) - axial * dot(turn, q)) / (a + p * s * dot(q, q));
    let push = p * (g + s * height);
    (std::array::from_fn(|i| (-push * q[i] - axial * turn[i]) / a), height)
}

/// ω × m + DL by the variational principle, against the simplified form that the full solver integrates.
#[test]
fn the_torque_of_the_full_equations_is_the_lagrangians() {
    let top = top_of([1.3, 0.7, 0.8, 1.1], 1.0);
    let state = FullState { alpha: [0.48, 0.64], beta: [0.36, -0.48], omega: [0.4, -0.3, 2.1] };
    let lagrangian = Lagrangian::new(&top);
    let equations = Equations::new(&top, &state);
    let y = equations.vector(&state);
    let rate = lagrangian.momentum_rate(state.axis(), state.omega);
    for (i, rate) in rate.into_iter().enumerate() {
        assert!((rate - equations.derivative(&y)[4 + i]).abs() < 2e-15);
        assert!((equations.state(&y).omega[i] - state.omega[i]).abs() < 1e-15);
    }
}

/// Comparison with differences of ω along the full solution, for both supports, with and without a rotor.
#[test]
fn newton_euler_is_the_acceleration_of_the_full_solution() {
    for (s, k) in [(0.6, 0.0), (0.6, 1.7), (0.0, -2.3)] {
        let parameters = TopParameters {
            transverse_inertia: 1.1,
            axial_inertia: 0.8,
            com_height: s,
            mass_moment: 0.9,
            gravity: 1.3,
            rotor_momentum: k,
            ..TopParameters::default()
        };
        let top = if s > 0.0 { Top::sliding(&parameters) } else { Top::fixed(&parameters) }.unwrap();
        let state = FullState { alpha: [0.6, 0.0], beta: [0.0, 0.8], omega: [0.3, -0.2, 2.5] };
        let solver = FullSolver::new(&top, state, FULL_SOLVER_TOLERANCE).unwrap();
        let at = |t: f64| solver.clone().advance_to(t).unwrap();
        let ((omega, height), step) = (accelerations(&top, &at(0.7)), 3e-5);
        let (before, after) = (at(0.7 - step), at(0.7 + step));
        for i in 0..3 {
            let difference = (after.omega[i] - before.omega[i]) / (2.0 * step);
            assert!((difference - omega[i]).abs() < 1e-7, "{i}: {difference} {omega:?}");
        }
        let rise = (after.udot() - before.udot()) / (2.0 * step);
        assert!((rise - height).abs() < 1e-7 && (height.abs() > 1e-2), "{rise} {height}");
    }
}

/// Rate of the momentum by the laws of Newton and Euler: m' = ∂m/∂ω ω' + ∂m/∂Φ Φ', with ω' from the contact force.
fn newton_euler_rate(top: &Top, state: &State) -> Vector<f64> {
    let (Lagrangian { a, axial, ps, .. }, omega) = (Lagrangian::new(top), state.omega());
    let full_state = FullState::new(&state.orientation(), omega);
    let (omega_rate, height) = accelerations(top, &full_state);
    let r = state.orientation().axis();
    let (q, turn) = (cross(r, UP), cross(omega, r));
    let q_dot = cross(turn, UP);
    std::array::from_fn(|i| {
        a * omega_rate[i] + axial * dot(omega, r) * turn[i] + ps * (height * q[i] + dot(omega, q) * q_dot[i])
    })
}

/// m = ∂T/∂ω by differences, which are exact for a quadratic form, and equation (3.1).
#[test]
fn eqn_motion_is_newton_and_euler() {
    let mut worst = 0.0_f64;
    for top in tops() {
        let lagrangian = Lagrangian::new(&top);
        for state in states() {
            let (r, omega) = (state.orientation().axis(), state.omega());
            let (m_dot, truth) = (lagrangian.momentum_rate(r, omega), newton_euler_rate(&top, &state));
            let size = length(m_dot).max(1.0);
            for i in 0..3 {
                worst = greater(worst, (m_dot[i] - truth[i]).abs() / size);
                let kinetic = |step: f64| {
                    let mut moved = omega;
                    moved[i] += step;
                    lagrangian.kinetic(r, moved)
                };
                let slope = 0.5 * (kinetic(1.0) - kinetic(-1.0));
                worst =
                    greater(worst, (lagrangian.momentum(r, omega)[i] - slope).abs() / kinetic(1.0).max(1.0));
            }
        }
    }
    check("eqn:motion", worst, tolerance::LAGRANGIAN_EQN_MOTION);
}

/// Proposition 1: l = ⟨m, k⟩, n = ⟨m, r⟩ and h = T + V are constant along the full solution, and equal those of the
/// launch.
#[test]
fn prop_1_first_integrals_are_conserved() {
    let mut worst = 0.0_f64;
    for vector in vectors::all() {
        let motion = vector.motion().unwrap();
        let (top, mut path) = (*motion.top(), solver(&motion));
        let lagrangian = Lagrangian::new(&top);
        let FirstIntegrals { l, n, h, .. } = motion.first_integrals();
        let scale = l.abs().max(n.abs()).max((lagrangian.a * lagrangian.pg).sqrt());
        let energy = h.abs().max(lagrangian.pg);
        for i in 0..40 {
            let state = path.advance_to(0.25 * f64::from(i)).unwrap();
            let (r, omega) = (state.axis(), state.omega);
            let m = lagrangian.momentum(r, omega);
            let drifts = [
                (m[2] - l) / scale,
                (dot(m, r) - n) / scale,
                (lagrangian.kinetic(r, omega) + lagrangian.pg * r[2] - h) / energy,
            ];
            worst = drifts.map(f64::abs).into_iter().fold(worst, greater);
        }
    }
    check("l, n, h along the full solution", worst, tolerance::LAGRANGIAN_L_N_H_ALONG_THE_FULL_SOLUTION);
}
