//! Page for a browser that needs no other file: the core as WebAssembly, and scripts that draw the motions that it
//! computes.
//!
//! A program that was compiled without the target for WebAssembly has no such core. Its pages play one motion from the table of
//! `toytop bake --lang json`, which [`EVALUATOR`] evaluates with the bits of the crate.

use crate::Failure;
use crate::bake::{Label, object};
use crate::input::builtin::{FIGURES, TOY_TOP};
use crate::input::scenario::Scenario;
use crate::motion::Scalar;
use crate::motion::ephemeris::{default_or_smallest, tick, ticks_per_time};
use crate::output::{base64, html, names};
use serde_json::{Map, Value, json};
use toml::Table;
use toytop::Motion;
use toytop_page::constants;

/// JavaScript with two functions: `readTable` reads a table from the JSON in `f32`, and `momentAt(table, tick)`
/// evaluates it.
pub const EVALUATOR: &str = include_str!("view/evaluator.js");

/// The core as WebAssembly; empty in a program that was compiled without that target.
pub const CORE: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/core.wasm"));

/// Message of a program whose pages play one motion only.
pub const NOT_LIVE: &str = "view: the page plays this motion only; for one with sliders: rustup target add \
                            wasm32-unknown-unknown, then install toytop again";

/// Scripts of every page, in the order of dependence.
const SCRIPTS: [&str; 25] = [
    include_str!("view/engine.js"),
    include_str!("view/scenario.js"),
    include_str!("view/geometry.js"),
    include_str!("view/body.js"),
    include_str!("view/gyroscope.js"),
    include_str!("view/scene.js"),
    include_str!("view/text.js"),
    include_str!("view/picture_3d.js"),
    include_str!("view/picture_sphere.js"),
    include_str!("view/picture_plan.js"),
    include_str!("view/picture_charts.js"),
    include_str!("view/picture_potential.js"),
    include_str!("view/svg.js"),
    include_str!("view/facts.js"),
    include_str!("view/presets.js"),
    include_str!("view/controls.js"),
    include_str!("view/drag.js"),
    include_str!("view/player.js"),
    include_str!("view/median_cut.js"),
    include_str!("view/gif.js"),
    include_str!("view/save.js"),
    include_str!("view/film.js"),
    include_str!("view/state.js"),
    include_str!("view/listen.js"),
    include_str!("view/main.js"),
];

/// Additional scripts of a page without the core.
const RECORDED: [&str; 2] = [EVALUATOR, include_str!("view/recorded.js")];

/// Motion that a page starts with.
#[derive(Clone, Debug)]
pub struct Start {
    /// Keys and values of its scenario.
    pub keys: Table,
    /// Scenario read from that text.
    pub scenario: Scenario,
}

impl Start {
    /// Motion of a scenario file's text; `name` is the name on the page and in messages.
    ///
    /// # Errors
    /// [`Failure::Input`]: as [`Scenario::parse`].
    pub fn parse(name: &str, text: &str) -> Result<Self, Failure> {
        let scenario = Scenario::parse(name, text)?;
        Ok(Self { keys: Scenario::keys_of(name, text)?, scenario })
    }

    /// Toy top of the sample scenarios.
    ///
    /// # Errors
    /// None: the sample is valid.
    pub fn toy_top() -> Result<Self, Failure> {
        Self::parse("A spinning top", TOY_TOP)
    }
}

fn keys_of_toy_top() -> Result<Table, Failure> {
    TOY_TOP.parse().map_err(|error| Failure::Input(format!("toy top: {error}")))
}

/// Page that starts with a motion, with the core as WebAssembly; where `core` is empty, a page that plays this motion
/// only.
///
/// # Errors
/// [`Failure::Method`]: no table fits the motion, even in `f32`.
pub fn page(start: &Start, core: &[u8]) -> Result<String, Failure> {
    let Start { keys, scenario } = start;
    let table = table(scenario)?;
    let unwritten = |error: serde_json::Error| Failure::Method(format!("view: {error}"));
    let recorded = || json!({ "table": table, "shown": shown(&scenario.motion) });
    let data = json!({
        "name": scenario.name,
        "scenario": serde_json::to_value(keys).map_err(unwritten)?,
        "constants": constants::names().collect::<Vec<_>>(),
        "figures": FIGURES.map(|(figure, signs, e3s)| json!([figure, signs.l_minus_n.factor(), e3s])),
        "toy_top": serde_json::to_value(keys_of_toy_top()?).map_err(unwritten)?,
        "recorded": if core.is_empty() { recorded() } else { Value::Null },
    });
    let before = if core.is_empty() { RECORDED.concat() } else { String::new() };
    let values = [
        ("name", html(&scenario.name)),
        ("style", concat!(include_str!("view/style.css"), include_str!("view/layout.css")).to_owned()),
        ("data", in_script(&data.to_string())),
        ("core", base64(core)),
        ("version", env!("CARGO_PKG_VERSION").to_owned()),
        ("script", before + &SCRIPTS.concat()),
    ];
    Ok(filled(include_str!("view/page.html"), &values))
}

/// Table of the motion in `f32`, which the page without the core plays. It is computed for every page, so that a motion
/// without a table is always refused.
fn table(scenario: &Scenario) -> Result<Value, Failure> {
    let motion = &scenario.motion;
    let frequency = frequency(motion);
    let clock = tick(frequency).map_err(|error| Failure::Method(error.to_string()))?;
    let unwritten = || Failure::Method("view: f32 has no table to write".into());
    let parts = default_or_smallest(Scalar::F32, motion, clock)?.parts().ok_or_else(unwritten)?;
    let label = Label { name: scenario.name.clone(), tick: format!("{frequency} Hz") };
    serde_json::from_str(&object(&label, &parts)).map_err(|error| Failure::Method(format!("view: {error}")))
}

/// Number of ticks in a unit of time, which makes the slowest motion look smooth.
fn frequency(motion: &Motion) -> f64 {
    const FINER: f64 = 256.0;
    (FINER * ticks_per_time(motion)).min(31_f64.exp2())
}

/// Constants of the motion, with the names that the core gives to the page.
fn shown(motion: &Motion) -> Value {
    let numbers = constants::CONSTANTS.iter().map(|(name, value)| ((*name).to_owned(), value(motion).into()));
    let words =
        [("regime", names::regime(motion.regime())), ("tipClass", names::tip_class(motion.tip_class()))];
    let words = words.map(|(name, word)| (name.to_owned(), Value::from(word)));
    Value::Object(numbers.chain(words).collect::<Map<_, _>>())
}

/// Text of a script element: JSON without characters that could end the element.
fn in_script(json: &str) -> String {
    json.replace('<', "\\u003c")
}

/// Template with every {{name}} replaced. Names in the replacement texts are not replaced.
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
