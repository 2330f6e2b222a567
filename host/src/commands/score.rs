//! `toytop score`: output of an integrator, compared with the exact motion.

use super::Report;
use crate::Failure;
use crate::benchmarks;
use crate::cli::{Format, ScoreArgs};
use crate::input::scenario::Scenario;
use crate::motion::propagate::period;
use crate::output::{self, Cell, Record, whole_file};
use crate::pictures::plot::Form;
use crate::pictures::work_precision::{MethodRuns, work_precision};
use crate::score::drift::RateSource;
use crate::score::judge::{Judge, Score};
use crate::score::order;
use crate::score::trajectory::Trajectory;
use std::path::PathBuf;
use toytop::Orientation;

pub(super) fn run(arguments: &ScoreArgs) -> Result<Report, Failure> {
    let form = arguments.plot.as_deref().map(|path| Form::of(path, "--plot")).transpose()?;
    let Task { scenario, results, body } = Task::of(arguments)?;
    let (steps, files) = (&arguments.steps, results.len());
    if !steps.is_empty() && steps.len() != files {
        return Err(Failure::Input(format!("--steps: must be {files} numbers, one for each file")));
    }
    let judge = Judge::new(&scenario)?;
    let mut runs = Vec::new();
    for (index, path) in results.iter().enumerate() {
        let trajectory = Trajectory::read(path)?.in_body_axes(&body);
        let score = judge.score(&trajectory)?;
        runs.push(Run::new(trajectory, score, steps.get(index).copied()));
    }
    let methods = Method::all(&runs);
    if let (Some(path), Some(form)) = (&arguments.plot, form) {
        let (unit, lines) = work(&runs, &methods, period(&scenario.motion))?;
        let picture = work_precision(&scenario.name, unit, lines);
        whole_file::write("--plot", path, &picture.encoded(form)?)?;
    }
    let ranked = Ranked::all(&runs, &methods);
    let records: Vec<_> = runs.iter().map(|run| record(run, &methods)).collect();
    let text = match arguments.format {
        Format::Table => tables(&ranked, &methods),
        Format::Csv => output::csv(&records).map_err(Failure::Output)?,
        Format::Json => json(&scenario, &records, &methods).map_err(Failure::Output)?,
    };
    let start = start_command(arguments);
    let doubts = runs.iter().filter_map(|run| {
        let doubt = run.score.doubt.as_ref()?;
        Some(format!("warning: {}: {}", run.name, doubt.question(&start)))
    });
    let doubts = doubts.chain(ranked.iter().filter_map(Ranked::doubt));
    Ok(Report { text, ..Report::default() }.with_remarks(doubts, arguments.format == Format::Table))
}

/// Results, and the scenario that they are compared with.
struct Task<'a> {
    scenario: Scenario,
    results: Vec<&'a PathBuf>,
    /// Rotation from the body axes of the files to those of the core.
    body: Orientation<f64>,
}

impl<'a> Task<'a> {
    fn of(arguments: &'a ScoreArgs) -> Result<Self, Failure> {
        let results = arguments.results.iter();
        let Some(name) = &arguments.benchmark else {
            let scenario = Scenario::read(&arguments.scenario)?;
            return Ok(Self { scenario, results: results.collect(), body: Orientation::IDENTITY });
        };
        let problem = benchmarks::named(name).map_err(|failure| failure.of("--benchmark"))?;
        let results = std::iter::once(&arguments.scenario).chain(results).collect();
        Ok(Self { body: problem.conventions.to_core(), scenario: problem.scenario, results })
    }
}

/// Command that prints the state from which a run has to start.
fn start_command(arguments: &ScoreArgs) -> String {
    match &arguments.benchmark {
        Some(name) => format!("toytop benchmark {name} --times 0 --format csv"),
        None => format!("toytop state {} --times 0", arguments.scenario.display()),
    }
}

/// One file with its score.
struct Run {
    name: String,
    method: String,
    rows: usize,
    /// Step size, s, and its source.
    step: Option<(f64, &'static str)>,
    evaluations: Option<f64>,
    score: Score,
}

impl Run {
    fn new(trajectory: Trajectory, score: Score, step: Option<f64>) -> Self {
        let spacing = trajectory.spacing();
        let Trajectory { name, method, step: stated, evaluations, rows } = trajectory;
        let step = step.map(|step| (step, "option"));
        let step = step.or(stated.map(|step| (step, "file"))).or(spacing.map(|step| (step, "rows")));
        Self { name, method: method.unwrap_or_default(), rows: rows.len(), step, evaluations, score }
    }

    /// Step size and greatest error.
    fn point(&self) -> Option<[f64; 2]> {
        self.step.map(|(step, _)| [step, self.score.max_error])
    }
}

/// Files of one method and their order of convergence.
struct Method {
    name: String,
    files: usize,
    order: Option<f64>,
}

impl Method {
    /// Methods in the order of their first files.
    fn all(runs: &[Run]) -> Vec<Self> {
        let mut names: Vec<&str> = Vec::new();
        for run in runs {
            if !names.contains(&run.method.as_str()) {
                names.push(&run.method);
            }
        }
        let method = |name: &str| {
            let of_method = || runs.iter().filter(|run| run.method == name);
            let points: Vec<_> = of_method().filter_map(Run::point).collect();
            Self { name: name.to_owned(), files: of_method().count(), order: order::fitted(&points) }
        };
        names.into_iter().map(method).collect()
    }
}

/// Run, and its order of convergence from the next larger step of the same method.
struct Ranked<'a> {
    run: &'a Run,
    order: Option<f64>,
    /// Whether the two steps are most likely wrong.
    doubtful: bool,
}

impl<'a> Ranked<'a> {
    /// Runs by method, and those of a method from the largest step; runs without a step are the last.
    fn all(runs: &'a [Run], methods: &[Method]) -> Vec<Self> {
        let mut ranked = Vec::new();
        for method in methods {
            let mut of_method: Vec<_> = runs.iter().filter(|run| run.method == method.name).collect();
            let step = |run: &Run| run.step.map_or(0.0, |(step, _)| step);
            of_method.sort_by(|a, b| step(b).total_cmp(&step(a)));
            let mut before: Option<[f64; 2]> = None;
            for run in of_method {
                let pair = before.zip(run.point());
                ranked.push(Self {
                    run,
                    order: pair.and_then(|(coarse, fine)| order::between(coarse, fine)),
                    doubtful: pair.is_some_and(|(coarse, fine)| order::is_doubtful(coarse, fine)),
                });
                before = run.point();
            }
        }
        ranked
    }

    fn doubt(&self) -> Option<String> {
        let order = self.order.filter(|_| self.doubtful)?;
        let question = match self.run.step {
            Some((_, "option")) => "do --steps belong to these files?",
            Some((_, "file")) => "do the lines # step = H belong to these files?",
            _ => "is the spacing of the rows the step? --steps states another one",
        };
        Some(format!("warning: {}: order {order:.2}: {question}", self.run.name))
    }
}

/// Unit of the work, and the runs of each method. The work is the number of evaluations of the equations if every file states it,
/// otherwise the number of steps.
fn work(runs: &[Run], methods: &[Method], period: f64) -> Result<(&'static str, Vec<MethodRuns>), Failure> {
    let counted = runs.iter().all(|run| run.evaluations.is_some());
    let of = |run: &Run| match run.step {
        _ if counted => run.evaluations,
        Some((step, _)) => Some(period / step),
        None => None,
    };
    let mut lines = Vec::new();
    for method in methods {
        let mut points = Vec::new();
        for run in runs.iter().filter(|run| run.method == method.name) {
            let work = of(run).ok_or_else(|| {
                let needed = "needs a line # evaluations = N in every file, or --steps";
                Failure::Input(format!("--plot: {}: {needed}, because its rows are uneven", run.name))
            })?;
            points.push([work, run.score.max_error]);
        }
        let order = method.order.map(|order| format!("measured order {order:.2}"));
        let name = [Some(method.name.clone()).filter(|name| !name.is_empty()), order];
        lines.push((name.into_iter().flatten().collect::<Vec<_>>().join(", "), points));
    }
    Ok((if counted { "evaluations of the equations" } else { "steps in a nutation period" }, lines))
}

fn json(scenario: &Scenario, records: &[Record], methods: &[Method]) -> std::io::Result<String> {
    let of_method = |method: &Method| {
        Record(vec![
            ("method", Cell::Text(method.name.clone())),
            ("files", Cell::Count(method.files as u64)),
            ("order", method.order.into()),
        ])
    };
    let of_methods: Vec<_> = methods.iter().map(of_method).collect();
    let only = if let [only] = methods { only.order } else { None };
    let rest = Record(vec![
        ("order", only.into()),
        ("scenario", Cell::Text(scenario.name.clone())),
        ("sign", Cell::Text("nearest".to_owned())),
    ]);
    output::json_lists(&[("files", records), ("methods", &of_methods)], &rest)
}

fn record(run: &Run, methods: &[Method]) -> Record {
    let Run { score, .. } = run;
    let (phases, drift) = (&score.phases, &score.drift);
    let drift_of = |i: usize| Cell::from(drift.integrals.map(|drifts| drifts[i]));
    let word = |word: Option<&str>| word.map_or(Cell::Absent, |word| Cell::Text(word.to_owned()));
    let order = methods.iter().find(|method| method.name == run.method).and_then(|method| method.order);
    Record(vec![
        ("name", Cell::Text(run.name.clone())),
        ("method", word(Some(&run.method[..]).filter(|name| !name.is_empty()))),
        ("rows", Cell::Count(run.rows as u64)),
        ("step", run.step.map(|(step, _)| step).into()),
        ("step_from", word(run.step.map(|(_, from)| from))),
        ("evaluations", run.evaluations.into()),
        ("max_error_rad", Cell::Number(score.max_error)),
        ("rms_error_rad", Cell::Number(score.rms_error)),
        ("final_error_rad", Cell::Number(score.final_error)),
        ("max_u_error", Cell::Number(score.max_u_error)),
        ("nutation_error_rad", phases.nutation.into()),
        ("precession_error_rad", phases.precession.into()),
        ("spin_error_rad", phases.spin.into()),
        ("residual_rad", phases.residual.into()),
        ("drift_h", drift_of(2)),
        ("drift_l", drift_of(0)),
        ("drift_n", drift_of(1)),
        ("drift_from", word(drift.from.map(source))),
        ("drift_uncertainty", drift.uncertainty.into()),
        ("max_norm_error", Cell::Number(score.norm_error)),
        ("truth_bound_rad", Cell::Number(score.truth_bound)),
        ("method_order", order.into()),
    ])
}

fn source(source: RateSource) -> &'static str {
    match source {
        RateSource::Columns => "columns",
        RateSource::Differences => "differences",
    }
}

/// Table of the errors, table of the phase errors and drifts, and the orders of convergence.
fn tables(ranked: &[Ranked<'_>], methods: &[Method]) -> String {
    let brief = |x: Option<f64>| x.map_or("-".to_owned(), |x| format!("{x:.1e}"));
    let words = |words: &[&str]| words.iter().map(|word| (*word).to_owned()).collect::<Vec<_>>();
    let mut errors =
        vec![words(&["", "rows", "step, s", "max, rad", "rms, rad", "final, rad", "u", "order"])];
    let mut details = vec![words(&["", "nutation", "precession", "spin", "residual", "h", "l", "n"])];
    for Ranked { run, order, .. } in ranked {
        let Score { max_error, rms_error, final_error, max_u_error, phases, drift, .. } = &run.score;
        let mut line = vec![run.name.clone(), run.rows.to_string()];
        line.push(run.step.map_or("-".to_owned(), |(step, _)| output::short(step, 4)));
        line.extend([max_error, rms_error, final_error, max_u_error].map(|x| brief(Some(*x))));
        line.push(order.map_or("-".to_owned(), |order| format!("{order:.2}")));
        errors.push(line);
        let [l, n, h] = [0, 1, 2].map(|i| drift.integrals.map(|drifts| drifts[i]));
        let numbers = [phases.nutation, phases.precession, phases.spin, phases.residual, h, l, n];
        details.push(std::iter::once(run.name.clone()).chain(numbers.map(brief)).collect());
    }
    let mut orders = String::new();
    for Method { name, order, .. } in methods {
        if let Some(order) = order {
            let of = if name.is_empty() { String::new() } else { format!(" of {name}") };
            orders.push_str(&format!("Order of convergence{of}: {order:.2}\n"));
        }
    }
    let scores = || ranked.iter().map(|ranked| &ranked.run.score);
    let differences = scores().any(|score| score.drift.from == Some(RateSource::Differences));
    let by = if differences {
        ", for files without angular velocity computed from differences of the error"
    } else {
        ""
    };
    let bound = scores().map(|score| score.truth_bound).fold(0.0, f64::max);
    format!(
        "Errors against the exact motion\n{}\nPhase errors over the last nutation period, rad (above 0: ahead), and relative drifts of h, l and n\n{}\n\
         {orders}The exact motion is within {bound:.1e} rad. Errors of the orientation are 2 sqrt(|d alpha|^2 + |d beta|^2) with the nearer\n\
         sign. Residual: what no phase error explains. Order: from the next larger step of the same method. Drifts: of h in units of\n\
         max(|h|, p g), of l and n in units of max(|l|, |n|, sqrt(2 A p g)){by}.\n",
        output::columns(errors, 1),
        output::columns(details, 1),
    )
}
