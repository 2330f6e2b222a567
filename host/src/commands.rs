//! Commands of `toytop`, one file for each, in folders by their purpose. All input is checked before the first byte;
//! `state` and `sweep` then stream rows.

pub mod options;

/// Commands on one motion: its states, constants, events and tables.
pub mod motion {
    pub mod bake;
    pub mod constants;
    pub mod events;
    pub mod state;

    use super::{Report, options, warnings};
}

/// Commands on samples of sensors and on the output of integrators.
pub mod data {
    pub mod benchmark;
    pub mod fit;
    pub mod score;
    pub mod simulate;

    use super::{Report, options};
}

/// Commands that draw a motion.
pub mod pictures {
    pub mod animate;
    pub mod figures;
    pub mod plot;
    pub mod view;

    use super::{Report, options, warnings};
}

/// Commands on many motions: errors of the core and of the paper, costs on chips, computing times, sweeps.
pub mod studies {
    pub mod accuracy;
    pub mod bench;
    pub mod budget;
    pub mod compare;
    pub mod errata;
    pub mod sweep;

    use super::{Report, options, warnings};
}

use crate::input::scenario::Scenario;
use crate::motion::tilts;
use crate::output::stdout::Report;
use toytop::{Motion, Regime, Support};

/// Warnings that a real top on a plane would move differently, one line for each reason, with the names of the motions.
fn warnings(scenarios: &[Scenario]) -> Vec<String> {
    let line = |what: &str, of: &dyn Fn(&Motion) -> Option<String>| {
        let named = |scenario: &Scenario| of(&scenario.motion).map(|number| scenario.name.clone() + &number);
        let names: Vec<_> = scenarios.iter().filter_map(named).collect();
        (!names.is_empty()).then(|| format!("warning: {what}: {}", names.join(", ")))
    };
    let pulled = line("a real top would leave the plane (least normal force / weight)", &|motion| {
        let force = motion.min_normal_force().filter(|force| *force < 0.0)?;
        Some(format!(" ({})", rounded(force, 3)))
    });
    // an unstable sleeping top does not leave the vertical, although its e₁ may be below 0
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
