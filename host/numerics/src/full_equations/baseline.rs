//! Baselines: the full equations in equal steps by three methods, as programs integrate them without this library.

use crate::full_equations::full_solver::{Equations, Vector7};
use crate::full_equations::full_solver::{FullState, FullTop};
use multicalc::linear_algebra::Vector;
use multicalc::ode::Rk4;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use std::marker::PhantomData;

/// Integration method of one step.
pub trait Scheme {
    /// State after `step`, s. The norm of Φ may differ slightly from 1.
    fn step(equations: &Equations, y: &Vector7, step: f64) -> Vector7;
}

/// Classical Runge-Kutta method, written out.
#[derive(Clone, Copy, Debug)]
pub struct RungeKutta;

impl Scheme for RungeKutta {
    fn step(equations: &Equations, y: &Vector7, step: f64) -> Vector7 {
        equations.runge_kutta(y, step)
    }
}

/// Runge-Kutta method of the crate multicalc.
#[derive(Clone, Copy, Debug)]
pub struct Multicalc;

impl Scheme for Multicalc {
    fn step(equations: &Equations, y: &Vector7, step: f64) -> Vector7 {
        let array = |y: &Vector<7, f64>| -> Vector7 { core::array::from_fn(|i| y[i]) };
        let rate = |_: f64, y: &Vector<7, f64>| Vector::new(equations.derivative(&array(y)));
        array(&Rk4::step(&rate, 0.0, &Vector::new(*y), step))
    }
}

/// Method of attitude filters, with nalgebra: the quaternion is rotated by the exponential of ω at the middle of the step, and the momenta
/// follow from the midpoint rule; second order.
#[derive(Clone, Copy, Debug)]
pub struct Exponential;

impl Scheme for Exponential {
    fn step(equations: &Equations, y: &Vector7, step: f64) -> Vector7 {
        // state y plus the change by the rates of another state
        let turned = |at: &Vector7, time: f64| -> Vector7 {
            let [w1, w2, w3] = equations.state(at).omega;
            let turn = UnitQuaternion::from_scaled_axis(Vector3::new(w1, w2, w3) * time);
            let q = turn.into_inner() * Quaternion::new(y[0], y[3], -y[2], y[1]);
            let rate = equations.derivative(at);
            let [l, m, n] = [4, 5, 6].map(|i| y[i] + time * rate[i]);
            [q.w, q.k, -q.j, q.i, l, m, n]
        };
        turned(&turned(y, 0.5 * step), step)
    }
}

/// Motion that is integrated in equal steps.
#[derive(Clone, Debug)]
pub struct EqualSteps<S> {
    equations: Equations,
    y: Vector7,
    /// Length of a step, s.
    step: f64,
    scheme: PhantomData<S>,
}

impl<S: Scheme> EqualSteps<S> {
    /// Integration from t = 0 in steps of `step`, s.
    #[must_use]
    pub fn new(top: &FullTop, state: &FullState, step: f64) -> Self {
        let equations = Equations::of(top, state);
        let ([a, b], [c, d], [l, m, n]) = (state.alpha, state.beta, equations.momentum(state));
        Self { equations, y: [a, b, c, d, l, m, n], step, scheme: PhantomData }
    }

    /// Performs one step, and normalises Φ.
    pub fn step(&mut self) {
        self.y = S::step(&self.equations, &self.y, self.step);
        let norm = self.y[..4].iter().map(|x| x * x).sum::<f64>().sqrt();
        self.y[..4].iter_mut().for_each(|x| *x /= norm);
    }

    /// State at the time that is reached.
    #[must_use]
    pub fn state(&self) -> FullState {
        self.equations.state(&self.y)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::full_equations::full_solver::{FULL_SOLVER_TOLERANCE, FullSolver};

    fn order<S: Scheme>() -> (f64, f64) {
        let top = FullTop { a: 1.1, c: 0.8, s: 0.6, p: 0.9, g: 1.0, k: 0.0 };
        let state = FullState { alpha: [0.6, 0.0], beta: [0.0, 0.8], omega: [0.3, -0.2, 2.5] };
        let truth = FullSolver::new(top, state, FULL_SOLVER_TOLERANCE).advance_to(2.0).unwrap();
        let error = |steps: u32| {
            let mut run = EqualSteps::<S>::new(&top, &state, 2.0 / f64::from(steps));
            (0..steps).for_each(|_| run.step());
            let found = run.state();
            let omega = (0..3).map(|i| found.omega[i] - truth.omega[i]);
            let phi = (0..2).flat_map(|i| [found.alpha[i] - truth.alpha[i], found.beta[i] - truth.beta[i]]);
            omega.chain(phi).fold(0.0, |worst: f64, off| worst.max(off.abs()))
        };
        let [coarse, fine] = [64, 128].map(error);
        ((coarse / fine).log2(), fine)
    }

    #[test]
    fn each_is_of_its_order() {
        for (order, fine) in [order::<RungeKutta>(), order::<Multicalc>()] {
            assert!(order > 3.5 && order < 5.0 && fine < 1e-6 && fine > 1e-10, "{order} {fine:e}");
        }
        let (order, fine) = order::<Exponential>();
        assert!(order > 1.8 && order < 2.2 && fine < 1e-3, "{order} {fine:e}");
    }
}
