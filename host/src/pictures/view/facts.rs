//! What the page says beside the pictures.

use crate::bake::Parts;
use crate::motion::physical_limits;
use crate::output::names;
use crate::output::short;
use crate::pictures::plot::Curve;
use toytop::{Motion, Support};

/// What kind of top and motion, in a line.
pub(super) fn summary(motion: &Motion) -> String {
    let top = match motion.top().support() {
        Support::Sliding => "a top whose tip slides without friction",
        Support::Fixed => "a top whose tip is held",
    };
    let curve = if motion.top().support() == Support::Fixed { "axis" } else { "tip" };
    let real = match (physical_limits::pulled(motion), physical_limits::fallen(motion)) {
        (Some(_), Some(_)) => ". A real top would leave the plane, and fall on its side.",
        (Some(_), None) => ". A real top would leave the plane.",
        (None, Some(_)) => ". A real top would fall on its side.",
        (None, None) if physical_limits::unstable(motion) => {
            ". By its equations it stays upright for ever; a real top would fall."
        }
        (None, None) => "",
    };
    format!(
        "{top}: {}, {curve} curve: {}{real}",
        words(names::regime(motion.regime())),
        words(names::tip_class(motion.tip_class()))
    )
}

fn words(name: &str) -> String {
    name.replace('_', " ")
}

pub(super) fn scene_label(held: bool) -> &'static str {
    if held {
        "A spinning top whose tip is held, and the foot of its axis on the plane."
    } else {
        "A spinning top whose tip slides on a plane and draws its curve there."
    }
}

pub(super) fn plan_title(held: bool) -> &'static str {
    if held { "The axis from above" } else { "The tip from above" }
}

pub(super) fn legend(curve: &Curve, held: bool) -> String {
    let tip = if held {
        "foot of the axis, −2αβ: minus the tip of <code>toytop state</code>"
    } else {
        "tip on the plane"
    };
    let mut items = vec![("tip", "solid", tip.to_owned()), ("axis", "solid", "end of the axis".to_owned())];
    let dashes = ["solid", "dashed", "dotted"];
    let bounds = curve.circles.iter().zip(dashes);
    items.extend(bounds.map(|(circle, dash)| ("bound", dash, format!("bound at {}", circle.name))));
    let vertical = if held { "vertical" } else { "where the centre of mass rises and falls" };
    items.push(("faint", "dotted", vertical.to_owned()));
    let item = |(colour, dash, text): &(&str, &str, String)| {
        format!(
            "      <li><i style=\"border-color: var(--{colour}); border-top-style: {dash}\"></i>{text}</li>\n"
        )
    };
    items.iter().map(item).collect()
}

/// Only a motion with a period counts them.
pub(super) fn periods_row(motion: &Motion) -> &'static str {
    match motion.period_advance() {
        Some(_) => "        <tr><th scope=\"row\">periods</th><td id=\"periods\"></td></tr>\n",
        None => "",
    }
}

pub(super) fn footer() -> String {
    format!(
        "toytop {}. The motion is exact; the outline of the top is a drawing. Space plays and pauses, Home goes back to \
         t = 0, the arrow keys turn the picture they are on; the field for t takes any time, at the same cost.",
        env!("CARGO_PKG_VERSION")
    )
}

/// Name, value, unit.
type Fact = (&'static str, String, &'static str);

/// Tables of what does not change.
pub(super) fn constants(motion: &Motion, parts: &Parts, frequency: f64) -> String {
    let groups = [
        ("Constants of the motion", of_motion(motion)),
        ("Means", means(motion)),
        ("The top", of_top(motion)),
        ("The table that is played", of_table(parts, frequency)),
    ];
    groups.iter().map(|(title, facts)| table(title, facts)).collect()
}

fn of_motion(motion: &Motion) -> Vec<Fact> {
    let (integrals, e) = (motion.first_integrals(), motion.branch_points());
    vec![
        ("e₁, lowest u", number(e.e1), ""),
        ("e₂, highest u", number(e.e2), ""),
        ("e₃", number(e.e3), ""),
        ("e₄", motion.top().e4().map_or_else(none, number), ""),
        ("l", number(integrals.l), "kg m²/s"),
        ("n", number(integrals.n), "kg m²/s"),
        ("h", number(integrals.h), "kg m²/s²"),
    ]
}

fn means(motion: &Motion) -> Vec<Fact> {
    let averages = motion.period_advance();
    let average = |value: fn(&toytop::PeriodAdvance) -> f64| {
        averages.as_ref().map_or_else(none, |of| number(value(of)))
    };
    let turning = averages.as_ref().filter(|_| !motion.regime().is_vertical());
    vec![
        ("nutation period", average(|of| of.period), "s"),
        ("α in a period", average(|of| of.alpha_turns), "turns"),
        ("β in a period", average(|of| of.beta_turns), "turns"),
        ("tip angle in a period", turning.map_or_else(none, |of| number(of.phi_per_period())), "rad"),
        ("least normal force", motion.min_normal_force().map_or_else(none, number), "weights"),
    ]
}

fn of_top(motion: &Motion) -> Vec<Fact> {
    let top = motion.top();
    let mut facts = vec![
        ("A, transverse", number(top.transverse_inertia()), "kg m²"),
        ("C, axial", number(top.axial_inertia()), "kg m²"),
    ];
    if top.support() == Support::Sliding {
        facts.push(("s, tip to centre", number(top.com_height()), "m"));
    }
    facts.extend([
        ("p, mass moment", number(top.mass_moment()), "kg m"),
        ("g", number(top.gravity()), "m/s²"),
    ]);
    facts
}

fn of_table(parts: &Parts, frequency: f64) -> Vec<Fact> {
    let ([segments, terms], constant) = (parts.size, parts.error_bound.constant);
    vec![
        ("segments", format!("{segments} × {terms} in {}", parts.scalar.name()), ""),
        ("size", parts.table_bytes().to_string(), "bytes"),
        ("ticks", number(frequency), "a second"),
        ("error, at most", number(constant), "rad"),
    ]
}

/// Six digits, as it is written.
fn number(x: f64) -> String {
    let text = short(x, 6).replace('-', "−");
    match text.split_once('e') {
        Some((digits, power)) => format!("{digits} · 10<sup>{power}</sup>"),
        None => text,
    }
}

fn none() -> String {
    "–".to_owned()
}

fn table(title: &str, facts: &[Fact]) -> String {
    let row = |(name, value, unit): &Fact| {
        let unit = if *value == none() { "" } else { unit };
        format!("        <tr><th scope=\"row\">{name}</th><td>{value} <small>{unit}</small></td></tr>\n")
    };
    let rows: String = facts.iter().map(row).collect();
    format!("    <div>\n      <h2>{title}</h2>\n      <table>\n{rows}      </table>\n    </div>\n")
}
