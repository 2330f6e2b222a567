//! State and derivatives along the motion of a pass, interpolated between nodes.
//!
//! The nodes are equally spaced in time, and computed when a measurement needs them. They cover one nutation period;
//! all other periods follow from it (`docs/partials.md`). A motion without a period, or with one that is too long,
//! is followed from node to node instead, and the earlier nodes are given up; its state is then corrected from
//! time to time by an integration of the state alone in `f64`, so that rounding does not add up.

use crate::fit::launch::{LAUNCH, Launch};
use crate::fit::node::{self, Node};
use crate::phase::Phase;
use crate::scalar::Real;
use crate::sensitivity::{COLUMNS, Coefficients, Equations, Flow, Partials, advance, total};
use crate::su2::{Orientation, bracket};

/// Largest number of nodes.
const NODES: usize = 20;
/// Distance of the nodes times the bound on the frequencies. The error of a step of the integration, and that of
/// the interpolation, are then about 1e-6.
const SPACING: f64 = 0.6;
/// Error of a step of the integration of the state alone, and the largest number of steps between two corrections.
const TOLERANCE: f64 = 1e-10;
const MOST_STEPS: u32 = 1000;

/// Effect of one nutation period.
#[derive(Clone, Copy, Debug)]
struct Period<F> {
    length: f64,
    /// Rotations about the vertical and about the axis.
    turns: [Phase; 2],
    /// Changes of the launch whose effect is what a period adds to the columns.
    growth: [[F; LAUNCH]; COLUMNS],
}

/// Motion of a launch with its derivatives.
#[derive(Clone, Copy, Debug)]
pub(super) struct Path<F> {
    exact: Coefficients<f64>,
    launch: Flow<f64, 0>,
    now: Partials<F>,
    /// Number of columns that are computed.
    known: usize,
    /// Time between two nodes, and nodes per time.
    spacing: f64,
    per_spacing: f64,
    nodes: [Node<F>; NODES],
    /// Number of the nodes, and of those before them that were given up.
    count: usize,
    given_up: usize,
    beyond: Beyond<F>,
}

/// Motion beyond the time that the nodes cover.
#[derive(Clone, Copy, Debug)]
enum Beyond<F> {
    /// Not asked for so far.
    Unknown,
    /// Repetition of the first period.
    Repeated(Period<F>),
    /// Integration of the state alone, at the last node that it corrected.
    Followed(usize, Flow<f64, 0>),
}

impl<F: Real> Path<F> {
    /// Path of a top at rest, to begin with.
    pub(super) fn new(tip_scale: f64, equations: &Equations<f64>, known: usize) -> Self {
        let flow = Flow::<f64, COLUMNS>::launched(&Orientation::IDENTITY, [0.0; 3]);
        let (exact, equations) = (equations.coefficients, equations.cast());
        Self {
            exact,
            launch: Flow::ZERO,
            now: Partials::new(&equations, flow.cast(), tip_scale, known),
            known,
            spacing: 0.0,
            per_spacing: 0.0,
            nodes: [Node::ZERO; NODES],
            count: 0,
            given_up: 0,
            beyond: Beyond::Unknown,
        }
    }

    /// Begins with a launch.
    pub(super) fn begin(&mut self, equations: &Equations<f64>, launch: &Launch) {
        let flow = Flow::<f64, COLUMNS>::launched(&launch.orientation, launch.omega);
        self.exact = equations.coefficients;
        self.now.equations = equations.cast();
        self.launch = Flow::launched(&launch.orientation, launch.omega);
        self.spacing = SPACING / equations.fastest(&flow);
        self.per_spacing = 1.0 / self.spacing;
        if let Some(first) = self.nodes.first_mut() {
            first.flow = flow.cast();
            first.find_rates(&self.now.equations, self.known);
        }
        (self.count, self.given_up, self.beyond) = (1, 0, Beyond::Unknown);
    }

    /// Moves to a time after the launch, later than that of the last call: the state and the derivatives there. `None` where
    /// it is not within some periods of the last node.
    ///
    /// * `turns`: as [`Motion::turns_in_period`](crate::Motion) of the launch, which is asked for where the nodes do not reach the time
    pub(super) fn move_to(
        &mut self,
        t: f64,
        turns: impl FnOnce() -> Option<(f64, [Phase; 2])>,
    ) -> Option<()> {
        if matches!(self.beyond, Beyond::Unknown) && t > self.reach() {
            self.beyond = match (!self.now.equations.lossy)
                .then(turns)
                .flatten()
                .and_then(|turns| self.period_of(turns))
            {
                Some(period) => Beyond::Repeated(period),
                None => Beyond::Followed(0, self.launch),
            };
        }
        let Beyond::Repeated(Period { length, turns, .. }) = self.beyond else {
            self.interpolate(t)?;
            self.now.flow.roll(self.exact.rolled(self.launch.spin, t));
            return Some(());
        };
        // the time is not negative and the quotient small: an integer takes less time than the rounding of a float
        let count = f64::from((t / length) as u32);
        let rest = t - count * length;
        self.interpolate(rest)?;
        let flow = &mut self.now.flow;
        if let Beyond::Repeated(period) = &self.beyond
            && count > 0.0
        {
            let launch = *flow.tangents.first_chunk::<LAUNCH>()?;
            let times = F::from_f64(count);
            for (tangent, growth) in flow.tangents.iter_mut().zip(&period.growth).take(self.known) {
                for (by, share) in launch.iter().zip(growth) {
                    *tangent = tangent.plus(by, times * *share);
                }
            }
        }
        let [about_vertical, about_axis] = turns.map(|turn| turn.times(count as i64));
        flow.turn(about_vertical);
        flow.roll(about_axis + self.exact.rolled(self.launch.spin, rest));
        Some(())
    }

    /// State and derivatives at the time to which the path was moved.
    pub(super) fn now(&self) -> &Partials<F> {
        &self.now
    }

    /// Time that the nodes can cover without giving any up.
    fn reach(&self) -> f64 {
        self.spacing * (NODES - 2) as f64
    }

    /// Effect of a period, if there is one that the nodes can cover.
    #[inline(never)]
    fn period_of(&mut self, (length, turns): (f64, [Phase; 2])) -> Option<Period<F>> {
        if length > self.reach() {
            return None;
        }
        let first = self.nodes.first()?.flow;
        let omega = first.omega();
        let [about_vertical, _] = turns;
        self.interpolate(length)?;
        let end = &mut self.now.flow;
        end.turn(-about_vertical);
        let mut growth = [[F::ZERO; LAUNCH]; COLUMNS];
        for (index, (shares, tangent)) in growth.iter_mut().zip(&end.tangents).take(self.known).enumerate() {
            let change = total(tangent.eta, bracket(tangent.theta, omega), F::ONE);
            for (place, (slot, share)) in
                shares.iter_mut().zip(tangent.theta.into_iter().chain(change)).enumerate()
            {
                *slot = if place == index { share - F::ONE } else { share };
            }
        }
        Some(Period { length, turns, growth })
    }

    /// Interpolates at a time that the nodes reach, or can reach; with the side of the nodes.
    fn interpolate(&mut self, t: f64) -> Option<()> {
        const FURTHEST: f64 = 1e5;
        let place = t * self.per_spacing - f64::from(self.given_up as u32);
        if !(-1.0..FURTHEST).contains(&place) {
            return None;
        }
        let nearest = (place + 0.5) as u32;
        let mut middle = nearest.max(1) as usize;
        let x = place - f64::from(nearest.max(1));
        while self.count < middle + 2 {
            middle -= self.extend()?;
        }
        let nodes = self.nodes.get(middle.checked_sub(1)?..)?.first_chunk()?;
        let h = F::from_f64(self.spacing);
        node::blend(nodes, F::from_f64(x), h, self.known, &mut self.now.flow);
        Some(())
    }

    /// Adds a node; the number of nodes that were given up for it.
    #[inline(never)] // its stages would be on the stack at every time
    fn extend(&mut self) -> Option<usize> {
        // the three last ones are kept
        let given_up = if self.count == NODES { NODES - 3 } else { 0 };
        if given_up > 0 {
            self.correct_last()?;
        }
        self.nodes.rotate_left(given_up);
        self.count -= given_up;
        self.given_up += given_up;
        let (reached, ahead) = self.nodes.split_at_mut_checked(self.count)?;
        let h = F::from_f64(self.spacing);
        reached.last()?.step(&self.now.equations, h, self.known, ahead.first_mut()?);
        self.count += 1;
        Some(given_up)
    }

    /// Gives the last node a state whose error is that of `f64` and of a small tolerance.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::Motion;
    use crate::sensitivity::Sensitivity;
    use crate::state::{Release, State};
    use crate::su2::{Vector, dot};
    use crate::top::{Top, TopParameters};

    /// Tops by A, C, s, M and K, sliding or held, and their throws by tilt, spin, precession and nutation rate.
    const CASES: [([f64; 5], bool, [f64; 4]); 9] = [
        ([3e-5, 2e-5, 0.03, 0.05, 0.0], false, [0.35, 150.0, 2.0, 0.5]),
        ([3e-5, 2e-5, 0.03, 0.05, 0.0], false, [0.1, -220.0, 2.0, 0.5]),
        ([3e-5, 2e-5, 0.03, 0.05, 0.0], false, [0.6, 20.0, 2.0, 0.5]),
        ([3e-5, 2e-5, 0.03, 0.05, 0.0], false, [0.05, 45.0, -1.0, 0.5]),
        ([3e-5, 2e-5, 0.03, 0.05, 0.0], false, [0.7, 0.0, 9.0, 3.0]),
        ([7.5e-5, 2e-5, 0.03, 0.05, 0.0], true, [0.35, 150.0, 2.0, 0.5]),
        ([7.5e-5, 2e-5, 0.03, 0.05, 0.0], true, [2.5, -12.0, 2.0, 0.5]),
        ([3e-5, 2e-5, 0.03, 0.05, 1e-3], false, [0.5, 10.0, 1.0, 0.0]),
        ([1e-5, 1.5e-5, 0.03, 0.05, 0.0], false, [0.0, 40.0, 0.0, 5.0]),
    ];

    /// Largest error of the state and of the columns of the launch within a second, relative to their size, and
    /// whether the motion was repeated.
    fn worst<F: Real>(case: &([f64; 5], bool, [f64; 4])) -> ([f64; 2], bool) {
        let ([a, c, s, mass, momentum], held, [tilt, spin, precession, nutation]) = *case;
        let parameters = TopParameters {
            transverse_inertia: a,
            axial_inertia: c,
            com_height: s,
            mass,
            gravity: 9.81,
            rotor_momentum: momentum,
            ..TopParameters::default()
        };
        let top = if held { Top::fixed(&parameters) } else { Top::sliding(&parameters) }.unwrap();
        let release = Release { tilt, spin, precession, nutation, azimuth: 0.4, roll: -0.7 };
        let state = State::release(&release).unwrap();
        let motion = Motion::launch(&top, &state).unwrap();
        let launch = Launch::new(state.orientation(), state.omega());
        let equations = Equations::of(&top);
        let mut path = Path::<F>::new(top.tip_scale(), &equations, LAUNCH);
        path.begin(&equations, &launch);
        let sensitivity = Sensitivity::of(&motion);
        let mut cursor = sensitivity.cursor();
        let frequency = equations.fastest(&Flow::<f64, COLUMNS>::launched(&launch.orientation, launch.omega));
        let [mut off, mut changed] = [0.0_f64; 2];
        let size = |x: Vector<f64>| libm::sqrt(dot(x, x));
        let apart = |x: Vector<F>, y: Vector<f64>| size(total(x.map(F::to_f64), y, -1.0));
        for n in 0..700 {
            let t = f64::from(n) / 699.0;
            path.move_to(t, || motion.turns_in_period()).unwrap();
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
