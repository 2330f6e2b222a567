//! `toytop plot`: curve of the tip between its bounding circles, and other pictures of a motion.

use super::options::{PICTURE, ending_in, span};
use super::{Report, warnings};
use crate::Failure;
use crate::input::scenario::Scenario;
use crate::output::names::tip_class;
use crate::output::short;
use crate::pictures::charts::motion;
use crate::pictures::drawing;
use crate::pictures::space;
use crate::pictures::span::{Span, require_at_most};
use crate::pictures::tip;
use clap::{Args, ValueEnum};
use kuva::render::render::Scene;
use std::path::PathBuf;
use toytop::{Sign, Support};

/// `toytop plot`
#[derive(Args)]
pub struct PlotArgs {
    /// Scenario file
    scenario: PathBuf,
    /// Kind of picture
    #[arg(long, default_value = "tip")]
    kind: PlotKind,
    /// Times to draw, s, at most 1000 nutation periods for the tip and the axis, 300 for tilt and precession, and none for the
    /// potential; without it, from 0 over about one turn of the tip around the centre
    #[arg(long, value_name = "LOW..HIGH", value_parser = span, allow_hyphen_values = true)]
    times: Option<[f64; 2]>,
    /// Width of the picture, pixels
    #[arg(long, value_name = "PIXELS", value_parser = clap::value_parser!(u32).range(100..=10_000))]
    size: Option<u32>,
    /// Output file, whose name ends in .svg or .png
    #[arg(short, long, value_name = "FILE", value_parser = ending_in(PICTURE))]
    output: PathBuf,
}

/// Kind of picture that `plot` draws.
#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub enum PlotKind {
    /// Curve of the tip between its two bounding circles, from above; for a held tip, the curve of the axis
    Tip,
    /// Curve of the axis on the unit sphere
    Axis,
    /// Tilt of the axis against time
    Tilt,
    /// Azimuth of the axis against time
    Precession,
    /// Effective potential of the nutation against the tilt
    Potential,
}

pub fn run(arguments: &PlotArgs) -> Result<Report, Failure> {
    let scenario = Scenario::read(&arguments.scenario)?;
    let scene = scene(arguments, &scenario).map_err(|failure| failure.of_motion(&scenario.name))?;
    drawing::write("--output", &arguments.output, &scene, arguments.size)?;
    Ok(Report::default().with_remarks(warnings(&[scenario]), false))
}

fn scene(arguments: &PlotArgs, scenario: &Scenario) -> Result<Scene, Failure> {
    let times = arguments.times;
    if arguments.kind == PlotKind::Potential {
        if times.is_some() {
            return Err(Failure::Input("--times: not for --kind potential".to_owned()));
        }
        return Ok(motion::potential(scenario));
    }
    if let Some(times) = times {
        // more would fill the frame
        let (most, kind) = match arguments.kind {
            PlotKind::Tilt => (300, " for --kind tilt"),
            PlotKind::Precession => (300, " for --kind precession"),
            _ => (1000, ""),
        };
        require_at_most(most, scenario, times, kind)?;
    }
    let span = Span::new(&scenario.motion, times)?;
    let caption = || caption(arguments.kind, scenario, &span);
    Ok(match arguments.kind {
        PlotKind::Tilt => motion::tilt(scenario, &span),
        PlotKind::Precession => motion::precession(scenario, &span)?,
        PlotKind::Axis => space::draw(scenario, &span, &caption()),
        _ => tip::draw(scenario, &span, &caption()),
    })
}

/// Class of the curve and numbers of the scenario, in two lines.
pub fn caption(kind: PlotKind, scenario: &Scenario, span: &Span) -> [String; 2] {
    let motion = &scenario.motion;
    let (top, e, signs) = (motion.top(), motion.branch_points(), motion.signs());
    let class = tip_class(motion.tip_class()).replace('_', " ");
    let periods = span.periods.map(|periods| format!(", {periods} periods")).unwrap_or_default();
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
