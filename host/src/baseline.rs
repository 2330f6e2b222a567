//! What one would write without this library: the full equations, stepped by the classical method of Runge and Kutta.

use crate::full_solver::{Equations, Vector7};
use crate::full_solver::{FullState, FullTop};

/// A motion followed in equal steps.
#[derive(Clone, Debug)]
pub struct FixedSteps {
    equations: Equations,
    y: Vector7,
    /// s.
    step: f64,
}

impl FixedSteps {
    /// At t = 0, to go on in steps of `step` in s.
    #[must_use]
    pub fn new(top: &FullTop, state: &FullState, step: f64) -> Self {
        let equations = Equations { a: top.a, c: top.c, ps: top.p * top.s, pg: top.p * top.g };
        let ([a, b], [c, d], [l, m, n]) = (state.alpha, state.beta, equations.momentum(state));
        Self { equations, y: [a, b, c, d, l, m, n], step }
    }

    /// One step, and Φ back onto the unit sphere.
    pub fn step(&mut self) {
        let ahead = |k: &Vector7, share: f64| -> Vector7 {
            core::array::from_fn(|i| self.y[i] + share * self.step * k[i])
        };
        let k1 = self.equations.derivative(&self.y);
        let k2 = self.equations.derivative(&ahead(&k1, 0.5));
        let k3 = self.equations.derivative(&ahead(&k2, 0.5));
        let k4 = self.equations.derivative(&ahead(&k3, 1.0));
        let sum: Vector7 = core::array::from_fn(|i| k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]);
        self.y = ahead(&sum, 1.0 / 6.0);
        let norm = self.y[..4].iter().map(|x| x * x).sum::<f64>().sqrt();
        self.y[..4].iter_mut().for_each(|x| *x /= norm);
    }

    /// Where it is.
    #[must_use]
    pub fn state(&self) -> FullState {
        self.equations.state(&self.y)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::full_solver::{FULL_SOLVER_TOLERANCE, FullSolver};

    #[test]
    fn it_is_of_fourth_order() {
        let top = FullTop { a: 1.1, c: 0.8, s: 0.6, p: 0.9, g: 1.0 };
        let state = FullState { alpha: [0.6, 0.0], beta: [0.0, 0.8], omega: [0.3, -0.2, 2.5] };
        let truth = FullSolver::new(top, state, FULL_SOLVER_TOLERANCE).advance_to(2.0).unwrap();
        let error = |steps: u32| {
            let mut run = FixedSteps::new(&top, &state, 2.0 / f64::from(steps));
            (0..steps).for_each(|_| run.step());
            let found = run.state();
            (0..3).map(|i| (found.omega[i] - truth.omega[i]).abs()).fold(0.0, f64::max)
        };
        let [coarse, fine] = [64, 128].map(error);
        assert!((coarse / fine).log2() > 3.5 && fine < 1e-6, "{coarse:e} {fine:e}");
    }
}
