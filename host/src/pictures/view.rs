//! A motion as one page that needs nothing else: the table of `toytop bake --lang json`, what evaluates it in the browser
//! with the bits of the crate ([`EVALUATOR`]), and pictures of what that says.

mod facts;

use crate::Failure;
use crate::bake::{Label, object};
use crate::cli::Scalar;
use crate::input::scenario::Scenario;
use crate::motion::ephemeris::{default_or_smallest, tick, ticks_per_time};
use crate::output::html;
use crate::pictures::plot::Curve;
use serde_json::{Value, json};
use std::f64::consts::PI;
use toytop::{Motion, Stepper, Support, Top};

/// JavaScript: `readTable` makes a table of the JSON in `f32`, and `momentAt(table, tick)` is what it says.
pub const EVALUATOR: &str = include_str!("view/evaluator.js");

/// What is made of it, in the order in which each needs those before.
const SCRIPTS: [&str; 5] = [
    EVALUATOR,
    include_str!("view/geometry.js"),
    include_str!("view/body.js"),
    include_str!("view/pictures.js"),
    include_str!("view/player.js"),
];

/// The page of a motion.
///
/// # Errors
/// [`Failure::Method`]: no table fits, even in `f32`.
pub fn page(scenario: &Scenario) -> Result<String, Failure> {
    let motion = &scenario.motion;
    let frequency = frequency(motion);
    let clock = tick(frequency).map_err(|error| Failure::Method(error.to_string()))?;
    let unwritten = || Failure::Method("view: f32 has no table to write".into());
    let parts = default_or_smallest(Scalar::F32, motion, clock)?.parts().ok_or_else(unwritten)?;
    let label = Label { name: scenario.name.clone(), tick: format!("{frequency} Hz") };
    let curve = Curve::of(motion)?;
    let held = motion.top().support() == Support::Fixed;
    let values = [
        ("name", html(&scenario.name)),
        ("summary", facts::summary(motion)),
        ("style", include_str!("view/style.css").to_owned()),
        ("scene_label", facts::scene_label(held).to_owned()),
        ("legend", facts::legend(&curve, held)),
        ("plan_title", facts::plan_title(held).to_owned()),
        ("plan_label", format!("{}, between its bounding circles.", facts::plan_title(held))),
        ("periods_row", facts::periods_row(motion).to_owned()),
        ("constants", facts::constants(motion, &parts, frequency)),
        ("footer", facts::footer()),
        ("scene", in_script(&scene(scenario, &curve).to_string())),
        ("table", in_script(object(&label, &parts).trim_end())),
        ("script", SCRIPTS.concat()),
    ];
    Ok(filled(include_str!("view/page.html"), &values))
}

/// Ticks in a unit of time: so many that the slowest motion is smooth.
fn frequency(motion: &Motion) -> f64 {
    const FINER: f64 = 256.0;
    (FINER * ticks_per_time(motion)).min(31_f64.exp2())
}

/// What the pictures have to know beside the table: lengths in units of s.
fn scene(scenario: &Scenario, curve: &Curve) -> Value {
    let motion = &scenario.motion;
    let (e, scale) = (motion.branch_points(), motion.top().tip_scale());
    let circle = |circle: &crate::pictures::plot::Circle| json!({ "radius": circle.radius / scale, "name": circle.name });
    let period = motion.period_advance().map(|averages| averages.period);
    json!({
        "held": motion.top().support() == Support::Fixed,
        "span": curve.time,
        "points": POINTS * curve.periods.unwrap_or(4),
        "period": period,
        "speed": speed(motion, period),
        "e": [e.e1, e.e2, e.e3],
        "breadth": breadth(motion.top(), e.e1),
        "circles": curve.circles.iter().map(circle).collect::<Value>(),
    })
}

/// Of a line, in a nutation period.
const POINTS: u32 = 160;

/// Units of time a second at first: about one turn or nutation, whichever is the faster; 1, 2 or 5 of a power of ten.
fn speed(motion: &Motion, period: Option<f64>) -> f64 {
    let [x, y, z] = Stepper::<f64>::new(motion).attitude_state().omega();
    let fastest = (x * x + y * y + z * z).sqrt().max(period.map_or(0.0, |period| 2.0 * PI / period));
    let wanted = 2.0 * PI / fastest;
    let power = wanted.log10().floor();
    let round = [1.0, 2.0, 5.0].into_iter().rfind(|digit| digit * 10_f64.powf(power) <= wanted);
    round.unwrap_or(1.0) * 10_f64.powf(power)
}

/// The greatest radius of the body that is drawn, in units of s: that of a disc with this C/A, where it stays above the
/// plane and looks like a top.
fn breadth(top: &Top, e1: f64) -> f64 {
    let ratio = top.axial_inertia() / top.transverse_inertia();
    let disc = match top.support() {
        Support::Sliding => (2.0 * top.axial_inertia() / (top.mass_moment() * top.com_height())).sqrt(),
        Support::Fixed => (4.0 * ratio / (2.0 - ratio).max(1e-3)).sqrt(),
    };
    // no point of the outline is wider, seen from the tip, than its greatest radius at the height 1
    let room = 0.93 * e1 / (1.0 - e1 * e1).max(1e-9).sqrt();
    let most = if room < 0.45 { 0.7 } else { room.min(0.82) };
    disc.clamp(0.45, most)
}

/// The text of a script element: JSON in which nothing ends it.
fn in_script(json: &str) -> String {
    json.replace('<', "\\u003c")
}

/// The template with every {{name}} replaced, once: what is put in is not looked at again.
fn filled(template: &str, values: &[(&str, String)]) -> String {
    let mut parts = template.split("{{");
    let mut page = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (name, rest) = part.split_once("}}").unwrap_or(("", part));
        let value = values.iter().find(|(known, _)| *known == name);
        debug_assert!(value.is_some(), "{{{{{name}}}}} has no value");
        page.push_str(value.map_or("", |(_, value)| value));
        page.push_str(rest);
    }
    page
}
