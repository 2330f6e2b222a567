//! `toytop budget`: cost of each call on each chip, compared with its budget.

use super::Report;
use crate::Failure;
use crate::budget::{
    CHIPS, Chip, CorpusCost, Cost, Limits, corpus, measure, with_corpus, with_corpus_in_brief,
    with_front_table, with_table,
};
use crate::cli::{BudgetArgs, Format};
use crate::output::progress::Progress;
use crate::output::whole_file;
use crate::output::{self, Cell, Record};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// Frequency of the interrupt that a tick has to fit into, Hz.
const TICK_RATE: f64 = 1000.0;

pub(super) fn run(arguments: &BudgetArgs) -> Result<Report, Failure> {
    let chips = chosen(&arguments.chip)?;
    if let Some(elf) = &arguments.elf {
        let [chip] = chips[..] else {
            return Err(Failure::Input("--elf: needs one --chip, for which the file was built".into()));
        };
        return shown(arguments, &[(chip, measure(chip, elf)?)]);
    }
    let root = repository()?;
    if arguments.corpus {
        return launches(arguments, &root, &chips);
    }
    let mut progress = Progress::new(chips.len() as u64, "chips");
    let mut measured = Vec::new();
    for chip in chips {
        let mut costs = measure(chip, &build(&root, chip, "cost", arguments.size)?)?;
        if FITTING_CHIPS.contains(&chip.name) {
            costs.extend(measure(chip, &build(&root, chip, "fit_cost", arguments.size)?)?);
        }
        measured.push((chip, costs));
        progress.add(1);
    }
    drop(progress);
    if arguments.accept {
        return accept(&root, &measured);
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

const LIMITS: &str = "firmware-examples/budgets.toml";
const COSTS: &str = "host/docs/costs.md";
const FRONT_PAGE: &str = "README.md";
/// Chips on which the fit of a launch is measured: one, because a trace of the fit takes long.
const FITTING_CHIPS: [&str; 1] = ["m4f"];
/// Pages with a table of costs, each with the function that writes the table.
const PAGES: [(&str, WithTable); 2] = [(COSTS, with_table), (FRONT_PAGE, with_front_table)];

/// Function that puts the table of the limits into a page; `None` if the page has no markers for it.
type WithTable = fn(&str, &Limits) -> Option<String>;

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
fn launches(arguments: &BudgetArgs, root: &Path, chips: &[&'static Chip]) -> Result<Report, Failure> {
    let limits = Limits::parse(&text_of(&root.join(LIMITS))?)?;
    let mut progress = Progress::new(chips.len() as u64, "chips");
    let mut costs = Vec::new();
    for chip in chips {
        if !arguments.accept || limits.of(chip.name, "launch").is_some_and(|cost| cost.cycles.is_some()) {
            costs.extend(corpus(chip, &build(root, chip, "corpus", arguments.size)?, &limits)?);
        }
        progress.add(1);
    }
    drop(progress);
    if arguments.accept {
        let no_place = |name| Failure::Input(format!("{name}: must contain the markers of the corpus"));
        let page = with_corpus(&text_of(&root.join(COSTS))?, &costs).ok_or_else(|| no_place(COSTS))?;
        let front = text_of(&root.join(FRONT_PAGE))?;
        let front = with_corpus_in_brief(&front, &costs).ok_or_else(|| no_place(FRONT_PAGE))?;
        whole_file::write("--accept", &root.join(COSTS), page.as_bytes())?;
        whole_file::write("--accept", &root.join(FRONT_PAGE), front.as_bytes())?;
        return Ok(Report {
            text: format!("written: the launches in {COSTS} and {FRONT_PAGE}\n"),
            ..Report::default()
        });
    }
    let records: Vec<_> = costs.iter().map(CorpusCost::record).collect();
    let text = match arguments.format {
        Format::Csv => output::csv(&records).map_err(Failure::Output)?,
        Format::Json => output::json_list("rows", &records).map_err(Failure::Output)?,
        Format::Table => format!(
            "{}\nMotion and table of 200 launches: tilt 0 to 180 degrees, spin 0 to 1000 rad/s, A/(ps) 0.01 to 1000, both \
             supports, corners; at most 64 segments. Instructions are exact to 40; cycles are those of bench_launch in \
             proportion (model). A slice is one poll of Launch or SetUp.\n",
            corpus_table(&records)
        ),
    };
    Ok(Report { text, ..Report::default() })
}

fn corpus_table(records: &[Record]) -> String {
    let words = |record: &Record| output::flat(record).into_iter();
    let header = records.iter().take(1).map(|record| words(record).map(|(name, _)| name).collect());
    let rows = records.iter().map(|record| words(record).map(|(_, value)| value).collect());
    output::columns(header.chain(rows).collect(), 3)
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

type Measured = [(&'static Chip, Vec<Cost>)];

fn by_name(measured: &Measured) -> Vec<(String, Vec<Cost>)> {
    measured.iter().map(|(chip, costs)| (chip.name.to_owned(), costs.clone())).collect()
}

fn text_of(path: &Path) -> Result<String, Failure> {
    fs::read_to_string(path).map_err(|error| Failure::Input(format!("{}: {error}", path.display())))
}

fn complaints(root: &Path, measured: &Measured) -> Result<Vec<String>, Failure> {
    let limits = Limits::parse(&text_of(&root.join(LIMITS))?)?;
    let mut complaints: Vec<_> =
        measured.iter().flat_map(|(chip, costs)| limits.complaints(chip.name, costs)).collect();
    if !complaints.is_empty() {
        complaints.push(format!("how to change a budget: the head of {LIMITS}"));
    }
    for (name, with_table) in PAGES {
        let page = text_of(&root.join(name))?;
        if with_table(&page, &limits).is_none_or(|fresh| fresh != page) {
            complaints.push(format!("{name}: the table is not that of {LIMITS}: toytop budget --accept"));
        }
    }
    Ok(complaints)
}

fn accept(root: &Path, measured: &Measured) -> Result<Report, Failure> {
    let limits = Limits::around(&by_name(measured));
    let mut pages = Vec::new();
    for (name, with_table) in PAGES {
        let no_place = || Failure::Input(format!("{name}: must contain the markers of the table"));
        let page = with_table(&text_of(&root.join(name))?, &limits).ok_or_else(no_place)?;
        pages.push((name, page));
    }
    whole_file::write("--accept", &root.join(LIMITS), limits.to_toml().as_bytes())?;
    for (name, page) in &pages {
        whole_file::write("--accept", &root.join(name), page.as_bytes())?;
    }
    let names = PAGES.map(|(name, _)| name).join(" and ");
    Ok(Report { text: format!("written: {LIMITS}, and the tables in {names}\n"), ..Report::default() })
}

fn shown(arguments: &BudgetArgs, measured: &Measured) -> Result<Report, Failure> {
    let records: Vec<_> = measured
        .iter()
        .flat_map(|(chip, costs)| costs.iter().map(|cost| record(chip, cost, arguments.clock)))
        .collect();
    let text = match arguments.format {
        Format::Csv => output::csv(&records).map_err(Failure::Output)?,
        Format::Json => output::json_list("rows", &records).map_err(Failure::Output)?,
        Format::Table => table(measured, arguments.clock),
    };
    Ok(Report { text, ..Report::default() })
}

/// Time in µs, and its share of a tick in percent.
fn time(cycles: u64, megahertz: f64) -> [f64; 2] {
    let microseconds = cycles as f64 / megahertz;
    [microseconds, microseconds * 1e-6 * TICK_RATE * 100.0]
}

fn record(chip: &Chip, cost: &Cost, megahertz: f64) -> Record {
    let count = |figure: Option<u64>| figure.map_or(Cell::Absent, Cell::Count);
    let time = cost.cycles.map(|cycles| time(cycles, megahertz));
    Record(vec![
        ("chip", Cell::Text(chip.name.to_owned())),
        ("call", Cell::Text(cost.call.clone())),
        ("instructions", Cell::Count(cost.instructions)),
        ("cycles_model", count(cost.cycles)),
        ("microseconds", time.map(|[microseconds, _]| microseconds).into()),
        ("tick_percent", time.map(|[_, percent]| percent).into()),
        ("stack", count(cost.stack)),
        ("flash", Cell::Count(cost.flash)),
        ("ram", count(cost.ram)),
    ])
}

fn table(measured: &Measured, megahertz: f64) -> String {
    let microseconds = format!("µs at {megahertz} MHz");
    let header =
        ["", "instructions", "cycles (model)", &microseconds, "% of a 1 kHz tick", "stack", "flash", "RAM"];
    let mut rows = vec![header.map(str::to_owned).to_vec()];
    for (chip, costs) in measured {
        rows.push(vec![chip.core.to_owned()]);
        for cost in costs {
            let count = |figure: Option<u64>| figure.map_or("-".to_owned(), |figure| figure.to_string());
            let number = |x: f64| if x < 10.0 { format!("{x:.2}") } else { format!("{x:.0}") };
            let time = cost
                .cycles
                .map_or(["-".to_owned(), "-".to_owned()], |cycles| time(cycles, megahertz).map(number));
            let [microseconds, percent] = time;
            rows.push(vec![
                format!("  {}", cost.call),
                cost.instructions.to_string(),
                count(cost.cycles),
                microseconds,
                percent,
                count(cost.stack),
                cost.flash.to_string(),
                count(cost.ram),
            ]);
        }
    }
    format!(
        "{}\nThe costliest of several calls. Instructions are exact; cycles are a model (published timings, no wait states); \
         stack, flash, RAM in bytes.\n",
        output::columns(rows, 1)
    )
}
