//! `toytop state`: orientation, rates and tip at given times.

use super::{Report, unreal};
use crate::Failure;
use crate::cli::times::{self, Instants};
use crate::cli::{DEFAULT_STEPS, Method, SampleFormat, Scalar, StateArgs};
use crate::full_equations::solution;
use crate::input::scenario::Scenario;
use crate::motion::ephemeris::{default_or_smallest, furthest_time, smallest};
use crate::motion::propagate::{Sample, period, stepped};
use crate::motion::tip_angle::TipAngle;
use crate::samples::sheet::Sheet;
use crate::samples::{npy, stream};
use crate::thread_pool;
use std::io::{self, Write};
use toytop::exact::ClosedForm;
use toytop::{Support, Tick};

/// Sample at a time, by the index of the time in the request.
type At = dyn Fn(u64) -> Sample + Sync;

pub(super) fn run(arguments: &StateArgs) -> Result<Report, Failure> {
    if arguments.format == SampleFormat::Parquet && !cfg!(feature = "parquet") {
        let reason = "this program was built without Parquet (cargo build --features parquet)";
        return Err(Failure::Input(format!("--format: parquet: {reason}")));
    }
    let scenario = Scenario::read(&arguments.scenario)?;
    let rate = arguments.tick.or(arguments.hertz.map(|hertz| [hertz, 1]));
    if rate.is_some() && arguments.times.ticks.is_none() {
        return Err(Failure::Input("--hertz, --tick: need --ticks".to_owned()));
    }
    let instants = times::read(&arguments.times, rate.unwrap_or([1000, 1]))?;
    let sheet = Sheet {
        columns: arguments.columns.clone(),
        units: scenario.units,
        support: scenario.motion.top().support(),
        named_units: arguments.units && arguments.format != SampleFormat::Parquet,
    };
    let count = instants.count();
    let at = source(arguments, &scenario, instants)?;
    // from here on the input cannot cause a failure
    stream::to(arguments.output.as_deref(), |out| write(arguments.format, &sheet, count, &*at, out))?;
    let table = arguments.format == SampleFormat::Table && arguments.output.is_none();
    Ok(Report::default().with_remarks(unreal(&[scenario]), table))
}

/// Function that computes samples by a method.
fn source(arguments: &StateArgs, scenario: &Scenario, instants: Instants) -> Result<Box<At>, Failure> {
    let motion = &scenario.motion;
    if arguments.steps_per_period.is_some() && arguments.method != Method::Stepper {
        return Err(Failure::Input("--steps-per-period: needs --method stepper".to_owned()));
    }
    let step = period(motion) / f64::from(arguments.steps_per_period.unwrap_or(DEFAULT_STEPS));
    let option = times::option(&arguments.times);
    let listed = || instants.times().map_err(|failure| failure.of(&option));
    let samples = match (arguments.method, arguments.scalar) {
        (Method::Ephemeris, scalar) => return tabulated(scalar, scenario, instants, &option),
        (Method::Stepper, scalar) => stepped(scalar, motion, &listed()?, step)?,
        (Method::Full, Scalar::F64) => solution::samples(scenario, &listed()?)?,
        (Method::ClosedForm, Scalar::F64) => return closed(scenario, instants, &option),
        (method, scalar) => {
            let (name, allowed) = (scalar.name(), scalars(method));
            let method = method.name();
            return Err(Failure::Input(format!(
                "--scalar: {name}: must be {allowed} with --method {method}"
            )));
        }
    };
    Ok(Box::new(move |index| samples[index as usize]))
}

/// Names of the scalars in which a method exists.
fn scalars(method: Method) -> &'static str {
    match method {
        Method::Ephemeris => "f64, f32, q31, q15 or micromath",
        Method::Stepper => "f64, f32 or micromath",
        Method::Full | Method::ClosedForm => "f64",
    }
}

/// Failure for times that a method cannot compute, without the name of their option.
fn within(instants: &Instants, furthest: f64, method: Method) -> Result<(), Failure> {
    let t = instants.furthest();
    if t.abs() <= furthest {
        return Ok(());
    }
    let allowed = format!("within ±{furthest:.1e} s with --method {}", method.name());
    Err(Failure::Input(format!("{t:e} must be {allowed}")))
}

fn tabulated(
    scalar: Scalar,
    scenario: &Scenario,
    instants: Instants,
    option: &str,
) -> Result<Box<At>, Failure> {
    let motion = &scenario.motion;
    let of_scenario = |failure: Failure| failure.of(&scenario.name);
    if let Instants::Ticks(ticks) = &instants {
        let [ticks_there, seconds] = ticks.rate;
        let tick =
            Tick::ratio(ticks_there, seconds).map_err(|error| Failure::Input(format!("--tick: {error}")))?;
        let table = default_or_smallest(scalar, motion, tick).map_err(of_scenario)?;
        let ticks = ticks.clone();
        return Ok(Box::new(move |i| table.sample_at_tick(ticks.number(i), instants.time(i)).sample));
    }
    within(&instants, furthest_time(motion), Method::Ephemeris).map_err(|failure| failure.of(option))?;
    let table = smallest(scalar, motion).map_err(of_scenario)?;
    Ok(Box::new(move |index| table.at(instants.time(index)).sample))
}

/// Function that computes samples by the closed form, if the motion has one.
fn closed(scenario: &Scenario, instants: Instants, option: &str) -> Result<Box<At>, Failure> {
    let motion = &scenario.motion;
    let form =
        ClosedForm::of(motion).map_err(|refusal| Failure::Method(refusal.to_string()).of(&scenario.name))?;
    let furthest = MOST_PERIODS * period(motion);
    within(&instants, furthest, Method::ClosedForm).map_err(|failure| failure.of(option))?;
    let scale = 2.0 * motion.top().tip_scale();
    let angle = TipAngle::of(motion)?;
    Ok(Box::new(move |index| {
        let t = instants.time(index);
        let state = form.at(t);
        let product = state.orientation.alpha * state.orientation.beta;
        Sample::of(t, &state, product.scaled(scale), angle.continued(t, product, NOISE))
    }))
}

/// Greatest number of periods of a closed form. If e₃ = e₄ holds only up to rounding, the form loses up to 5e-14 rad in a period, and
/// beyond this number no digit is correct.
const MOST_PERIODS: f64 = 1e12;

/// Least |αβ| at which the rounding of α and β changes the argument of αβ by less than 1e-5 rad.
const NOISE: f64 = 1e-11;

/// Writes all samples to the output.
fn write(
    format: SampleFormat,
    sheet: &Sheet,
    count: u64,
    at: &At,
    out: &mut (dyn Write + Send),
) -> io::Result<()> {
    let cores = thread_pool::of_all_cores().map_err(io::Error::other)?;
    match format {
        SampleFormat::Csv => {
            out.write_all(sheet.csv_header().as_bytes())?;
            stream::rows(&cores, count, &|row, numbers, text| sheet.csv(&at(row), numbers, text), out)
        }
        SampleFormat::Json => {
            let object = |row, numbers: &mut Vec<f64>, text: &mut Vec<u8>| {
                text.extend_from_slice(if row == 0 { b"" } else { b"," });
                sheet.json(&at(row), numbers, text);
            };
            out.write_all(b"{\"samples\":[")?;
            stream::rows(&cores, count, &object, out)?;
            out.write_all(b"]}\n")
        }
        SampleFormat::Table => {
            let block = |row, _: &mut Vec<f64>, text: &mut Vec<u8>| {
                text.extend_from_slice(if row == 0 { b"" } else { b"\n" });
                text.extend_from_slice(sheet.block(&at(row)).as_bytes());
            };
            stream::rows(&cores, count, &block, out)?;
            out.write_all(remark(sheet).as_bytes())
        }
        SampleFormat::Npy => {
            out.write_all(&npy::header(sheet, count))?;
            stream::rows(&cores, count, &|row, numbers, bytes| npy::row(sheet, &at(row), numbers, bytes), out)
        }
        #[cfg(feature = "parquet")]
        SampleFormat::Parquet => crate::samples::parquet::write(sheet, count, &at, out),
        #[cfg(not(feature = "parquet"))]
        SampleFormat::Parquet => Ok(()),
    }
}

/// Remark below a table with the tip of a top that is held.
fn remark(sheet: &Sheet) -> &'static str {
    use crate::samples::column::Column;
    match sheet.support {
        Support::Fixed if sheet.columns.contains(&Column::Tip) => {
            "\ntip: 2 alpha beta, minus the horizontal part of the axis (the tip is held)\n"
        }
        Support::Free if sheet.columns.contains(&Column::Tip) => {
            "\ntip: 2 alpha beta, minus the horizontal part of the axis (the body is free)\n"
        }
        _ => "",
    }
}
