//! The command line: what can be asked, and how a wrong question is answered in one line.

mod choice;
mod many;
mod measure;
mod motion;

pub use choice::{Format, Method, Scalar, ScalarChoice};
pub use many::{Shard, SweepArgs};
pub use measure::{AccuracyArgs, BenchArgs, BudgetArgs, CompareArgs, ErrataArgs, FiguresArgs};
pub use motion::{
    BakeArgs, ConstantsArgs, DEFAULT_STEPS, Language, PlotArgs, StateArgs, TimesArgs, ViewArgs,
};

use clap::{Args, CommandFactory, Parser, Subcommand};
use clap_complete::Shell;

/// The motion of a spinning top whose tip slides on a plane, or is fixed.
#[derive(Debug, Parser)]
#[command(name = "toytop", version)]
pub struct Cli {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// A command with its arguments.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Errors of the core against an integration of the full 3-D equations
    ///
    /// The exit code is 1 if a bound is missed.
    #[command(after_help = "Example: toytop compare host/scenarios/toy_top.toml --periods 100 --format csv")]
    Compare(CompareArgs),
    /// Orientation, rates and tip at given times
    #[command(
        after_help = "Units of every format (the CSV columns have the names of the JSON keys): t in s, udot in 1/s, omega in rad/s, tip in m, phi in rad;\n\
            u, alpha, beta, gamma and delta are pure numbers. The tip is c = 2 s alpha beta; with support = \"fixed\" it is 2 alpha beta,\n\
            a pure number: minus the horizontal part of the axis, which plot and view draw.\n\n\
            Example: toytop state host/scenarios/toy_top.toml --times 0,0.5,1e6 --format json"
    )]
    State(StateArgs),
    /// First integrals, branch points, period and mean rotations
    #[command(after_help = "Example: toytop constants host/scenarios/figure_3_loops.toml")]
    Constants(ConstantsArgs),
    /// Picture of the curve of the tip between its bounding circles
    ///
    /// For a held tip it is the curve of the axis, -2 alpha beta.
    #[command(after_help = "Example: toytop plot host/scenarios/figure_3_loops.toml -o tip.svg")]
    Plot(PlotArgs),
    /// Page for a browser, in which a top is thrown and watched
    ///
    /// The page needs nothing else: it contains the core, which computes any other motion that is set with its sliders.
    #[command(
        after_help = "Example: toytop view host/scenarios/figure_3_loops.toml -o top.html\n         top.html#t=12.5 then shows that time\n         toytop view -o index.html   the page that introduces the project"
    )]
    View(ViewArgs),
    /// Table of a motion as a constant for firmware: Rust, C or JSON
    ///
    /// C comes with its evaluator.
    #[command(
        after_help = "Example: toytop bake top.toml --hertz 8000 -o src/top.rs         a static, which a changed bit keeps from compiling\n         toytop bake top.toml --lang c --tick 44100/2 -o top.h   C99 or C++11, the same results to the bit"
    )]
    Bake(BakeArgs),
    /// Figures 2 and 3 of the paper, nutation and errors, as SVG and PNG
    #[command(after_help = "Example: toytop figures -o figures")]
    Figures(FiguresArgs),
    /// Time for a state on this machine: ephemeris, stepper, full solver
    #[command(after_help = "Example: toytop bench --format json")]
    Bench(BenchArgs),
    /// Cost of each call on emulated microcontrollers, and its budget
    ///
    /// The exit code is 1 if a call is beyond its budget.
    Budget(BudgetArgs),
    #[command(after_help = "Example: toytop errata --format csv")]
    /// Slips of the printed paper, both versions against the equations
    ///
    /// The exit code is 1 if a pair does not differ as stated.
    Errata(ErrataArgs),
    /// Errors of each scalar up to tick 2^40, and cost on each chip
    #[command(after_help = "Example: toytop accuracy --plot accuracy.svg")]
    Accuracy(AccuracyArgs),
    /// Constants and errors of many motions, a grid or a random sample
    ///
    /// The motions are computed on all cores, in shards if wanted, and get a row each.
    #[command(
        after_help = "Example: toytop sweep --e1=-0.9..0.1/41 --e2 0.9 --e3 log:1.01..100/33 --a-over-ps 1 --c-over-a 0.5 -o grid.csv\n         toytop sweep --motions 1000000 --shard 3/100 --resume -o part_3.csv"
    )]
    Sweep(SweepArgs),
    /// Completions for a shell
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
