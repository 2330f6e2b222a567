//! `toytop fit`: the launch of a top from samples.

use super::Report;
use crate::Failure;
use crate::cli::{FitArgs, Format};
use crate::fit::free;
use crate::fit::launch::{fitted, reason};
use crate::fit::report::FitReport;
use crate::fit::sensors::{Body, Sensors};
use crate::fit::table;
use crate::input::scenario::Scenario;
use crate::output::{self, Cell, Record, whole_file};
use crate::pictures::fit as pictures;
use crate::pictures::plot::Form;
use toml::{Table, Value};
use toytop::Top;
use toytop::fit::{Fit, Sensor};

pub(super) fn run(arguments: &FitArgs) -> Result<Report, Failure> {
    let plots =
        [("--plot-residuals", &arguments.plot_residuals), ("--plot-prediction", &arguments.plot_prediction)];
    for (option, path) in plots {
        path.as_deref().map(|path| Form::of(path, option)).transpose()?;
    }
    let file = arguments.top.display().to_string();
    let keys = Scenario::keys(&arguments.top)?;
    let top = Scenario::top(&arguments.top)?;
    let body = body(&keys, &top);
    let mut sensors = match &arguments.sensors {
        Some(path) => Sensors::read(path, body)?,
        None => Sensors::telephone(body),
    };
    let measurements = table::read(&arguments.samples, &mut sensors, arguments.sensors.is_some())?;
    let own = Table::new();
    let table = keys.get("top").and_then(Value::as_table).unwrap_or(&own);
    let ratios = free::ratios(table, &top, &arguments.free)
        .map_err(|reason| Failure::Input(format!("--free: {reason} ({file})")))?;

    let samples = arguments.samples.display();
    let refuse = |error: toytop::fit::FitError| Failure::Input(format!("{samples}: {error}"));
    let listed: Vec<&dyn Sensor> =
        sensors.instruments.iter().map(|instrument| &*instrument.sensor as &dyn Sensor).collect();
    let mut fit = Fit::new(&top, &listed, &ratios).map_err(refuse)?.with_huber(arguments.huber);
    if let Some(deviation) = arguments.drift {
        fit = fit
            .with_drift(deviation)
            .map_err(|_| Failure::Input("--drift: --free must name at most one key with it".to_owned()))?;
    }
    let fitted = fitted(&mut fit, &measurements).map_err(refuse)?;
    let end = measurements.last().map_or(0.0, |last| last.time);
    let report = FitReport {
        fitted: &fitted,
        reason: reason(&fitted, &sensors, &measurements, &format!("--top {file}")),
        top: &top,
        table,
        free: &arguments.free,
        sensors: &sensors,
        end,
    };
    let mut notes = Vec::new();
    match (&arguments.output, fitted.converged()) {
        (Some(path), true) => {
            let units = keys.get("units").and_then(Value::as_str);
            let (text, _) = report.scenario(units)?;
            whole_file::write("--output", path, text.as_bytes())?;
        }
        (Some(path), false) => {
            notes.push(format!("{}: not written, because the fit has not converged", path.display()));
        }
        (None, _) => {}
    }
    for (option, path) in plots {
        let Some(path) = path else { continue };
        if !report.has_launch() {
            notes.push(format!("{}: not written, because there is no launch", path.display()));
            continue;
        }
        let Ok(motion) = fitted.motion(&top) else {
            notes.push(format!("{}: not written, because no top has the fitted numbers", path.display()));
            continue;
        };
        let picture = match option {
            "--plot-residuals" => pictures::residuals(&report, &measurements),
            _ => pictures::prediction(&report, &motion),
        };
        whole_file::write(option, path, &picture.encoded(Form::of(path, option)?)?)?;
    }
    let text = match arguments.format {
        Format::Table => report.table(),
        Format::Json => format!("{}\n", report.json()),
        Format::Csv => output::csv(&[record(&report)]).map_err(Failure::Output)?,
    };
    Ok(Report { text, notes, missed: !fitted.converged() })
}

/// Launch in one row.
fn record(report: &FitReport<'_>) -> Record {
    let fitted = report.fitted;
    let deviations = fitted.deviations();
    let [w, x, y, z] = fitted.launch.orientation.quaternion();
    let [a, b, c] = fitted.launch.omega;
    let reason = report.reason.clone().map_or(Cell::Absent, Cell::Text);
    let mut cells = vec![("reason", reason)];
    for (name, value) in [
        ("epoch", fitted.epoch),
        ("w", w),
        ("x", x),
        ("y", y),
        ("z", z),
        ("omega_x", a),
        ("omega_y", b),
        ("omega_z", c),
        ("theta_x_deviation", deviations[0]),
        ("theta_y_deviation", deviations[1]),
        ("theta_z_deviation", deviations[2]),
        ("omega_x_deviation", deviations[3]),
        ("omega_y_deviation", deviations[4]),
        ("omega_z_deviation", deviations[5]),
        ("reduced_chi_squared", fitted.statistics.reduced_chi_squared(fitted.count)),
    ] {
        cells.push((name, Cell::Number(value)));
    }
    Record(cells)
}

/// Lengths of the body that sensors need, from the keys of a scenario file.
pub(super) fn body(keys: &Table, top: &Top) -> Body {
    let height = keys
        .get("top")
        .and_then(|top| top.get("com_height"))
        .and_then(|value| value.as_float().or(value.as_integer().map(|x| x as f64)));
    Body::of(top, height)
}
