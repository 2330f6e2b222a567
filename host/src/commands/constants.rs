//! `toytop constants`: what does not change in a motion.

use super::{Report, unreal};
use crate::Failure;
use crate::cli::{ConstantsArgs, Format};
use crate::input::scenario::Scenario;
use crate::output::names;
use crate::output::{self, Cell, Record, number};
use toytop::{Motion, PeriodAdvance};

pub(super) fn run(arguments: &ConstantsArgs) -> Result<Report, Failure> {
    let scenario = Scenario::read(&arguments.scenario)?;
    let constants = constants(&scenario.motion);
    let record = || Record(constants.iter().map(|(key, cell, _)| (*key, cell.clone())).collect());
    let text = match arguments.format {
        Format::Table => table(&constants),
        Format::Csv => output::csv(&[record()]).map_err(Failure::Output)?,
        Format::Json => output::json(&record()).map_err(Failure::Output)?,
    };
    let report = Report { text, ..Report::default() };
    Ok(report.with_remarks(unreal(&[scenario]), arguments.format == Format::Table))
}

/// Key, value, unit. The units are those of a scenario in SI.
fn constants(motion: &Motion) -> Vec<(&'static str, Cell, &'static str)> {
    let (integrals, e) = (motion.first_integrals(), motion.branch_points());
    let averages = motion.period_advance();
    let average = |value: fn(&PeriodAdvance) -> f64| averages.as_ref().map(value);
    let phi_per_period = average(PeriodAdvance::phi_per_period).filter(|_| !motion.regime().is_vertical());
    vec![
        ("l", Cell::Number(integrals.l), "kg m^2/s"),
        ("n", Cell::Number(integrals.n), "kg m^2/s"),
        ("h", Cell::Number(integrals.h), "kg m^2/s^2"),
        ("e1", Cell::Number(e.e1), ""),
        ("e2", Cell::Number(e.e2), ""),
        ("e3", Cell::Number(e.e3), ""),
        ("e4", motion.top().e4().into(), ""),
        ("one_plus_e1", Cell::Number(e.one_plus_e1), ""),
        ("one_minus_e2", Cell::Number(e.one_minus_e2), ""),
        ("e2_minus_e1", Cell::Number(e.e2_minus_e1), ""),
        ("e3_minus_e2", Cell::Number(e.e3_minus_e2), ""),
        ("e3_minus_one", Cell::Number(e.e3_minus_one), ""),
        ("regime", Cell::Text(names::regime(motion.regime()).to_owned()), ""),
        ("period", average(|averages| averages.period).into(), "s"),
        ("alpha_turns", average(|averages| averages.alpha_turns).into(), "turns a period"),
        ("beta_turns", average(|averages| averages.beta_turns).into(), "turns a period"),
        ("phi_per_period", phi_per_period.into(), "rad a period"),
        ("tip_class", Cell::Text(names::tip_class(motion.tip_class()).to_owned()), ""),
        ("min_normal_force", motion.min_normal_force().into(), "weights"),
    ]
}

fn table(constants: &[(&'static str, Cell, &'static str)]) -> String {
    let row = |(key, cell, unit): &(&'static str, Cell, &'static str)| {
        let value = match cell {
            Cell::Number(x) => number(*x),
            Cell::Text(word) => word.clone(),
            _ => "-".to_owned(),
        };
        vec![(*key).to_owned(), value, (*unit).to_owned()]
    };
    output::columns(constants.iter().map(row).collect(), 3)
}
