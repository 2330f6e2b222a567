//! Runs of integrators by method, with their orders of convergence.

use crate::Failure;
use crate::pictures::chart::Curve;
use crate::score::exact_reference::Score;
use crate::score::order;
use crate::score::trajectory::Trajectory;

/// One file with its score.
pub struct Run {
    /// Place of the file on the command line.
    pub file: usize,
    pub name: String,
    pub method: String,
    pub rows: usize,
    /// Step size, s, and its source.
    pub step: Option<(f64, &'static str)>,
    pub evaluations: Option<f64>,
    /// Time of the last row, s.
    end: f64,
    pub score: Score,
    /// Order of convergence from the next larger step.
    pub order: Option<f64>,
}

impl Run {
    /// * `step`: step size of the command line, s; without it, that of the file, or the spacing of its rows
    pub fn new(file: usize, trajectory: Trajectory, score: Score, step: Option<f64>) -> Self {
        let spacing = trajectory.spacing();
        let Trajectory { name, method, step: stated, evaluations, rows } = trajectory;
        let sources = [(step, "option"), (stated, "file"), (spacing, "rows")];
        let step = sources.into_iter().find_map(|(step, source)| Some((step?, source)));
        let (method, end) = (method.unwrap_or_default(), rows.last().map_or(0.0, |row| row.t));
        Self { file, name, method, rows: rows.len(), step, evaluations, end, score, order: None }
    }

    /// Whether another run ends at the same time: errors over different times have no order.
    fn is_as_long_as(&self, other: &Self) -> bool {
        (self.end - other.end).abs() <= 1e-6 * self.end.abs()
    }

    /// Step size and greatest error.
    fn point(&self) -> Option<[f64; 2]> {
        self.step.map(|(step, _)| [step, self.score.max_error])
    }

    /// Warning about an order below 0.
    fn warning(&self) -> Option<String> {
        let order = self.order.filter(|order| *order < 0.0)?;
        let question = match self.step {
            Some((_, "option")) => "do --steps belong to these files",
            Some((_, "file")) => "do the lines # step = H belong to these files",
            _ => "is the spacing of the rows the step (--steps states another one)",
        };
        let name = &self.name;
        Some(format!("warning: {name}: order {order:.2}: {question}, or do only rounding errors remain?"))
    }
}

/// Runs of one method.
pub struct Method {
    pub name: String,
    /// Runs from the largest step; those without a step are the last.
    pub runs: Vec<Run>,
    /// Order of convergence.
    pub order: Option<f64>,
    /// Warnings about orders.
    pub warnings: Vec<String>,
}

impl Method {
    /// Method of these runs, of which there is at least one, in the order of their files.
    pub fn new(mut runs: Vec<Run>) -> Self {
        let uneven = runs.iter().find(|run| !run.is_as_long_as(&runs[0])).map(|other| {
            format!("warning: no order: {} and {} end at different times", runs[0].name, other.name)
        });
        let step = |run: &Run| run.step.map_or(0.0, |(step, _)| step);
        runs.sort_by(|a, b| step(b).total_cmp(&step(a)));
        for i in 1..runs.len() {
            let [coarse, fine] = [&runs[i - 1], &runs[i]];
            let points = coarse.point().zip(fine.point()).filter(|_| fine.is_as_long_as(coarse));
            runs[i].order = points.and_then(|(coarse, fine)| order::between(coarse, fine));
        }
        let points: Vec<_> = runs.iter().filter_map(Run::point).collect();
        let order = order::fitted(&points).filter(|_| uneven.is_none());
        let warnings = runs.iter().filter_map(Run::warning).chain(uneven).collect();
        Self { name: runs[0].method.clone(), runs, order, warnings }
    }
}

/// Unit of the work, and a curve of greatest error against work for each method.
///
/// The work is the number of evaluations of the equations if every file states it, otherwise the number of steps.
pub fn work(methods: &[Method], period: f64) -> Result<(&'static str, Vec<Curve>), Failure> {
    let counted = methods.iter().flat_map(|method| &method.runs).all(|run| run.evaluations.is_some());
    let point = |run: &Run| {
        let steps = run.step.map(|(step, _)| period / step);
        let work = if counted { run.evaluations } else { steps }.ok_or_else(|| {
            let needed = "needs a line # evaluations = N in every file, or --steps";
            Failure::Input(format!("--plot: {}: {needed}, because its rows are uneven", run.name))
        })?;
        Ok([work, run.score.max_error])
    };
    let mut curves = Vec::new();
    for Method { name, runs, order, .. } in methods {
        let mut label = vec![name.clone()];
        label.extend(order.map(|order| format!("measured order {order:.2}")));
        label.retain(|word| !word.is_empty());
        let mut points = runs.iter().map(point).collect::<Result<Vec<_>, Failure>>()?;
        points.sort_by(|[a, _], [b, _]| a.total_cmp(b));
        curves.push(Curve::marked(label.join(", "), points));
    }
    Ok((if counted { "evaluations of the equations" } else { "steps in a nutation period" }, curves))
}
