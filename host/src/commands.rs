//! Commands of `toytop`, one file for each. A command returns its whole output, and nothing is printed before it is complete.

pub mod accuracy;
mod animate;
mod bake;
mod bench;
mod benchmark;
mod budget;
pub mod compare;
mod constants;
mod errata;
mod events;
mod figures;
mod fit;
mod plot;
mod score;
mod simulate;
mod state;
mod sweep;
mod view;

use crate::Failure;
use crate::cli::{self, Command};
use crate::input::scenario::Scenario;
use crate::motion::physical_limits;
use toytop::Motion;

/// Report of a command.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Report {
    /// Text for stdout.
    pub text: String,
    /// Lines for stderr.
    pub notes: Vec<String>,
    /// Whether a stated bound was missed.
    pub missed: bool,
}

impl Report {
    /// Report with remarks on the result: in the text below a table, but on stderr if another program will read the text.
    #[must_use]
    pub fn with_remarks(mut self, remarks: impl IntoIterator<Item = String>, below: bool) -> Self {
        for remark in remarks {
            if below {
                self.text.push_str(&format!("{remark}\n"));
            } else {
                self.notes.push(remark);
            }
        }
        self
    }
}

/// Report of a command.
///
/// # Errors
/// See [`Failure`].
pub(crate) fn run(command: &Command) -> Result<Report, Failure> {
    match command {
        Command::Compare(arguments) => compare::run(arguments),
        Command::State(arguments) => state::run(arguments),
        Command::Constants(arguments) => constants::run(arguments),
        Command::Events(arguments) => events::run(arguments),
        Command::Plot(arguments) => plot::run(arguments),
        Command::Animate(arguments) => animate::run(arguments),
        Command::View(arguments) => view::run(arguments),
        Command::Bake(arguments) => bake::run(arguments),
        Command::Figures(arguments) => figures::run(arguments),
        Command::Score(arguments) => score::run(arguments),
        Command::Benchmark(arguments) => benchmark::run(arguments),
        Command::Simulate(arguments) => simulate::run(arguments),
        Command::Fit(arguments) => fit::run(arguments),
        Command::Bench(arguments) => bench::run(arguments),
        Command::Budget(arguments) => budget::run(arguments),
        Command::Errata(arguments) => errata::run(arguments),
        Command::Accuracy(arguments) => accuracy::run(arguments),
        Command::Sweep(arguments) => sweep::run(arguments),
        Command::Completions(arguments) => {
            let script = String::from_utf8_lossy(&cli::completions(arguments.shell)).into_owned();
            Ok(Report { text: script, ..Report::default() })
        }
    }
}

/// Warnings that a real top on a plane would move differently, one line for each reason, with the names of the motions.
fn unreal(scenarios: &[Scenario]) -> Vec<String> {
    let line = |what: &str, number: fn(&Motion) -> Option<f64>, digits: usize| {
        let of = |scenario: &Scenario| {
            number(&scenario.motion).map(|number| format!("{} ({})", scenario.name, rounded(number, digits)))
        };
        let named: Vec<_> = scenarios.iter().filter_map(of).collect();
        (!named.is_empty()).then(|| format!("warning: a real top would {what}: {}", named.join(", ")))
    };
    let pulled = line("leave the plane (least normal force / weight)", physical_limits::pulled, 3);
    let fallen = line("fall on its side (greatest tilt, degrees)", physical_limits::fallen, 1);
    let upright: Vec<_> = scenarios
        .iter()
        .filter(|scenario| physical_limits::unstable(&scenario.motion))
        .map(|scenario| scenario.name.as_str())
        .collect();
    let unstable = (!upright.is_empty()).then(|| {
        let names = upright.join(", ");
        format!("warning: by the equations the axis stays upright, but the motion is unstable (a real top would fall): {names}")
    });
    [pulled, fallen, unstable].into_iter().flatten().collect()
}

/// Number with this many digits after the point, or in scientific notation where these are all 0.
fn rounded(number: f64, digits: usize) -> String {
    let text = format!("{number:.digits$}");
    if text.bytes().any(|byte| (b'1'..=b'9').contains(&byte)) { text } else { format!("{number:.1e}") }
}
