//! `toytop state`: orientation, rates and tip at given times.

mod row_format;

use crate::arguments::options::{Method, hertz};
use crate::arguments::times::{Times, TimesArgs};
use crate::commands::warnings::warnings;
use crate::files::{file_or_stdout, whole_file};
use crate::terminal::parallel::{Progress, write_rows};
use crate::terminal::report::Report;
use clap::Args;
use row_format::RowFormat;
use std::path::PathBuf;
use toytop::{Regime, TableSettings, Tick};
use toytop_closed_forms::ClosedForm;
use toytop_host::Failure;
use toytop_host::input::scenario::Scenario;
use toytop_host::motion::Scalar;
use toytop_host::motion::column::SampleColumn;
use toytop_host::motion::evaluator::MotionEvaluator;
use toytop_host::motion::full_solver;
use toytop_host::motion::sample::MotionSample;
use toytop_host::motion::stepper::{self, steps_needed};
use toytop_host::motion::tip_angle::TipAngle;
use toytop_host::output::Format;
use toytop_model::equations::{FullState, Rates};

/// Returns the sample at the i-th requested time.
type Sampler = dyn Fn(u64) -> MotionSample + Sync;

/// Orientation, rates and tip at given times
#[derive(Args)]
#[command(
    after_help = "Units: t in s, udot in 1/s, omega in rad/s, tip in m, phi in rad, and all other angles in rad.\n\
        With units = \"none\" in the scenario only angles have a unit.\n\
        The tip is 2 s alpha beta. Of a held top or free body it is 2 alpha beta, minus the horizontal part of the axis, without unit.\n\
        CSV columns: quaternion is w,x,y,z; omega_body is wx,wy,wz; angles is tilt,azimuth,roll;\n\
        euler_zxz is euler_phi,euler_theta,euler_psi; all others have their JSON names.\n\n\
        Example: toytop state host/scenarios/toy_top.toml --times 0,0.5,1e6 --format json\n         \
        toytop state host/scenarios/toy_top.toml --from 0 --to 10 --count 1000001 --columns t,quaternion,omega_body --format csv -o top.csv\n         \
        toytop state host/scenarios/toy_top.toml --ticks 0..999 --hertz 8000 --scalar q15 --format csv"
)]
pub struct StateArgs {
    /// Scenario file
    scenario: PathBuf,
    // without a doc comment, which would replace the help text of the whole command
    #[command(flatten)]
    times: TimesArgs,
    /// Method that computes the motion
    #[arg(long, default_value = "ephemeris")]
    method: Method,
    /// Scalar type of the core
    #[arg(long, default_value = "f64")]
    scalar: Scalar,
    /// Steps in a nutation period, for --method stepper; by default 4096. Without a period: in 2 pi sqrt((A/p + s)/g)
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1 << 24))]
    steps_per_period: Option<u32>,
    /// Ticks in a second, for --ticks: N, or A/B for A ticks in B seconds; by default 1000
    #[arg(long, value_name = "N", value_parser = hertz, conflicts_with_all = ["times", "times_file", "from"])]
    hertz: Option<[u32; 2]>,
    /// Columns in their order; JSON always has error_bound too. Default: t,u,udot,alpha,beta,quaternion,omega,tip,phi,error_bound; in JSON also gamma,delta
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    columns: Vec<SampleColumn>,
    /// Form of the output
    #[arg(long, default_value = "table")]
    format: Format,
    /// Output file; without it, stdout
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

pub fn run(arguments: &StateArgs) -> Result<Report, Failure> {
    let inputs = [Some(&*arguments.scenario), arguments.times.times_file.as_deref()];
    whole_file::require_other("--output", arguments.output.as_deref(), &inputs)?;
    let scenario = Scenario::read(&arguments.scenario)?;
    let hertz = arguments.hertz.unwrap_or([1000, 1]);
    let times = Times::read(&arguments.times, hertz)?;
    let format = arguments.format;
    let mut columns = arguments.columns.clone();
    let json_columns = if columns.is_empty() {
        columns.extend(SampleColumn::DEFAULT);
        &[SampleColumn::Gamma, SampleColumn::Delta][..]
    } else {
        &[SampleColumn::ErrorBound]
    };
    // JSON always contains the bound
    if format == Format::Json {
        columns.extend(json_columns.iter().filter(|column| !arguments.columns.contains(column)));
    }
    let support = scenario.motion.top().support();
    let row_format = RowFormat { format, columns, units: scenario.units, support };
    let count = times.seconds.len() as u64;
    let sample = sampler(arguments, &scenario, times, hertz)?;
    // from here on the input cannot cause a failure
    file_or_stdout::write(arguments.output.as_deref(), |out| {
        out.write_all(row_format.head().as_bytes())?;
        write_rows(count, &|index, bytes| bytes.extend(row_format.row(index, &sample(index)).bytes()), out)?;
        out.write_all(row_format.end().as_bytes())
    })?;
    Ok(Report::default().with_notes(warnings(&[scenario])))
}

/// Function that computes samples by a method.
fn sampler(
    arguments: &StateArgs,
    scenario: &Scenario,
    times: Times,
    hertz: [u32; 2],
) -> Result<Box<Sampler>, Failure> {
    let motion = &scenario.motion;
    if arguments.steps_per_period.is_some() && arguments.method != Method::Stepper {
        return Err(Failure::input("--steps-per-period: needs --method stepper"));
    }
    let samples = match (arguments.method, arguments.scalar) {
        (Method::Table, scalar) => return table_sampler(scalar, scenario, times, hertz),
        (Method::Stepper, Scalar::Q31 | Scalar::Q15) => {
            let name = arguments.scalar.name();
            let reason = format!("none in {name}: use --method ephemeris, which has {name}");
            return Err(Failure::input(format!("--method stepper: {reason}")));
        }
        (Method::Stepper, scalar) => {
            let step = motion.characteristic_time() / f64::from(arguments.steps_per_period.unwrap_or(4096));
            let option = arguments.steps_per_period.map_or(&*times.stated_by, |_| "--steps-per-period");
            let steps = steps_needed(&times.seconds, step).map_err(|failure| failure.at(option))?;
            let progress = Progress::new(steps, "steps");
            let samples = match scalar {
                Scalar::F64 => stepper::samples::<f64>,
                _ => stepper::samples::<f32>,
            };
            samples(motion, &times.seconds, step, &|steps| progress.add(steps))
        }
        (Method::Full, Scalar::F64) => full_solver_samples(scenario, &times.seconds)?,
        (Method::ClosedForm, Scalar::F64) => return closed_form_sampler(scenario, times),
        (method, scalar) => {
            let (name, method) = (scalar.name(), method.name());
            return Err(Failure::input(format!("--scalar: {name}: must be f64 with --method {method}")));
        }
    };
    Ok(Box::new(move |index| samples[index as usize]))
}

/// Samples of the full solver. The core gives the start of a motion from branch points, the whole turns of the tip angle, and the tip angle
/// itself where the tip is near the centre.
fn full_solver_samples(scenario: &Scenario, times: &[f64]) -> Result<Vec<MotionSample>, Failure> {
    let states = full_solver::states(scenario, times)?;
    let angle = TipAngle::new(&scenario.motion);
    let sample = |(&t, state): (&f64, &FullState)| {
        let (orientation, omega) = (state.orientation(), state.omega);
        let omega_body = orientation.inverse().adjoint(omega);
        angle.sample(t, orientation, Rates { omega, omega_body, udot: state.udot() })
    };
    Ok(times.iter().zip(&states).map(sample).collect())
}

/// * `hertz`: tick rate `[A, B]`, A ticks in B seconds
fn table_sampler(
    scalar: Scalar,
    scenario: &Scenario,
    times: Times,
    hertz: [u32; 2],
) -> Result<Box<Sampler>, Failure> {
    let motion = &scenario.motion;
    let named = |failure: Failure| match scalar {
        Scalar::F64 => failure.at(&scenario.name),
        _ => failure.at(scalar.name()).at("--scalar").at(&scenario.name),
    };
    let (mut settings, in_ticks) = (TableSettings::new(motion.tick()), !times.ticks.is_empty());
    if in_ticks {
        let tick = Tick::ratio(hertz[0], hertz[1]);
        settings.tick = tick.map_err(|error| Failure::from(error).at("--hertz"))?;
    }
    let evaluator = MotionEvaluator::with_settings(motion, scalar, &settings).map_err(named)?;
    // every tick of 64 bits is in reach of a table
    if in_ticks && motion.regime() != Regime::Aperiodic {
        return Ok(Box::new(move |index| {
            let (tick, t) = (times.ticks[index as usize], times.seconds[index as usize]);
            MotionSample { t, ..evaluator.at_tick(tick) }
        }));
    }
    times.require_within(evaluator.furthest_time(), " with --method ephemeris")?;
    Ok(Box::new(move |index| evaluator.at(times.seconds[index as usize])))
}

/// Function that computes samples by the closed form, if the motion has one.
fn closed_form_sampler(scenario: &Scenario, times: Times) -> Result<Box<Sampler>, Failure> {
    let motion = &scenario.motion;
    let form = ClosedForm::from_motion(motion)
        .map_err(|refusal| Failure::method(refusal.to_string()).at(&scenario.name))?;
    let furthest = motion.furthest_time_of_closed_form();
    times.require_within(furthest, " with --method closed-form")?;
    let angle = TipAngle::new(motion);
    Ok(Box::new(move |index| {
        let t = times.seconds[index as usize];
        let state = form.at(t);
        angle.sample(t, state.orientation, Rates::from_attitude(&state))
    }))
}
