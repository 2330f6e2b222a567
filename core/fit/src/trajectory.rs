//! State and derivatives along the motion of a pass, interpolated between nodes.
//!
//! The nodes are equally spaced in time, by one step of the integration. The state is also integrated in `f64` with half the step, and
//! replaces that of each node: the errors of the steps do not add up.

use crate::sensitivity::{COLUMNS, Coefficients, Equations, Flow, Partials, rolled};
use crate::vector::{UNITS, Vector};
use toytop::scalar::{Real, Ring};
use toytop::su2::Orientation;

/// Distance of the nodes times the bound on the frequencies. The error of a step, and that of the interpolation, are then about 1e-6.
const SPACING: f64 = 0.5;
/// Largest number of nodes from one measurement to the next.
const FURTHEST: f64 = 1e5;
/// State and derivatives at one time, with their rates.
#[derive(Clone, Copy, Debug)]
struct Node<F> {
    flow: Flow<F, COLUMNS>,
    rate: Flow<F, COLUMNS>,
}

/// Motion of a launch with its derivatives. Those of the launch are changes along its body axes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Trajectory<F> {
    now: Partials<F>,
    /// Time of `now`.
    time: f64,
    /// Coefficients, and the rate about the axis at the launch, in `f64`.
    coefficients: Coefficients,
    spin: f64,
    /// State at the last node.
    state: Flow<f64, 0>,
    /// Time between two nodes.
    spacing: f64,
    /// Last three nodes.
    nodes: [Node<F>; 3],
    /// Number of the last node, counted from 0 at the launch.
    last: u32,
}

impl<F: Real> Trajectory<F> {
    /// Trajectory of a top at rest, before the first launch.
    pub(crate) fn new(equations: &Equations<f64>) -> Self {
        let launch = Flow::launched(&Orientation::IDENTITY, [0.0; 3]);
        let flow = launch.with_tangents(&UNITS);
        Self {
            now: Partials { flow, equations: equations.cast() },
            time: f64::NAN,
            coefficients: equations.coefficients,
            spin: 0.0,
            state: launch,
            spacing: 0.0,
            nodes: [Node { flow, rate: flow }; 3],
            last: 0,
        }
    }

    /// Begins with a launch.
    #[inline(never)] // the equations in `f64` are on the stack only here
    pub(crate) fn begin(
        &mut self,
        orientation: &Orientation<f64>,
        omega: Vector<f64>,
        equations: &Equations<f64>,
    ) {
        let launch = Flow::launched(orientation, omega);
        (self.coefficients, self.spin, self.state) = (equations.coefficients, launch.spin, launch);
        self.spacing = SPACING / equations.frequency(&launch);
        self.now.equations = equations.cast();
        self.now.flow = launch.with_tangents(&launch.axes());
        self.time = f64::NAN;
        self.last = 0;
        let [.., last] = &mut self.nodes;
        (last.flow, last.rate) = (self.now.flow, self.now.equations.rate(&self.now.flow));
    }

    /// State and derivatives at the time to which the trajectory was moved.
    pub(crate) fn now(&self) -> &Partials<F> {
        &self.now
    }

    /// Moves to a time after the launch, not earlier than that of the last call. `None` where it is too far from the last one.
    #[inline(never)] // the prediction and the motion must not be on the stack together
    pub(crate) fn move_to(&mut self, t: f64) -> Option<()> {
        // the bits are compared, which is faster on a chip without a unit for `f64`
        if self.time.to_bits() == t.to_bits() {
            return Some(());
        }
        let nodes = t / self.spacing;
        let middle = libm::round(nodes).max(1.0);
        if middle - f64::from(self.last) >= FURTHEST {
            return None;
        }
        let middle = middle as u32;
        while self.last <= middle {
            self.extend();
        }
        self.interpolate(F::from_f64(nodes - f64::from(middle)));
        self.now.flow.roll(rolled(self.spin, &self.coefficients, t));
        self.time = t;
        Some(())
    }

    /// Adds a node, and discards the first one.
    #[inline(never)] // its stages would be on the stack at every time
    fn extend(&mut self) {
        let equations = &self.now.equations;
        let [first, middle, last] = &mut self.nodes;
        (*first, *middle) = (*middle, *last);
        equations.step(&middle.flow, &middle.rate, self.spacing, &mut last.flow);
        self.extend_state();
        let [.., last] = &mut self.nodes;
        last.flow.set_state(&self.state);
        last.rate = self.now.equations.rate(&last.flow);
        self.last += 1;
    }

    /// Moves the state in `f64` to the last node, by two steps.
    #[inline(never)] // the stages of the integration are on the stack only here
    fn extend_state(&mut self) {
        let Equations { columns, lossy, .. } = self.now.equations;
        let equations = Equations { coefficients: self.coefficients, changes: [[0.0; _]; _], columns, lossy };
        for _ in 0..2 {
            let start = self.state;
            equations.step(&start, &equations.rate(&start), 0.5 * self.spacing, &mut self.state);
        }
    }

    /// Hermite interpolation at x spacings from the middle node. The first body axis does not contain the roll.
    fn interpolate(&mut self, x: F) {
        let (half, three, h) = (F::ONE.halved(), F::from_f64(3.0), F::from_f64(self.spacing));
        let (left, right) = (x + F::ONE, x - F::ONE);
        let [before, at, after] = [half * x * right, -left * right, half * x * left].map(Ring::squared);
        let weights = [
            [(F::ONE + three * left) * before, h * left * before],
            [at, h * x * at],
            [(F::ONE - three * right) * after, h * right * after],
        ];
        let sum = &mut self.now.flow;
        *sum = Flow::ZERO;
        for (Node { flow, rate }, [weight, rate_weight]) in self.nodes.iter().zip(weights) {
            sum.add(flow, weight);
            sum.add(rate, rate_weight);
        }
        // the loss of S between two nodes is nearly linear
        let [_, middle, _] = &self.nodes;
        sum.spin = middle.flow.spin + x * h * middle.rate.spin;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sensitivity::{LAUNCH_COLUMNS, Sensitivity, Tangent};
    use crate::vector::{add_scaled, along, cross, dot};
    use toytop::{Motion, Release, State, Top, TopParameters};

    /// A top by A, C, s, M, K and support (0: sliding, 1: fixed, 2: free), and its launch by tilt, spin, precession and
    /// nutation rate.
    type Case = ([f64; 5], u8, [f64; 4]);

    /// Top and state of a case.
    fn launched(&(top, support, launch): &Case) -> (Top, State) {
        let [transverse_inertia, axial_inertia, com_height, mass, rotor_momentum] = top;
        let parameters = TopParameters {
            transverse_inertia,
            axial_inertia,
            com_height,
            mass,
            gravity: 9.81,
            rotor_momentum,
            ..TopParameters::default()
        };
        let top = match support {
            0 => Top::sliding(&parameters),
            1 => Top::fixed(&parameters),
            _ => Top::free(&parameters),
        };
        let [tilt, spin, precession, nutation] = launch;
        let release = Release { tilt, spin, precession, nutation, azimuth: 0.4, roll: -0.7 };
        (top.unwrap(), State::from_release(&release).unwrap())
    }

    const CASES: [Case; 9] = [
        ([3e-5, 2e-5, 0.03, 0.05, 0.0], 0, [0.35, 150.0, 2.0, 0.5]),
        ([3e-5, 2e-5, 0.03, 0.05, 0.0], 0, [0.1, -220.0, 2.0, 0.5]),
        ([3e-5, 2e-5, 0.03, 0.05, 0.0], 0, [0.6, 20.0, 2.0, 0.5]),
        ([3e-5, 2e-5, 0.03, 0.05, 0.0], 0, [0.05, 45.0, -1.0, 0.5]),
        ([3e-5, 2e-5, 0.03, 0.05, 0.0], 0, [0.7, 0.0, 9.0, 3.0]),
        ([7.5e-5, 2e-5, 0.03, 0.05, 0.0], 1, [0.35, 150.0, 2.0, 0.5]),
        ([7.5e-5, 2e-5, 0.03, 0.05, 0.0], 1, [2.5, -12.0, 2.0, 0.5]),
        ([3e-5, 2e-5, 0.03, 0.05, 1e-3], 0, [0.5, 10.0, 1.0, 0.0]),
        ([1e-5, 1.5e-5, 0.03, 0.05, 0.0], 0, [0.0, 40.0, 0.0, 5.0]),
    ];

    /// Largest error of the state and of the columns of the launch within a second, relative to their size.
    fn worst<F: Real>(case: &Case) -> [f64; 2] {
        let (top, state) = launched(case);
        let motion = Motion::launch(&top, &state).unwrap();
        let equations = Equations { columns: LAUNCH_COLUMNS, ..Equations::new(&top) };
        let mut trajectory = Trajectory::<F>::new(&equations);
        trajectory.begin(&state.orientation(), state.omega(), &equations);
        let launch = Flow::launched(&state.orientation(), state.omega());
        let axes = launch.axes();
        let sensitivity = Sensitivity::new(&motion);
        let mut cursor = sensitivity.cursor();
        let frequency = equations.frequency(&launch);
        let [mut off, mut changed] = [0.0_f64; 2];
        let size = |x: Vector<f64>| libm::sqrt(dot(x, x));
        let apart = |x: Vector<F>, y: Vector<f64>| size(add_scaled(x.map(F::to_f64), y, -1.0));
        for n in 0..700 {
            let t = f64::from(n) / 699.0;
            trajectory.move_to(t).unwrap();
            let (found, truth) = (trajectory.now().flow, cursor.at(t).unwrap().flow);
            off = off.max(apart(found.axis, truth.axis)).max(apart(found.side, truth.side));
            off = off.max(apart(found.across, truth.across) / frequency);
            // the columns of the truth are changes along the fixed axes, those of Φ with ω kept
            let column = |theta: Vector<f64>, eta: Vector<f64>| {
                let shares = [along(&axes, theta), along(&axes, eta)];
                let columns = found.tangents.iter().zip(shares.as_flattened());
                columns
                    .fold(Tangent::ZERO, |sum: Tangent<F>, (one, weight)| sum.plus(one, F::from_f64(*weight)))
            };
            let turns = UNITS.map(|unit| column(unit, cross(state.omega(), unit)));
            let rates = UNITS.map(|unit| column([0.0; 3], unit));
            for (x, y) in [turns, rates].as_flattened().iter().zip(&truth.tangents) {
                let error = apart(x.theta, y.theta) + apart(x.eta, y.eta) / frequency;
                changed = changed.max(error / (size(y.theta) + size(y.eta) / frequency));
            }
        }
        [off, changed]
    }

    #[test]
    fn the_course_is_the_motion_of_the_launch() {
        for (index, case) in CASES.iter().enumerate() {
            let [double, single] = [worst::<f64>(case), worst::<f32>(case)];
            println!("{index}: {double:?} {single:?}");
            for [state, columns] in [double, single] {
                assert!(state < 3e-6 && columns < 2e-3, "{index}: {double:?} {single:?}");
            }
        }
    }
}
