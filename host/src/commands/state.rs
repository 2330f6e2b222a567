//! `toytop state`: orientation, rates and tip at given times.

use super::{Report, unreal};
use crate::Failure;
use crate::cli::{Format, Method, Scalar, StateArgs};
use crate::full_equations::solution;
use crate::input::scenario::Scenario;
use crate::input::times;
use crate::motion::ephemeris::{furthest_time, smallest};
use crate::motion::propagate::{Sample, TimedStepper, period, steps_needed, visit_times};
use crate::motion::tip_angle::TipAngle;
use crate::output::progress::Progress;
use crate::output::{self, Cell, Record, number};
use toytop::exact::ClosedForm;
use toytop::scalar::Real;
use toytop::{Complex, Micromath, Motion, Support};

pub(super) fn run(arguments: &StateArgs) -> Result<Report, Failure> {
    let scenario = Scenario::read(&arguments.scenario)?;
    let times = times::read(&arguments.times)?;
    let step = period(&scenario.motion) / f64::from(arguments.steps_per_period);
    let samples = match (arguments.method, arguments.scalar) {
        (Method::Ephemeris, scalar) => tabulated(scalar, &scenario, &times)?,
        (Method::Stepper, Scalar::F64) => stepped::<f64>(&scenario.motion, &times, step)?,
        (Method::Stepper, Scalar::F32) => stepped::<f32>(&scenario.motion, &times, step)?,
        (Method::Stepper, Scalar::Micromath) => stepped::<Micromath>(&scenario.motion, &times, step)?,
        (Method::Stepper, Scalar::Q31 | Scalar::Q15) => return Err(no_stepper(arguments.scalar)),
        (Method::Full, Scalar::F64) => solution::samples(&scenario, &times)?,
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
        Method::Stepper => "f64, f32 or micromath",
        Method::Full | Method::ClosedForm => "f64",
    }
}

/// The refusal of a stepper in fixed point, where only the ephemeris exists.
fn no_stepper(scalar: Scalar) -> Failure {
    let name = scalar.name();
    Failure::Method(format!("--method stepper: none in {name}: use --method ephemeris, which has {name}"))
}

fn tabulated(scalar: Scalar, scenario: &Scenario, times: &[f64]) -> Result<Vec<Sample>, Failure> {
    let motion = &scenario.motion;
    let furthest = furthest_time(motion);
    if let Some(t) = times.iter().find(|t| t.abs() > furthest) {
        let allowed = format!("within ±{furthest:.1e} s with --method ephemeris");
        return Err(Failure::Input(format!("times: {t:e} must be {allowed}")));
    }
    let ephemeris = smallest(scalar, motion).map_err(|failure| failure.of(&scenario.name))?;
    Ok(times.iter().map(|&t| ephemeris.at(t).sample).collect())
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
    let angle = TipAngle::of(motion)?;
    let sample = |&t: &f64| {
        let state = form.at(t);
        let product = state.orientation.alpha * state.orientation.beta;
        Sample::of(t, &state, product.scaled(scale), angle.continued(t, product, NOISE))
    };
    Ok(times.iter().map(sample).collect())
}

/// The form for e₃ = e₄ loses up to 5e-14 rad a period where that is true only to a rounding: beyond this nothing would be left.
const MOST_PERIODS: f64 = 1e12;

/// |αβ| of a tip whose angle the rounding of α and β blurs by more than 1e-5 rad.
const NOISE: f64 = 1e-11;

fn stepped<R: Real>(motion: &Motion, times: &[f64], step: f64) -> Result<Vec<Sample>, Failure> {
    let mut progress = Progress::new(steps_needed(times, step)?, "steps");
    visit_times(
        times,
        || TimedStepper::<R>::new(motion, step),
        |stepper, t| {
            stepper.reach(t, &mut progress);
            Ok(Sample::stepped(t, stepper.stepper()))
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
    let held = match support {
        Support::Sliding => "",
        Support::Fixed => "\ntip: 2 alpha beta, minus the horizontal part of the axis (the tip is held)\n",
    };
    blocks.join("\n") + held
}
