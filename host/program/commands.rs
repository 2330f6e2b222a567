//! Commands of `toytop`, one module for each, in the groups of `toytop --help`. A command checks its input before it writes.

/// Options of several commands.
mod options;
/// Warnings about motions that a real top does not follow.
mod warnings;

/// States, constants and events; errors; many motions; tables for a chip.
mod motions {
    pub mod bake;
    pub mod compare;
    pub mod constants;
    pub mod events;
    pub mod state;
    pub mod sweep;
}
/// Drawings, films and pages of a motion.
mod pictures {
    pub mod animate;
    pub mod plot;
    pub mod view;
}
/// Samples of sensors, and launches fitted to them.
mod samples {
    pub mod fit;
    pub mod simulate;
}
/// Output of other integrators, and problems to test them with.
mod integrators {
    pub mod benchmark;
    mod problem_files;
    pub mod score;
}
/// Checks of toytop itself: errors of the core and of the paper, computing times, costs on chips.
mod checks {
    pub mod accuracy;
    pub mod budget;
    pub mod errata;
    pub mod figures;
    pub mod study;
    pub mod timings;
}

use crate::terminal::stdout::Report;
use checks::*;
use clap::{CommandFactory, Parser};
use clap_complete::Shell;
use integrators::*;
use motions::*;
use pictures::*;
use samples::*;
use toytop_host::Failure;

/// Groups of commands in `toytop --help`: the folders of the modules.
const GROUPS: [(&str, &str); 5] = [
    ("Motions", "state constants events compare sweep bake"),
    ("Pictures", "plot animate view"),
    ("Samples", "simulate fit"),
    ("Integrators", "score benchmark"),
    ("Shell", "completions"),
];

/// Template of `toytop --help`.
pub fn help() -> String {
    let mut help =
        "{about}\n{usage-heading} {usage}; each command has --help, and toytop has --version\n\n".to_owned();
    let commands = Command::command();
    for (group, names) in GROUPS {
        help += &format!("{group}:\n");
        for name in names.split(' ') {
            let about = commands.find_subcommand(name).and_then(clap::Command::get_about);
            help += &format!("  {name:<12}{}\n", about.cloned().unwrap_or_default());
        }
    }
    let hidden: Vec<_> = commands
        .get_subcommands()
        .filter(|command| command.is_hide_set())
        .map(clap::Command::get_name)
        .collect();
    help + &format!("Checks of toytop itself: {}\n", hidden.join(" "))
}

/// Exact motion of a spinning top whose tip slides on a plane or is held, or of a free body.
#[derive(Parser)]
#[command(name = "toytop", version)]
pub enum Command {
    State(state::StateArgs),
    Constants(constants::ConstantsArgs),
    Events(events::EventsArgs),
    Compare(compare::CompareArgs),
    Sweep(Box<sweep::SweepArgs>),
    Bake(bake::BakeArgs),
    Plot(plot::PlotArgs),
    Animate(animate::AnimateArgs),
    View(view::ViewArgs),
    Simulate(simulate::SimulateArgs),
    Fit(fit::FitArgs),
    Score(score::ScoreArgs),
    Benchmark(benchmark::BenchmarkArgs),
    /// Completions for a shell
    #[command(
        after_help = "Example: toytop completions bash > ~/.local/share/bash-completion/completions/toytop"
    )]
    Completions {
        /// Shell that the completions are for
        shell: Shell,
    },
    #[command(hide = true)]
    Accuracy(accuracy::AccuracyArgs),
    #[command(hide = true)]
    Budget(budget::BudgetArgs),
    #[command(hide = true)]
    Errata(errata::ErrataArgs),
    #[command(hide = true)]
    Figures(figures::FiguresArgs),
    /// Random launches near degenerate cases, and fits, against the truth
    #[command(
        hide = true,
        subcommand,
        after_help = "Example: toytop study corners --motions 20000 --truths 400 --accept"
    )]
    Study(study::Study),
    #[command(hide = true, alias = "bench")]
    Timings(timings::TimingsArgs),
}

impl Command {
    /// Runs the command.
    ///
    /// # Errors
    /// See [`Failure`].
    pub fn run(&self) -> Result<Report, Failure> {
        match self {
            Self::State(arguments) => state::run(arguments),
            Self::Constants(arguments) => constants::run(arguments),
            Self::Events(arguments) => events::run(arguments),
            Self::Compare(arguments) => compare::run(arguments),
            Self::Sweep(arguments) => sweep::run(arguments),
            Self::Bake(arguments) => bake::run(arguments),
            Self::Plot(arguments) => plot::run(arguments),
            Self::Animate(arguments) => animate::run(arguments),
            Self::View(arguments) => view::run(arguments),
            Self::Simulate(arguments) => simulate::run(arguments),
            Self::Fit(arguments) => fit::run(arguments),
            Self::Score(arguments) => score::run(arguments),
            Self::Benchmark(arguments) => benchmark::run(arguments),
            Self::Completions { shell } => {
                let mut script = Vec::new();
                clap_complete::generate(*shell, &mut Self::command(), "toytop", &mut script);
                Ok(String::from_utf8_lossy(&script).into_owned().into())
            }
            Self::Accuracy(arguments) => accuracy::run(arguments),
            Self::Budget(arguments) => budget::run(arguments),
            Self::Errata(arguments) => errata::run(arguments),
            Self::Figures(arguments) => figures::run(arguments),
            Self::Study(study) => study::run(study),
            Self::Timings(arguments) => timings::run(arguments),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn help_lists_every_command() {
        let grouped = GROUPS.map(|(_, names)| names).join(" ");
        for command in Command::command().get_subcommands() {
            let name = command.get_name();
            assert_eq!(grouped.split(' ').any(|one| one == name), !command.is_hide_set(), "{name}");
        }
    }
}
