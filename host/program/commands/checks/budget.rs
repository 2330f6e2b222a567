//! `toytop budget`: cost of each call on each emulated chip, compared with its budget.
//!
//! QEMU runs the firmware `cost` and logs the blocks of code that it executes. No clock is used: the same ELF gives the same figures.
//!
//! | module | contents |
//! |---|---|
//! | `budgets` | allowed costs, `firmware-examples/budgets.toml` |
//! | `corpus` | set-up of many launches |
//! | `pages` | tables of the documents |

mod budgets;
mod corpus;
mod pages;

use crate::arguments::values::{POSITIVE, number};
use crate::files::doc_page::repository;
use crate::files::whole_file;
use crate::terminal::report::Report;
use crate::terminal::table::TextTable;
use budgets::{Budgets, FLASH_S};
use clap::Args;
use clap::builder::PossibleValuesParser;
use corpus::costs_of_launches;
use serde_json::json;
use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};
use std::process::Stdio;
use toytop_chips::chip::{Chip, M4F};
use toytop_chips::costs::{Cost, Costs, linked_flash, measure};
use toytop_host::Failure;
use toytop_host::output::{self, Format};

/// Frequency of the interrupt, Hz; a tick has to fit into its period.
const TICK_RATE: f64 = 1000.0;

/// Cost of each call on emulated microcontrollers, beside its budget
///
/// The exit code is 1 if a call is beyond its budget.
#[derive(Args)]
#[command(
    after_help = "Example: toytop budget --chip m4f,m0plus --clock 48\nNeeds QEMU (qemu-system-arm, qemu-system-misc) and, without --elf, the repository."
)]
pub struct BudgetArgs {
    /// Chips, separated by commas: m0plus, m4f, m7, m33, riscv; without it, all
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = PossibleValuesParser::new(Chip::measured().map(|chip| chip.name)))]
    chip: Vec<String>,
    /// Clock of the chip, MHz, from which times follow
    #[arg(long, value_name = "MHZ", default_value_t = 64.0, value_parser = number(POSITIVE), conflicts_with = "corpus")]
    clock: f64,
    /// ELF file of your own, whose functions named bench_... are measured
    #[arg(long, value_name = "FILE", group = "measurement")]
    elf: Option<PathBuf>,
    /// Compare with firmware-examples/budgets.toml
    #[arg(long, group = "measurement")]
    check: bool,
    /// Measure all chips, and rewrite that file and the tables of host/docs/costs.md and README.md
    #[arg(long, conflicts_with_all = ["chip", "clock", "elf", "check", "flash", "format"])]
    accept: bool,
    /// Measure the set-up of 200 different launches: median and greatest cost on each chip. With --accept, only chips whose cycles have a model
    /// are measured, and the table in host/docs/costs.md is rewritten
    #[arg(long, group = "measurement")]
    corpus: bool,
    /// Compile for little flash (opt-level s) instead of speed
    #[arg(long, group = "measurement")]
    flash: bool,
    /// Form of the output
    #[arg(long, default_value = "table")]
    format: Format,
}

/// File of the limits.
const LIMITS: &str = "firmware-examples/budgets.toml";
/// Calls whose flash is measured as the program `flash` minus `empty`: a launch, a table and a tick.
const SET_UPS: [&str; 5] = ["launch", "new", "launch_in_static", "launch_slow", "launch_falling"];

impl BudgetArgs {
    fn chips(&self) -> Vec<&'static Chip> {
        let is_chosen = |name: &str| self.chip.is_empty() || self.chip.iter().any(|chip| chip == name);
        Chip::measured().filter(|chip| is_chosen(chip.name)).collect()
    }
}

pub fn run(arguments: &BudgetArgs) -> Result<Report, Failure> {
    let chips = arguments.chips();
    if let Some(elf) = &arguments.elf {
        let [chip] = chips[..] else {
            return Err(Failure::input("--elf: needs one --chip, for which the file was built"));
        };
        let costs = measure(chip, elf).map_err(|error| failure(chip, error))?;
        return Ok(report_on_calls(arguments, &BTreeMap::from([(chip.name.to_owned(), costs)])));
    }
    let root =
        repository("firmware-examples/measure/cost").map_err(|failure| failure.at("budget without --elf"))?;
    if arguments.corpus {
        return report_on_launches(arguments, &root, chips);
    }
    let mut measured = BTreeMap::new();
    for chip in chips {
        let costs = costs_of_calls(&root, chip, arguments.flash).map_err(|error| failure(chip, error))?;
        measured.insert(chip.name.to_owned(), costs);
    }
    if arguments.accept {
        let budgets = Budgets(measured);
        let report = pages::write(&pages::parts_with_budgets(&budgets))?;
        whole_file::write("--accept", &root.join(LIMITS), budgets.to_toml().as_bytes())?;
        return Ok(report);
    }
    let report = report_on_calls(arguments, &measured);
    if !arguments.check {
        return Ok(report);
    }
    let mut violations = Budgets::read(&root.join(LIMITS))?.violations(&measured);
    let check_failed = !violations.is_empty();
    violations.push(if check_failed {
        format!("how to change a budget: the head of {LIMITS}")
    } else {
        "within budget".into()
    });
    Ok(Report { check_failed, ..report }.with_notes(violations))
}

/// Failure of a measurement on a chip.
fn failure(chip: &Chip, error: io::Error) -> Failure {
    match error.kind() {
        io::ErrorKind::InvalidInput => Failure::input(error.to_string()),
        _ => Failure::tool(format!("budget: {}: {error}", chip.name)),
    }
}

/// Costs of all calls on a chip.
fn costs_of_calls(root: &Path, chip: &Chip, small: bool) -> io::Result<Costs> {
    let program = |name| build(root, chip, name, small);
    let mut costs = measure(chip, &program("cost")?)?;
    let flash_of_table = |small| {
        let [with_table, empty] = ["flash", "empty"].map(|name| build(root, chip, name, small));
        io::Result::Ok(linked_flash(&with_table?)? - linked_flash(&empty?)?)
    };
    // two slow measurements are made on one chip
    if chip.name == M4F.name {
        costs.extend(measure(chip, &program("fit_cost")?)?);
        costs.insert(FLASH_S.to_owned(), Cost { flash: Some(flash_of_table(true)?), ..Cost::default() });
    }
    // a set-up cannot be linked without the rest of its table: its flash is measured with a whole program, as the linker sees it
    let flash = flash_of_table(small)?;
    for call in SET_UPS {
        if let Some(cost) = costs.get_mut(call) {
            cost.flash = Some(flash);
        }
    }
    costs.extend(measure(chip, &program("flash")?)?);
    Ok(costs)
}

/// Path of a program of the package `toytop-cost` after its build, optimised for size if `small`, otherwise for speed.
fn build(root: &Path, chip: &Chip, program: &str, small: bool) -> io::Result<PathBuf> {
    let (mut cargo, folder) = chip.build(root, &format!("--quiet --package toytop-cost --bin {program}"));
    cargo.envs(small.then_some(("CARGO_PROFILE_RELEASE_OPT_LEVEL", "s")));
    match cargo.stdout(Stdio::null()).status()? {
        status if status.success() => Ok(folder.join(program)),
        status => Err(io::Error::other(format!("cargo build of {program}: {status}"))),
    }
}

/// Report on the set-up of many launches on each chip.
fn report_on_launches(arguments: &BudgetArgs, root: &Path, chips: Vec<&Chip>) -> Result<Report, Failure> {
    let budgets = Budgets::read(&root.join(LIMITS))?;
    let mut rows = Vec::new();
    for chip in chips.into_iter().filter(|chip| !arguments.accept || chip.timings.is_some()) {
        let costs =
            build(root, chip, "corpus", false).and_then(|elf| costs_of_launches(chip, &elf, &budgets));
        rows.extend(costs.map_err(|error| failure(chip, error))?);
    }
    if arguments.accept {
        return pages::write(&[pages::part_with_launches(&rows)]);
    }
    let table = || {
        format!(
            "{}\nMotion and table of 200 launches: tilt 0 to 180 degrees, spin 0 to 1000 rad/s, A/(ps) 0.01 to 1000, both \
             supports, corners; at most 64 segments. Instructions are exact to 40; cycles are those of bench_launch in \
             proportion (model). A slice is the time between two calls of the set-up's function.\n",
            TextTable::of_fields(&rows, 8).aligned()
        )
    };
    Ok(output::render(arguments.format, &json!({ "rows": rows }), &rows, table).into())
}

/// Report on the cost of each call on each chip.
fn report_on_calls(arguments: &BudgetArgs, measured: &BTreeMap<String, Costs>) -> Report {
    let record = |chip: &str, call: &str, cost: &Cost| {
        let microseconds = cost.cycles.map(|cycles| cycles as f64 / arguments.clock);
        json!({
            "chip": chip,
            "call": call,
            "instructions": cost.instructions,
            "cycles_model": cost.cycles,
            "microseconds": microseconds,
            "tick_percent": microseconds.map(|time| time * 1e-6 * TICK_RATE * 100.0),
            "stack": cost.stack,
            "flash": cost.flash,
            "ram": cost.ram,
        })
    };
    let mut records = Vec::new();
    for (chip, costs) in measured {
        records.extend(costs.iter().map(|(call, cost)| record(chip, call, cost)));
    }
    let table = || {
        format!(
            "{}\nThe costliest of several calls. Instructions are exact; cycles are a model (published timings, no wait states); \
             stack, flash, RAM in bytes; tick_percent of a tick of 1 kHz.\n",
            TextTable::of_fields(&records, 3).aligned()
        )
    };
    output::render(arguments.format, &json!({ "rows": records }), &records, table).into()
}
