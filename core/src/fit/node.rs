//! Nodes of a path: state and derivatives with their rates, the step from one to the next, and the interpolation.

use crate::scalar::{Real, Ring};
use crate::sensitivity::{Acceleration, COLUMNS, Coefficients, Equations, Flow, LAUNCH, Tangent, total};
use crate::su2::{Vector, bracket};

/// Number of stages of a step.
const STAGES: usize = 7;
/// Method of order 6 with seven stages (Butcher): weights of the stages before each stage, and those of the result.
const WEIGHTS: [[f64; STAGES]; STAGES] = [
    [1.0 / 3.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    [0.0, 2.0 / 3.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    [1.0 / 12.0, 1.0 / 3.0, -1.0 / 12.0, 0.0, 0.0, 0.0, 0.0],
    [25.0 / 48.0, -55.0 / 24.0, 35.0 / 48.0, 15.0 / 8.0, 0.0, 0.0, 0.0],
    [3.0 / 20.0, -11.0 / 24.0, -1.0 / 8.0, 1.0 / 2.0, 1.0 / 10.0, 0.0, 0.0],
    [-261.0 / 260.0, 33.0 / 13.0, 43.0 / 156.0, -118.0 / 39.0, 32.0 / 195.0, 80.0 / 39.0, 0.0],
    [13.0 / 200.0, 0.0, 11.0 / 40.0, 11.0 / 40.0, 4.0 / 25.0, 4.0 / 25.0, 13.0 / 200.0],
];

/// State and derivatives at one time, with the rates of the state and of η; the rate of θ is η.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node<F> {
    pub(super) flow: Flow<F, COLUMNS>,
    axis_rate: Vector<F>,
    side_rate: Vector<F>,
    across_rate: Vector<F>,
    spin_rate: F,
    eta_rates: [Vector<F>; COLUMNS],
}

/// Weights of the stages, times the length of the step.
type Weights<F> = [[F; STAGES]; STAGES];

impl<F: Real> Node<F> {
    /// Node of zeros.
    pub(super) const ZERO: Self = Self {
        flow: Flow::ZERO,
        axis_rate: [F::ZERO; 3],
        side_rate: [F::ZERO; 3],
        across_rate: [F::ZERO; 3],
        spin_rate: F::ZERO,
        eta_rates: [[F::ZERO; 3]; COLUMNS],
    };

    /// Computes the rates from the state and the first `known` derivatives.
    pub(super) fn find_rates(&mut self, equations: &Equations<F>, known: usize) {
        let state = self.flow.state();
        let at = equations.acceleration(&state);
        (self.axis_rate, self.side_rate) = (at.axis_rate, bracket(state.across, state.side));
        (self.across_rate, self.spin_rate) = (at.across, at.spin);
        let columns = self.flow.tangents.iter().zip(&mut self.eta_rates).take(known).enumerate();
        for (column, (tangent, slot)) in columns {
            let change = equations.changes.get(column.wrapping_sub(LAUNCH));
            *slot = equations.tangent_rate(&state, &at, tangent, change).eta;
        }
    }

    /// Computes the node `next` after a time h, by one step. The columns of the derivatives are integrated one after
    /// another, so that only the stages of one column are in memory at a time.
    pub(super) fn step(&self, equations: &Equations<F>, h: F, known: usize, next: &mut Self) {
        let weights = WEIGHTS.map(|row| row.map(|weight| h * F::from_f64(weight)));
        let mut states = [Flow::ZERO; STAGES];
        let mut at = [Acceleration::ZERO; STAGES];
        let end = self.state_after(equations, &weights, &mut states, &mut at);
        next.flow.set_state(&end);
        let columns = self.flow.tangents.iter().zip(&self.eta_rates).zip(&mut next.flow.tangents);
        for (column, ((start, eta_rate), slot)) in columns.take(known).enumerate() {
            let change = equations.changes.get(column.wrapping_sub(LAUNCH));
            let stages = states.iter().zip(&at).zip(&weights);
            *slot = column_after(
                equations,
                [start, &Tangent { theta: start.eta, eta: *eta_rate }],
                change,
                stages,
            );
        }
        next.find_rates(equations, known);
    }

    /// State after a step, and the state and the accelerations at each stage.
    #[inline(never)] // the stages of the state and those of a column must not be on the stack together
    fn state_after(
        &self,
        equations: &Equations<F>,
        weights: &Weights<F>,
        states: &mut [Flow<F, 0>; STAGES],
        at: &mut [Acceleration<F>; STAGES],
    ) -> Flow<F, 0> {
        let mut side_rates = [[F::ZERO; 3]; STAGES];
        let mut state = self.flow.state();
        for (stage, (slot, row)) in states.iter_mut().zip(weights).enumerate() {
            if let (Some(at), Some(side_rate)) = (at.get_mut(stage), side_rates.get_mut(stage)) {
                *at = equations.acceleration(&state);
                *side_rate = bracket(state.across, state.side);
            }
            *slot = state;
            state = self.flow.state();
            for ((at, side_rate), weight) in at.iter().zip(&side_rates).zip(row).take(stage + 1) {
                state.axis = total(state.axis, at.axis_rate, *weight);
                state.side = total(state.side, *side_rate, *weight);
                state.across = total(state.across, at.across, *weight);
                state.spin = state.spin + *weight * at.spin;
            }
        }
        state
    }
}

/// Column after a step.
///
/// * `start`: column before the step, and its rate
/// * `stages`: state and accelerations of each stage, with the weights of the stages before the next one
#[inline(never)] // as above
fn column_after<'a, F: Real + 'a>(
    equations: &Equations<F>,
    [start, rate]: [&Tangent<F>; 2],
    change: Option<&Coefficients<F>>,
    stages: impl Iterator<Item = ((&'a Flow<F, 0>, &'a Acceleration<F>), &'a [F; STAGES])>,
) -> Tangent<F> {
    let mut rates = [Tangent::NONE; STAGES];
    let mut tangent = *start;
    for (stage, ((state, at), row)) in stages.enumerate() {
        if let Some(slot) = rates.get_mut(stage) {
            *slot = if stage == 0 { *rate } else { equations.tangent_rate(state, at, &tangent, change) };
        }
        tangent = *start;
        for (rate, weight) in rates.iter().zip(row).take(stage + 1) {
            tangent = tangent.plus(rate, *weight);
        }
    }
    tangent
}

/// Sets `sum` to the Hermite interpolation of three nodes at x spacings h from the second, in the first `known` columns.
pub(super) fn blend<F: Real>(nodes: &[Node<F>; 3], x: F, h: F, known: usize, sum: &mut Flow<F, COLUMNS>) {
    let (half, three) = (F::ONE.halved(), F::from_f64(3.0));
    let (left, right) = (x + F::ONE, x - F::ONE);
    let [before, at, after] = [half * x * right, -left * right, half * x * left].map(Ring::squared);
    let weights = [
        [(F::ONE + three * left) * before, h * left * before],
        [at, h * x * at],
        [(F::ONE - three * right) * after, h * right * after],
    ];
    let nodes = nodes.each_ref();
    sum.axis = mixed(&weights, nodes.map(|node| (&node.flow.axis, &node.axis_rate)));
    sum.side = mixed(&weights, nodes.map(|node| (&node.flow.side, &node.side_rate)));
    sum.across = mixed(&weights, nodes.map(|node| (&node.flow.across, &node.across_rate)));
    // the loss of S between two nodes is nearly linear
    let [_, middle, _] = nodes;
    sum.spin = middle.flow.spin + x * h * middle.spin_rate;
    let [before, at, after] = nodes.map(|node| node.flow.tangents.iter().zip(&node.eta_rates));
    // the columns that are not known stay 0
    let columns = sum.tangents.iter_mut().zip(before.zip(at.zip(after))).take(known);
    for (slot, (first, (second, third))) in columns {
        let of = [first, second, third];
        slot.theta = mixed(&weights, of.map(|(tangent, _)| (&tangent.theta, &tangent.eta)));
        slot.eta = mixed(&weights, of.map(|(tangent, rate)| (&tangent.eta, rate)));
    }
}

/// Sum of three vectors and of their rates with these weights.
fn mixed<F: Real>(weights: &[[F; 2]; 3], of: [(&Vector<F>, &Vector<F>); 3]) -> Vector<F> {
    let [[before, before_rate], [at, at_rate], [after, after_rate]] = *weights;
    let [(u, du), (v, dv), (w, dw)] = of;
    let [u, v, w] = [
        total(scaled(u, before), *du, before_rate),
        total(scaled(v, at), *dv, at_rate),
        total(scaled(w, after), *dw, after_rate),
    ];
    total(total(u, v, F::ONE), w, F::ONE)
}

fn scaled<F: Real>(x: &Vector<F>, f: F) -> Vector<F> {
    x.map(|component| f * component)
}
