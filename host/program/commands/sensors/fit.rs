//! `toytop fit`: the launch of a top from samples.

mod report;
mod residuals;

use crate::arguments::options::{PICTURE, ending_in, not_stdout};
use crate::arguments::values::{POSITIVE, number};
use crate::drawing;
use crate::files::whole_file;
use crate::terminal::report::Report;
use clap::Args;
use std::path::{Path, PathBuf};
use std::slice;
use toytop_host::input::scenario::ScenarioFile;
use toytop_host::output::{self, Format};
use toytop_host::sensors::columns;
use toytop_host::sensors::fit::{FREE_KEYS, FitInput, fit_launch};
use toytop_host::sensors::models::{Sensors, centre_of_mass};
use toytop_host::sensors::summary::FitSummary;
use toytop_host::{Failure, excerpt};

/// Launch of a top from samples of sensors, with error bars
///
/// If the fit has not converged, the exit code is 1, the reason is printed, and no scenario is written.
#[derive(Args)]
#[command(
    after_help = "SAMPLES has a column t (s) and those of its sensors; an empty field is no reading:\n  \
        gyro_x,gyro_y,gyro_z     rad/s, body frame\n  \
        accel_x,accel_y,accel_z  m/s^2\n  \
        mag_x,mag_y,mag_z        magnetometer\n  \
        w,x,y,z                  unit quaternion from body to fixed coordinates\n  \
        axis_x,axis_y,axis_z     unit vector along the axis\n  \
        tip_x,tip_y              position of the tip, m\n  \
      mark                     azimuth through which a mark on the body passes, rad\n\
        CSV has one row with all values of JSON; x, y and z of a drift are those of l, n and h.\n\n\
        Example: toytop fit samples.csv --top host/scenarios/toy_top.toml --free axial_inertia -o fitted.toml"
)]
pub struct FitArgs {
    /// Samples, as `toytop simulate` writes them
    samples: PathBuf,
    /// Scenario file with the top; its motion is not read
    #[arg(long, value_name = "TOP.toml")]
    top: PathBuf,
    /// Sensors; by default those of a telephone whose columns the samples have
    #[arg(long, value_name = "SENSORS.toml")]
    sensors: Option<PathBuf>,
    /// Keys of the top that are fitted too
    #[arg(long, value_parser = FREE_KEYS, value_name = "KEY,...", value_delimiter = ',')]
    free: Vec<String>,
    /// Residual, in standard deviations, from which a sample is an outlier; inf for least squares
    #[arg(long, value_name = "X", default_value_t = 3.0, value_parser = number(1.0..=f64::INFINITY))]
    huber: f64,
    /// Fits a slow loss of rotation too, expected to be X (relative, 1/s; 0.017 loses the spin in a minute), and reports the drifts
    #[arg(long, value_name = "X", value_parser = number(POSITIVE))]
    drift: Option<f64>,
    /// Form of the output
    #[arg(long, default_value = "table")]
    format: Format,
    /// Picture of the residuals against time, whose name ends in .svg or .png
    #[arg(long, value_name = "FILE", value_parser = ending_in(PICTURE))]
    plot_residuals: Option<PathBuf>,
    /// Scenario file to write
    #[arg(short, long, value_name = "FITTED.toml", value_parser = not_stdout)]
    output: Option<PathBuf>,
}

pub fn run(arguments: &FitArgs) -> Result<Report, Failure> {
    let FitArgs { samples, top, sensors, free, huber, drift, output, .. } = arguments;
    let inputs = [Some(&**samples), Some(&**top), sensors.as_deref()];
    whole_file::require_other("--output", output.as_deref(), &inputs)?;
    let others = [inputs.as_slice(), &[output.as_deref()]].concat();
    whole_file::require_other("--plot-residuals", arguments.plot_residuals.as_deref(), &others)?;
    let scenario = ScenarioFile::read(top)?;
    let (top, parameters) = scenario.top()?;
    let all = sensors.is_some();
    let mut sensors = Sensors::read(sensors.as_deref(), centre_of_mass(&top, parameters.com_height))?;
    let (measurements, unused) = columns::read(samples, &mut sensors, all)?;
    let table = scenario.table.get("top").and_then(toml::Value::as_table).cloned().unwrap_or_default();
    let input = FitInput { top, table, free: free.clone(), sensors, huber: *huber, drift: *drift };
    let samples = samples.display().to_string();
    let fit = fit_launch(input, &measurements).map_err(|mut failure| {
        if failure.name() == "free" {
            failure.reason += &format!(" ({})", scenario.file);
        }
        let options = [("free", "--free"), ("huber", "--huber"), ("drift", "--drift")];
        failure.renamed(options.into_iter().chain([("samples", &*samples)]))
    })?;
    let converged = fit.fitted.is_trusted();
    let mut notes = Vec::new();
    if !unused.is_empty() {
        let names: Vec<_> = unused.iter().map(|name| excerpt(name)).collect();
        notes.push(format!("{samples}: columns that no sensor reads: {}", names.join(", ")));
    }
    let not_written = |path: &Path, reason| format!("{}: not written, because {reason}", path.display());
    let mut files: Vec<(&str, &Path, Vec<u8>)> = Vec::new();
    match output {
        Some(path) if converged => {
            let units = scenario.table.get("units").and_then(toml::Value::as_str);
            files.push(("--output", path, fit.scenario(units)?.into_bytes()));
        }
        Some(path) => notes.push(not_written(path, "the fit has not converged")),
        None => {}
    }
    if let Some(path) = &arguments.plot_residuals {
        if fit.used_any_sample() {
            let picture = drawing::encoded(path, &residuals::draw(&fit, &measurements), None);
            files.push(("--plot-residuals", path, picture.map_err(Failure::output)?));
        } else {
            notes.push(not_written(path, "there is no launch"));
        }
    }
    whole_file::write_all(&files)?;
    let summary = FitSummary::new(&fit);
    let table = || report::table(&fit, &summary);
    let text = output::render(arguments.format, &summary, slice::from_ref(&summary), table);
    Ok(Report { text, notes, check_failed: !converged })
}
