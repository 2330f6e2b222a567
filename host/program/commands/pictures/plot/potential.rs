//! Effective potential of the nutation.

use crate::drawing::chart::{Chart, Curve};
use kuva::render::render::Scene;
use toytop::{Motion, Regime};
use toytop_host::input::scenario::{Scenario, Units};
use toytop_model::constants::tilts;

/// Least distance from the vertical at which the potential is drawn, degrees. It may be infinite at the vertical.
const NEAREST: f64 = 0.05;

/// Effective potential minus the energy, against the tilt: the axis moves where it is negative.
///
/// V = (l - n u)²/(2A (1 - u²)) + C ⟨ω, r⟩²/2 + p g u, with u the cosine of the tilt.
pub fn draw(scenario: &Scenario) -> Scene {
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
    Chart::draw_linear(
        &title,
        ["tilt, degrees", &format!("effective potential minus the energy h{unit}")],
        &curves,
    )
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
