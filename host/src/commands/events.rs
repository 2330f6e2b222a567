//! `toytop events`: times of turning points, tilts, circles, tip angles and lift-off.

use super::constants::tilts;
use super::{Report, unreal};
use crate::Failure;
use crate::cli::{EventsArgs, Format, Kind, Scalar, What};
use crate::input::scenario::{Scenario, Units};
use crate::motion::ephemeris::{AnyScalar, FoundEvent, Sought, furthest_time, smallest, ticks_per_time};
use crate::output::{self, Cell, Record, number};
use toytop::{Level, Motion, ParameterError, Phase, Support};

pub(super) fn run(arguments: &EventsArgs) -> Result<Report, Failure> {
    let scenario = Scenario::read(&arguments.scenario)?;
    let motion = &scenario.motion;
    let reach = furthest_time(motion);
    if arguments.from.abs() > reach {
        return Err(Failure::Input(format!("--from: {:e} must be within ±{reach:.1e} s", arguments.from)));
    }
    let mut searches = Vec::new();
    for kind in &arguments.kinds {
        searches.extend(
            sought(kind, motion).map_err(|failure| failure.of("--kind"))?.into_iter().map(|s| (kind, s)),
        );
    }
    let table = smallest(Scalar::F64, motion).map_err(|failure| failure.of(&scenario.name))?;
    let mut events = Vec::new();
    for (kind, sought) in searches {
        let wanted =
            |t: f64, upward: bool| t >= arguments.from && kind.upward.is_none_or(|only| only == upward);
        let from = (arguments.from * ticks_per_time(motion)).floor() as i64;
        let found = table.events(sought, from, &wanted, arguments.count as usize);
        events.extend(found.into_iter().map(|event| (kind, sought, event)));
    }
    events.sort_by(|(_, _, a), (_, _, b)| a.t.total_cmp(&b.t));
    events.truncate(arguments.count as usize);
    let records: Vec<_> =
        events.iter().map(|(kind, sought, event)| record(kind, sought, event, motion, &*table)).collect();
    let text = match arguments.format {
        Format::Table if records.is_empty() => none(&arguments.kinds, motion),
        Format::Table => rows(&records, scenario.units),
        Format::Csv => output::csv(&records).map_err(Failure::Output)?,
        Format::Json => output::json_list("events", &records).map_err(Failure::Output)?,
    };
    // no warning that the top leaves the plane if the command asks for these times
    let asked = arguments.kinds.iter().any(|kind| kind.what == What::LiftOff);
    let remarks = if asked { Vec::new() } else { unreal(&[scenario]) };
    Ok(Report { text, ..Report::default() }.with_remarks(remarks, arguments.format == Format::Table))
}

/// Searches for the events of a kind: two where two levels of u belong to a circle, none where a top does not leave the plane.
fn sought(kind: &Kind, motion: &Motion) -> Result<Vec<Sought>, Failure> {
    let refused = |error: ParameterError| Failure::Input(format!("{}: {error}", kind.text));
    let top = motion.top();
    Ok(match kind.what {
        What::Turning => vec![Sought::Turning],
        What::Tilt(degrees) => vec![Sought::Crossing(Level::of_tilt(degrees.to_radians()).map_err(refused)?)],
        What::TipAngle(degrees) => vec![Sought::TipAngle(Phase::new(degrees / 360.0))],
        What::Circle(radius) => {
            let levels = Level::of_circle(top, radius).map_err(|_| {
                let allowed = format!("must be above 0 and below {}", output::short(top.tip_scale(), 6));
                Failure::Input(format!("{}: {allowed}", kind.text))
            })?;
            levels.map(Sought::Crossing).to_vec()
        }
        What::LiftOff if top.support() != Support::Sliding => {
            return Err(Failure::Method(
                "lift-off: none, because the tip does not slide on a plane".to_owned(),
            ));
        }
        What::LiftOff => Level::of_lift_off(motion).map(Sought::Crossing).into_iter().collect(),
    })
}

fn record(
    kind: &Kind,
    sought: &Sought,
    event: &FoundEvent,
    motion: &Motion,
    table: &dyn AnyScalar,
) -> Record {
    let sample = &event.there.sample;
    let product = sample.alpha * sample.beta;
    let radius = 2.0 * product.modulus();
    // error of u or of the tip angle, divided by its rate
    let bound = table.error_bound().after(event.t * ticks_per_time(motion)) + f64::EPSILON;
    let error = match sought {
        Sought::Turning => None,
        Sought::Crossing(_) => Some(bound / sample.udot.abs()),
        Sought::TipAngle(_) => {
            let rate = event.there.rate.alpha * sample.beta + sample.alpha * event.there.rate.beta;
            let turning = (product.re * rate.im - product.im * rate.re) / product.norm_squared();
            Some(bound / (radius * turning.abs()))
        }
    };
    let sense = match (sought, event.upward) {
        (Sought::Turning, true) => "upper",
        (Sought::Turning, false) => "lower",
        (_, true) => "up",
        (_, false) => "down",
    };
    let tilt = 2.0 * sample.beta.modulus().atan2(sample.alpha.modulus());
    Record(vec![
        ("t", Cell::Number(event.t)),
        ("kind", Cell::Text(kind.text.clone())),
        ("sense", Cell::Text(sense.to_owned())),
        ("u", Cell::Number(sample.u)),
        ("tilt_deg", Cell::Number(tilt.to_degrees())),
        ("tip", Cell::Numbers(vec![("x", sample.tip.re), ("y", sample.tip.im)])),
        ("phi_deg", sample.phi.map(f64::to_degrees).into()),
        ("time_error", error.filter(|error| error.is_finite()).into()),
    ])
}

/// Text in place of a table without events, with the range of the tilt if no tilt that was sought is in it.
fn none(kinds: &[Kind], motion: &Motion) -> String {
    let [least, greatest] = tilts(motion);
    let outside = |kind: &Kind| matches!(kind.what, What::Tilt(tilt) if tilt < least || tilt > greatest);
    if !kinds.iter().all(outside) {
        return "no such event\n".to_owned();
    }
    let [least, greatest] = [least, greatest].map(|tilt| output::short(tilt, 5));
    if least == greatest {
        return format!("no such event: the tilt stays at {least} degrees\n");
    }
    format!("no such event: the tilt stays between {least} and {greatest} degrees\n")
}

fn rows(records: &[Record], units: Units) -> String {
    let text = |cell: &Cell| match cell {
        Cell::Text(word) => word.clone(),
        Cell::Number(x) => number(*x),
        _ => "-".to_owned(),
    };
    let header = ["event", "sense", "t", "tilt, degrees", "tip angle, degrees", "error of t at most"];
    let mut lines = vec![header.map(str::to_owned).to_vec()];
    if units == Units::Si {
        lines[0][2] = "t, s".to_owned();
        lines[0][5] = "error of t at most, s".to_owned();
    }
    for Record(cells) in records {
        let of = |key: &str| {
            cells.iter().find(|(name, _)| *name == key).map_or("-".to_owned(), |(_, cell)| text(cell))
        };
        let rounded = |key: &str| match cells.iter().find(|(name, _)| *name == key) {
            Some((_, Cell::Number(x))) => output::short(*x, 8),
            _ => "-".to_owned(),
        };
        let error = match cells.iter().find(|(name, _)| *name == "time_error") {
            Some((_, Cell::Number(x))) => format!("{x:.1e}"),
            _ => "-".to_owned(),
        };
        lines.push(vec![of("kind"), of("sense"), of("t"), rounded("tilt_deg"), rounded("phi_deg"), error]);
    }
    output::columns(lines, 2)
}
