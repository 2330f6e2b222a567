//! Command line of `toytop`: its commands, their help texts and their arguments. Any program with commands reads its line by [`report`].

use crate::Failure;
use crate::commands::data::{benchmark, fit, score, simulate};
use crate::commands::motion::{bake, constants, events, state};
use crate::commands::options::FormatArgs;
use crate::commands::pictures::{animate, figures, plot, view};
use crate::commands::studies::{accuracy, bench, budget, compare, errata, sweep};
use crate::output::stdout::Report;
use clap::error::ErrorKind;
use clap::{Arg, CommandFactory, Parser, Subcommand};
use clap_complete::Shell;
use std::ffi::OsString;

/// Exact motion of a spinning top whose tip slides on a plane or is held, or of a free body.
#[derive(Parser)]
#[command(
    name = "toytop",
    version,
    help_template = "{about}\n{usage-heading} {usage}; each command has --help, and toytop has --version\n\nCommands:\n{subcommands}\n"
)]
struct Cli {
    /// Command to run.
    #[command(subcommand)]
    command: Command,
}

/// Command with its arguments.
#[derive(Subcommand)]
enum Command {
    /// Errors of the core against an integration of the full 3-D equations
    ///
    /// The exit code is 1 if a bound is missed.
    #[command(after_help = "Example: toytop compare host/scenarios/toy_top.toml --periods 100 --format csv")]
    Compare(compare::CompareArgs),
    /// Orientation, rates and tip at given times
    #[command(
        after_help = "Units: t in s, udot in 1/s, omega in rad/s, tip in m, phi in rad; the other angles are in rad too.\n\
            With units = \"none\" in the scenario no units are named. u, alpha, beta, gamma, delta, quaternion and axis are pure numbers.\n\
            The tip is c = 2 s alpha beta. With support = \"fixed\" or \"free\" it is 2 alpha beta, a pure number: minus the horizontal part of the axis.\n\
            The CSV columns have the names of the JSON keys, except for quaternion (w,x,y,z), omega_body (wx,wy,wz), angles (tilt,azimuth,roll)\n\
            and euler_zxz (euler_phi,euler_theta,euler_psi).\n\n\
            Example: toytop state host/scenarios/toy_top.toml --times 0,0.5,1e6 --format json\n         \
            toytop state host/scenarios/toy_top.toml --from 0 --to 10 --count 1000001 --columns t,quaternion,omega_body --format csv -o top.csv\n         \
            toytop state host/scenarios/toy_top.toml --ticks 0..999 --hertz 8000 --scalar q15 --format csv"
    )]
    State(state::StateArgs),
    /// First integrals, branch points, period and mean rotations
    #[command(
        after_help = "A tilt is the angle of the axis from the upward vertical. The precession is the mean rate of the axis about the vertical. The spin is\n\
            omega . r, the whole component of omega along the axis. Above the critical spin a top that spins upright is stable.\n\
            With units = \"none\" a second stands for the unit of time of the scenario.\n\n\
            Example: toytop constants host/scenarios/figure_3_loops.toml"
    )]
    Constants(constants::ConstantsArgs),
    /// Times of turning points, tilts, circles, tip angles and lift-off
    #[command(
        after_help = "tilt=X: the axis makes the angle X with the upward vertical; :up selects the times at which it rises. circle=R: the tip is at the\n\
            distance R from the centre (for a held tip R is the sine of the tilt). tip-angle=X: the tip angle is X, whole turns aside. lift-off: the\n\
            normal force is 0; :up selects the times at which a real top leaves the plane.\n\n\
            Example: toytop events host/scenarios/figure_3_loops.toml --kind turning,tilt=40:up,tip-angle=90 --count 20\n         \
            toytop events host/scenarios/toy_top.toml --kind tilt=22 --from 1e6 --format json"
    )]
    Events(events::EventsArgs),
    /// Picture of a motion: curve of the tip or axis, tilt, precession, potential
    ///
    /// For a held tip the curve from above is that of the end of a unit vector along the axis, which is minus the tip of toytop state.
    #[command(
        after_help = "Symbols: u: cosine of the tilt; e1 <= u <= e2: its bounds; e3: third root of the cubic of the nutation; rho: distance of the\n\
            tip from the centre, s sqrt(1 - u^2); l, n: angular momenta about the vertical and about the axis of the top.\n\n\
            Example: toytop plot host/scenarios/figure_3_loops.toml -o tip.svg\n         toytop plot host/scenarios/toy_top.toml --kind tilt --times 0..0.5 --size 1200 -o tilt.png"
    )]
    Plot(plot::PlotArgs),
    /// Animation of a motion, as a GIF
    #[command(
        after_help = "Each frame shows the top at one exact time. A red spoke of the disc turns with the body. A fast spin can be seen only in slow motion:\n\
            --times 0..0.2 shows a fifth of a second over the whole film.\n\n\
            Example: toytop animate host/scenarios/toy_top.toml --times 0..0.2 -o top.gif"
    )]
    Animate(animate::AnimateArgs),
    /// Page for a browser that shows a top, with sliders for its launch
    ///
    /// The page needs no network and no other file. It contains the core, which computes the motion that the sliders set.
    #[command(
        after_help = "Example: toytop view host/scenarios/figure_3_loops.toml -o top.html\n         top.html#t=12.5 then shows that time\n         toytop view -o index.html   a page that begins with a toy top"
    )]
    View(view::ViewArgs),
    /// Table of a motion as a constant for firmware: Rust or C
    ///
    /// A table in C contains the code that evaluates it.
    #[command(
        after_help = "Example: toytop bake top.toml --hertz 8000 -o src/top.rs         a static; it does not compile if a bit was changed\n         toytop bake top.toml --lang c --hertz 44100/2 -o top.h   C99 or C++11, with the same results to the bit"
    )]
    Bake(bake::BakeArgs),
    /// Curves of figures 2 and 3 of the paper, as SVG
    #[command(after_help = "Example: toytop figures -o figures")]
    Figures(figures::FiguresArgs),
    /// Errors of your integrator's output against the exact motion
    #[command(
        after_help = "A RESULT has a header, and a row for each time: t in s, and w,x,y,z (unit quaternion from body to fixed coordinates), or\n\
            alpha_re,alpha_im,beta_re,beta_im, or r11,r12,...,r33 (matrix by rows, body to fixed). The drifts of h, l and n need\n\
            wx,wy,wz (rad/s, body frame) or omega_x,omega_y,omega_z (fixed frame). Other columns are\n\
            ignored. The two signs of a quaternion are one rotation. Lines above the header may state: # method = RK4, # step = 0.001,\n\
            # evaluations = 40000. Files of one method with different steps give its order of convergence.\n\n\
            Example: toytop score host/scenarios/toy_top.toml rk4_*.csv --plot rk4.svg\n         \
            toytop state TOP.toml --times 0..1/1001 --method stepper --format csv > s.csv && toytop score TOP.toml s.csv"
    )]
    Score(score::ScoreArgs),
    /// Reference values of the heavy tops that integrators are tested with
    #[command(
        after_help = "The values have 30 digits, and two integrations confirm each of them. The conventions are those of the problem's source.\n\n\
            Example: toytop benchmark bruls_cardona --format json\n         \
            toytop benchmark bruls_cardona --times 0..2/2001 --format csv > run.csv && toytop score --benchmark bruls_cardona run.csv"
    )]
    Benchmark(benchmark::BenchmarkArgs),
    /// Samples of sensors on a top, with noise, bias and limited range
    #[command(
        after_help = "Example: toytop simulate host/scenarios/toy_top.toml --hertz 1000 --duration 1 --seed 7 -o samples.csv"
    )]
    Simulate(simulate::SimulateArgs),
    /// Launch of a top from samples of sensors, with error bars
    ///
    /// The exit code is 1 if the fit has not converged; the reason is printed, and no scenario is written.
    #[command(
        after_help = "SAMPLES.csv has a column t (s), and those of its sensors: gyro_x,gyro_y,gyro_z (rad/s, body frame); accel_x,accel_y,accel_z (m/s^2);\n\
            mag_x,mag_y,mag_z; w,x,y,z (unit quaternion from body to fixed coordinates); axis_x,axis_y,axis_z; tip_x,tip_y (m); mark (azimuth, rad).\n\
            An empty field is no reading.\n\n\
            Example: toytop fit samples.csv --top host/scenarios/toy_top.toml --free axial_inertia -o fitted.toml"
    )]
    Fit(fit::FitArgs),
    /// Computing times on this machine: ephemeris, stepper, full solver
    #[command(after_help = "Example: toytop bench --format json")]
    Bench(FormatArgs),
    /// Cost of each call on emulated microcontrollers, beside its budget
    ///
    /// The exit code is 1 if a call is beyond its budget.
    Budget(budget::BudgetArgs),
    #[command(after_help = "Example: toytop errata --format csv")]
    /// Errors of the printed paper and their corrections
    Errata(FormatArgs),
    /// Errors of each scalar up to tick 2^40
    #[command(after_help = "Example: toytop accuracy --scalar f32,q31")]
    Accuracy(accuracy::AccuracyArgs),
    /// Constants and errors of many motions of a scenario, a grid or a random sample
    ///
    /// Each motion is one row. All processor cores are used, and a sweep can be divided into parts.
    #[command(
        after_help = "Example: toytop sweep host/scenarios/toy_top.toml --spin 90..300/200 --tilt 1..60/100 -o grid.csv\n         toytop sweep host/scenarios/figure_3_loops.toml --axis e1=-0.9..0.1/41 --axis e3=log:1.01..100/33 -o grid.csv\n         toytop sweep host/scenarios/toy_top.toml --spin 90..300 --motions 1000000 --part 3/100 -o part_003.csv"
    )]
    Sweep(Box<sweep::SweepArgs>),
    /// Completions for a shell
    #[command(
        after_help = "Example: toytop completions bash > ~/.local/share/bash-completion/completions/toytop"
    )]
    Completions {
        /// Shell that the completions are for
        shell: Shell,
    },
}

/// Report of one command line of `toytop`.
///
/// # Errors
/// See [`Failure`].
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> Result<Report, Failure> {
    report(arguments, |cli: &Cli| match &cli.command {
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
        Command::Completions { shell } => {
            let mut script = Vec::new();
            clap_complete::generate(*shell, &mut Cli::command(), "toytop", &mut script);
            Ok(String::from_utf8_lossy(&script).into_owned().into())
        }
    })
}

/// Report of `run`, or the help or the version that the command line asks for; it begins with the program's name.
///
/// # Errors
/// [`Failure::Input`] for everything that clap refuses, and the failures of `run`.
pub fn report<C: Parser>(
    arguments: impl IntoIterator<Item = OsString>,
    run: impl FnOnce(&C) -> Result<Report, Failure>,
) -> Result<Report, Failure> {
    let parsed = with_negative_numbers(C::command())
        .try_get_matches_from(arguments)
        .and_then(|matches| C::from_arg_matches(&matches));
    let error = match parsed {
        Ok(cli) => return run(&cli),
        Err(error) => error,
    };
    match error.kind() {
        ErrorKind::DisplayHelp | ErrorKind::DisplayVersion => Ok(error.render().to_string().into()),
        ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand => {
            Err(Failure::Input(format!("no command given; see {} --help", C::command().get_name())))
        }
        _ => Err(Failure::Input(in_one_line(&error.render().to_string()))),
    }
}

/// Command whose options take negative numbers as values.
fn with_negative_numbers(command: clap::Command) -> clap::Command {
    let takes_one = |argument: &Arg| !argument.is_positional() && argument.get_action().takes_values();
    command
        .mut_args(
            |argument| if takes_one(&argument) { argument.allow_negative_numbers(true) } else { argument },
        )
        .mut_subcommands(with_negative_numbers)
}

/// Message of clap in one line: its first paragraph and its suggestion.
fn in_one_line(message: &str) -> String {
    let paragraph = message.lines().take_while(|line| !line.trim().is_empty());
    let line = paragraph.map(str::trim).collect::<Vec<_>>().join(" ");
    let meant = message
        .lines()
        .find_map(|line| line.trim().strip_prefix("tip: ").filter(|tip| tip.contains("similar")));
    let meant = meant.map(|tip| format!("; {tip}")).unwrap_or_default();
    line.trim_start_matches("error: ").to_owned() + &meant
}
