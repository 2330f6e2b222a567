//! Random launch: branch points or a state.

use std::f64::consts::{FRAC_PI_2, PI};
use toytop::{InitialAngles, Release, Sign, Signs, State, Support, TopParameters};
use toytop_host::input::scenario::{Launch, MotionInput};
use toytop_host::random::Random;

/// Least tilt from the vertical that is not 0, rad.
const MIN_TILT: f64 = 1e-6;

/// Random launch near the degenerate cases. Half are branch points; a quarter are states on such motions, in `f64`; a quarter are
/// releases: tilts down to 1e-6 from either vertical, spins from 1e-3 to 1e6 rad/s, and in every second one a top that the paper does
/// not contain.
pub fn draw(random: &mut Random) -> MotionInput {
    let input = on_branch_points(random);
    if random.one_in(2) {
        return input;
    }
    let thrown = random.one_in(2);
    let release = release(random);
    let state = if thrown { State::from_release(&release).ok() } else { on_motion(&input) };
    // a release in range, and a point of a motion with valid constants, give a state
    let Some(state) = state else { return input };
    let input = MotionInput { launch: Launch::from(&state), ..input };
    if thrown { with_other_top(random, input) } else { input }
}

/// Random branch points of a sliding top, log-uniform near the degenerate cases: A/(ps) in \[1e-3, 1e6\], C/A in \[1e-3, 2\], 1 + e₁, e₂ - e₁, 1 - e₂
/// and e₃ - 1 down to 1e-12, and one in sixteen at 0.
fn on_branch_points(random: &mut Random) -> MotionInput {
    let [s, p, g] = [(); 3].map(|()| random.log_uniform(0.1, 10.0));
    let a = random.log_uniform(1e-3, 1e6) * p * s;
    let c = a * random.log_uniform(1e-3, 2.0);
    // 1 + e₁, e₂ - e₁ and 1 - e₂ add up to 2
    let mut gap = || if random.one_in(16) { 0.0 } else { random.log_uniform(1e-12, 1.0) };
    let [below, swing, above] = [gap(), gap(), gap()];
    let unit = 0.5 * (below + swing + above).max(1e-12);
    let e1 = below / unit - 1.0;
    let e2 = if swing == 0.0 { e1 } else { (1.0 - above / unit).max(e1) };
    let e3 = if random.one_in(16) { 1.0 } else { 1.0 + random.log_uniform(1e-12, 1e12) };
    let mut sign = || Sign::new(random.sign());
    let signs = Signs { l_plus_n: sign(), l_minus_n: sign() };
    let [theta, arg_alpha, arg_beta] = [(); 3].map(|()| random.between(-PI, PI));
    let at_corner = [0.0, PI].into_iter().find(|_| random.one_in(16));
    let phases = InitialAngles { theta: at_corner.unwrap_or(theta), arg_alpha, arg_beta };
    let top = TopParameters {
        transverse_inertia: a,
        axial_inertia: c,
        com_height: s,
        mass_moment: p,
        gravity: g,
        ..TopParameters::default()
    };
    let launch = Launch::BranchPoints { e: [e1, e2, e3], signs, phases };
    MotionInput { support: Support::Sliding, top, launch }
}

/// Input whose top in every second draw is one that the paper does not contain: with a rotor inside, held, a rod, a ring, free, or a
/// combination of these.
fn with_other_top(random: &mut Random, input: MotionInput) -> MotionInput {
    if random.one_in(2) {
        return input;
    }
    let TopParameters { transverse_inertia: a, axial_inertia: c, com_height, .. } = input.top;
    let axial_inertia = [0.0, 2.0 * a, c, c][random.between(0.0, 4.0) as usize];
    let rotor_momentum =
        if random.one_in(2) { random.sign() * random.log_uniform(1e-6, 1e6) * a } else { 0.0 };
    let supports = [(Support::Sliding, com_height), (Support::Fixed, 0.0), (Support::Free, 0.0)];
    let (support, com_height) = supports[random.between(0.0, 3.0) as usize];
    let top = TopParameters { axial_inertia, rotor_momentum, com_height, ..input.top };
    MotionInput { support, top, ..input }
}

/// State at t = 0 of a motion, rounded to `f64`, which is a state of a slightly different motion.
fn on_motion(input: &MotionInput) -> Option<State> {
    State::from_attitude(&input.motion().ok()?.attitude_at_launch()).ok()
}

fn release(random: &mut Random) -> Release {
    let tilt = if random.one_in(16) { 0.0 } else { random.log_uniform(MIN_TILT, FRAC_PI_2) };
    let tilt = if random.one_in(3) { PI - tilt } else { tilt };
    let [azimuth, roll] = [(); 2].map(|()| random.between(-PI, PI));
    let mut rate = |one_in_rests: u64, most: f64| {
        if random.one_in(one_in_rests) { 0.0 } else { random.sign() * random.log_uniform(1e-3, most) }
    };
    let (spin, precession, nutation) = (rate(16, 1e6), rate(3, 1e3), rate(3, 1e3));
    Release { tilt, azimuth, roll, spin, precession, nutation }
}
