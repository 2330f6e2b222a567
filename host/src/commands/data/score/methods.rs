//! Runs of integrators, grouped by their methods.

use crate::Failure;
use crate::pictures::chart::Curve;
use crate::score::judge::Score;
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
}

impl Run {
    pub fn new(file: usize, trajectory: Trajectory, score: Score, step: Option<f64>) -> Self {
        let spacing = trajectory.spacing();
        let Trajectory { name, method, step: stated, evaluations, rows } = trajectory;
        let step = step.map(|step| (step, "option"));
        let step = step.or(stated.map(|step| (step, "file"))).or(spacing.map(|step| (step, "rows")));
        let end = rows.last().map_or(0.0, |row| row.t);
        Self {
            file,
            name,
            method: method.unwrap_or_default(),
            rows: rows.len(),
            step,
            evaluations,
            end,
            score,
        }
    }

    /// Whether another run ends at the same time: errors over different times have no order.
    fn is_as_long_as(&self, other: &Self) -> bool {
        (self.end - other.end).abs() <= 1e-6 * self.end.abs()
    }

    /// Step size and greatest error.
    fn point(&self) -> Option<[f64; 2]> {
        self.step.map(|(step, _)| [step, self.score.max_error])
    }
}

/// Runs of one method, from the largest step; those without a step are the last.
pub struct Group<'a> {
    pub method: &'a str,
    pub runs: Vec<&'a Run>,
    /// Run that ends at another time than the first, so that there is no order.
    uneven: Option<&'a Run>,
    /// Order of convergence.
    pub order: Option<f64>,
}

impl<'a> Group<'a> {
    pub fn new(method: &'a str, runs: &'a [Run]) -> Self {
        let mut runs: Vec<_> = runs.iter().filter(|run| run.method == method).collect();
        let first = runs[0];
        let uneven = runs.iter().copied().find(|run| !run.is_as_long_as(first));
        let step = |run: &Run| run.step.map_or(0.0, |(step, _)| step);
        runs.sort_by(|a, b| step(b).total_cmp(&step(a)));
        let points: Vec<_> = runs.iter().filter_map(|run| run.point()).collect();
        let order = order::fitted(&points).filter(|_| uneven.is_none());
        Self { method, runs, uneven, order }
    }

    /// Runs, each with the order from the next larger step.
    pub fn with_orders(&self) -> impl Iterator<Item = (&'a Run, Option<f64>)> {
        self.runs.iter().enumerate().map(|(index, run)| {
            let before = index.checked_sub(1).map(|before| self.runs[before]);
            let coarse = before.filter(|before| run.is_as_long_as(before)).and_then(Run::point);
            (*run, coarse.zip(run.point()).and_then(|(coarse, fine)| order::between(coarse, fine)))
        })
    }

    /// Warnings about orders.
    pub fn doubts(&self) -> Vec<String> {
        let negative = self.with_orders().filter_map(|(run, order)| {
            let order = order.filter(|order| *order < 0.0)?;
            let question = match run.step {
                Some((_, "option")) => "do --steps belong to these files",
                Some((_, "file")) => "do the lines # step = H belong to these files",
                _ => "is the spacing of the rows the step (--steps states another one)",
            };
            let name = &run.name;
            Some(format!("warning: {name}: order {order:.2}: {question}, or do only rounding errors remain?"))
        });
        let uneven = self.uneven.map(|other| {
            let first = self.runs.iter().min_by_key(|run| run.file).map_or("", |run| &run.name);
            format!("warning: no order: {first} and {} end at different times", other.name)
        });
        negative.chain(uneven).collect()
    }
}

/// Unit of the work, and a curve of greatest error against work for each method. The work is the number of evaluations of the equations if every file states it,
/// otherwise the number of steps.
pub fn work(groups: &[Group<'_>], period: f64) -> Result<(&'static str, Vec<Curve>), Failure> {
    let counted = groups.iter().flat_map(|group| &group.runs).all(|run| run.evaluations.is_some());
    let point = |run: &&Run| {
        let steps = run.step.map(|(step, _)| period / step);
        let work = if counted { run.evaluations } else { steps }.ok_or_else(|| {
            let needed = "needs a line # evaluations = N in every file, or --steps";
            Failure::Input(format!("--plot: {}: {needed}, because its rows are uneven", run.name))
        })?;
        Ok([work, run.score.max_error])
    };
    let line = |group: &Group<'_>| {
        let order = group.order.map(|order| format!("measured order {order:.2}"));
        let name = Some(group.method.to_owned()).filter(|name| !name.is_empty());
        let names: Vec<_> = name.into_iter().chain(order).collect();
        let mut points = group.runs.iter().map(point).collect::<Result<Vec<[f64; 2]>, Failure>>()?;
        points.sort_by(|[a, _], [b, _]| a.total_cmp(b));
        Ok(Curve::marked(names.join(", "), points))
    };
    let lines = groups.iter().map(line).collect::<Result<_, Failure>>()?;
    Ok((if counted { "evaluations of the equations" } else { "steps in a nutation period" }, lines))
}
