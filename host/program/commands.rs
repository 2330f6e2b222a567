//! Commands of `toytop` in the groups of `toytop --help`, and what several of them share. A command checks its input before it writes.

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
/// Simulated sensors, and launches fitted to the samples of sensors.
mod sensors {
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

use crate::terminal::report::Report;
use checks::*;
use clap::{ArgMatches, Args, Command};
use clap_complete::Shell;
use integrators::*;
use motions::*;
use pictures::*;
use sensors::*;
use std::collections::HashMap;
use toytop_host::Failure;

/// Command of `toytop` with the function that runs it from its arguments.
type RunnableCommand = (Command, Box<dyn Fn(&ArgMatches) -> Result<Report, Failure>>);

/// Command of this name, whose arguments are those of its function.
fn command<A: Args + 'static>(name: &'static str, run: fn(&A) -> Result<Report, Failure>) -> RunnableCommand {
    let arguments = |matches: &ArgMatches| A::from_arg_matches(matches).expect("the command's arguments");
    (A::augment_args(Command::new(name)), Box::new(move |matches| run(&arguments(matches))))
}

/// Commands in the groups of `toytop --help`. The last group is that of the checks.
fn groups() -> [(&'static str, Vec<RunnableCommand>); 6] {
    [
        (
            "Motions",
            vec![
                command("state", state::run),
                command("constants", constants::run),
                command("events", events::run),
                command("compare", compare::run),
                command("sweep", sweep::run),
                command("bake", bake::run),
            ],
        ),
        (
            "Pictures",
            vec![command("plot", plot::run), command("animate", animate::run), command("view", view::run)],
        ),
        ("Sensors", vec![command("simulate", simulate::run), command("fit", fit::run)]),
        ("Integrators", vec![command("score", score::run), command("benchmark", benchmark::run)]),
        ("Shell", vec![command("completions", completions)]),
        (
            "Checks of toytop itself",
            vec![
                command("accuracy", accuracy::run),
                command("budget", budget::run),
                command("errata", errata::run),
                command("figures", figures::run),
                command("study", study::run),
                command("timings", timings::run),
            ],
        ),
    ]
}

/// Command line of the program, and the function that runs one of its commands from the arguments.
pub fn toytop() -> (Command, impl FnOnce(&ArgMatches) -> Result<Report, Failure>) {
    let mut runs = HashMap::new();
    let mut help =
        "{about}\n{usage-heading} {usage}; each command has --help, and toytop has --version\n\n".to_owned();
    let mut toytop = Command::new("toytop")
        .version(env!("CARGO_PKG_VERSION"))
        .about("Exact motion of a spinning top whose tip slides on a plane or is held, or of a free body")
        .subcommand_required(true)
        .arg_required_else_help(true);
    let [groups @ .., (heading, checks)] = groups();
    for (group, commands) in groups {
        help += &format!("{group}:\n");
        for (command, run) in commands {
            let (name, about) = (command.get_name().to_owned(), command.get_about().cloned());
            help += &format!("  {name:<12}{}\n", about.unwrap_or_default());
            toytop = toytop.subcommand(command);
            runs.insert(name, run);
        }
    }
    help += &format!("{heading}:");
    for (command, run) in checks {
        help += &format!(" {}", command.get_name());
        runs.insert(command.get_name().to_owned(), run);
        toytop = toytop.subcommand(command.hide(true));
    }
    let run = move |matches: &ArgMatches| {
        let (name, arguments) = matches.subcommand().expect("a command is required");
        runs[name](arguments)
    };
    (toytop.help_template(help + "\n"), run)
}

/// Completions for a shell
#[derive(Args)]
#[command(
    after_help = "Example: toytop completions bash > ~/.local/share/bash-completion/completions/toytop"
)]
struct CompletionsArgs {
    /// Shell that the completions are for
    shell: Shell,
}

fn completions(arguments: &CompletionsArgs) -> Result<Report, Failure> {
    let mut script = Vec::new();
    let (mut command, _) = toytop();
    clap_complete::generate(arguments.shell, &mut command, "toytop", &mut script);
    Ok(String::from_utf8_lossy(&script).into_owned().into())
}
