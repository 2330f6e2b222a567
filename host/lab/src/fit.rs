//! `toytop-lab fit`: launches fitted to simulated samples.

use crate::{Found, Study};
use nalgebra::{Matrix6, Vector6};
use std::collections::BTreeMap;
use toytop::{Motion, Orientation, Release, State, Top, TopParameters};
use toytop_fit::{Fit, Fitted};
use toytop_host::fit::sensors::{Body, Instrument, KINDS, Sensors};
use toytop_host::fit::simulated::{Recording, measurements};
use toytop_host::input::random::Random;
use toytop_host::output::Record;
use toytop_host::score::rotation_between;
use toytop_host::{Failure, thread_pool};

/// Results of the launches with one set of sensors.
#[derive(Default)]
struct Sums {
    converged: u64,
    covered: u64,
    /// Sum of the squares of the normalised errors, and of the numbers of directions that the samples determine.
    squares: f64,
    freedom: u64,
    wrong: Vec<u64>,
    refused: BTreeMap<String, u64>,
}

pub fn run(study: &Study) -> Result<Found, Failure> {
    let cores = thread_pool::of_all_cores()?;
    let add = |sums: &mut [Sums; 3], launch| {
        for (set, sums) in sums.iter_mut().enumerate() {
            sums.add(study.seed, launch, set);
        }
    };
    let sums = thread_pool::tally(&cores, (study.motions, "launches"), add, merged);
    let wrong = |(name, sums): (&&str, &Sums)| {
        let launches: Vec<_> = sums.wrong.iter().take(20).collect();
        (!launches.is_empty()).then(|| format!("{name}: accepted, but wrong: launches {launches:?}"))
    };
    Ok(Found {
        headline: format!("{} launches of each set, seed {}.", study.motions, study.seed),
        rows: SETS.iter().zip(&sums).map(|(name, sums)| sums.row(name)).collect(),
        failures: SETS.iter().zip(&sums).filter_map(wrong).collect(),
    })
}

fn merged(mut sums: [Sums; 3], more: [Sums; 3]) -> [Sums; 3] {
    for (sums, more) in sums.iter_mut().zip(more) {
        sums.converged += more.converged;
        sums.covered += more.covered;
        sums.squares += more.squares;
        sums.freedom += more.freedom;
        sums.wrong.extend(more.wrong);
        for (reason, count) in more.refused {
            *sums.refused.entry(reason).or_default() += count;
        }
    }
    sums
}

impl Sums {
    fn add(&mut self, seed: u64, launch: u64, set: usize) {
        let stream = 3 * launch + set as u64;
        let noise = seed.wrapping_mul(1_000_003).wrapping_add(stream);
        match trial(&mut Random::new(seed, stream), set, noise) {
            Ok(Accepted { square, .. }) if square > WRONG => self.wrong.push(launch),
            Ok(Accepted { square, freedom }) => {
                self.converged += 1;
                self.covered += u64::from(square <= QUANTILES[freedom - 1]);
                self.squares += square;
                self.freedom += freedom as u64;
            }
            Err(reason) => *self.refused.entry(reason).or_default() += 1,
        }
    }

    fn row(&self, name: &str) -> Record {
        let refused: Vec<_> =
            self.refused.iter().map(|(reason, count)| format!("{count} {reason}")).collect();
        Record::default()
            .with("sensors", name)
            .with("not_converged", refused.join("; "))
            .with("converged", self.converged)
            .with("wrong", self.wrong.len())
            .with("in_the_95_percent_ellipsoid", self.covered as f64 / self.converged as f64)
            .with("rms_error_of_bound", (self.squares / self.freedom as f64).sqrt())
    }
}

/// Sets of sensors that are tried.
pub const SETS: [&str; 3] = ["gyroscope, accelerometer, magnetometer", "gyroscope, accelerometer", "camera"];

/// Number of samples of a launch.
const SAMPLES: u64 = 300;
/// Rate of the samples, Hz.
const HERTZ: f64 = 1000.0;

/// Square of the normalised error beyond which an accepted launch counts as wrong: the probability of a larger one is below 1e-9.
const WRONG: f64 = 56.0;
/// 95 % quantiles of the chi-squared distributions of 1 to 6 degrees of freedom.
const QUANTILES: [f64; 6] = [3.841, 5.991, 7.815, 9.488, 11.070, 12.592];

/// Accepted launch with one set of sensors.
struct Accepted {
    /// Square of the normalised error.
    square: f64,
    /// Number of directions that the samples determine.
    freedom: usize,
}

/// A random launch whose tip stays on the plane, and the height of its centre of mass.
fn random_launch(random: &mut Random) -> (Top, State, Motion, f64) {
    loop {
        if let Some(found) = draw(random) {
            return found;
        }
    }
}

fn draw(random: &mut Random) -> Option<(Top, State, Motion, f64)> {
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
        spin: sign * random.scale(1.0, 250.0),
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
    (real && stands).then_some((top, state, motion, height))
}

/// Sensors of a set.
fn sensors(set: usize, top: &Top, com_height: f64) -> Sensors {
    // a telephone that is held in a top is at its centre of mass, not at the tip
    let body = Body::of(top, com_height);
    let mut sensors = Sensors::telephone(body);
    match set {
        0 => {}
        1 => sensors.instruments.truncate(2),
        _ => {
            let camera = toytop_fit::OrientationCamera { deviation: 2e-3 };
            sensors.instruments = vec![Instrument {
                kind: KINDS[3],
                noise: toytop_fit::Noise { deviation: camera.deviation, bias: 0.0 },
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
///
/// # Errors
/// Reason why the fit refuses the launch.
fn trial(random: &mut Random, set: usize, seed: u64) -> Result<Accepted, String> {
    let (top, state, motion, height) = random_launch(random);
    let sensors = sensors(set, &top, height);
    let recording = Recording { hertz: HERTZ, count: SAMPLES, seed };
    let samples = measurements(&motion, &sensors, &recording).ok_or("not simulated")?;
    let listed = sensors.listed();
    let mut fit = Fit::new(&top, &listed, &[]).map_err(|error| error.to_string())?;
    let fitted = fit.run(samples.iter().copied()).map_err(|error| error.to_string())?;
    match fitted.reason {
        Some(reason) => Err(reason.to_string()),
        None => Ok(Accepted {
            square: normalised_square(&fitted, &state),
            freedom: 6 - fitted.unobservable.count.min(5),
        }),
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
    let theta = rotation_between(&Orientation::IDENTITY, &turn);
    let seen = turn.inverse().adjoint(yaw.adjoint(state.omega()));
    let eta = [0, 1, 2].map(|k| seen[k] - launch.omega[k]);
    let error = Vector6::from_iterator(theta.into_iter().chain(eta));
    let covariance = Matrix6::from_fn(|i, j| fitted.covariance.get(i, j));
    covariance.cholesky().map_or(f64::INFINITY, |factors| error.dot(&factors.solve(&error)))
}
