//! The command line: what can be asked, and how a wrong question is answered in one line.

use crate::Failure;
use crate::sweep::{Axis, Column, DEFAULT_COLUMNS, SignChoice};
use clap::builder::PossibleValue;
use clap::error::ErrorKind;
use clap::{Args, CommandFactory, Parser, Subcommand, ValueEnum};
use clap_complete::Shell;
use std::ffi::OsString;
use std::path::PathBuf;
use std::str::FromStr;

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
    /// The slips of the printed paper: both versions against the full equations (exit code 1 if one does not tell)
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
        after_help = "Example: toytop study --motions 5000 --seed 2         toytop study --corners --motions 100000 --docs host/docs/study.md"
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

/// `toytop bench`
#[derive(Args, Debug)]
pub struct BenchArgs {
    /// Form of the output
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub format: Format,
}

/// The script that completes this program's commands, options and values.
#[must_use]
pub fn completions(shell: Shell) -> Vec<u8> {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut Cli::command(), "toytop", &mut script);
    script
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

/// `toytop view`
#[derive(Args, Debug)]
pub struct ViewArgs {
    /// Scenario file
    pub scenario: PathBuf,
    /// Where to: a file that ends in .html
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
}

/// `toytop bake`
#[derive(Args, Debug)]
pub struct BakeArgs {
    /// Scenario file
    pub scenario: PathBuf,
    /// Scalar type of the results
    #[arg(long, value_enum, default_value_t = Scalar::F32)]
    pub scalar: Scalar,
    /// What to write
    #[arg(long, value_enum, default_value_t = Language::Rust)]
    pub lang: Language,
    /// Segments and terms, as 64x7; without it the crate's default, or the smallest that fits
    #[arg(long, value_name = "SxT", value_parser = size)]
    pub size: Option<[u32; 2]>,
    /// Ticks a second
    #[arg(long, value_name = "N", default_value_t = 1000, conflicts_with = "tick",
        value_parser = clap::value_parser!(u32).range(1..))]
    pub hertz: u32,
    /// A ticks in B seconds
    #[arg(long, value_name = "A/B", value_parser = ratio)]
    pub tick: Option<[u32; 2]>,
    /// Where to; without it, to stdout
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

/// What `bake` writes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Language {
    /// A module with one static
    Rust,
    /// A header with the table and what evaluates it
    C,
    /// One object with all numbers
    Json,
}

fn size(text: &str) -> Result<[u32; 2], &'static str> {
    two(text, 'x').ok_or("must be segments x terms, as 64x7")
}

fn ratio(text: &str) -> Result<[u32; 2], &'static str> {
    two(text, '/')
        .filter(|two| !two.contains(&0))
        .ok_or("must be two whole numbers from 1 to 4294967295, as 44100/2")
}

fn two(text: &str, between: char) -> Option<[u32; 2]> {
    let (first, second) = text.split_once(between)?;
    Some([first.parse().ok()?, second.parse().ok()?])
}

/// `toytop figures`
#[derive(Args, Debug)]
pub struct FiguresArgs {
    /// Folder to write to; made if it is not there
    #[arg(short, long, value_name = "DIR")]
    pub output: PathBuf,
}

/// `toytop report`
#[derive(Args, Debug)]
#[command(group = clap::ArgGroup::new("what").required(true).multiple(true).args(["output", "readme"]))]
pub struct ReportArgs {
    /// Folder for index.html; made if it is not there
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,
    /// Markdown file whose tables to bring up to date
    #[arg(long, value_name = "FILE")]
    pub readme: Option<PathBuf>,
    /// Change nothing; exit code 1 if a table is stale
    #[arg(long, requires = "readme")]
    pub check: bool,
    /// What `toytop budget --format json` wrote, for the page; without it, what the calls are allowed
    #[arg(long, value_name = "FILE", requires = "output")]
    pub budget: Option<PathBuf>,
    /// What host/benches/by_heyoka.py --json wrote, for the page
    #[arg(long, value_name = "FILE", requires = "output")]
    pub rivals: Option<PathBuf>,
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

/// `toytop accuracy`
#[derive(Args, Debug)]
pub struct AccuracyArgs {
    /// Scalar types
    #[arg(long, value_name = "LIST", value_delimiter = ',', default_value = "all")]
    pub scalar: Vec<ScalarChoice>,
    /// Error against cost, as a picture: a file that ends in .svg or .png
    #[arg(long, value_name = "FILE")]
    pub plot: Option<PathBuf>,
    /// Form of the output
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub format: Format,
}

/// `toytop sines`
#[derive(Args, Debug)]
pub struct SinesArgs {
    /// Only every N-th phase
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..))]
    pub every: u32,
    /// Form of the output
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub format: Format,
}

/// `toytop overflow`
#[derive(Args, Debug)]
pub struct OverflowArgs {
    /// How many motions
    #[arg(long, value_name = "N", default_value_t = 10_000, value_parser = clap::value_parser!(u64).range(1..=100_000_000))]
    pub motions: u64,
    /// Ticks of each, in 32 and in 16 bits, and as many steps
    #[arg(long, value_name = "N", default_value_t = 1000, value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub ticks: u32,
    /// Another seed, other motions
    #[arg(long, value_name = "S", default_value_t = 1)]
    pub seed: u64,
}

/// `toytop study`
#[derive(Args, Debug)]
pub struct StudyArgs {
    /// How many (100000 if nothing is said; with --corners 1000000)
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..=100_000_000))]
    pub motions: Option<u64>,
    /// Another seed, other motions
    #[arg(long, value_name = "S", default_value_t = 1)]
    pub seed: u64,
    /// Launches towards every degenerate corner, of branch points and of states, in four scalars
    #[arg(long)]
    pub corners: bool,
    /// How many of the launches are held against the truth
    #[arg(long, value_name = "N", default_value_t = 10_000, requires = "corners", value_parser = clap::value_parser!(u64).range(1..))]
    pub truths: u64,
    /// Markdown page whose table to write
    #[arg(long, value_name = "FILE", requires = "corners")]
    pub docs: Option<PathBuf>,
    /// Form of the output
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub format: Format,
}

impl StudyArgs {
    /// How many motions.
    #[must_use]
    pub fn count(&self) -> u64 {
        self.motions.unwrap_or(if self.corners { 1_000_000 } else { 100_000 })
    }
}

/// `toytop longrun`
#[derive(Args, Debug)]
pub struct LongrunArgs {
    /// How many ticks
    #[arg(long, value_name = "N", default_value_t = 1_000_000_000, value_parser = clap::value_parser!(u64).range(1000..=1_000_000_000_000))]
    pub ticks: u64,
    /// Markdown page whose table to write
    #[arg(long, value_name = "FILE")]
    pub docs: Option<PathBuf>,
    /// Form of the output
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub format: Format,
}

/// `toytop sweep`
#[derive(Args, Debug)]
pub struct SweepArgs {
    /// CSV file to write; it must not exist, unless --resume is given
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
    /// Draw so many motions by lot; without it, the grid of all combinations
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..=1_000_000_000_000))]
    pub motions: Option<u64>,
    /// e1: X,Y,... or LOW..HIGH (even in the logarithm: log:LOW..HIGH), in a grid LOW..HIGH/PLACES
    #[arg(long, value_name = "AXIS", default_value = "-1..1", allow_hyphen_values = true)]
    pub e1: Axis,
    /// e2 >= e1
    #[arg(long, value_name = "AXIS", default_value = "-1..1", allow_hyphen_values = true)]
    pub e2: Axis,
    /// e3 >= 1
    #[arg(long, value_name = "AXIS", default_value = "log:1..100", allow_hyphen_values = true)]
    pub e3: Axis,
    /// A/(ps), the transverse moment of inertia
    #[arg(long, value_name = "AXIS", default_value = "log:0.1..10", allow_hyphen_values = true)]
    pub a_over_ps: Axis,
    /// C/A, the axial moment of inertia
    #[arg(long, value_name = "AXIS", default_value = "0.1..2", allow_hyphen_values = true)]
    pub c_over_a: Axis,
    /// Signs of l + n and l - n (the two other pairs are mirror images)
    #[arg(long, value_enum, default_value_t = SignChoice::Both)]
    pub signs: SignChoice,
    /// Another seed, other motions
    #[arg(long, value_name = "S", default_value_t = 1)]
    pub seed: u64,
    /// What to say of each
    #[arg(long, value_enum, value_name = "LIST", value_delimiter = ',', default_value = DEFAULT_COLUMNS)]
    pub columns: Vec<Column>,
    /// Evaluate each at so many moments
    #[arg(long, value_name = "N", default_value_t = 16, value_parser = clap::value_parser!(u32).range(1..=4096))]
    pub ticks: u32,
    /// ... spread over so many nutation periods (where there is no period: natural times of the top)
    #[arg(long, value_name = "X", default_value_t = 1.0, value_parser = periods, allow_hyphen_values = true)]
    pub periods: f64,
    /// Only every N-th motion, beginning with the I-th: 1/1 is all
    #[arg(long, value_name = "I/N", default_value = "1/1")]
    pub shard: Shard,
    /// Go on with the file, if it exists
    #[arg(long)]
    pub resume: bool,
}

fn periods(text: &str) -> Result<f64, String> {
    let number = text.parse::<f64>().ok().filter(|x| *x > 0.0 && *x <= 1e9);
    number.ok_or_else(|| "must be above 0 and at most 1e9".to_owned())
}

/// One part of a sweep: its number, from 1, and how many there are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard(pub [u64; 2]);

impl FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let number = |text: &str| text.parse::<u64>().ok().filter(|n| *n <= 1 << 32);
        let pair = text.split_once('/').and_then(|(shard, of)| Some([number(shard)?, number(of)?]));
        let pair = pair.filter(|[shard, of]| (1..=*of).contains(shard));
        pair.map(Self).ok_or_else(|| "must be I/N with I from 1 to N".to_owned())
    }
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

/// Scalar types of the core, and a rival's.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Scalar {
    /// Double precision
    F64,
    /// Single precision
    F32,
    /// Fixed point of 32 bits
    Q31,
    /// Fixed point of 16 bits
    Q15,
    /// Single precision with the sines and roots of the crate micromath, to compare with
    Micromath,
}

impl Scalar {
    /// All there are.
    pub const ALL: [Self; 5] = [Self::F64, Self::F32, Self::Q31, Self::Q15, Self::Micromath];

    /// Its name on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::F64 => "f64",
            Self::F32 => "f32",
            Self::Q31 => "q31",
            Self::Q15 => "q15",
            Self::Micromath => "micromath",
        }
    }
}

/// A scalar type, or all there are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ScalarChoice {
    /// This one
    One(Scalar),
    /// Every one
    All,
}

impl ValueEnum for ScalarChoice {
    fn value_variants<'a>() -> &'a [Self] {
        const {
            let mut choices = [Self::All; Scalar::ALL.len() + 1];
            let mut i = 0;
            while i < Scalar::ALL.len() {
                choices[i] = Self::One(Scalar::ALL[i]);
                i += 1;
            }
            &{ choices }
        }
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        match self {
            Self::One(scalar) => scalar.to_possible_value(),
            Self::All => Some(PossibleValue::new("all").help("Every one")),
        }
    }
}

impl ScalarChoice {
    /// The types chosen, each once, in the order of their declaration.
    #[must_use]
    pub fn chosen(choices: &[Self]) -> Vec<Scalar> {
        let wanted = |scalar: &Scalar| choices.contains(&Self::All) || choices.contains(&Self::One(*scalar));
        Scalar::ALL.into_iter().filter(wanted).collect()
    }
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

/// The first paragraph of clap's message, which says what is wrong and what is possible; the rest is usage and tips.
fn in_one_line(message: &str) -> String {
    let paragraph = message.lines().take_while(|line| !line.trim().is_empty());
    let line = paragraph.map(str::trim).collect::<Vec<_>>().join(" ");
    line.trim_start_matches("error: ").to_owned()
}
