//! `toytop plot`: the curve of the tip between its bounding circles.

use super::{Report, lift_off};
use crate::Failure;
use crate::cli::PlotArgs;
use crate::names::tip_class;
use crate::plot::{Curve, Form, draw};
use crate::scenario::Scenario;
use crate::whole_file;
use std::path::Path;
use toytop::{Sign, Support};

/// The endings of a file, and what is written.
const FORMS: [(&str, Form); 2] = [("svg", Form::Svg), ("png", Form::Png)];

pub(super) fn run(arguments: &PlotArgs) -> Result<Report, Failure> {
    let path = &arguments.output;
    let form = form(path)?;
    let scenario = Scenario::read(&arguments.scenario)?;
    let curve = Curve::of(&scenario.motion).map_err(|failure| failure.of(&scenario.name))?;
    let picture = draw(&scenario, &curve, &caption(&scenario, &curve), form)?;
    whole_file::write("--output", path, &picture)?;
    Ok(Report::default().with_remarks(lift_off(&[scenario]), false))
}

fn form(path: &Path) -> Result<Form, Failure> {
    let ending = path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
    FORMS.iter().find(|(name, _)| *name == ending).map(|(_, form)| *form).ok_or_else(|| {
        let allowed = FORMS.map(|(name, _)| format!(".{name}")).join(" or ");
        Failure::Input(format!("--output: {}: must end in {allowed}", path.display()))
    })
}

/// The class of the curve and the numbers of the scenario, in two lines.
fn caption(scenario: &Scenario, curve: &Curve) -> [String; 2] {
    let motion = &scenario.motion;
    let (top, e, signs) = (motion.top(), motion.branch_points(), motion.signs());
    let class = tip_class(motion.tip_class()).replace('_', " ");
    let periods = curve.periods.map(|periods| format!(", {periods} periods")).unwrap_or_default();
    let [e1, e2, e3] = [e.e1, e.e2, e.e3].map(short);
    let sign = |sign: Sign| if sign == Sign::Plus { '>' } else { '<' };
    let (plus, minus) = (sign(signs.l_plus_n), sign(signs.l_minus_n));
    let inertias = match top.support() {
        Support::Sliding => format!("A/(ps) = {}, C/A = ", short(top.a() / (top.p() * top.s()))),
        Support::Fixed => "tip held, C/A = ".to_owned(),
    } + &short(top.c() / top.a());
    [
        format!("{class}{periods}: e₁ = {e1}, e₂ = {e2}, e₃ = {e3}"),
        format!("l + n {plus} 0, l - n {minus} 0, {inertias}"),
    ]
}

/// Four digits and no more than it needs.
fn short(x: f64) -> String {
    let rounded: f64 = format!("{x:.3e}").parse().unwrap_or(x);
    if (1e-4..1e5).contains(&rounded.abs()) || rounded == 0.0 {
        rounded.to_string()
    } else {
        format!("{rounded:e}")
    }
}
