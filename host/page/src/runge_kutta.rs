//! Classical Runge-Kutta method in equal steps, for comparison with the exact motion.

use toytop::{Complex, Motion, Orientation};
use toytop_model::equations::{Equations, FullState, Vector7};

/// Integration of the full equations from t = 0, forwards or backwards.
pub struct RungeKutta {
    equations: Equations,
    /// Distance s of the centre of mass from the tip, m.
    com_height: f64,
    start: Vector7,
    /// Length of a step, s, > 0.
    step: f64,
    /// State after `steps` steps in the direction `sense`.
    y: Vector7,
    steps: f64,
    sense: f64,
}

/// Greatest number of steps of a call, so that a page stays responsive.
pub const MAX_STEPS: u32 = 40_000;

impl RungeKutta {
    /// Integration of a motion, at t = 0.
    pub fn new(motion: &Motion, step: f64) -> Self {
        let (top, state) = (motion.top(), motion.attitude_at_launch());
        let full = FullState::new(&state.orientation, state.omega());
        let equations = Equations::new(top, &full);
        let start = equations.vector(&full);
        Self { equations, com_height: top.com_height(), start, step, y: start, steps: 0.0, sense: 1.0 }
    }

    /// Integrates towards a time by at most [`MAX_STEPS`] whole steps. Returns the time that is reached, and the orientation and the tip
    /// there. Within a step of t the last step is shorter, and is not kept. An earlier time than the last one begins again at t = 0.
    pub fn advance_to(&mut self, t: f64) -> (f64, Orientation<f64>, Complex<f64>) {
        let sense = if t < 0.0 { -1.0 } else { 1.0 };
        if sense != self.sense || sense * t < self.steps * self.step {
            (self.y, self.steps, self.sense) = (self.start, 0.0, sense);
        }
        let mut left = MAX_STEPS;
        while left > 0 && (self.steps + 1.0) * self.step <= sense * t {
            self.y = self.equations.runge_kutta(&self.y, sense * self.step);
            self.steps += 1.0;
            left -= 1;
        }
        let reached = sense * self.steps * self.step;
        let rest = t - reached;
        if sense * rest >= self.step {
            return self.at(reached, &self.y);
        }
        self.at(t, &self.equations.runge_kutta(&self.y, rest))
    }

    fn at(&self, t: f64, y: &Vector7) -> (f64, Orientation<f64>, Complex<f64>) {
        let state = self.equations.state(y);
        let [x, y, _] = state.axis();
        (t, state.orientation(), Complex::new(x, y).scaled(-self.com_height))
    }
}
