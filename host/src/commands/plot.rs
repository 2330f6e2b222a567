//! `toytop plot`: curve of the tip between its bounding circles, and other pictures of a motion.

use super::{Report, unreal};
use crate::Failure;
use crate::cli::{PlotArgs, PlotKind};
use crate::input::scenario::Scenario;
use crate::output::names::tip_class;
use crate::output::short;
use crate::output::whole_file;
use crate::pictures::plot::{Curve, Form, draw, encode_at};
use crate::pictures::span::{Span, require_at_most};
use crate::pictures::{charts, sphere};
use kuva::render::render::Scene;
use toytop::{Sign, Support};

pub(super) fn run(arguments: &PlotArgs) -> Result<Report, Failure> {
    let path = &arguments.output;
    let form = Form::of(path, "--output")?;
    let scenario = Scenario::read(&arguments.scenario)?;
    let scene = scene(arguments, &scenario).map_err(|failure| match failure {
        Failure::Method(_) => failure.of(&scenario.name),
        other => other,
    })?;
    whole_file::write("--output", path, &encode_at(&scene, form, arguments.size)?)?;
    Ok(Report::default().with_remarks(unreal(&[scenario]), false))
}

fn scene(arguments: &PlotArgs, scenario: &Scenario) -> Result<Scene, Failure> {
    let (motion, times) = (&scenario.motion, arguments.times);
    if arguments.kind == PlotKind::Potential {
        if times.is_some() {
            return Err(Failure::Input("--times: not for --kind potential".to_owned()));
        }
        return Ok(charts::potential(scenario));
    }
    if let Some(times) = times {
        let (most, kind) = arguments.kind.most_cycles();
        require_at_most(most, scenario, times, kind)?;
    }
    let span = Span::new(motion, times)?;
    Ok(match arguments.kind {
        PlotKind::Tilt => charts::tilt(scenario, &span),
        PlotKind::Precession => charts::precession(scenario, &span)?,
        _ => {
            let curve = Curve::between(motion, times)?;
            let caption = caption(arguments.kind, scenario, &curve);
            match arguments.kind {
                PlotKind::Axis => sphere::draw(scenario, &span, &caption),
                _ => draw(scenario, &curve, &caption),
            }
        }
    })
}

/// Class of the curve and numbers of the scenario, in two lines.
fn caption(kind: PlotKind, scenario: &Scenario, curve: &Curve) -> [String; 2] {
    let motion = &scenario.motion;
    let (top, e, signs) = (motion.top(), motion.branch_points(), motion.signs());
    let class = tip_class(motion.tip_class()).replace('_', " ");
    let periods = curve.periods.map(|periods| format!(", {periods} periods")).unwrap_or_default();
    let shown = |e: f64| if e.is_finite() { short(e, 4) } else { "∞".to_owned() };
    let [e1, e2, e3] = [e.e1, e.e2, e.e3].map(shown);
    // (l + n)² and (l - n)² are proportional to these
    let vanishes = [e.one_plus_e1 * (1.0 + e.e2), (1.0 - e.e1) * e.one_minus_e2 * e.e3_minus_one];
    let sign = |sign: Sign, vanishes: f64| match sign {
        _ if vanishes == 0.0 => '=',
        Sign::Plus => '>',
        Sign::Minus => '<',
    };
    let (plus, minus) = (sign(signs.l_plus_n, vanishes[0]), sign(signs.l_minus_n, vanishes[1]));
    let ratio = format!("C/A = {}", short(top.axial_inertia() / top.transverse_inertia(), 4));
    let roots = format!("{class}{periods}: e₁ = {e1}, e₂ = {e2}, e₃ = {e3}");
    let signs = format!("l + n {plus} 0, l - n {minus} 0");
    let support = match top.support() {
        Support::Sliding => {
            let slenderness = top.transverse_inertia() / (top.mass_moment() * top.com_height());
            return [roots, format!("{signs}, A/(ps) = {}, {ratio}", short(slenderness, 4))];
        }
        Support::Free => "free body",
        Support::Fixed => "tip held",
    };
    let curve = match kind {
        PlotKind::Axis => "",
        _ => ": seen from above, the end of a unit vector along the axis",
    };
    [format!("{roots}, {ratio}"), format!("{signs}, {support}{curve}")]
}
