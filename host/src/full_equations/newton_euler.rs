//! Full equations in their original form: Newton's equation for the centre of mass, Euler's for the rotation about it, with the unknown force
//! of the plane. They use neither the Lagrangian nor the momentum m, so that formulas derived from these can be checked.
//!
//! ```text
//! M s u'' = N - M g        d/dt (A ω + ((C - A) ⟨ω, r⟩ + K) r) = (-s r) × (N k) = -s N q        q = r × k
//! ```
//!
//! The axial part is ⟨ω, r⟩' = 0; the part along q, with u' = ⟨ω, q⟩, is one linear equation for u''.

use super::equations::{FullState, FullTop, cross, dot};

/// Accelerations and normal force of a state.
#[derive(Debug)]
pub struct Accelerations {
    /// Angular acceleration ω', rad/s².
    pub omega: [f64; 3],
    /// Second derivative u'' of the cosine of the tilt, 1/s².
    pub height: f64,
    /// Force of the plane in units of the weight (without meaning for a fixed tip).
    pub normal_force: f64,
}

/// Accelerations of a state of a top; for `s` = 0, about the fixed tip.
pub fn accelerations(top: &FullTop, state: &FullState) -> Accelerations {
    let FullTop { a, c, s, p, g, k } = *top;
    let (r, omega) = (state.axis(), state.omega);
    let (q, turn) = ([r[1], -r[0], 0.0], cross(omega, r));
    let axial = (c - a) * dot(omega, r) + k;
    // u'' = ⟨ω', q⟩ + ⟨ω, r' × k⟩ and A ω' = -p (g + s u'') q - axial r'
    let bend = a * dot(omega, [turn[1], -turn[0], 0.0]);
    let height = (bend - p * g * dot(q, q) - axial * dot(turn, q)) / (a + p * s * dot(q, q));
    let push = p * (g + s * height);
    let omega = std::array::from_fn(|i| (-push * q[i] - axial * turn[i]) / a);
    Accelerations { omega, height, normal_force: 1.0 + s * height / g }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::full_equations::full_solver::{FULL_SOLVER_TOLERANCE, FullSolver};

    /// Comparison with differences of ω along the full solution, for both supports, with and without a rotor.
    #[test]
    fn it_is_the_acceleration_of_the_full_solution() {
        for (s, k) in [(0.6, 0.0), (0.6, 1.7), (0.0, -2.3)] {
            let top = FullTop { a: 1.1, c: 0.8, s, p: 0.9, g: 1.3, k };
            let state = FullState { alpha: [0.6, 0.0], beta: [0.0, 0.8], omega: [0.3, -0.2, 2.5] };
            let solver = FullSolver::new(top, state, FULL_SOLVER_TOLERANCE);
            let at = |t: f64| solver.clone().advance_to(t).unwrap();
            let (found, step) = (accelerations(&top, &at(0.7)), 3e-5);
            let (before, after) = (at(0.7 - step), at(0.7 + step));
            for i in 0..3 {
                let difference = (after.omega[i] - before.omega[i]) / (2.0 * step);
                assert!((difference - found.omega[i]).abs() < 1e-7, "{i}: {difference} {found:?}");
            }
            let rise = (after.axis_height_rate() - before.axis_height_rate()) / (2.0 * step);
            assert!((rise - found.height).abs() < 1e-7 && (found.height.abs() > 1e-2), "{rise} {found:?}");
        }
    }
}
