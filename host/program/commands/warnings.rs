//! Warnings about motions that a real top does not follow.

use toytop::{Motion, Regime, Support};
use toytop_host::input::scenario::Scenario;
use toytop_model::constants::tilts;

/// Warnings of lift-off, fall and instability of a real top: a line for each reason, with the names of the motions.
pub fn warnings(scenarios: &[Scenario]) -> Vec<String> {
    let line = |what: &str, of: &dyn Fn(&Motion) -> Option<String>| {
        let named = |scenario: &Scenario| of(&scenario.motion).map(|number| scenario.name.clone() + &number);
        let names: Vec<_> = scenarios.iter().filter_map(named).collect();
        (!names.is_empty()).then(|| format!("warning: {what}: {}", names.join(", ")))
    };
    let pulled = line("a real top would leave the plane (least normal force / weight)", &|motion| {
        let force = motion.min_normal_force().filter(|force| *force < 0.0)?;
        Some(format!(" ({})", rounded(force, 3)))
    });
    // e₁ < 0 does not mean that a sleeping top falls: it stays at u = 1
    let fallen = line("a real top would fall on its side (greatest tilt, degrees)", &|motion| {
        let [_, tilt] = tilts(motion);
        let fallen = motion.top().support() == Support::Sliding && tilt > 90.0;
        fallen.then(|| format!(" ({})", rounded(tilt, 1)))
    });
    let unstable = line(
        "by the equations the axis stays upright, but the motion is unstable (a real top would fall)",
        &|motion| (motion.regime() == Regime::SleepingUnstable).then(String::new),
    );
    [pulled, fallen, unstable].into_iter().flatten().collect()
}

/// Number with this many digits after the point, or in scientific notation where these are all 0.
fn rounded(number: f64, digits: usize) -> String {
    let text = format!("{number:.digits$}");
    if text.bytes().any(|byte| (b'1'..=b'9').contains(&byte)) { text } else { format!("{number:.1e}") }
}
