//! `toytop events`: times of turning points, tilts, circles, tip angles and lift-off.

use crate::arguments::values::{FINITE, POSITIVE, number};
use crate::commands::warnings::warnings;
use crate::terminal::report::Report;
use crate::terminal::table::TextTable;
use clap::Args;
use serde::Serialize;
use serde_json::json;
use std::path::PathBuf;
use toytop::{Phase, Support};
use toytop_host::Failure;
use toytop_host::input::scenario::{Scenario, Units};
use toytop_host::motion::evaluator::{EventKind, EventQuery, MotionEvaluator, MotionEvent};
use toytop_host::motion::sample::MotionSample;
use toytop_host::motion::times::require_within;
use toytop_host::output::{self, Format, error_text, or_dash, significant};

/// Times of turning points, tilts, circles, tip angles and lift-off
#[derive(Args)]
#[command(after_help = "Events:\n  \
        turning            u is least or greatest\n  \
        tilt=DEGREES       angle between the axis and the upward vertical; :up where the axis rises\n  \
        tip-angle=DEGREES  tip angle, apart from whole turns\n  \
        circle=RADIUS      distance of the tip from the centre; for a held tip the sine of the tilt\n  \
        lift-off           the normal force is 0; :up where a real top leaves the plane\n\
        The search ends after 10000 skipped events.\n\n\
        Example: toytop events host/scenarios/figure_3_loops.toml --kind turning,tilt=40:up,tip-angle=90 --count 20\n         \
        toytop events host/scenarios/toy_top.toml --kind tilt=22 --from 1e6 --format json")]
pub struct EventsArgs {
    /// Scenario file
    scenario: PathBuf,
    /// Events listed below, separated by commas; :up or :down after one selects the times at which u (or the tip angle) rises or falls
    #[arg(long = "kind", value_name = "KIND,...", value_delimiter = ',', default_value = "turning", allow_hyphen_values = true, value_parser = kind)]
    kinds: Vec<KindArgument>,
    /// Time of the earliest event to list, s
    #[arg(long, value_name = "T", default_value_t = 0.0, allow_hyphen_values = true, value_parser = number(FINITE))]
    from: f64,
    /// Greatest number of events
    #[arg(long, value_name = "N", default_value_t = 10, value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    count: u32,
    /// Form of the output
    #[arg(long, default_value = "table")]
    format: Format,
}

/// Value of --kind.
#[derive(Clone, PartialEq)]
pub struct KindArgument {
    kind: EventKind,
    /// Whether only upward (`true`) or only downward (`false`) events count; `None` for both.
    upward: Option<bool>,
    /// Text of the command line that names it.
    text: String,
}

fn kind(text: &str) -> Result<KindArgument, String> {
    const ALLOWED: &str = "must be turning, tilt=DEGREES, tip-angle=DEGREES, circle=RADIUS or lift-off, with or without :up or :down";
    let (rest, upward) = match text.rsplit_once(':') {
        Some((rest, "up")) => (rest, Some(true)),
        Some((rest, "down")) => (rest, Some(false)),
        Some(_) => return Err(ALLOWED.to_owned()),
        None => (text, None),
    };
    let parse = |range, unit, value| number(range)(value).map_err(|reason| format!("{rest}: {reason}{unit}"));
    let kind = match rest.split_once('=') {
        None if rest == "turning" => EventKind::Turning,
        None if rest == "lift-off" => EventKind::LiftOff,
        Some(("tilt", value)) => EventKind::Tilt(parse(0.0..=180.0, " degrees", value)?.to_radians()),
        Some(("tip-angle", value)) => {
            EventKind::TipAngle(Phase::from_turns(parse(-1e6..=1e6, " degrees", value)? / 360.0))
        }
        Some(("circle", value)) => EventKind::Circle(parse(POSITIVE, "", value)?),
        _ => return Err(ALLOWED.to_owned()),
    };
    Ok(KindArgument { kind, upward, text: text.to_owned() })
}

pub fn run(arguments: &EventsArgs) -> Result<Report, Failure> {
    let scenario = Scenario::read(&arguments.scenario)?;
    let (motion, from, count) = (&scenario.motion, arguments.from, arguments.count as usize);
    let evaluator = MotionEvaluator::of_scenario(&scenario)?;
    require_within([from], evaluator.furthest_time(), " s").map_err(|failure| failure.at("--from"))?;
    let mut events = Vec::new();
    for argument in &arguments.kinds {
        let KindArgument { kind, upward, text } = argument;
        if *kind == EventKind::LiftOff && motion.top().support() != Support::Sliding {
            let reason = "--kind: lift-off: none, because the tip does not slide on a plane";
            return Err(Failure::method(reason));
        }
        // only a circle depends on the top
        let refused = |_| {
            let below = significant(motion.top().tip_scale(), 6);
            Failure::input(format!("--kind: {text}: must be above 0 and below {below}"))
        };
        let query = EventQuery { kind: *kind, from, upward: *upward, count };
        let matching = evaluator.events(&query).map_err(refused)?;
        events.extend(matching.into_iter().map(|event| (argument, event)));
    }
    events.sort_by(|(_, a), (_, b)| a.sample.t.total_cmp(&b.sample.t));
    events.truncate(count);
    let rows: Vec<_> = events.iter().map(|(argument, event)| EventRow::new(argument, event)).collect();
    let table = || match &rows[..] {
        [] => "no such event\n".to_owned(),
        _ => table_of(&rows, scenario.units),
    };
    let text = match (arguments.format, &rows[..]) {
        (Format::Csv, []) => output::csv_header(&EventRow::default()),
        (format, rows) => output::render(format, &json!({ "events": rows }), rows, table),
    };
    // no warning that the top leaves the plane if the command asks for these times
    let asked = arguments.kinds.iter().any(|argument| argument.kind == EventKind::LiftOff);
    let notes = if asked { Vec::new() } else { warnings(&[scenario]) };
    Ok(Report::from(text).with_notes(notes))
}

/// Event. The names are the keys of JSON.
#[derive(Default, Serialize)]
struct EventRow<'a> {
    /// Time, s.
    t: f64,
    /// Text of the command line that asks for it.
    kind: &'a str,
    /// Turning point, or direction in which the quantity passes its value.
    sense: &'static str,
    /// Height of the axis, the cosine of the tilt.
    u: f64,
    /// Angle of the axis from the upward vertical, degrees.
    tilt_deg: f64,
    /// Position of the tip, m.
    tip: [f64; 2],
    /// Tip angle, degrees; `None` where the axis is vertical for ever.
    phi_deg: Option<f64>,
    /// Upper bound on the error of `t`, s.
    time_error: Option<f64>,
}

impl<'a> EventRow<'a> {
    fn new(argument: &'a KindArgument, event: &MotionEvent) -> Self {
        let MotionSample { t, orientation, u, tip, tip_angle, .. } = event.sample;
        let sense = match (argument.kind, event.upward) {
            (EventKind::Turning, true) => "upper",
            (EventKind::Turning, false) => "lower",
            (_, true) => "up",
            (_, false) => "down",
        };
        let tilt = 2.0 * orientation.beta.modulus().atan2(orientation.alpha.modulus());
        Self {
            t,
            kind: &argument.text,
            sense,
            u,
            tilt_deg: tilt.to_degrees(),
            tip: [tip.re, tip.im],
            phi_deg: tip_angle.map(f64::to_degrees),
            time_error: event.time_error,
        }
    }
}

fn table_of(rows: &[EventRow<'_>], units: Units) -> String {
    let [t, error] = match units {
        Units::Si => ["t, s", "error of t at most, s"],
        Units::Unnamed => ["t", "error of t at most"],
    };
    let line = |row: &EventRow<'_>| {
        [
            row.kind.to_owned(),
            row.sense.to_owned(),
            significant(row.t, 17),
            significant(row.tilt_deg, 8),
            or_dash(row.phi_deg, |degrees| significant(degrees, 8)),
            or_dash(row.time_error, error_text),
        ]
    };
    let header = ["event", "sense", t, "tilt, degrees", "tip angle, degrees", error];
    TextTable::new(2, header, rows.iter().map(line)).aligned()
}
