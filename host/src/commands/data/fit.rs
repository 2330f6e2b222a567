//! `toytop fit`: the launch of a top from samples.

use super::Report;
use super::options::{PICTURE, ending_in, positive};
use crate::Failure;
use crate::fit::columns;
use crate::fit::launch::FREE_KEYS;
use crate::fit::launch::FitInput;
use crate::fit::report::FitReport;
use crate::fit::sensors::{Body, Sensors};
use crate::input::scenario::ScenarioFile;
use crate::output::{self, Format, Record, shown, whole_file};
use crate::pictures::drawing;
use crate::pictures::fit as pictures;
use clap::Args;
use serde_json::Value;
use std::path::PathBuf;

/// `toytop fit`
#[derive(Args)]
pub struct FitArgs {
    /// Samples, as `toytop simulate` writes them
    samples: PathBuf,
    /// Scenario file with the top; its motion is not read
    #[arg(long, value_name = "TOP.toml")]
    top: PathBuf,
    /// Sensors; without this option, those of a telephone, as far as the samples have their columns
    #[arg(long, value_name = "SENSORS.toml")]
    sensors: Option<PathBuf>,
    /// Keys of the top that are fitted too
    #[arg(long, value_parser = FREE_KEYS, value_name = "KEY,...", value_delimiter = ',')]
    free: Vec<String>,
    /// Residual, in standard deviations, from which a sample is an outlier; inf for least squares
    #[arg(long, value_name = "X", default_value_t = 3.0, value_parser = huber)]
    huber: f64,
    /// Fits a slow loss of rotation too, and reports the drift of l, n and h: standard deviation of the loss in units of the rotation
    /// itself, 1/s, such as 0.017 where the spin may be lost in a minute
    #[arg(long, value_name = "X", value_parser = positive)]
    drift: Option<f64>,
    /// Form of the output
    #[arg(long, default_value = "table")]
    format: Format,
    /// Residuals against time, as a picture: a file that ends in .svg or .png
    #[arg(long, value_name = "FILE", value_parser = ending_in(PICTURE))]
    plot_residuals: Option<PathBuf>,
    /// Error of the prediction against time, as a picture
    #[arg(long, value_name = "FILE", value_parser = ending_in(PICTURE))]
    plot_prediction: Option<PathBuf>,
    /// Scenario file to write
    #[arg(short, long, value_name = "FITTED.toml")]
    output: Option<PathBuf>,
}

fn huber(text: &str) -> Result<f64, &'static str> {
    text.parse().ok().filter(|x| *x >= 1.0).ok_or("must be a number from 1, or inf")
}

pub fn run(arguments: &FitArgs) -> Result<Report, Failure> {
    let inputs = [Some(&*arguments.samples), Some(&*arguments.top), arguments.sensors.as_deref()];
    whole_file::require_other("--output", arguments.output.as_deref(), &inputs)?;
    let plots =
        [("--plot-residuals", &arguments.plot_residuals), ("--plot-prediction", &arguments.plot_prediction)];
    let scenario = ScenarioFile::read(&arguments.top)?;
    let (top, parameters) = scenario.top()?;
    let body = Body::of(&top, parameters.com_height);
    let mut sensors = Sensors::read(arguments.sensors.as_deref(), body)?;
    let (measurements, unused) =
        columns::read(&arguments.samples, &mut sensors, arguments.sensors.is_some())?;
    let table = scenario.keys.get("top").and_then(toml::Value::as_table).cloned().unwrap_or_default();
    let FitArgs { free, huber, drift, .. } = arguments;
    let input = FitInput { top, table, free: free.clone(), sensors, huber: *huber, drift: *drift };
    let samples = arguments.samples.display();
    let report = input.fitted(&measurements).map_err(|(parameter, reason)| {
        Failure::Input(match parameter {
            "samples" => format!("{samples}: {reason}"),
            _ => format!("--{parameter}: {reason} ({})", scenario.file),
        })
    })?;
    let fitted = &report.fitted;
    let mut notes = Vec::new();
    if !unused.is_empty() {
        let names: Vec<_> = unused.iter().map(|name| shown(name)).collect();
        notes.push(format!("{samples}: columns that no sensor reads: {}", names.join(", ")));
    }
    match (&arguments.output, fitted.converged()) {
        (Some(path), true) => {
            let units = scenario.keys.get("units").and_then(toml::Value::as_str);
            let text = report.scenario(units)?;
            whole_file::write("--output", path, text.as_bytes())?;
        }
        (Some(path), false) => {
            notes.push(format!("{}: not written, because the fit has not converged", path.display()));
        }
        (None, _) => {}
    }
    for (option, path) in plots {
        let Some(path) = path else { continue };
        let motion = Some(fitted.motion(&top)).filter(|_| report.has_launch());
        let Some(Ok(motion)) = motion else {
            let reason = motion.map_or("there is no launch", |_| "no top has the fitted numbers");
            notes.push(format!("{}: not written, because {reason}", path.display()));
            continue;
        };
        let picture = match option {
            "--plot-residuals" => pictures::residuals(&report, &measurements),
            _ => pictures::prediction(&report, &motion),
        };
        drawing::write(option, path, &picture, None)?;
    }
    let text = match arguments.format {
        Format::Table => report.table(),
        Format::Json => format!("{}\n", report.json()),
        Format::Csv => output::csv(&[record(&report)])?,
    };
    Ok(Report { text, notes, missed: !fitted.converged() })
}

/// Launch in one row.
fn record(report: &FitReport) -> Record {
    let fitted = &report.fitted;
    let deviations = fitted.deviations();
    let mut cells = vec![("reason", report.reason.as_deref().into()), ("epoch", fitted.epoch.into())];
    let mut add = |names: &[&'static str], values: &[f64]| {
        cells.extend(names.iter().copied().zip(values.iter().copied().map(Value::from)));
    };
    add(&["w", "x", "y", "z"], &fitted.launch.orientation.quaternion());
    add(&["omega_x", "omega_y", "omega_z"], &fitted.launch.omega);
    add(&["theta_x_deviation", "theta_y_deviation", "theta_z_deviation"], &deviations[..3]);
    add(&["omega_x_deviation", "omega_y_deviation", "omega_z_deviation"], &deviations[3..]);
    add(&["reduced_chi_squared"], &[fitted.statistics.reduced_chi_squared(fitted.count)]);
    Record(cells)
}
