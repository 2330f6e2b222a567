//! The command line: what can be asked, and how a wrong question is answered in one line.

use crate::Failure;
use clap::error::ErrorKind;
use clap::{Args, Parser, Subcommand, ValueEnum};
use std::ffi::OsString;
use std::path::PathBuf;

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
    Compare(CompareArgs),
    /// Orientation, rates and tip at given times
    State(StateArgs),
    /// First integrals, branch points, period and mean rotations of a motion
    Constants(ConstantsArgs),
    /// The curve of the tip between its bounding circles, as a picture
    Plot(PlotArgs),
    /// What a state costs: ephemeris and stepper against the full solver, on this machine
    Bench,
    /// What each call costs on emulated microcontrollers, and whether that is within its budget (exit code 1 if not)
    Budget(BudgetArgs),
    /// The slips of the printed paper: both versions against the full equations (exit code 1 if one does not tell)
    Errata(ErrataArgs),
    /// Random motions of every regime: does the ephemeris keep its error bound? (exit code 1 if not)
    Study(StudyArgs),
}

/// `toytop compare`
#[derive(Args, Debug)]
pub struct CompareArgs {
    /// Scenario files; none: the built-in motions
    #[arg(value_name = "SCENARIO")]
    pub scenarios: Vec<PathBuf>,
    /// Nutation periods to compare over (where there is no period: natural times of the top)
    #[arg(long, value_name = "N", default_value_t = 10, value_parser = clap::value_parser!(u32).range(1..=10_000))]
    pub periods: u32,
    /// Scalar types of the core
    #[arg(long, value_name = "LIST", value_delimiter = ',', default_value = "all")]
    pub scalar: Vec<ScalarChoice>,
    /// Form of the output
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub format: Format,
}

/// `toytop state`
#[derive(Args, Debug)]
pub struct StateArgs {
    /// Scenario file
    pub scenario: PathBuf,
    #[expect(missing_docs, reason = "a comment would head the help text of the whole command")]
    #[command(flatten)]
    pub times: TimesArgs,
    /// How to get there
    #[arg(long, value_enum, default_value_t = Method::Ephemeris)]
    pub method: Method,
    /// Scalar type of the core
    #[arg(long, value_enum, default_value_t = Scalar::F64)]
    pub scalar: Scalar,
    /// Steps of the stepper in a nutation period (where there is none: in a natural time of the top)
    #[arg(long, value_name = "N", default_value_t = DEFAULT_STEPS, value_parser = clap::value_parser!(u32).range(1..=1 << 24))]
    pub steps_per_period: u32,
    /// Form of the output
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub format: Format,
}

/// Steps a period where nothing else is said.
pub const DEFAULT_STEPS: u32 = 4096;

/// The times of `toytop state`: exactly one of the two.
#[derive(Args, Debug)]
#[group(required = true, multiple = false)]
pub struct TimesArgs {
    /// Times, separated by commas, in any order; negative ones too
    #[arg(long, value_name = "T1,T2,...", allow_hyphen_values = true)]
    pub times: Option<String>,
    /// File with one time a line; # starts a comment
    #[arg(long, value_name = "FILE")]
    pub times_file: Option<PathBuf>,
}

/// `toytop constants`
#[derive(Args, Debug)]
pub struct ConstantsArgs {
    /// Scenario file
    pub scenario: PathBuf,
    /// Form of the output
    #[arg(long, value_enum, default_value_t = ConstantsFormat::Table)]
    pub format: ConstantsFormat,
}

/// `toytop plot`
#[derive(Args, Debug)]
pub struct PlotArgs {
    /// Scenario file
    pub scenario: PathBuf,
    /// Where to: a file that ends in .svg or .png
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
}

/// `toytop budget`
#[derive(Args, Debug)]
#[command(
    after_help = "Example: toytop budget --chip m4f,m0plus --clock 48\nNeeds QEMU (qemu-system-arm, qemu-system-misc) and, without --elf, the repository."
)]
pub struct BudgetArgs {
    /// Chips: m0plus, m4f, m7, m33, riscv; none: all
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    pub chip: Vec<String>,
    /// Clock of the chip in MHz, for times
    #[arg(long, value_name = "MHZ", default_value_t = 64.0, value_parser = positive)]
    pub clock: f64,
    /// An ELF of your own: measures its functions named bench_...
    #[arg(long, value_name = "FILE", conflicts_with_all = ["check", "accept"])]
    pub elf: Option<PathBuf>,
    /// Compare with firmware-examples/budgets.toml and the table in README.md
    #[arg(long, conflicts_with = "accept")]
    pub check: bool,
    /// Rewrite both
    #[arg(long)]
    pub accept: bool,
    /// Form of the output
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub format: Format,
}

/// `toytop errata`
#[derive(Args, Debug)]
pub struct ErrataArgs {
    /// Form of the output
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub format: Format,
}

/// A number above 0.
fn positive(text: &str) -> Result<f64, String> {
    text.parse().ok().filter(|x| *x > 0.0 && f64::is_finite(*x)).ok_or_else(|| "a number above 0".into())
}

/// `toytop study`
#[derive(Args, Debug)]
pub struct StudyArgs {
    /// How many
    #[arg(long, value_name = "N", default_value_t = 100_000, value_parser = clap::value_parser!(u64).range(1..=100_000_000))]
    pub motions: u64,
    /// Another seed, other motions
    #[arg(long, value_name = "S", default_value_t = 1)]
    pub seed: u64,
}

/// Form of the output.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// For reading
    Table,
    /// Comma-separated, one line a record
    Csv,
    /// One JSON object
    Json,
}

/// Form of the output of `constants`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum ConstantsFormat {
    /// For reading
    Table,
    /// One JSON object
    Json,
}

/// How `state` gets to a time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Method {
    /// The core's ephemeris: any time at the same cost
    Ephemeris,
    /// The core's stepper
    Stepper,
    /// The full 3-D equations, integrated numerically
    Full,
    /// The paper's elliptic and elementary solutions, for the motions that have one (exit code 3 for the others)
    ClosedForm,
}

impl Method {
    /// Its name on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Ephemeris => "ephemeris",
            Self::Stepper => "stepper",
            Self::Full => "full",
            Self::ClosedForm => "closed-form",
        }
    }
}

/// Scalar types of the core.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Scalar {
    /// Double precision
    F64,
    /// Single precision
    F32,
}

impl Scalar {
    /// Its name on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::F64 => "f64",
            Self::F32 => "f32",
        }
    }
}

/// A scalar type, or all there are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum ScalarChoice {
    /// Double precision
    F64,
    /// Single precision
    F32,
    /// Every one
    All,
}

impl ScalarChoice {
    /// The types chosen, each once, in the order of their declaration.
    #[must_use]
    pub fn chosen(choices: &[Self]) -> Vec<Scalar> {
        let wanted = |(choice, _): &(Self, Scalar)| choices.contains(&Self::All) || choices.contains(choice);
        [(Self::F64, Scalar::F64), (Self::F32, Scalar::F32)]
            .into_iter()
            .filter(wanted)
            .map(|(_, scalar)| scalar)
            .collect()
    }
}

/// What a command line asks for.
#[derive(Debug)]
pub enum Request {
    /// Run a command.
    Run(Command),
    /// Print the help or the version.
    Show(String),
}

/// Parses a command line, the program's name in front.
///
/// # Errors
/// [`Failure::Input`] for everything that clap refuses.
pub fn parse(arguments: impl IntoIterator<Item = OsString>) -> Result<Request, Failure> {
    match Cli::try_parse_from(arguments) {
        Ok(cli) => Ok(Request::Run(cli.command)),
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

/// The first paragraph of clap's message, which says what is wrong and what is possible; the rest is usage and tips.
fn in_one_line(message: &str) -> String {
    let paragraph = message.lines().take_while(|line| !line.trim().is_empty());
    let line = paragraph.map(str::trim).collect::<Vec<_>>().join(" ");
    line.trim_start_matches("error: ").to_owned()
}
