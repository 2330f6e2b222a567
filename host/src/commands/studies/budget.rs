//! `toytop budget`: cost of each call on each emulated chip, compared with its budget.
//!
//! The firmware `cost` gives every call a symbol of its own. QEMU runs it and logs the blocks of code that it executes, and those between the
//! entry of a call and its return are counted. No clock is used: the same ELF gives the same figures.
//!
//! | module | contents |
//! |---|---|
//! | `chips` | chips with their compilers and emulators |
//! | `trace` | blocks of code that QEMU executes |
//! | `model` | cycles of an instruction, from published timings |
//! | `meter` | cost of each call |
//! | `limits` | allowed costs, `firmware-examples/budgets.toml` |
//! | `corpus` | set-up of many launches |
//! | `pages` | tables of pages |

mod chips;
mod corpus;
mod limits;
mod meter;
mod model;
mod pages;
mod trace;

use super::Report;
use super::options::positive;
use crate::Failure;
use crate::output::doc_markers::Page;
use crate::output::{self, Column, Format, Record, eight_digits, short, whole_file};
pub use chips::Chip;
use clap::Args;
use corpus::corpus;
pub use limits::Limits;
use meter::{Cost, Costs, flash, measure};
pub use model::Model;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// Chips whose calls are measured.
pub const CHIPS: [Chip; 5] = [chips::M0PLUS, chips::M4F, chips::M7, chips::M33, chips::RISCV];

/// Frequency of the interrupt that a tick has to fit into, Hz.
const TICK_RATE: f64 = 1000.0;

/// `toytop budget`
#[derive(Args)]
#[command(
    after_help = "Example: toytop budget --chip m4f,m0plus --clock 48\nNeeds QEMU (qemu-system-arm, qemu-system-misc) and, without --elf, the repository."
)]
pub struct BudgetArgs {
    /// Chips, separated by commas: m0plus, m4f, m7, m33, riscv; without it, all
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    chip: Vec<String>,
    /// Clock of the chip, MHz, from which times follow
    #[arg(long, value_name = "MHZ", default_value_t = 64.0, value_parser = positive)]
    clock: f64,
    /// ELF file of your own, whose functions named bench_... are measured
    #[arg(long, value_name = "FILE", conflicts_with_all = ["check", "accept"])]
    elf: Option<PathBuf>,
    /// Compare with firmware-examples/budgets.toml, and that file with the tables of host/docs/costs.md and README.md
    #[arg(long, conflicts_with = "accept")]
    check: bool,
    /// Measure all chips, and rewrite these files
    #[arg(long, conflicts_with = "chip")]
    accept: bool,
    /// Measure the set-up of 200 different launches: median and greatest cost on each chip; with --accept, on those with a model
    /// of their cycles, for the table in host/docs/costs.md
    #[arg(long, conflicts_with_all = ["elf", "check"])]
    corpus: bool,
    /// Compile for size (opt-level s) instead of speed
    #[arg(long, conflicts_with_all = ["elf", "check", "accept"])]
    size: bool,
    /// Form of the output
    #[arg(long, default_value = "table")]
    format: Format,
}

/// File of the limits.
const LIMITS: &str = "firmware-examples/budgets.toml";
/// Chip on which the fit of a launch is measured: one, because a trace of the fit takes long.
const FITTING_CHIP: &str = "m4f";
/// Calls whose flash is that of a program with a launch, a table and a tick, minus that of the same program without them.
const SET_UPS: [&str; 5] = ["launch", "new", "slices", "launch_slow", "launch_falling"];

pub fn run(arguments: &BudgetArgs) -> Result<Report, Failure> {
    let chips = chosen(&arguments.chip)?;
    if let Some(elf) = &arguments.elf {
        let [chip] = chips[..] else {
            return Err(Failure::Input("--elf: needs one --chip, for which the file was built".into()));
        };
        return shown(arguments, &BTreeMap::from([(chip.name.to_owned(), measure(chip, elf)?)]));
    }
    let root = repository()?;
    if arguments.corpus {
        return launches(arguments, &root, chips);
    }
    let measured =
        chips.into_iter().map(|chip| Ok((chip.name.to_owned(), measured(arguments, &root, chip)?)));
    let measured = measured.collect::<Result<BTreeMap<_, _>, Failure>>()?;
    if arguments.accept {
        let limits = Limits::around(measured);
        let report = pages::write(&root, &pages::of_limits(&limits))?;
        whole_file::write("--accept", &root.join(LIMITS), limits.to_toml().as_bytes())?;
        return Ok(report);
    }
    let report = shown(arguments, &measured)?;
    if !arguments.check {
        return Ok(report);
    }
    let complaints = complaints(&root, &measured)?;
    let missed = !complaints.is_empty();
    let remarks = if missed { complaints } else { vec!["within budget".to_owned()] };
    Ok(Report { missed, ..report }.with_remarks(remarks, arguments.format == Format::Table))
}

fn chosen(names: &[String]) -> Result<Vec<&'static Chip>, Failure> {
    let find = |name: &String| {
        let all = || CHIPS.map(|chip| chip.name).join(", ");
        let unknown = || Failure::Input(format!("--chip {name}: one of {}", all()));
        CHIPS.iter().find(|chip| chip.name == name).ok_or_else(unknown)
    };
    if names.is_empty() { Ok(CHIPS.iter().collect()) } else { names.iter().map(find).collect() }
}

/// Root of the repository: the current folder, or one above it.
fn repository() -> Result<PathBuf, Failure> {
    let here = std::env::current_dir().map_err(|error| Failure::Input(format!("current folder: {error}")))?;
    let root = here.ancestors().find(|folder| folder.join("firmware-examples/cost").is_dir());
    let missing = "budget: not in the repository of toytop (it builds firmware-examples/cost); see --elf";
    root.map(Path::to_owned).ok_or_else(|| Failure::Input(missing.into()))
}

/// Costs of all calls on a chip.
fn measured(arguments: &BudgetArgs, root: &Path, chip: &Chip) -> Result<Costs, Failure> {
    let program = |name| build(root, chip, name, arguments.size);
    let mut costs = measure(chip, &program("cost")?)?;
    if chip.name == FITTING_CHIP {
        costs.extend(measure(chip, &program("fit_cost")?)?);
    }
    // a set-up cannot be linked without the rest of its table: its flash is that of a program, as the linker sees it
    let with_table = program("flash")?;
    let linked = flash(&with_table)? - flash(&program("empty")?)?;
    for call in SET_UPS {
        costs.entry(call.to_owned()).and_modify(|cost| cost.flash = linked);
    }
    costs.extend(measure(chip, &with_table)?);
    Ok(costs)
}

/// Path of a program of the package `toytop-cost` after its build, optimised for size if `size`, otherwise for speed.
fn build(root: &Path, chip: &Chip, program: &str, size: bool) -> Result<PathBuf, Failure> {
    let mut cargo = Command::new("cargo");
    cargo.current_dir(root.join("firmware-examples")).stdout(Stdio::null());
    cargo.args(["build", "--quiet", "--package", "toytop-cost", "--bin", program]);
    cargo.envs(size.then_some(("CARGO_PROFILE_RELEASE_OPT_LEVEL", "s")));
    let folder = chip.build(&mut cargo, root);
    match cargo.status() {
        Ok(status) if status.success() => Ok(folder.join(program)),
        ended => {
            let reason = ended.map_or_else(|error| error.to_string(), |status| status.to_string());
            Err(Failure::Tool(format!("budget: cargo build of {program} for {}: {reason}", chip.name)))
        }
    }
}

/// Report on the set-up of many launches on each chip.
fn launches(arguments: &BudgetArgs, root: &Path, chips: Vec<&'static Chip>) -> Result<Report, Failure> {
    let limits = Limits::read(&root.join(LIMITS))?;
    let modelled = |chip: &Chip| limits.of(chip.name, "launch").is_some_and(|cost| cost.cycles.is_some());
    let mut rows = Vec::new();
    for chip in chips.into_iter().filter(|chip| !arguments.accept || modelled(chip)) {
        rows.extend(corpus(chip, &build(root, chip, "corpus", arguments.size)?, &limits)?);
    }
    if arguments.accept {
        return pages::write(root, &pages::of_corpus(&rows));
    }
    let table = || {
        format!(
            "{}\nMotion and table of 200 launches: tilt 0 to 180 degrees, spin 0 to 1000 rad/s, A/(ps) 0.01 to 1000, both \
             supports, corners; at most 64 segments. Instructions are exact to 40; cycles are those of bench_launch in \
             proportion (model). A slice is the time between two calls of the set-up's function.\n",
            output::aligned(&rows, &output::all_columns(&rows, eight_digits))
        )
    };
    Ok(output::render(arguments.format, &output::list("rows", &rows), table).into())
}

fn complaints(root: &Path, measured: &BTreeMap<String, Costs>) -> Result<Vec<String>, Failure> {
    let limits = Limits::read(&root.join(LIMITS))?;
    let mut complaints: Vec<_> =
        measured.iter().flat_map(|(chip, costs)| limits.complaints(chip, costs)).collect();
    if !complaints.is_empty() {
        complaints.push(format!("how to change a budget: the head of {LIMITS}"));
    }
    for (name, mark, text) in pages::of_limits(&limits) {
        if !Page::read(&root.join(name), mark)?.has(&text) {
            complaints.push(format!("{name}: the table is not that of {LIMITS}: toytop budget --accept"));
        }
    }
    Ok(complaints)
}

fn shown(arguments: &BudgetArgs, measured: &BTreeMap<String, Costs>) -> Result<Report, Failure> {
    let mut records = Vec::new();
    for (chip, costs) in measured {
        records.extend(costs.iter().map(|(call, cost)| record(chip, call, cost, arguments.clock)));
    }
    let microseconds = format!("µs at {} MHz", arguments.clock);
    let columns = [
        ("chip", "chip"),
        ("call", "call"),
        ("instructions", "instructions"),
        ("cycles_model", "cycles (model)"),
        ("microseconds", &microseconds),
        ("tick_percent", "% of a 1 kHz tick"),
        ("stack", "stack"),
        ("flash", "flash"),
        ("ram", "RAM"),
    ];
    let columns = columns.map(|(name, heading)| -> Column<'_> { (name, heading, |x| short(x, 3)) });
    let table = || {
        format!(
            "{}\nThe costliest of several calls. Instructions are exact; cycles are a model (published timings, no wait states); \
             stack, flash, RAM in bytes.\n",
            output::aligned(&records, &columns)
        )
    };
    Ok(output::render(arguments.format, &output::list("rows", &records), table).into())
}

fn record(chip: &str, call: &str, cost: &Cost, megahertz: f64) -> Record {
    let microseconds = cost.cycles.map(|cycles| cycles as f64 / megahertz);
    Record::default()
        .with("chip", chip)
        .with("call", call)
        .with("instructions", cost.instructions)
        .with("cycles_model", cost.cycles)
        .with("microseconds", microseconds)
        .with("tick_percent", microseconds.map(|time| time * 1e-6 * TICK_RATE * 100.0))
        .with("stack", cost.stack)
        .with("flash", cost.flash)
        .with("ram", cost.ram)
}
