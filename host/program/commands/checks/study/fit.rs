//! `toytop study fit`: launches fitted to simulated samples.

use super::{StudyOptions, Summary};
use crate::terminal::parallel::map_with_progress;
use nalgebra::{Matrix6, Vector6};
use serde::Serialize;
use std::collections::BTreeMap;
use std::f64::consts::PI;
use toytop::{Motion, Orientation, Release, State, Top, TopParameters};
use toytop_fit::{Fit, Fitted};
use toytop_host::Failure;
use toytop_host::motion::errors::rotation_between;
use toytop_host::random::Random;
use toytop_host::sensors::models::{Sensors, centre_of_mass};
use toytop_host::sensors::simulated::{Recording, simulate_measurements};

/// Sets of sensors that are tried.
const SENSOR_SETS: [&str; 3] =
    ["gyroscope, accelerometer, magnetometer", "gyroscope, accelerometer", "camera"];
/// Number of samples of a launch.
const SAMPLES: u64 = 300;
/// Rate of the samples, Hz.
const SAMPLE_RATE: f64 = 1000.0;
/// Square of the normalised error beyond which an accepted launch counts as wrong: the probability of a larger one is below 1e-9.
const WRONG: f64 = 56.0;
/// 95 % quantiles of the chi-squared distributions of 1 to 6 degrees of freedom.
const QUANTILES: [f64; 6] = [3.841, 5.991, 7.815, 9.488, 11.070, 12.592];

/// Accepted launch.
struct Accepted {
    /// Square of the normalised error.
    square: f64,
    /// Number of directions that the samples determine.
    freedom: usize,
}

/// Launches of a set of sensors. The names are the keys of JSON.
#[derive(Serialize)]
pub struct Row {
    sensors: &'static str,
    /// Reasons why launches were refused, each with their number.
    not_converged: String,
    /// Number of accepted launches that are not wrong.
    converged: usize,
    /// Number of launches that were accepted, but are wrong.
    wrong: usize,
    in_the_95_percent_ellipsoid: f64,
    rms_error_over_bound: f64,
}

pub fn run(study: &StudyOptions) -> Result<Summary<Row>, Failure> {
    let trials = map_with_progress(3 * study.motions, "launches", |stream| {
        let noise = study.seed.wrapping_mul(1_000_003).wrapping_add(stream);
        trial(&mut Random::new(study.seed, stream), (stream % 3) as usize, noise)
    })?;
    let (mut rows, mut failures) = (Vec::new(), Vec::new());
    for (set, name) in SENSOR_SETS.into_iter().enumerate() {
        let (mut accepted, mut wrong) = (Vec::new(), Vec::new());
        let mut refused = BTreeMap::<_, u64>::new();
        for (launch, trial) in trials.iter().skip(set).step_by(3).enumerate() {
            match trial {
                Ok(trial) if trial.square > WRONG => wrong.push(launch),
                Ok(trial) => accepted.push(trial),
                Err(reason) => *refused.entry(reason).or_default() += 1,
            }
        }
        if !wrong.is_empty() {
            let first: Vec<_> = wrong.iter().take(20).collect();
            failures.push(format!("{name}: accepted, but wrong: launches {first:?}"));
        }
        let refused: Vec<_> = refused.iter().map(|(reason, count)| format!("{count} {reason}")).collect();
        let covered = accepted.iter().filter(|trial| trial.square <= QUANTILES[trial.freedom - 1]).count();
        let squares: f64 = accepted.iter().map(|trial| trial.square).sum();
        let freedom: usize = accepted.iter().map(|trial| trial.freedom).sum();
        rows.push(Row {
            sensors: name,
            not_converged: refused.join("; "),
            converged: accepted.len(),
            wrong: wrong.len(),
            in_the_95_percent_ellipsoid: covered as f64 / accepted.len() as f64,
            rms_error_over_bound: (squares / freedom as f64).sqrt(),
        });
    }
    let headline = format!("{} launches of each set, seed {}.", study.motions, study.seed);
    Ok(Summary { headline, rows, failures })
}

/// Simulates a launch and fits it.
///
/// # Errors
/// Reason why the fit refuses the launch.
fn trial(random: &mut Random, set: usize, seed: u64) -> Result<Accepted, String> {
    let (motion, state, height) =
        std::iter::repeat_with(|| draw(random)).flatten().next().ok_or("no launch")?;
    let sensors =
        sensors(set, centre_of_mass(motion.top(), height)).map_err(|failure| failure.to_string())?;
    let recording = Recording { sample_rate: SAMPLE_RATE, count: SAMPLES, seed };
    let samples = simulate_measurements(&motion, &sensors, &recording).ok_or("not simulated")?;
    let listed = sensors.as_sensors();
    let mut fit = Fit::new(motion.top(), &listed, &[]).map_err(|error| error.to_string())?;
    let fitted = fit.run(samples.iter().copied()).map_err(|error| error.to_string())?;
    match fitted.warning {
        Some(reason) => Err(reason.to_string()),
        None => Ok(Accepted {
            square: normalised_square(&fitted, &state),
            freedom: 6 - fitted.unobservable.count.min(5),
        }),
    }
}

/// Random launch, and the height of the centre of mass; `None` where the tip of a real top would leave the plane, or the top is on its
/// side.
fn draw(random: &mut Random) -> Option<(Motion, State, f64)> {
    let held = random.one_in(3);
    let mass = random.log_uniform(0.02, 0.2);
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
    let sign = random.sign();
    let mut release = Release {
        tilt: random.between(0.05, 0.9),
        azimuth: random.between(-3.1, 3.1),
        roll: random.between(-3.1, 3.1),
        spin: sign * random.log_uniform(1.0, 250.0),
        precession: random.between(-3.0, 3.0),
        nutation: random.between(-3.0, 3.0),
    };
    match random.between(0.0, 10.0) as u32 {
        // upright
        0 => (release.tilt, release.precession, release.nutation) = (0.0, 0.0, 0.0),
        // let go at rest
        1 => (release.precession, release.nutation) = (0.0, 0.0),
        // hanging from its tip
        2 if held => release.tilt = PI - release.tilt,
        // about regular precession
        3 => {
            let rate = top.mass_moment() * top.gravity() / (top.axial_inertia() * release.spin);
            (release.precession, release.nutation) = (rate, 0.0);
        }
        _ => {}
    }
    let state = State::from_release(&release).ok()?;
    let motion = Motion::launch(&top, &state).ok()?;
    let real = motion.min_normal_force().is_none_or(|least| least > 0.05);
    let stands = held || motion.branch_points().e1 > 0.1;
    (real && stands).then_some((motion, state, height))
}

/// Sensors of a set. A telephone that is held in a top is at its centre of mass, not at the tip.
fn sensors(set: usize, com: [f64; 3]) -> Result<Sensors, Failure> {
    let mut sensors = match set {
        2 => Sensors::parse("camera", "[orientation]\nnoise = 0.002\nevery = 2\n", com)?,
        _ => Sensors::telephone(com),
    };
    if set == 1 {
        sensors.models.truncate(2);
    }
    // rounding is not normally distributed, and is no part of the stated noise
    for model in &mut sensors.models {
        model.quantum = 0.0;
    }
    Ok(sensors)
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
    let covariance = Matrix6::from_fn(|i, j| fitted.covariance(i, j).unwrap_or(f64::NAN));
    covariance.cholesky().map_or(f64::INFINITY, |factors| error.dot(&factors.solve(&error)))
}
