//! One file a command. A command returns its whole output; nothing is printed before all of it is there.

mod accuracy;
mod bake;
mod bench;
mod budget;
mod compare;
mod constants;
mod errata;
mod figures;
mod longrun;
mod overflow;
mod plot;
mod report;
mod sines;
mod state;
mod study;
mod sweep;
mod view;

use crate::Failure;
use crate::cli::{self, Command};
use crate::reality;
use crate::scenario::Scenario;
use toytop::Motion;

/// What a command has to say.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Report {
    /// For stdout.
    pub text: String,
    /// Lines for stderr.
    pub notes: Vec<String>,
    /// A stated bound was missed.
    pub missed: bool,
}

impl Report {
    /// Adds remarks on the result: below a table, but beside what another program will read.
    fn with_remarks(mut self, remarks: impl IntoIterator<Item = String>, below: bool) -> Self {
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

/// Runs a command.
///
/// # Errors
/// See [`Failure`].
pub fn run(command: &Command) -> Result<Report, Failure> {
    match command {
        Command::Compare(arguments) => compare::run(arguments),
        Command::State(arguments) => state::run(arguments),
        Command::Constants(arguments) => constants::run(arguments),
        Command::Plot(arguments) => plot::run(arguments),
        Command::View(arguments) => view::run(arguments),
        Command::Bake(arguments) => bake::run(arguments),
        Command::Figures(arguments) => figures::run(arguments),
        Command::Bench(arguments) => bench::run(arguments),
        Command::Report(arguments) => report::run(arguments),
        Command::Budget(arguments) => budget::run(arguments),
        Command::Errata(arguments) => errata::run(arguments),
        Command::Accuracy(arguments) => accuracy::run(arguments),
        Command::Sines(arguments) => sines::run(arguments),
        Command::Overflow(arguments) => overflow::run(arguments),
        Command::Study(arguments) => study::run(arguments),
        Command::Longrun(arguments) => longrun::run(arguments),
        Command::Sweep(arguments) => sweep::run(arguments),
        Command::Completions(arguments) => {
            let script = String::from_utf8_lossy(&cli::completions(arguments.shell)).into_owned();
            Ok(Report { text: script, ..Report::default() })
        }
    }
}

/// What a real top on a plane would do otherwise: a line a kind, with the motions it is true of.
fn unreal(scenarios: &[Scenario]) -> Vec<String> {
    let line = |what: &str, number: fn(&Motion) -> Option<f64>, digits: usize| {
        let of = |scenario: &Scenario| {
            number(&scenario.motion).map(|number| format!("{} ({number:.digits$})", scenario.name))
        };
        let named: Vec<_> = scenarios.iter().filter_map(of).collect();
        (!named.is_empty()).then(|| format!("warning: a real top would {what}: {}", named.join(", ")))
    };
    let pulled = line("leave the plane (least normal force / weight)", reality::pulled, 3);
    let fallen = line("fall on its side (greatest tilt, degrees)", reality::fallen, 1);
    [pulled, fallen].into_iter().flatten().collect()
}
