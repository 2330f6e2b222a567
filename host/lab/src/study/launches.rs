//! Simulated launches, and a test of the error bars of those fitted to their samples.

use toytop::fit::{Fit, Fitted, Sensor};
use toytop::su2::{Vector, bracket};
use toytop::{Motion, Orientation, Release, State, Top, TopParameters};
use toytop_host::fit::sensors::{Body, Instrument, KINDS, Sensors};
use toytop_host::fit::simulated::{Recording, measurements};
use toytop_host::input::random::Random;

/// Sets of sensors that are tried.
pub(crate) const SETS: [&str; 3] =
    ["gyroscope, accelerometer, magnetometer", "gyroscope, accelerometer", "camera"];

/// Number of samples of a launch.
const SAMPLES: u64 = 300;
/// Rate of the samples, Hz.
const HERTZ: f64 = 1000.0;

/// Square of the normalised error beyond which an accepted launch counts as wrong: the probability of a larger one is below 1e-9.
const WRONG: f64 = 56.0;
/// 95 % quantiles of the chi-squared distributions of 1 to 6 degrees of freedom.
const QUANTILES: [f64; 6] = [3.841, 5.991, 7.815, 9.488, 11.070, 12.592];

/// Result of one launch with one set of sensors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Outcome {
    /// Launch that the fit refused, with the reason.
    NotConverged(&'static str),
    /// Accepted launch that is far from the truth.
    Wrong,
    /// Accepted launch that is near the truth.
    Good {
        /// Square of the normalised error.
        square: f64,
        /// Number of directions that the samples determine.
        freedom: usize,
    },
}

impl Outcome {
    /// Whether the truth is in the ellipsoid of 95 %.
    #[must_use]
    pub(crate) fn is_covered(self) -> bool {
        matches!(self, Self::Good { square, freedom } if square <= QUANTILES[freedom.clamp(1, 6) - 1])
    }
}

/// A random launch whose tip stays on the plane.
#[must_use]
pub(crate) fn random_launch(random: &mut Random) -> (Top, State, Motion) {
    loop {
        if let Some(found) = draw(random) {
            return found;
        }
    }
}

fn draw(random: &mut Random) -> Option<(Top, State, Motion)> {
    let held = random.one_in(3);
    let mass = random.scale(0.02, 0.2);
    let height = random.between(0.015, 0.05);
    let about_com = mass * height * height * random.between(0.2, 1.5);
    let parameters = TopParameters {
        transverse_inertia: about_com + if held { mass * height * height } else { 0.0 },
        axial_inertia: about_com * random.between(0.3, 1.8),
        com_height: height,
        mass,
        gravity: 9.81,
        ..TopParameters::default()
    };
    let top = if held { Top::fixed(&parameters) } else { Top::sliding(&parameters) }.ok()?;
    let sign = if random.one_in(2) { 1.0 } else { -1.0 };
    let mut release = Release {
        tilt: random.between(0.05, 0.9),
        azimuth: random.between(-3.1, 3.1),
        roll: random.between(-3.1, 3.1),
        spin: sign * random.scale(10.0, 250.0),
        precession: random.between(-3.0, 3.0),
        nutation: random.between(-3.0, 3.0),
    };
    match (random.share() * 10.0) as u32 {
        // upright
        0 => (release.tilt, release.precession, release.nutation) = (0.0, 0.0, 0.0),
        // let go at rest
        1 => (release.precession, release.nutation) = (0.0, 0.0),
        // hanging from its tip
        2 if held => release.tilt = std::f64::consts::PI - release.tilt,
        // about regular precession
        3 => {
            let rate = top.mass_moment() * top.gravity() / (top.axial_inertia() * release.spin);
            (release.precession, release.nutation) = (rate, 0.0);
        }
        _ => {}
    }
    let state = State::release(&release).ok()?;
    let motion = Motion::launch(&top, &state).ok()?;
    // the plane does not pull a real top down, and the equations do not hold for a top that lies on its side
    let real = motion.min_normal_force().is_none_or(|least| least > 0.05);
    let stands = held || motion.branch_points().e1 > 0.1;
    (real && stands).then_some((top, state, motion))
}

/// Sensors of a set.
#[must_use]
pub(crate) fn sensors(set: usize, top: &Top) -> Sensors {
    let body = Body { tip_scale: top.tip_scale(), com: [0.0; 3] };
    let mut sensors = Sensors::telephone(body);
    match set {
        0 => {}
        1 => sensors.instruments.truncate(2),
        _ => {
            let camera = toytop::fit::OrientationCamera { deviation: 2e-3 };
            sensors.instruments = vec![Instrument {
                kind: KINDS[3],
                noise: toytop::fit::Noise { deviation: camera.deviation, bias: 0.0 },
                range: f64::INFINITY,
                quantum: 0.0,
                every: 2,
                sensor: Box::new(camera),
            }];
        }
    }
    // rounding is not normally distributed, and is no part of the stated noise
    for instrument in &mut sensors.instruments {
        instrument.quantum = 0.0;
    }
    sensors
}

/// Simulates a launch and fits it.
#[must_use]
pub(crate) fn run(random: &mut Random, set: usize, seed: u64) -> Outcome {
    let (top, state, motion) = random_launch(random);
    let sensors = sensors(set, &top);
    let recording = Recording { hertz: HERTZ, count: SAMPLES, seed };
    let Some(samples) = measurements(&motion, &sensors, &recording) else {
        return Outcome::NotConverged("simulation");
    };
    let listed: Vec<&dyn Sensor> =
        sensors.instruments.iter().map(|instrument| &*instrument.sensor as &dyn Sensor).collect();
    let fitted = Fit::new(&top, &listed, &[]).and_then(|mut fit| fit.run(samples.iter().copied()));
    match fitted {
        Err(_) => Outcome::NotConverged("error"),
        Ok(Fitted { reason: Some(reason), .. }) => Outcome::NotConverged(match reason {
            toytop::fit::Reason::NotSettled => "not settled",
            toytop::fit::Reason::Misfit => "misfit",
            toytop::fit::Reason::SpinUnknown => "upright and of unknown spin",
            toytop::fit::Reason::AtRest => "at rest",
            toytop::fit::Reason::NoBeginning => "without beginning",
            _ => "other",
        }),
        Ok(fitted) => {
            let freedom = 6 - fitted.unobservable.count.min(5);
            let square = normalised_square(&fitted, &state);
            if square > WRONG { Outcome::Wrong } else { Outcome::Good { square, freedom } }
        }
    }
}

/// Square of the error of the launch in standard deviations.
fn normalised_square(fitted: &Fitted, state: &State) -> f64 {
    let launch = &fitted.launch;
    let whole = state.orientation().normalised().compose(&launch.orientation.inverse());
    // an undetermined rotation about the vertical is not counted as an error, and need not be small
    let yaw = match whole.quaternion() {
        [w, _, _, z] if fitted.unobservable.yaw => Orientation::exp([0.0, 0.0, -2.0 * z.atan2(w)]),
        _ => Orientation::IDENTITY,
    };
    let turn = yaw.compose(&whole);
    let theta = rotation_vector(&turn);
    let seen = turn.inverse().adjoint(yaw.adjoint(state.omega()));
    let eta = [0, 1, 2].map(|k| seen[k] - launch.omega[k]);
    let along = bracket(theta, launch.omega);
    let error = [theta[0], theta[1], theta[2], eta[0] + along[0], eta[1] + along[1], eta[2] + along[2]];
    // Cholesky's factor of the covariance, and the error in its coordinates
    let mut factor = [[0.0; 6]; 6];
    let mut square = 0.0;
    let mut scaled = [0.0; 6];
    for i in 0..6 {
        for j in 0..=i {
            let inner: f64 = (0..j).map(|k| factor[i][k] * factor[j][k]).sum();
            let rest = fitted.covariance.of(i, j) - inner;
            factor[i][j] = if i == j { rest.max(1e-30).sqrt() } else { rest / factor[j][j] };
        }
        let known: f64 = (0..i).map(|k| factor[i][k] * scaled[k]).sum();
        scaled[i] = (error[i] - known) / factor[i][i];
        square += scaled[i] * scaled[i];
    }
    square
}

fn rotation_vector(phi: &Orientation<f64>) -> Vector<f64> {
    let [w, x, y, z] = phi.quaternion();
    let sign = w.signum();
    let sine = (x * x + y * y + z * z).sqrt();
    let scale = if sine > 1e-12 { 2.0 * sine.atan2(w.abs()) / sine } else { 2.0 };
    [x, y, z].map(|component| sign * scale * component)
}
