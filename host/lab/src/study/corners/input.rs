//! Input of a launch: branch points or a state, in the allowed range or outside of it.

use std::f64::consts::{FRAC_PI_2, PI};
use std::fmt;
use toytop::{Motion, ParameterError, Release, Sign, Signs, Start, State, Stepper};
use toytop_host::input::random::Random;
use toytop_host::truth::exact::Exact;
use toytop_host::truth::motions::{Numbers, branch_points};
use toytop_host::truth::state_constants::Launched;
use toytop_host::truth::states::StateNumbers;

/// Least difference of branch points that is not 0; its root is the least tilt from the vertical.
const LEAST: f64 = 1e-12;
/// Greatest e₃ - 1, at which the body makes some 10^6 turns in the time in which the axis would fall.
const MOST: f64 = 1e12;

/// Input of a launch, whose numbers are taken as exact.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Input {
    /// Branch points e₁, e₂, e₃, the signs, and the phases at t = 0.
    BranchPoints(Numbers),
    /// Orientation and angular velocity.
    State(StateNumbers),
}

impl Input {
    /// Random input, log-uniform near the degenerate cases: A/(ps) in \[1e-3, 1e6\], C/A in \[1e-3, 2\], 1 + e₁, e₂ - e₁, 1 - e₂ and e₃ - 1 down to
    /// 1e-12, and one in sixteen at 0. Half of them are branch points; a quarter are states on such motions, in `f64`; a
    /// quarter are releases: tilts down to 1e-6 from either vertical, spins from 1e-3 to 1e6 rad/s, and in every second one a top that
    /// the paper does not contain.
    #[must_use]
    pub(crate) fn random(random: &mut Random) -> Self {
        let numbers = numbers(random);
        if random.one_in(2) {
            return Self::BranchPoints(numbers);
        }
        let thrown = random.one_in(2);
        let release = release(random);
        let state = if thrown { State::release(&release).ok() } else { on_motion(&numbers) };
        let Numbers { a, c, s, p, g, .. } = numbers;
        // a release in range, and a point of a motion with valid constants, give a state
        state.map_or(Self::BranchPoints(numbers), |state| {
            let top = if thrown { other_top(random, &numbers) } else { [a, c, s, p, g, 0.0] };
            Self::State(StateNumbers::of(top, &state))
        })
    }

    /// Random input with one number outside the allowed range.
    #[must_use]
    pub(crate) fn beyond(random: &mut Random) -> Self {
        let mut input = Self::random(random);
        let far = random.scale(1e3, 1e12);
        let not_finite = if random.one_in(2) { f64::NAN } else { f64::INFINITY };
        let place = random.between(0.0, 6.0) as u32;
        match (&mut input, place) {
            (Self::BranchPoints(numbers), 0) => numbers.a = 1e-7 / far * numbers.p * numbers.s,
            (Self::BranchPoints(numbers), 1) => numbers.c = (2.0 + 1e-3 * far) * numbers.a,
            (Self::BranchPoints(numbers), 2) => numbers.e[2] = 1e12 * far,
            (Self::BranchPoints(numbers), 3) => numbers.e[0] = -1.0 - 1e-15 * far,
            (Self::BranchPoints(numbers), 4) => numbers.e[1] = 1.0 + 1e-15 * far,
            (Self::BranchPoints(numbers), _) => numbers.start.theta = not_finite,
            (Self::State(numbers), 0) => numbers.top[0] = 1e-7 / far * numbers.top[2] * numbers.top[3],
            (Self::State(numbers), 1) => numbers.top[1] = (2.0 + 1e-3 * far) * numbers.top[0],
            (Self::State(numbers), 2) => numbers.omega[2] = 1e10 * far,
            (Self::State(numbers), 3) => numbers.phi = numbers.phi.map(|z| z.map(|x| (1.0 + 1e-9 * far) * x)),
            (Self::State(numbers), 4) => {
                numbers.top[4] = if numbers.top[4] > 0.0 { -numbers.top[4] } else { f64::NAN }
            }
            (Self::State(numbers), _) => numbers.omega[0] = not_finite,
        }
        input
    }

    /// Motion of the core.
    ///
    /// # Errors
    /// The errors of a launch.
    pub(crate) fn motion(&self) -> Result<Motion, ParameterError> {
        match self {
            Self::BranchPoints(numbers) => numbers.motion(),
            Self::State(numbers) => numbers.motion(),
        }
    }

    /// Motion launched for `f32`, whose mean rates have fewer bits. From branch points there is one motion for all scalars.
    ///
    /// # Errors
    /// See [`motion`](Self::motion).
    pub(crate) fn motion_for_f32(&self) -> Result<Motion, ParameterError> {
        match self {
            Self::BranchPoints(numbers) => numbers.motion(),
            Self::State(numbers) => numbers.motion_for::<f32>(),
        }
    }

    /// Truth of the motion.
    #[must_use]
    pub(crate) fn exact(&self) -> Exact {
        match self {
            Self::BranchPoints(numbers) => Exact::new(numbers),
            Self::State(numbers) => Exact::launched(&Launched::new(numbers)),
        }
    }

    /// Input in which every number is changed by one unit in its last place, in a random direction. A number of a degenerate case is not
    /// changed, and two equal branch points stay equal.
    #[must_use]
    pub(crate) fn neighbour(&self, random: &mut Random) -> Self {
        let mut moved = |x: f64, corners: &[f64]| match random.one_in(2) {
            _ if corners.contains(&x.abs()) => x,
            true => x.next_up(),
            false => x.next_down(),
        };
        match *self {
            Self::BranchPoints(numbers) => {
                let [e1, e2, e3] = numbers.e;
                let lower = moved(e1, &[1.0]);
                let upper = if e1 == e2 { lower } else { moved(e2, &[1.0]).max(lower) };
                let start = numbers.start;
                Self::BranchPoints(Numbers {
                    a: moved(numbers.a, &[]),
                    c: moved(numbers.c, &[]),
                    s: moved(numbers.s, &[]),
                    p: moved(numbers.p, &[]),
                    g: moved(numbers.g, &[]),
                    e: [lower, upper, moved(e3, &[1.0])],
                    signs: numbers.signs,
                    start: Start {
                        theta: moved(start.theta, &[0.0, PI]),
                        arg_alpha: moved(start.arg_alpha, &[]),
                        arg_beta: moved(start.arg_beta, &[]),
                    },
                })
            }
            Self::State(numbers) => Self::State(StateNumbers {
                top: numbers.top.map(|x| moved(x, &[0.0])),
                phi: numbers.phi.map(|z| z.map(|x| moved(x, &[0.0]))),
                omega: numbers.omega.map(|x| moved(x, &[0.0])),
            }),
        }
    }
}

/// Numbers A, C, s, p, g and K of a top, which in every second draw is one that the paper does not contain: with a rotor inside, held, a
/// rod, a ring, free, or a combination of these.
fn other_top(random: &mut Random, numbers: &Numbers) -> [f64; 6] {
    let Numbers { a, c, s, p, g, .. } = *numbers;
    if random.one_in(2) {
        return [a, c, s, p, g, 0.0];
    }
    let c = match random.between(0.0, 4.0) as u32 {
        0 => 0.0,
        1 => 2.0 * a,
        _ => c,
    };
    let rotor = random.scale(1e-6, 1e6) * a * if random.one_in(2) { 1.0 } else { -1.0 };
    let k = if random.one_in(2) { rotor } else { 0.0 };
    match random.between(0.0, 3.0) as u32 {
        0 => [a, c, s, p, g, k],
        1 => [a, c, 0.0, p, g, k],
        _ => [a, c, 0.0, 0.0, 0.0, k],
    }
}

fn numbers(random: &mut Random) -> Numbers {
    let [s, p, g] = [(); 3].map(|()| random.scale(0.1, 10.0));
    let a = random.scale(1e-3, 1e6) * p * s;
    let c = a * random.scale(1e-3, 2.0);
    let e = branch_points(random, LEAST, MOST);
    let mut sign = || if random.one_in(2) { Sign::Plus } else { Sign::Minus };
    let signs = Signs { l_plus_n: sign(), l_minus_n: sign() };
    let [theta, arg_alpha, arg_beta] = [(); 3].map(|()| random.between(-PI, PI));
    let at_corner = [0.0, PI].into_iter().find(|_| random.one_in(16));
    let start = Start { theta: at_corner.unwrap_or(theta), arg_alpha, arg_beta };
    Numbers { a, c, s, p, g, e, signs, start }
}

/// State at t = 0 of a motion, rounded to `f64`, which is a state of a slightly different motion.
fn on_motion(numbers: &Numbers) -> Option<State> {
    let attitude = Stepper::<f64>::new(&numbers.motion().ok()?).attitude_state();
    State::new(attitude.orientation, attitude.omega()).ok()
}

fn release(random: &mut Random) -> Release {
    let tilt = match (random.one_in(16), random.one_in(3)) {
        (true, _) => 0.0,
        (false, true) => PI - random.scale(LEAST.sqrt(), FRAC_PI_2),
        (false, false) => random.scale(LEAST.sqrt(), FRAC_PI_2),
    };
    let [azimuth, roll] = [(); 2].map(|()| random.between(-PI, PI));
    let mut rate = |one_in_rests: u64, most: f64| match (random.one_in(one_in_rests), random.one_in(2)) {
        (true, _) => 0.0,
        (false, true) => random.scale(1e-3, most),
        (false, false) => -random.scale(1e-3, most),
    };
    let (spin, precession, nutation) = (rate(16, 1e6), rate(3, 1e3), rate(3, 1e3));
    Release { tilt, azimuth, roll, spin, precession, nutation }
}

impl fmt::Display for Input {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::BranchPoints(numbers) => numbers.fmt(f),
            Self::State(numbers) => numbers.fmt(f),
        }
    }
}
