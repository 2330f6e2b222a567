//! Tilt and precession against time.

use crate::drawing::chart::{Chart, Curve};
use kuva::render::render::Scene;
use std::f64::consts::PI;
use toytop_host::Failure;
use toytop_host::input::scenario::Scenario;
use toytop_host::motion::euler_angles::tilt_azimuth_roll;
use toytop_host::output::significant;
use toytop_host::pictures::MotionSpan;
use toytop_host::pictures::curve::TiltLimit;
use toytop_model::constants::Unit::Si;

/// Subtraction of a number, for a label; empty for 0.
fn minus(x: f64, unit: &str) -> String {
    if x == 0.0 { String::new() } else { format!(" {} {}{unit}", if x > 0.0 { '-' } else { '+' }, x.abs()) }
}

/// Label of the axis of time, which counts from the first time, because the labels of later times would need many digits.
fn time_label(scenario: &Scenario, from: f64) -> String {
    let unit = scenario.units.name(Si(", s"));
    if from == 0.0 { format!("t{unit}") } else { format!("t{}", minus(from, scenario.units.name(Si(" s")))) }
}

/// Tilt between its limits, against time.
pub fn tilt(scenario: &Scenario, span: &MotionSpan) -> Scene {
    let [from, until] = span.ends;
    let degrees = |t: f64| {
        let orientation = span.at(t).orientation;
        [t - from, tilt_azimuth_roll(&orientation)[0].to_degrees()]
    };
    let mut curves = vec![Curve::line("tilt", span.times_of_curve().map(degrees).collect())];
    curves.extend(TiltLimit::all(&scenario.motion).into_iter().map(|limit| {
        let tilt = limit.u.acos().to_degrees();
        Curve::line(limit.to_string(), vec![[0.0, tilt], [until - from, tilt]])
    }));
    let title = format!("{}: tilt of the axis from the vertical", scenario.name);
    Chart::draw_linear(&title, [&time_label(scenario, from), "tilt, degrees"], &curves)
}

/// Angle in degrees, rounded to nine decimals: the azimuth of an axis that stays in a plane is constant except for rounding. The added 0
/// turns -0 into 0.
fn without_rounding(degrees: f64) -> f64 {
    (degrees * 1e9).round() / 1e9 + 0.0
}

/// Azimuth of the axis, continued over whole turns, and its mean motion, against time.
///
/// # Errors
/// [`Failure::method`]: the axis is vertical at all times.
pub fn precession(scenario: &Scenario, span: &MotionSpan) -> Result<Scene, Failure> {
    // the axis leans in the direction opposite to the tip, so that its azimuth differs from the tip angle by half a turn
    let start = span.at(0.0).tip_angle.ok_or_else(|| {
        Failure::method(format!(
            "{}: the axis is vertical at all times, so that it has no azimuth",
            scenario.name
        ))
    })?;
    let turn = if start > 0.0 { -PI } else { PI };
    let [from, until] = span.ends;
    let continued = |t: f64| (span.at(t).tip_angle.unwrap_or(f64::NAN) + turn).to_degrees();
    // the labels of the axis count from whole turns, like the labels of the time
    let turns = (continued(from) / 360.0).trunc();
    let azimuth = |t: f64| without_rounding(continued(t) - 360.0 * turns);
    let degrees = |t: f64| [t - from, azimuth(t)];
    let mut curves = vec![Curve::line("azimuth of the axis", span.times_of_curve().map(degrees).collect())];
    if let Some(advance) = scenario.motion.advance() {
        let rate = without_rounding(advance.phi_radians.to_degrees()) / advance.period;
        let first = azimuth(from);
        let mean = vec![[0.0, first], [until - from, first + rate * (until - from)]];
        let unit = scenario.units.name(Si(" degrees/s"));
        curves.push(Curve::line(format!("its mean: {}{unit}", significant(rate, 4)), mean));
    }
    let title = format!("{}: precession", scenario.name);
    Ok(Chart::draw_linear(
        &title,
        [&time_label(scenario, from), &format!("azimuth of the axis{}, degrees", minus(turns, " turns"))],
        &curves,
    ))
}
