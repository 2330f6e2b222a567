//! The command line: what can be asked, and how a wrong question is answered in one line.

mod choice;
mod many;
mod measure;
mod motion;

pub use choice::{Format, Method, Scalar, ScalarChoice};
pub use many::{LongrunArgs, OverflowArgs, Shard, StudyArgs, SweepArgs};
pub use measure::{
    AccuracyArgs, BenchArgs, BudgetArgs, CompareArgs, ErrataArgs, FiguresArgs, ReportArgs, SinesArgs,
};
pub use motion::{
    BakeArgs, ConstantsArgs, DEFAULT_STEPS, Language, PlotArgs, StateArgs, TimesArgs, ViewArgs,
};

use crate::Failure;
use clap::error::ErrorKind;
use clap::{Args, CommandFactory, Parser, Subcommand};
use clap_complete::Shell;
use std::ffi::OsString;

/// The motion of a spinning top whose tip slides on a plane, or is fixed.
#[derive(Debug, Parser)]
#[command(name = "toytop", version)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

/// A command with its arguments.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// How far the core is from an independent integration of the full 3-D equations (exit code 1 if a bound is missed)
    #[command(after_help = "Example: toytop compare host/scenarios/toy_top.toml --periods 100 --format csv")]
    Compare(CompareArgs),
    /// Orientation, rates and tip at given times
    #[command(
        after_help = "Example: toytop state host/scenarios/toy_top.toml --times 0,0.5,1e6 --format json"
    )]
    State(StateArgs),
    /// First integrals, branch points, period and mean rotations of a motion
    #[command(after_help = "Example: toytop constants host/scenarios/figure_3_loops.toml")]
    Constants(ConstantsArgs),
    /// The curve of the tip between its bounding circles, as a picture
    #[command(after_help = "Example: toytop plot host/scenarios/figure_3_loops.toml -o tip.svg")]
    Plot(PlotArgs),
    /// The motion as one page for a browser: the top in 3-D, the curve of its tip, its axis and its constants
    #[command(
        after_help = "Example: toytop view host/scenarios/figure_3_loops.toml -o top.html\n         top.html#t=12.5 then shows that time"
    )]
    View(ViewArgs),
    /// The table of a motion as a constant for firmware: Rust, C with its evaluator, or JSON
    #[command(
        after_help = "Example: toytop bake top.toml --hertz 8000 -o src/top.rs         a static, which a changed bit keeps from compiling\n         toytop bake top.toml --lang c --tick 44100/2 -o top.h   C99, the same results to the bit"
    )]
    Bake(BakeArgs),
    /// The paper's figures 2 and 3, the height of the axis and the errors against time, as SVG and PNG
    #[command(after_help = "Example: toytop figures -o figures")]
    Figures(FiguresArgs),
    /// What a state costs: ephemeris and stepper against the full solver, on this machine
    #[command(after_help = "Example: toytop bench --format json")]
    Bench(BenchArgs),
    /// One page with accuracy, work and precision, figures; and the tables of the README
    #[command(after_help = "Example: toytop report -o report")]
    Report(ReportArgs),
    /// What each call costs on emulated microcontrollers, and whether that is within its budget (exit code 1 if not)
    Budget(BudgetArgs),
    #[command(after_help = "Example: toytop errata --format csv")]
    /// The slips of the printed paper: both versions against the full equations (exit code 1 if a pair does not differ as stated)
    Errata(ErrataArgs),
    /// The scalars side by side: errors from tick 1 to tick 2^40, and what a tick costs on each chip
    #[command(after_help = "Example: toytop accuracy --plot accuracy.svg")]
    Accuracy(AccuracyArgs),
    /// The sines of an integer phase, swept over all 2^32 phases
    #[command(
        after_help = "Example: toytop sines --format json\n         toytop sines --every 4099   a million of them, in no time"
    )]
    Sines(SinesArgs),
    /// Fixed point on random motions, in a build that checks every sum (exit code 1 if one overflows)
    #[command(
        after_help = "Example: toytop overflow --motions 100000\nSums are checked in a build of: cargo run --release --config profile.release.overflow-checks=true --bin toytop -- overflow"
    )]
    Overflow(OverflowArgs),
    /// Random motions of every regime: does the ephemeris keep its error bound? (exit code 1 if not)
    #[command(
        after_help = "Example: toytop study --motions 5000 --seed 2\n         toytop study --corners --motions 100000 --docs host/docs/study.md"
    )]
    Study(StudyArgs),
    /// Steppers and ephemeris cursors over very many ticks against the truth, there and back, and the full solver against itself
    #[command(after_help = "Example: toytop longrun --ticks 10000000 --format csv")]
    Longrun(LongrunArgs),
    /// Constants and errors of many motions, a row each: a grid or a random sample, on all cores, in shards if wanted
    #[command(
        after_help = "Example: toytop sweep --e1=-0.9..0.1/41 --e2 0.9 --e3 log:1.01..100/33 --a-over-ps 1 --c-over-a 0.5 -o grid.csv\n         toytop sweep --motions 1000000 --shard 3/100 --resume -o part_3.csv"
    )]
    Sweep(SweepArgs),
    /// Completions for a shell, to be sourced or put where it looks for them
    #[command(
        after_help = "Example: toytop completions bash > ~/.local/share/bash-completion/completions/toytop"
    )]
    Completions(CompletionsArgs),
}

/// `toytop completions`
#[derive(Args, Debug)]
pub struct CompletionsArgs {
    /// Which shell
    pub shell: Shell,
}

/// The script that completes this program's commands, options and values.
#[must_use]
pub fn completions(shell: Shell) -> Vec<u8> {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut Cli::command(), "toytop", &mut script);
    script
}

/// What a command line asks for.
#[derive(Debug)]
pub enum Request {
    /// Run a command.
    Run(Box<Command>),
    /// Print the help or the version.
    Show(String),
}

/// Parses a command line, the program's name in front.
///
/// # Errors
/// [`Failure::Input`] for everything that clap refuses.
pub fn parse(arguments: impl IntoIterator<Item = OsString>) -> Result<Request, Failure> {
    match Cli::try_parse_from(arguments) {
        Ok(cli) => Ok(Request::Run(Box::new(cli.command))),
        Err(error) => match error.kind() {
            ErrorKind::DisplayHelp | ErrorKind::DisplayVersion => {
                Ok(Request::Show(error.render().to_string()))
            }
            ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand => {
                Err(Failure::Input("no command given; see toytop --help".into()))
            }
            _ => Err(Failure::Input(in_one_line(&error.render().to_string()))),
        },
    }
}

/// The first paragraph of clap's message, which says what is wrong and what is possible, and what may have been meant; the
/// rest is usage.
fn in_one_line(message: &str) -> String {
    let paragraph = message.lines().take_while(|line| !line.trim().is_empty());
    let line = paragraph.map(str::trim).collect::<Vec<_>>().join(" ");
    let meant = message
        .lines()
        .find_map(|line| line.trim().strip_prefix("tip: ").filter(|tip| tip.contains("similar")));
    let meant = meant.map(|tip| format!("; {tip}")).unwrap_or_default();
    line.trim_start_matches("error: ").to_owned() + &meant
}
