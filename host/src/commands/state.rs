//! `toytop state`: orientation, rates and tip at given times.

use super::{Report, unreal};
use crate::Failure;
use crate::cli::{Format, Method, Scalar, StateArgs};
use crate::ephemeris::{Instant, furthest_time, smallest};
use crate::fixed_steps::FixedSteps;
use crate::micromath::Micromath;
use crate::output::{self, Cell, Record, number};
use crate::progress::Progress;
use crate::propagate::{Paced, Sample, period, steps_needed, sweep};
use crate::scenario::Scenario;
use crate::{times, tip_angle, truth};
use toytop::exact::ClosedForm;
use toytop::real::Real;
use toytop::{Complex, Motion, Support};

pub(super) fn run(arguments: &StateArgs) -> Result<Report, Failure> {
    let scenario = Scenario::read(&arguments.scenario)?;
    let times = times::read(&arguments.times)?;
    let step = period(&scenario.motion) / f64::from(arguments.steps_per_period);
    let samples = match (arguments.method, arguments.scalar) {
        (Method::Ephemeris, scalar) => tabulated(scalar, &scenario, &times)?,
        (Method::Stepper, Scalar::F64) => stepped::<f64>(&scenario.motion, &times, step)?,
        (Method::Stepper, Scalar::F32) => stepped::<f32>(&scenario.motion, &times, step)?,
        (Method::Stepper, Scalar::Micromath) => stepped::<Micromath>(&scenario.motion, &times, step)?,
        (Method::Stepper, Scalar::Q31) => ticked(&scenario, &times, step)?,
        (Method::Full, Scalar::F64) => truth::samples(&scenario, &times, step)?,
        (Method::ClosedForm, Scalar::F64) => closed(&scenario, &times)?,
        (method, scalar) => {
            let (name, allowed) = (scalar.name(), scalars(method));
            let method = method.name();
            return Err(Failure::Input(format!(
                "--scalar: {name}: must be {allowed} with --method {method}"
            )));
        }
    };
    let text = match arguments.format {
        Format::Table => table(&samples, scenario.motion.top().support()),
        Format::Csv => output::csv(&records(&samples)).map_err(Failure::Output)?,
        Format::Json => output::json_list("samples", &records(&samples)).map_err(Failure::Output)?,
    };
    let report = Report { text, ..Report::default() };
    Ok(report.with_remarks(unreal(&[scenario]), arguments.format == Format::Table))
}

/// Those that a method exists in.
fn scalars(method: Method) -> &'static str {
    match method {
        Method::Ephemeris => "f64, f32, q31, q15 or micromath",
        Method::Stepper => "f64, f32, q31 or micromath",
        Method::Full | Method::ClosedForm => "f64",
    }
}

fn tabulated(scalar: Scalar, scenario: &Scenario, times: &[f64]) -> Result<Vec<Sample>, Failure> {
    let motion = &scenario.motion;
    let furthest = furthest_time(motion);
    if let Some(t) = times.iter().find(|t| t.abs() > furthest) {
        let allowed = format!("within ±{furthest:.1e} s with --method ephemeris");
        return Err(Failure::Input(format!("times: {t:e} must be {allowed}")));
    }
    let ephemeris = smallest(scalar, motion).map_err(|failure| failure.of(&scenario.name))?;
    anywhere(motion, times, ephemeris.error_bound().constant, |t| ephemeris.at(t))
}

/// By the closed form, if the motion has one.
fn closed(scenario: &Scenario, times: &[f64]) -> Result<Vec<Sample>, Failure> {
    let motion = &scenario.motion;
    let form =
        ClosedForm::of(motion).map_err(|refusal| Failure::Method(refusal.to_string()).of(&scenario.name))?;
    let furthest = MOST_PERIODS * period(motion);
    if let Some(t) = times.iter().find(|t| t.abs() > furthest) {
        let allowed = format!("within ±{furthest:.1e} s with --method closed-form");
        return Err(Failure::Input(format!("times: {t:e} must be {allowed}")));
    }
    let scale = 2.0 * motion.top().tip_scale();
    anywhere(motion, times, NOISE, |t| {
        let pose = form.at(t);
        let tip = (pose.phi.alpha * pose.phi.beta).scaled(scale);
        let nutation_phase = form.nutation_phase(t).unwrap_or_default();
        Instant { sample: Sample::of(t, &pose, tip, None), rate: pose.rate, nutation_phase }
    })
}

/// A closed form loses some 1e-15 rad a period: beyond this nothing would be left.
const MOST_PERIODS: f64 = 1e12;

/// Of its orientation, rad: what the rounding of α and β alone leaves unknown.
const NOISE: f64 = 2.0 * f64::EPSILON;

/// Samples of what says where it is at any time without going there.
fn anywhere(
    motion: &Motion,
    times: &[f64],
    noise: f64,
    at: impl Fn(f64) -> Instant,
) -> Result<Vec<Sample>, Failure> {
    let instants: Vec<_> = times.iter().map(|&t| at(t)).collect();
    let phis = tip_angle::continued(motion, &at(0.0), &instants, noise)?;
    Ok(instants.iter().zip(phis).map(|(instant, phi)| Sample { phi, ..instant.sample }).collect())
}

/// By the fixed-point stepper.
fn ticked(scenario: &Scenario, times: &[f64], step: f64) -> Result<Vec<Sample>, Failure> {
    let motion = &scenario.motion;
    let mut progress = Progress::new(steps_needed(times, step)?, "ticks");
    let start = FixedSteps::new(motion, step).map_err(|failure| failure.of(&scenario.name))?;
    sweep(
        times,
        || start.clone(),
        |ticks, t| {
            ticks.reach(t, &mut progress);
            Ok(ticks.sample_at(t))
        },
    )
}

fn stepped<R: Real>(motion: &Motion, times: &[f64], step: f64) -> Result<Vec<Sample>, Failure> {
    let mut progress = Progress::new(steps_needed(times, step)?, "steps");
    sweep(
        times,
        || Paced::<R>::new(motion, step),
        |paced, t| {
            paced.reach(t, &mut progress);
            Ok(Sample::stepped(t, paced.stepper()))
        },
    )
}

fn records(samples: &[Sample]) -> Vec<Record> {
    let complex = |z: Complex<f64>| Cell::Numbers(vec![("re", z.re), ("im", z.im)]);
    let record = |sample: &Sample| {
        let [x, y, z] = sample.omega;
        Record(vec![
            ("t", Cell::Number(sample.t)),
            ("u", Cell::Number(sample.u)),
            ("udot", Cell::Number(sample.udot)),
            ("alpha", complex(sample.alpha)),
            ("beta", complex(sample.beta)),
            ("gamma", complex(-sample.beta.conj())),
            ("delta", complex(sample.alpha.conj())),
            ("omega", Cell::Numbers(vec![("x", x), ("y", y), ("z", z)])),
            ("tip", Cell::Numbers(vec![("x", sample.tip.re), ("y", sample.tip.im)])),
            ("phi", sample.phi.into()),
        ])
    };
    samples.iter().map(record).collect()
}

/// Of a scenario in SI.
fn unit(name: &str, support: Support) -> &'static str {
    match (name, support) {
        ("t", _) => "s",
        ("udot", _) => "1/s",
        ("omega", _) => "rad/s",
        ("phi", _) => "rad",
        ("tip", Support::Sliding) => "m",
        _ => "",
    }
}

/// A block a sample: with all digits, one line would not fit any screen.
fn table(samples: &[Sample], support: Support) -> String {
    let block = |record: &Record| {
        let line = |(name, cell): &(&'static str, Cell)| {
            let numbers = match cell {
                Cell::Number(x) => vec![*x],
                Cell::Numbers(parts) => parts.iter().map(|(_, x)| *x).collect(),
                _ => Vec::new(),
            };
            let mut line = vec![(*name).to_owned(), unit(name, support).to_owned()];
            line.extend(numbers.into_iter().map(number));
            line.resize(5, String::new());
            line
        };
        record.0.iter().map(line).collect::<Vec<_>>()
    };
    let blocks: Vec<_> = records(samples).iter().map(|record| output::columns(block(record), 2)).collect();
    blocks.join("\n")
}
