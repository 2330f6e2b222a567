//! Tilt and precession against time, and the effective potential of the nutation.

use super::figures::{Chart, Curve};
use super::span::Span;
use crate::Failure;
use crate::input::scenario::{Scenario, Units};
use kuva::render::render::Scene;
use std::f64::consts::PI;
use toytop::{Motion, Regime};

/// Least number of points of a curve, and least number in a cycle of the motion.
const POINTS: u64 = 2000;
const PER_CYCLE: u64 = 32;

fn label(name: &str, unit: &str) -> String {
    if unit.is_empty() { name.to_owned() } else { format!("{name}, {unit}") }
}

fn curve(name: &str, points: Vec<[f64; 2]>) -> Curve {
    Curve { name: name.to_owned(), points, marked: false }
}

/// Tilt between its bounds, against time.
#[must_use]
pub(crate) fn tilt(scenario: &Scenario, span: &Span) -> Scene {
    let degrees = |t: f64| {
        let phi = span.at(t).orientation();
        [t, crate::samples::angles::tilt_azimuth_roll(&phi)[0].to_degrees()]
    };
    let mut curves = vec![curve("tilt", span.times_in_cycles(POINTS, PER_CYCLE).map(degrees).collect())];
    curves.extend(bounds(&scenario.motion).into_iter().map(|(name, tilt)| {
        curve(&format!("{name}: {tilt:.2} degrees"), span.ends().map(|t| [t, tilt]).into())
    }));
    Chart {
        title: &format!("{}: tilt of the axis from the vertical", scenario.name),
        labels: [&label("t", scenario.units.name("s")), "tilt, degrees"],
        powers: [false; 2],
    }
    .draw(&curves)
}

/// Bounds of the tilt, degrees; none where the axis is vertical at all times.
fn bounds(motion: &Motion) -> Vec<(&'static str, f64)> {
    let e = motion.branch_points();
    let degrees = |u: f64| u.clamp(-1.0, 1.0).acos().to_degrees();
    match motion.regime() {
        regime if regime.is_vertical() => Vec::new(),
        regime if regime.is_regular_precession() => vec![("u = e₁ = e₂", degrees(e.e1))],
        _ => vec![("at u = e₁", degrees(e.e1)), ("at u = e₂", degrees(e.e2))],
    }
}

/// Angle in degrees, rounded to nine decimals, because the azimuth of an axis that stays in a plane is constant except for rounding. The
/// added 0 turns -0 into 0.
fn without_rounding(degrees: f64) -> f64 {
    (degrees * 1e9).round() / 1e9 + 0.0
}

/// Azimuth of the axis, continued over whole turns, and its mean motion, against time.
///
/// # Errors
/// [`Failure::Method`]: the axis is vertical at all times.
pub(crate) fn precession(scenario: &Scenario, span: &Span) -> Result<Scene, Failure> {
    // the axis leans in the direction opposite to the tip, so that its azimuth differs from the tip angle by half a turn
    let start = span.at(0.0).phi.ok_or_else(|| {
        Failure::Method("the axis is vertical at all times, so that it has no azimuth".to_owned())
    })?;
    let turn = if start > 0.0 { -PI } else { PI };
    let degrees = |t: f64| [t, without_rounding((span.at(t).phi.unwrap_or(f64::NAN) + turn).to_degrees())];
    let mut curves =
        vec![curve("azimuth of the axis", span.times_in_cycles(POINTS, PER_CYCLE).map(degrees).collect())];
    if let Some(advance) = scenario.motion.period_advance() {
        let rate = without_rounding(advance.phi_per_period().to_degrees()) / advance.period;
        let [from, until] = span.ends();
        let [_, first] = degrees(from);
        let mean = vec![[from, first], [until, first + rate * (until - from)]];
        let unit = if scenario.units.name("s").is_empty() { "" } else { " degrees/s" };
        curves.push(curve(&format!("its mean: {}{unit}", crate::output::short(rate, 4)), mean));
    }
    let chart = Chart {
        title: &format!("{}: precession", scenario.name),
        labels: [&label("t", scenario.units.name("s")), "azimuth of the axis, degrees"],
        powers: [false; 2],
    };
    Ok(chart.draw(&curves))
}

/// Effective potential minus the energy, against the tilt: the axis moves where it is negative.
///
/// V = (l - n u)²/(2A (1 - u²)) + C ⟨ω, r⟩²/2 + p g u, with u the cosine of the tilt.
#[must_use]
pub(crate) fn potential(scenario: &Scenario) -> Scene {
    let (motion, h) = (&scenario.motion, scenario.motion.first_integrals().h);
    let e = motion.branch_points();
    let [least, greatest] = if motion.regime().is_vertical() {
        if motion.regime() == Regime::Hanging { [120.0, 180.0] } else { [0.0, 60.0] }
    } else {
        [e.e2, e.e1].map(|u: f64| u.clamp(-1.0, 1.0).acos().to_degrees())
    };
    let room = (0.45 * (greatest - least)).max(1.5);
    let [from, until] = [(least - room).max(0.05), (greatest + room).min(179.95)];
    let tilts = (0..=POINTS).map(|i| from + (until - from) * i as f64 / POINTS as f64);
    // the differences are small compared with h
    let (unit, scale) = if scenario.units == Units::Si { ("mJ", 1e3) } else { ("", 1.0) };
    let above = |degrees: f64| scale * (effective_potential(motion, degrees.to_radians().cos()) - h);
    let mut curves = vec![
        curve("effective potential", tilts.map(|degrees| [degrees, above(degrees)]).collect()),
        curve("energy", vec![[from, 0.0], [until, 0.0]]),
    ];
    let marks: Vec<_> = bounds(motion).into_iter().rev().map(|(_, tilt)| [tilt, 0.0]).collect();
    if !marks.is_empty() {
        curves.push(Curve { name: "turning points".to_owned(), points: marks, marked: true });
    }
    Chart {
        title: &format!("{}: effective potential of the nutation", scenario.name),
        labels: ["tilt, degrees", &label("effective potential minus the energy h", unit)],
        powers: [false; 2],
    }
    .draw(&curves)
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
    use crate::input::builtin;

    /// At the turning points the effective potential equals the energy; between them it is smaller.
    #[test]
    fn the_potential_is_the_energy_at_the_turning_points() {
        for scenario in builtin::figures().unwrap().concat() {
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
