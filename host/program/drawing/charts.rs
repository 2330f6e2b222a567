//! Tilt and precession against time, and the effective potential of the nutation.

use super::chart::{Chart, Curve};
use kuva::render::render::Scene;
use std::f64::consts::PI;
use toytop::{Motion, Regime};
use toytop_host::Failure;
use toytop_host::input::scenario::{Scenario, Units};
use toytop_host::motion::euler_angles::tilt_azimuth_roll;
use toytop_host::motion::tilts;
use toytop_host::output::significant;
use toytop_host::pictures::curve::{LimitKind, TiltLimit};
use toytop_host::pictures::span::MotionSpan;

/// Subtraction of a number, for a label; empty for 0.
fn minus(x: f64, unit: &str) -> String {
    if x == 0.0 { String::new() } else { format!(" {} {}{unit}", if x > 0.0 { '-' } else { '+' }, x.abs()) }
}

/// Label of the axis of time, which counts from the first time, because the labels of later times would need many digits.
fn time_label(scenario: &Scenario, from: f64) -> String {
    let unit = scenario.units.name(", s");
    if from == 0.0 { format!("t{unit}") } else { format!("t{}", minus(from, scenario.units.name(" s"))) }
}

/// Chart over linear axes.
fn chart(title: &str, labels: [&str; 2], curves: &[Curve]) -> Scene {
    Chart { title, labels, logarithmic: false }.draw(curves)
}

/// Tilt between its limits, against time.
pub fn tilt(scenario: &Scenario, span: &MotionSpan) -> Scene {
    let [from, until] = span.ends;
    let degrees = |t: f64| {
        let orientation = span.at(t).pose.orientation;
        [t - from, tilt_azimuth_roll(&orientation)[0].to_degrees()]
    };
    let mut curves = vec![Curve::line("tilt", span.times_of_curve().map(degrees).collect())];
    curves.extend(TiltLimit::all(&scenario.motion).into_iter().map(|limit| {
        let tilt = limit.u.acos().to_degrees();
        let name = match limit.kind {
            LimitKind::GreatestTilt => "greatest",
            LimitKind::LeastTilt => "least",
            LimitKind::Constant | LimitKind::Horizontal => "constant",
        };
        Curve::line(format!("{name}: {tilt:.2}°"), vec![[0.0, tilt], [until - from, tilt]])
    }));
    let title = format!("{}: tilt of the axis from the vertical", scenario.name);
    chart(&title, [&time_label(scenario, from), "tilt, degrees"], &curves)
}

/// Angle in degrees, rounded to nine decimals: the azimuth of an axis that stays in a plane is constant except for rounding. The added 0
/// turns -0 into 0.
fn without_rounding(degrees: f64) -> f64 {
    (degrees * 1e9).round() / 1e9 + 0.0
}

/// Azimuth of the axis, continued over whole turns, and its mean motion, against time.
///
/// # Errors
/// [`Failure::Method`]: the axis is vertical at all times.
pub fn precession(scenario: &Scenario, span: &MotionSpan) -> Result<Scene, Failure> {
    // the axis leans in the direction opposite to the tip, so that its azimuth differs from the tip angle by half a turn
    let start = span.at(0.0).tip_angle.ok_or_else(|| {
        Failure::Method(format!(
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
    if let Some(advance) = scenario.motion.period_advance() {
        let rate = without_rounding(advance.phi_radians.to_degrees()) / advance.period;
        let first = azimuth(from);
        let mean = vec![[0.0, first], [until - from, first + rate * (until - from)]];
        let unit = if scenario.units.name("s").is_empty() { "" } else { " degrees/s" };
        curves.push(Curve::line(format!("its mean: {}{unit}", significant(rate, 4)), mean));
    }
    let title = format!("{}: precession", scenario.name);
    let label = format!("azimuth of the axis{}, degrees", minus(turns, " turns"));
    Ok(chart(&title, [&time_label(scenario, from), &label], &curves))
}

/// Least distance from the vertical at which the potential is drawn, degrees. It may be infinite at the vertical.
const NEAREST: f64 = 0.05;

/// Effective potential minus the energy, against the tilt: the axis moves where it is negative.
///
/// V = (l - n u)²/(2A (1 - u²)) + C ⟨ω, r⟩²/2 + p g u, with u the cosine of the tilt.
pub fn potential(scenario: &Scenario) -> Scene {
    const POINTS: u32 = 2000;
    let (motion, h) = (&scenario.motion, scenario.motion.first_integrals().h);
    let ends = tilts(motion);
    let [least, greatest] = match motion.regime() {
        Regime::Hanging => [120.0, 180.0],
        regime if regime.is_vertical() => [0.0, 60.0],
        _ => ends,
    };
    let room = (0.45 * (greatest - least)).max(1.5);
    let [from, until] = [(least - room).max(NEAREST), (greatest + room).min(180.0 - NEAREST)];
    let all = (0..=POINTS).map(|i| from + (until - from) * f64::from(i) / f64::from(POINTS));
    // the differences are small compared with h
    let (unit, scale) = if scenario.units == Units::Si { (", mJ", 1e3) } else { ("", 1.0) };
    let above =
        |degrees: f64| [degrees, scale * (effective_potential(motion, degrees.to_radians().cos()) - h)];
    let limits = ends.map(|tilt| above(tilt.clamp(from, until))).into();
    let curves = [
        Curve::line("effective potential", all.map(above).collect()),
        Curve::line("energy", vec![[from, 0.0], [until, 0.0]]),
        Curve::dots("least, greatest tilt", limits),
    ];
    let title = format!("{}: effective potential of the nutation", scenario.name);
    let label = format!("effective potential minus the energy h{unit}");
    chart(&title, ["tilt, degrees", &label], &curves)
}

/// Effective potential at a cosine of the tilt between -1 and 1, without cancellation near -1 and 1.
fn effective_potential(motion: &Motion, u: f64) -> f64 {
    let (top, constants) = (motion.top(), motion.first_integrals());
    let [plus, minus] = [constants.l + constants.n, constants.l - constants.n];
    let swing =
        plus * plus * (1.0 - u) / (1.0 + u) + minus * minus * (1.0 + u) / (1.0 - u) + 2.0 * plus * minus;
    swing / (8.0 * top.transverse_inertia())
        + 0.5 * top.axial_inertia() * constants.spin * constants.spin
        + top.mass_moment() * top.gravity() * u
}

#[cfg(test)]
mod tests {
    use super::*;
    use toytop_host::input::builtin;

    /// At the turning points the effective potential equals the energy; between them it is smaller.
    #[test]
    fn the_potential_is_the_energy_at_the_turning_points() {
        for scenario in builtin::figures() {
            let (e, h) = (scenario.motion.branch_points(), scenario.motion.first_integrals().h);
            for u in [e.e1, e.e2] {
                let potential = effective_potential(&scenario.motion, u);
                assert!((potential - h).abs() < 1e-13 * h.abs().max(1.0), "{potential} {h}");
            }
            assert!(effective_potential(&scenario.motion, 0.5 * (e.e1 + e.e2)) < h - 1e-4);
            assert!(effective_potential(&scenario.motion, e.e1 - 0.05) > h);
        }
    }
}
