//! Section 3.1: T, V, m and DL by the laws of Newton and Euler, and Proposition 1 along the full solution.
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

use crate::motion::full_solver::{full_state, full_top, solver};
use toytop::su2::{Vector, cross, dot};
use toytop::{Complex, FirstIntegrals, Orientation, State, Top};
use toytop_host::full_equations::newton_euler::accelerations;
use toytop_tests::{check, greater, tolerance, vectors};

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

/// Rate of the momentum by the laws of Newton and Euler: m' = ∂m/∂ω ω' + ∂m/∂Φ Φ', with ω' from the contact force.
fn newton_euler_rate(top: &Top, state: &State) -> Vector<f64> {
    let (Lagrangian { a, axial, ps, .. }, omega) = (Lagrangian::new(top), state.omega());
    let truth = accelerations(&full_top(top), &full_state(state));
    let r = state.orientation().axis();
    let (q, turn) = (cross(r, UP), cross(omega, r));
    let q_dot = cross(turn, UP);
    std::array::from_fn(|i| {
        a * truth.omega[i]
            + axial * dot(omega, r) * turn[i]
            + ps * (truth.height * q[i] + dot(omega, q) * q_dot[i])
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
            let size = dot(m_dot, m_dot).sqrt().max(1.0);
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
