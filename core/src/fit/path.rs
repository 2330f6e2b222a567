//! State and derivatives along the motion of a pass, interpolated between nodes.
//!
//! The nodes are equally spaced in time, and computed when a measurement needs them. They cover one nutation period;
//! all other periods follow from it (`docs/partials.md`). A motion without a period, or with one that is too long, is
//! followed from node to node instead, and the earlier nodes are discarded; its state is then corrected from time to
//! time by an integration of the state alone in `f64`, so that rounding errors do not accumulate.

use crate::fit::launch::{LAUNCH, Launch};
use crate::fit::node::{self, Node};
use crate::fit::period::Turns;
use crate::fit::place::{Length, Place, Rate};
use crate::phase::Phase;
use crate::scalar::Real;
use crate::sensitivity::{COLUMNS, Coefficients, Equations, Flow, Partials, Tangent, advance, total};
use crate::su2::{Orientation, bracket};

/// Largest number of nodes.
const NODES: usize = 20;
/// Distance of the nodes times the bound on the frequencies. The error of a step of the integration, and that of
/// the interpolation, are then about 1e-6.
const SPACING: f64 = 0.6;
/// Largest number of nodes that are followed from one measurement to the next.
const FURTHEST: u32 = 100_000;
/// Error of a step of the integration of the state alone, and the largest number of steps between two corrections.
const TOLERANCE: f64 = 1e-10;
const MOST_STEPS: u32 = 1000;

/// Effect of one nutation period, and of the periods that have passed.
#[derive(Clone, Copy, Debug)]
struct Period<F> {
    length: Length,
    /// Rotations about the vertical and about the axis.
    turns: [Phase; 2],
    /// Shares of the columns of the launch in the growth of each column over a period.
    growth: [[F; LAUNCH]; COLUMNS],
    /// End of the whole periods before the last time, their number, and the rotations during them.
    over: Place,
    count: F,
    turned: (F, F),
    rolled: Phase,
}

/// Motion of a launch with its derivatives.
#[derive(Clone, Copy, Debug)]
pub(super) struct Path<F> {
    exact: Coefficients<f64>,
    launch: Flow<f64, 0>,
    now: Partials<F>,
    /// Number of columns that are computed.
    known: usize,
    /// Time between two nodes, and units of a place per time.
    spacing: f64,
    step: F,
    units_per_time: f64,
    /// Rotation of the body about its axis.
    roll: Rate,
    nodes: [Node<F>; NODES],
    /// Number of the nodes, and of the earlier nodes that were discarded.
    count: usize,
    given_up: usize,
    beyond: Beyond<F>,
}

/// Motion beyond the time that the nodes cover.
#[derive(Clone, Copy, Debug)]
enum Beyond<F> {
    /// Not needed so far.
    Unknown,
    /// Repetition of the first period.
    Repeated(Period<F>),
    /// Integration of the state alone: the last node that it corrected, and the state there.
    Followed(usize, Flow<f64, 0>),
}

impl<F: Real> Path<F> {
    /// Path of a top at rest, before the first launch.
    pub(super) fn new(tip_scale: f64, equations: &Equations<f64>, known: usize) -> Self {
        let flow = Flow::<f64, COLUMNS>::launched(&Orientation::IDENTITY, [0.0; 3]);
        let (exact, equations) = (equations.coefficients, equations.cast());
        Self {
            exact,
            launch: Flow::ZERO,
            now: Partials::new(&equations, flow.cast(), tip_scale, known),
            known,
            spacing: 0.0,
            step: F::ZERO,
            units_per_time: 0.0,
            roll: Rate::of(0.0),
            nodes: [Node::ZERO; NODES],
            count: 0,
            given_up: 0,
            beyond: Beyond::Unknown,
        }
    }

    /// Begins with a launch.
    pub(super) fn begin(&mut self, launch: &Launch, equations: impl FnOnce() -> Equations<f64>) {
        self.launch = Flow::launched(&launch.orientation, launch.omega);
        self.take_over(equations);
        self.step = F::from_f64(self.spacing);
        self.units_per_time = Place::units_per_time(self.spacing);
        self.roll = Rate::of(self.launch.spin * self.spacing);
        if let Some(first) = self.nodes.first_mut() {
            first.flow.set_state(&self.launch.cast());
            let omega = launch.omega.map(F::from_f64);
            for (index, tangent) in first.flow.tangents.iter_mut().enumerate() {
                *tangent = Tangent::of_launch(index, omega);
            }
            first.find_rates(&self.now.equations, self.known);
        }
        (self.count, self.given_up, self.beyond) = (1, 0, Beyond::Unknown);
    }

    /// Stores the equations of a launch and the distance of the nodes.
    #[inline(never)] // the equations in `f64` are on the stack only here
    fn take_over(&mut self, equations: impl FnOnce() -> Equations<f64>) {
        let equations = equations();
        self.exact = equations.coefficients;
        self.now.equations = equations.cast();
        self.spacing = SPACING / equations.fastest(&self.launch);
    }

    /// Moves to a time after the launch, later than that of the last call, and computes the state and the derivatives there.
    /// `None` where it is negative, or beyond [`FURTHEST`] nodes or the range of [`Place`].
    ///
    /// * `turns`: period and rotations of the launch, needed only where the nodes do not reach the time
    pub(super) fn move_to(&mut self, t: f64, turns: impl FnOnce() -> Option<Turns>) -> Option<()> {
        let place = Place::of_units(t * self.units_per_time)?;
        if matches!(self.beyond, Beyond::Unknown) && place > Place::of_node(NODES as u32 - 2) {
            self.beyond = Beyond::Followed(0, self.launch);
            if !self.now.equations.lossy
                && let Some(turns) = turns()
            {
                self.repeat(&turns);
            }
        }
        let Beyond::Repeated(period) = &mut self.beyond else {
            self.interpolate(place)?;
            let rolled = if self.now.equations.lossy {
                self.exact.rolled(self.launch.spin, t)
            } else {
                self.roll.at(place)
            };
            self.now.flow.roll(rolled);
            return Some(());
        };
        period.pass(place);
        let rest = place.minus(period.over);
        self.interpolate(rest)?;
        let Beyond::Repeated(period) = &self.beyond else { return None };
        let flow = &mut self.now.flow;
        if period.count > F::ZERO {
            grow(flow, period, self.known)?;
            flow.turn_by(period.turned, self.known);
        }
        flow.roll(period.rolled + self.roll.at(rest));
        Some(())
    }

    /// State and derivatives at the time to which the path was moved.
    pub(super) fn now(&self) -> &Partials<F> {
        &self.now
    }

    /// Repeats a period from now on, if the nodes can cover it.
    #[inline(never)] // once in a pass only
    fn repeat(&mut self, &Turns { length, about_vertical, about_axis }: &Turns) -> Option<()> {
        let length = Length::of_units(length * self.units_per_time)?;
        if length.place() > Place::of_node(NODES as u32 - 2) {
            return None;
        }
        let omega = self.nodes.first()?.flow.omega();
        self.interpolate(length.place())?;
        let end = &mut self.now.flow;
        end.turn(-about_vertical);
        self.beyond = Beyond::Repeated(Period {
            length,
            turns: [about_vertical, about_axis],
            growth: [[F::ZERO; LAUNCH]; COLUMNS],
            over: Place::ZERO,
            count: F::ZERO,
            turned: (F::ZERO, F::ONE),
            rolled: Phase::ZERO,
        });
        let Beyond::Repeated(Period { growth, .. }) = &mut self.beyond else { return None };
        for (index, (shares, tangent)) in growth.iter_mut().zip(&end.tangents).take(self.known).enumerate() {
            let change = total(tangent.eta, bracket(tangent.theta, omega), F::ONE);
            for (place, (slot, share)) in
                shares.iter_mut().zip(tangent.theta.into_iter().chain(change)).enumerate()
            {
                *slot = if place == index { share - F::ONE } else { share };
            }
        }
        Some(())
    }

    /// Interpolates at a place that the nodes reach, or can reach. The vector `side` does not contain the roll.
    fn interpolate(&mut self, place: Place) -> Option<()> {
        let place = place.minus(Place::of_node(self.given_up as u32));
        if !(Place::of_node(0).minus(Place::of_node(1))..Place::of_node(FURTHEST)).contains(&place) {
            return None;
        }
        // the first node is before the middle one
        let (mut middle, x) = place.nearest_inner();
        while self.count < middle + 2 {
            middle -= self.extend()?;
        }
        let nodes = self.nodes.get(middle.checked_sub(1)?..)?.first_chunk()?;
        let h = self.step;
        node::blend(nodes, Place::number(x), h, self.known, &mut self.now.flow);
        Some(())
    }

    /// Adds a node. Returns the number of nodes that were discarded for it.
    #[inline(never)] // its stages would be on the stack at every time
    fn extend(&mut self) -> Option<usize> {
        // the last three nodes are kept
        const LOST: usize = NODES - 3;
        let given_up = if self.count == NODES { LOST } else { 0 };
        if given_up > 0 {
            self.correct_last()?;
            self.nodes.copy_within(LOST.., 0);
        }
        self.count -= given_up;
        self.given_up += given_up;
        let (reached, ahead) = self.nodes.split_at_mut_checked(self.count)?;
        let h = self.step;
        reached.last()?.step(&self.now.equations, h, self.known, ahead.first_mut()?);
        self.count += 1;
        Some(given_up)
    }

    /// Corrects the state of the last node by an integration in `f64` with a small tolerance.
    #[inline(never)] // the stages of the integration are on the stack only here
    fn correct_last(&mut self) -> Option<()> {
        let index = self.count.checked_sub(1)?;
        let node = self.nodes.get_mut(index)?;
        let Beyond::Followed(last, state) = &mut self.beyond else { return Some(()) };
        let now = index + self.given_up;
        let span = self.spacing * (now - *last) as f64;
        *state = advance(&Equations::of_state(&self.exact), state, span, TOLERANCE, MOST_STEPS)?;
        *last = now;
        node.flow.set_state(&state.cast());
        node.find_rates(&self.now.equations, self.known);
        Some(())
    }
}

impl<F: Real> Period<F> {
    /// Advances by the whole periods before a place that is not before the last one.
    fn pass(&mut self, place: Place) {
        if place.minus(self.over) < self.length.place() {
            return;
        }
        let (count, over) = self.length.whole(place);
        let [about_vertical, about_axis] = self.turns.map(|turn| turn.times(count));
        self.over = over;
        self.count = F::from_f64(count as f64);
        self.turned = F::sine_cosine(about_vertical);
        self.rolled = about_axis;
    }
}

/// Adds to each column the growth over the periods that have passed.
#[inline(never)] // the columns of the launch are on the stack only here
fn grow<F: Real>(flow: &mut Flow<F, COLUMNS>, period: &Period<F>, known: usize) -> Option<()> {
    let launch = *flow.tangents.first_chunk::<LAUNCH>()?;
    for (tangent, growth) in flow.tangents.iter_mut().zip(&period.growth).take(known) {
        for (by, share) in launch.iter().zip(growth) {
            *tangent = tangent.plus(by, period.count * *share);
        }
    }
    Some(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fit::period::tests::{Case, launched};
    use crate::motion::Motion;
    use crate::sensitivity::Sensitivity;
    use crate::su2::{Vector, dot};

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

    /// Largest error of the state and of the columns of the launch within a second, relative to their size, and
    /// whether the motion was repeated.
    fn worst<F: Real>(case: &Case) -> ([f64; 2], bool) {
        let (top, state) = launched(case);
        let motion = Motion::launch(&top, &state).unwrap();
        let launch = Launch::new(state.orientation(), state.omega());
        let equations = Equations::of(&top);
        let mut path = Path::<F>::new(top.tip_scale(), &equations, LAUNCH);
        path.begin(&launch, || equations);
        let sensitivity = Sensitivity::of(&motion);
        let mut cursor = sensitivity.cursor();
        let frequency = equations.fastest(&Flow::<f64, COLUMNS>::launched(&launch.orientation, launch.omega));
        let [mut off, mut changed] = [0.0_f64; 2];
        let size = |x: Vector<f64>| libm::sqrt(dot(x, x));
        let apart = |x: Vector<F>, y: Vector<f64>| size(total(x.map(F::to_f64), y, -1.0));
        for n in 0..700 {
            let t = f64::from(n) / 699.0;
            path.move_to(t, || Turns::of(&top, &state)).unwrap();
            let (found, truth) = (path.now().flow, cursor.at(t).unwrap().flow);
            off = off.max(apart(found.axis, truth.axis)).max(apart(found.side, truth.side));
            off = off.max(apart(found.across, truth.across) / frequency);
            for (x, y) in found.tangents.iter().zip(&truth.tangents).take(LAUNCH) {
                let error = apart(x.theta, y.theta) + apart(x.eta, y.eta) / frequency;
                changed = changed.max(error / (size(y.theta) + size(y.eta) / frequency));
            }
        }
        ([off, changed], matches!(path.beyond, Beyond::Repeated(_)))
    }

    #[test]
    fn the_path_is_the_motion_of_the_launch() {
        for (index, case) in CASES.iter().enumerate() {
            let (double, repeated) = worst::<f64>(case);
            let (single, _) = worst::<f32>(case);
            assert_eq!(repeated, [0, 1, 6].contains(&index), "{index}");
            for [state, columns] in [double, single] {
                assert!(state < 3e-6 && columns < 2e-3, "{index}: {double:?} {single:?}");
            }
        }
    }
}
