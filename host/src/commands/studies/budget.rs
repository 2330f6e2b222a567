//! `toytop budget`: cost of each call on each chip, compared with its budget.

use super::Report;
use super::options::positive;
use crate::Failure;
use crate::budget::{CHIPS, Chip, Cost, Costs, Image, Limits, OF_CORPUS, OF_LIMITS, Part, corpus, measure};
use crate::output::doc_markers::Page;
use crate::output::{self, Column, Format, Record, eight, short, whole_file};
use clap::Args;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

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
    let measured = |chip: &'static Chip| {
        let program = |name| build(&root, chip, name, arguments.size);
        let mut costs = measure(chip, &program("cost")?)?;
        if FITTING_CHIPS.contains(&chip.name) {
            costs.extend(measure(chip, &program("fit_cost")?)?);
        }
        // a set-up cannot be linked without the rest of its table: its flash is that of a program, as the linker sees it
        let flash = program("flash")?;
        let linked = Image::read(&flash)?.flash - Image::read(&program("empty")?)?.flash;
        for call in SET_UPS {
            costs.entry(call.to_owned()).and_modify(|cost| cost.flash = linked);
        }
        costs.extend(measure(chip, &flash)?);
        Ok((chip.name.to_owned(), costs))
    };
    let measured = chips.into_iter().map(measured).collect::<Result<BTreeMap<_, _>, Failure>>()?;
    if arguments.accept {
        let limits = Limits::around(measured);
        let report = rewrite(&root, OF_LIMITS, &limits)?;
        whole_file::write("--accept", &root.join(LIMITS), limits.to_toml().as_bytes())?;
        return Ok(report);
    }
    let mut report = shown(arguments, &measured)?;
    if arguments.check {
        let complaints = complaints(&root, &measured)?;
        report.missed = !complaints.is_empty();
        let remarks = if report.missed { complaints } else { vec!["within budget".to_owned()] };
        report = report.with_remarks(remarks, arguments.format == Format::Table);
    }
    Ok(report)
}

fn chosen(names: &[String]) -> Result<Vec<&'static Chip>, Failure> {
    let find = |name: &String| {
        let all = || CHIPS.map(|chip| chip.name).join(", ");
        let unknown = || Failure::Input(format!("--chip {name}: one of {}", all()));
        CHIPS.iter().find(|chip| chip.name == name).ok_or_else(unknown)
    };
    if names.is_empty() { Ok(CHIPS.iter().collect()) } else { names.iter().map(find).collect() }
}

/// File of the limits.
const LIMITS: &str = "firmware-examples/budgets.toml";
/// Chips on which the fit of a launch is measured: one, because a trace of the fit takes long.
const FITTING_CHIPS: [&str; 1] = ["m4f"];
/// Calls whose flash is that of a program with a launch, a table and a tick, minus that of the same program without them.
const SET_UPS: [&str; 5] = ["launch", "new", "slices", "launch_slow", "launch_falling"];
/// Root of the repository: the current folder, or one above it.
fn repository() -> Result<PathBuf, Failure> {
    let here = std::env::current_dir().map_err(|error| Failure::Input(format!("current folder: {error}")))?;
    let holds = |folder: &&Path| folder.join("firmware-examples/cost").is_dir();
    let missing = || {
        Failure::Input(
            "budget: not in the repository of toytop (it builds firmware-examples/cost); see --elf".into(),
        )
    };
    here.ancestors().find(holds).map(Path::to_owned).ok_or_else(missing)
}

/// Report on the set-up of many launches on each chip.
fn launches(arguments: &BudgetArgs, root: &Path, chips: Vec<&'static Chip>) -> Result<Report, Failure> {
    let limits = Limits::read(&root.join(LIMITS))?;
    let modelled = |chip: &Chip| limits.of(chip.name, "launch").is_some_and(|cost| cost.cycles.is_some());
    let mut costs = Vec::new();
    for chip in chips.into_iter().filter(|chip| !arguments.accept || modelled(chip)) {
        costs.extend(corpus(chip, &build(root, chip, "corpus", arguments.size)?, &limits)?);
    }
    if arguments.accept {
        return rewrite(root, OF_CORPUS, &costs[..]);
    }
    let records: Vec<_> = costs.iter().map(|cost| cost.record()).collect();
    let table = || {
        let columns = records.first().map(|record| record.columns(eight)).unwrap_or_default();
        format!(
            "{}\nMotion and table of 200 launches: tilt 0 to 180 degrees, spin 0 to 1000 rad/s, A/(ps) 0.01 to 1000, both \
             supports, corners; at most 64 segments. Instructions are exact to 40; cycles are those of bench_launch in \
             proportion (model). A slice is the time between two calls of the set-up's function.\n",
            output::aligned(&records, &columns)
        )
    };
    Ok(output::render(arguments.format, &output::list("rows", &records), table)?.into())
}

/// Path of the firmware after its build, optimised for size if `size`, otherwise for speed. The messages of the build go to stderr.
fn build(root: &Path, chip: &Chip, program: &str, size: bool) -> Result<PathBuf, Failure> {
    let fail = |what: String| {
        Failure::Tool(format!("budget: cargo xtask firmware {program} --chip {} --elf: {what}", chip.name))
    };
    let built = Command::new("cargo")
        .current_dir(root)
        .args(["xtask", "firmware", program, "--chip", chip.name, "--elf"])
        .envs(size.then_some(("CARGO_PROFILE_RELEASE_OPT_LEVEL", "s")))
        .stderr(Stdio::inherit())
        .output()
        .map_err(|error| fail(error.to_string()))?;
    if !built.status.success() {
        return Err(fail(built.status.to_string()));
    }
    Ok(PathBuf::from(String::from_utf8_lossy(&built.stdout).trim()))
}

fn complaints(root: &Path, measured: &BTreeMap<String, Costs>) -> Result<Vec<String>, Failure> {
    let limits = Limits::read(&root.join(LIMITS))?;
    let mut complaints: Vec<_> =
        measured.iter().flat_map(|(chip, costs)| limits.complaints(chip, costs)).collect();
    if !complaints.is_empty() {
        complaints.push(format!("how to change a budget: the head of {LIMITS}"));
    }
    for (name, mark, text) in OF_LIMITS {
        if !Page::read(&root.join(name), mark)?.has(&text(&limits)) {
            complaints.push(format!("{name}: the table is not that of {LIMITS}: toytop budget --accept"));
        }
    }
    Ok(complaints)
}

/// Writes parts of pages, after each of them was found to have a place.
fn rewrite<T: ?Sized, const N: usize>(
    root: &Path,
    parts: [Part<T>; N],
    costs: &T,
) -> Result<Report, Failure> {
    let pages = parts.map(|(name, mark, _)| Page::read(&root.join(name), mark));
    let pages = pages.into_iter().collect::<Result<Vec<_>, _>>()?;
    for (page, (.., text)) in pages.iter().zip(parts) {
        page.write(&text(costs))?;
    }
    Ok(format!("written: the tables in {}\n", parts.map(|(name, ..)| name).join(" and ")).into())
}

fn shown(arguments: &BudgetArgs, measured: &BTreeMap<String, Costs>) -> Result<Report, Failure> {
    let mut records = Vec::new();
    for (chip, costs) in measured {
        records.extend(costs.iter().map(|(call, cost)| record(chip, call, cost, arguments.clock)));
    }
    let microseconds = format!("µs at {} MHz", arguments.clock);
    let three = |x| short(x, 3);
    let columns: [Column<'_>; 9] = [
        ("chip", "chip", three),
        ("call", "call", three),
        ("instructions", "instructions", three),
        ("cycles_model", "cycles (model)", three),
        ("microseconds", &microseconds, three),
        ("tick_percent", "% of a 1 kHz tick", three),
        ("stack", "stack", three),
        ("flash", "flash", three),
        ("ram", "RAM", three),
    ];
    let table = || {
        format!(
            "{}\nThe costliest of several calls. Instructions are exact; cycles are a model (published timings, no wait states); \
             stack, flash, RAM in bytes.\n",
            output::aligned(&records, &columns)
        )
    };
    Ok(output::render(arguments.format, &output::list("rows", &records), table)?.into())
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
