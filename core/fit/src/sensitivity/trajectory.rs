//! State and derivatives of a motion, moved from one time to the next.

use crate::sensitivity::coefficients::Coefficients;
use crate::sensitivity::equations::Equations;
use crate::sensitivity::partials::Partials;
use crate::sensitivity::state::{BodyState, COLUMNS, Tangent};
use crate::vector::about_third_axis;
use toytop::Phase;
use toytop::scalar::Real;

/// Largest number of steps from one time to the next.
const MAX_STEPS: f64 = 200_000.0;
/// Largest square of a tangent's size; the squares of larger ones would not be finite.
const LARGEST: f64 = 1e300;

/// Motion of a launch with its derivatives.
///
/// The derivatives are integrated in the scalar `F`. The state is integrated in `f64` from node to node, so that its errors do not add up.
/// Each time is reached from the node by one step in `F`. The node moves to the last time where the next one is beyond the longest step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Trajectory<F> {
    /// State and derivatives at the time of the last move.
    pub(crate) now: Partials<F>,
    /// Time of `now`.
    time: f64,
    node: Node<F>,
    /// Coefficients of the equations of the state at a node.
    coefficients: Coefficients,
    /// Rate about the axis at the launch.
    spin: f64,
    /// Longest step of the integration.
    longest_step: f64,
}

/// Time with its state, without the rotation about the axis since the launch, and with its derivatives.
#[derive(Clone, Copy, Debug)]
struct Node<F> {
    time: f64,
    state: BodyState<f64>,
    tangents: [Tangent<F>; COLUMNS],
}

impl<F: Real> Trajectory<F> {
    /// Trajectory at its launch.
    ///
    /// * `longest_step`: product of the longest step and the bound on the frequencies
    #[inline(never)] // stack
    pub(crate) fn new(state: &BodyState<f64>, equations: &Equations<f64>, longest_step: f64) -> Self {
        let tangents = Tangent::launch_columns();
        Self {
            now: Partials { state: state.cast(), tangents, equations: equations.cast() },
            time: 0.0,
            node: Node { time: 0.0, state: *state, tangents },
            coefficients: equations.coefficients,
            spin: state.spin,
            longest_step: longest_step / equations.frequency(state),
        }
    }

    /// Moves to a time after the launch, or before it. `None` where it is too far from the last one, or where a tangent has grown too large
    /// before.
    #[inline(never)] // stack
    pub(crate) fn move_to(&mut self, t: f64) -> Option<()> {
        // the bits are compared, which is faster on a chip without a unit for `f64`
        if self.time.to_bits() == t.to_bits() {
            return Some(());
        }
        if !self.reaches(t, MAX_STEPS) {
            return None;
        }
        while !self.reaches(t, 1.0) {
            if self.time.to_bits() == self.node.time.to_bits() {
                self.step_to(self.node.time + self.longest_step.copysign(t - self.node.time));
            }
            self.move_node();
            if !self.is_bounded() {
                return None;
            }
        }
        self.step_to(t);
        let roll = about_third_axis(self.roll(t));
        self.now.state.orientation = self.now.state.orientation.compose(&roll);
        Some(())
    }

    /// Whether no tangent is too large. In `f32` the limit is infinite.
    fn is_bounded(&self) -> bool {
        let limit = F::from_f64(LARGEST);
        self.now.tangents.iter().all(|tangent| tangent.inner(tangent) < limit)
    }

    /// Whether a time is within this number of steps from the node.
    fn reaches(&self, t: f64, steps: f64) -> bool {
        (t - self.node.time).abs() <= steps * self.longest_step
    }

    /// Moves from the node to a time.
    fn step_to(&mut self, t: f64) {
        let Node { time, state, tangents } = &self.node;
        let Partials { state: now, tangents: tangents_now, equations } = &mut self.now;
        (*now, *tangents_now) = (state.cast(), *tangents);
        equations.step(now, tangents_now, F::from_f64(t - time));
        self.time = t;
    }

    /// Moves the node to the last time.
    #[inline(never)] // stack
    fn move_node(&mut self) {
        let Node { time, state, tangents } = &mut self.node;
        let equations =
            Equations { coefficients: self.coefficients, changes: Default::default(), column_count: 0 };
        equations.step(state, &mut [], self.time - *time);
        (*tangents, *time) = (self.now.tangents, self.time);
    }

    /// Angle by which the body has turned about its axis at a time.
    fn roll(&self, t: f64) -> Phase {
        let [loss, ..] = self.coefficients.losses;
        let lost = loss * t;
        // (1 - e⁻ˣ)/x
        let mean = if lost == 0.0 { 1.0 } else { -libm::expm1(-lost) / lost };
        Phase::from_radians(self.spin * t * mean)
    }
}

impl Trajectory<f64> {
    /// Launch with other tangents and another angle of the body about its axis.
    pub(crate) fn relaunched(mut self, roll: Phase, tangents: [Tangent<f64>; COLUMNS]) -> Self {
        let orientation = &mut self.node.state.orientation;
        *orientation = orientation.compose(&about_third_axis(roll));
        self.node.tangents = tangents;
        (self.now.state, self.now.tangents) = (self.node.state, tangents);
        self
    }

    /// Trajectory at another time. `None` where that is too far, or where a tangent has grown beyond 1e150.
    pub(crate) fn at(mut self, t: f64) -> Option<Self> {
        self.move_to(t)?;
        self.is_bounded().then_some(self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sensitivity::{LAUNCH_COLUMNS, PASS_STEP, Sensitivity};
    use crate::vector::{Vector, add_scaled, dot};
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
        let equations = Equations { column_count: LAUNCH_COLUMNS, ..Equations::new(&top) };
        let launch = BodyState::new(state.orientation(), state.omega());
        let mut trajectory = Trajectory::<F>::new(&launch, &equations, PASS_STEP);
        let mut sensitivity = Sensitivity::new(&motion);
        let frequency = equations.frequency(&launch);
        let [mut off, mut changed] = [0.0_f64; 2];
        let size = |x: Vector<f64>| libm::sqrt(dot(x, x));
        let apart = |x: Vector<F>, y: Vector<f64>| size(add_scaled(x.map(F::to_f64), y, -1.0));
        for n in 0..700 {
            let t = f64::from(n) / 699.0;
            trajectory.move_to(t).unwrap();
            let (now, partials) = (trajectory.now, sensitivity.advance_to(t).unwrap());
            let (found, truth) = (now.state, partials.state);
            for (found, truth) in found.orientation.matrix().into_iter().zip(truth.orientation.matrix()) {
                off = off.max(apart(found, truth));
            }
            off = off.max(apart(found.transverse, truth.transverse) / frequency);
            for (x, y) in now.tangents.iter().zip(&partials.tangents).take(LAUNCH_COLUMNS) {
                let error = apart(x.theta, y.theta) + apart(x.eta, y.eta) / frequency;
                changed = changed.max(error / (size(y.theta) + size(y.eta) / frequency));
            }
        }
        [off, changed]
    }

    /// Limits of state and columns, in `f64` and `f32`. With state errors of 6e-7 in `f64` some fits of fast tops were wrong.
    #[test]
    fn the_trajectory_is_the_motion_of_the_launch() {
        let errors = CASES.map(|case| [worst::<f64>(&case), worst::<f32>(&case)]);
        let greatest =
            |scalar: usize, kind: usize| errors.iter().map(|error| error[scalar][kind]).fold(0.0, f64::max);
        let within = |error: f64, limit: f64| (0.1 * limit..limit).contains(&error);
        for (scalar, limits) in [[3e-7, 3e-5], [1e-6, 2e-3]].into_iter().enumerate() {
            let are_near = [0, 1].into_iter().all(|kind| within(greatest(scalar, kind), limits[kind]));
            assert!(are_near, "{scalar}: {errors:?}");
        }
    }
}
