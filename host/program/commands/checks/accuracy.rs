//! `toytop accuracy`: error of each scalar at ticks 1 to 2^40, against the truth to thirty digits.

use crate::arguments::options::{Scalars, scalars};
use crate::files::doc_page::DocPage;
use crate::terminal::parallel::map_with_progress;
use crate::terminal::report::Report;
use crate::terminal::table::TextTable;
use clap::Args;
use micromath::F32Ext;
use serde::Serialize;
use serde_json::json;
use std::iter::once;
use toytop::{InitialAngles, Regime, Support, TopParameters};
use toytop_host::Failure;
use toytop_host::input::builtin;
use toytop_host::input::scenario::{Launch, MotionInput, Scenario};
use toytop_host::motion::Scalar;
use toytop_host::motion::errors::Errors;
use toytop_host::motion::evaluator::MotionEvaluator;
use toytop_host::output::{self, Format};
use toytop_host::random::Random;
use toytop_host::reference::float640::{from_f64, from_i64};
use toytop_host::reference::quadrature::Quadrature;

/// Errors of each scalar up to tick 2^40
#[derive(Args)]
#[command(after_help = "Example: toytop accuracy --scalar f32,q31")]
pub struct AccuracyArgs {
    /// Scalar types
    #[arg(long, value_name = "LIST", default_value = "all", value_parser = scalars)]
    scalar: Scalars,
    /// Rewrite the table of host/docs/accuracy.md
    #[arg(long, conflicts_with = "scalar")]
    accept: bool,
    /// Form of the output
    #[arg(long, default_value = "table")]
    format: Format,
}

/// Errors of a scalar. The names are the keys of JSON.
#[derive(Serialize)]
struct ScalarErrors {
    /// Name of the scalar.
    scalar: &'static str,
    /// Greatest error of the orientation, rad.
    max_orientation_error_rad: f64,
    /// Greatest error of the tip in units of s.
    max_tip_error_per_s: f64,
    /// Greatest error of the norm.
    max_norm_defect: f64,
    /// Greatest drift of the energy.
    max_energy_defect: f64,
    /// First tick of the octave.
    first_tick: u64,
    /// Last tick of the octave.
    last_tick: u64,
}

/// Headings of the scalar and of its errors.
const HEADINGS: [&str; 5] = ["", "greatest error, rad", "tip, s", "norm", "energy"];

/// Binary logarithm of the last tick.
const OCTAVES: usize = 40;

/// Number of ticks in each octave that are evaluated for each motion.
const TICKS: u64 = 16;

pub fn run(arguments: &AccuracyArgs) -> Result<Report, Failure> {
    let page = || DocPage::read("host/docs/accuracy.md", "toytop accuracy: scalars");
    let page = arguments.accept.then(page).transpose()?;
    let Scalars(scalars) = &arguments.scalar;
    let (mut totals, mut rows) = (Vec::new(), Vec::new());
    for (scalar, octaves) in scalars.iter().zip(errors_by_octave(scalars)?) {
        for (octave, errors) in octaves.iter().enumerate() {
            let first_tick = 1 << octave;
            let last_tick = if octave < OCTAVES { 2 * first_tick - 1 } else { first_tick };
            rows.push(ScalarErrors {
                scalar: scalar.name(),
                max_orientation_error_rad: errors.orientation,
                max_tip_error_per_s: errors.tip,
                max_norm_defect: errors.norm,
                max_energy_defect: errors.drift.h,
                first_tick,
                last_tick,
            });
        }
        totals.push((scalar.name(), octaves.into_iter().fold(Errors::default(), Errors::greater)));
    }
    let table_of_totals = |text: fn(f64) -> String| {
        let line = |(scalar, errors): &(&str, Errors)| {
            let errors = [errors.orientation, errors.tip, errors.norm, errors.drift.h];
            once((*scalar).to_owned()).chain(errors.map(text))
        };
        TextTable::new(1, HEADINGS, totals.iter().map(line))
    };
    let micromath = format!(
        "The sine of micromath, an approximation for f32, is off by up to {:.0e}.\n",
        error_of_micromath()
    );
    let table = || {
        format!(
            "{}\nThe table in each scalar, over ticks from 1 to 2^{OCTAVES}, against the truth to thirty digits. Tip: in units of s. Norm:\n\
             of alpha and beta. Energy: from alpha, beta and their rates (in fixed point, f32), relative. CSV and JSON have the\n\
             errors over each octave of ticks. {micromath}",
            table_of_totals(output::error_text).aligned(),
        )
    };
    let text = output::render(arguments.format, &json!({ "rows": rows }), &rows, table);
    if let Some(page) = page {
        let table = table_of_totals(|x| format!("{x:.0e}")).markdown();
        page.write(&format!("{table}\n{micromath}"))?;
    }
    Ok(text.into())
}

/// Greatest error of micromath's sine over one turn.
fn error_of_micromath() -> f64 {
    let error = |x: f32| (f64::from(F32Ext::sin(x)) - f64::from(x).sin()).abs();
    (0..=u16::MAX).map(|i| error(1e-4 * f32::from(i))).fold(0.0, f64::max)
}

/// Errors of each scalar over all motions: at ticks from 2^k to 2^(k+1) - 1 for each k below [`OCTAVES`], and at tick 2^40.
fn errors_by_octave(scalars: &[Scalar]) -> Result<Vec<Vec<Errors>>, Failure> {
    let motions: Vec<_> = builtin::scenarios().iter().filter_map(input_of).collect();
    let errors = |motion: u64| errors_of_motion(&motions[motion as usize], scalars);
    let mut greatest = vec![vec![Errors::default(); OCTAVES + 1]; scalars.len()];
    for errors in map_with_progress(motions.len() as u64, "motions", errors)? {
        greatest.iter_mut().flatten().zip(errors?.iter().flatten()).for_each(|(a, b)| *a = a.greater(*b));
    }
    Ok(greatest)
}

/// Input of a motion that nutates and whose tip slides, launched at u = e₁.
fn input_of(scenario: &Scenario) -> Option<MotionInput> {
    let motion = &scenario.motion;
    let (top, e) = (motion.top(), motion.branch_points());
    let known = motion.regime() == Regime::Nutating && top.support() == Support::Sliding;
    let phases = InitialAngles::default();
    known.then(|| MotionInput {
        top: TopParameters { mass: 0.0, mass_moment: top.mass_moment(), ..scenario.input.top },
        launch: Launch::BranchPoints { e: [e.e1, e.e2, e.e3], signs: motion.signs(), phases },
        ..scenario.input
    })
}

/// Errors of each scalar on a motion, by octave.
fn errors_of_motion(input: &MotionInput, scalars: &[Scalar]) -> Result<Vec<Vec<Errors>>, Failure> {
    let motion = input.motion().map_err(|error| Failure::from(error).at(format!("{input:?}")))?;
    let evaluators =
        scalars.iter().map(|&scalar| MotionEvaluator::new(&motion, scalar)).collect::<Result<Vec<_>, _>>()?;
    let truth = Quadrature::new(input);
    let rate = motion.ticks_per_time();
    let mut random = Random::new(1, 0);
    let mut errors = vec![vec![Errors::default(); OCTAVES + 1]; scalars.len()];
    for octave in 0..=OCTAVES {
        let first = 1_u64 << octave;
        for _ in 0..TICKS.min(first) {
            let more = if octave < OCTAVES { random.uniform() * first as f64 } else { 0.0 };
            let n = (first + more as u64) as i64;
            let exact = truth.at(&(from_i64(n) / from_f64(rate)));
            for (table, octaves) in evaluators.iter().zip(&mut errors) {
                let sample = table.at_tick(n);
                let (orientation, rounded) = (sample.orientation, exact.to_f64());
                // in fixed point the tip of a sample is rounded to f32
                let tip = (orientation.tip_over_s() - rounded.tip_over_s()).modulus();
                let orientation = exact.error_of(&orientation);
                let errors = Errors { orientation, tip, ..Errors::between(&motion, &sample, &rounded) };
                octaves[octave] = octaves[octave].greater(errors);
            }
        }
    }
    Ok(errors)
}
