//! `toytop constants`: first integrals, branch points, period and mean rotations of a motion.

use super::{Report, unreal};
use crate::Failure;
use crate::cli::{ConstantsArgs, Format};
use crate::input::scenario::{Scenario, Units};
use crate::output::names;
use crate::output::{self, Cell, Record, number};
use std::f64::consts::PI;
use toytop::{Motion, PeriodAdvance, Regime};

pub(super) fn run(arguments: &ConstantsArgs) -> Result<Report, Failure> {
    let scenario = Scenario::read(&arguments.scenario)?;
    let mut constants = constants(&scenario.motion);
    constants.extend(in_everyday_units(&scenario.motion));
    let record = || Record(constants.iter().map(|(key, cell, _)| (*key, cell.clone())).collect());
    let text = match arguments.format {
        Format::Table => table(&constants, scenario.units),
        Format::Csv => output::csv(&[record()]).map_err(Failure::Output)?,
        Format::Json => output::json(&record()).map_err(Failure::Output)?,
    };
    let report = Report { text, ..Report::default() };
    Ok(report.with_remarks(unreal(&[scenario]), arguments.format == Format::Table))
}

/// Key, value and unit of each constant, for a scenario in SI units.
fn constants(motion: &Motion) -> Vec<(&'static str, Cell, &'static str)> {
    let (integrals, e) = (motion.first_integrals(), motion.branch_points());
    let averages = motion.period_advance();
    let turning = |value: fn(&PeriodAdvance) -> f64| {
        averages.as_ref().map(|averages| if is_in_a_plane(motion) { 0.0 } else { value(averages) })
    };
    let phi_per_period = turning(PeriodAdvance::phi_per_period).filter(|_| !motion.regime().is_vertical());
    vec![
        ("l", Cell::Number(integrals.l), "kg m^2/s"),
        ("n", Cell::Number(integrals.n), "kg m^2/s"),
        ("h", Cell::Number(integrals.h), "kg m^2/s^2"),
        ("e1", Cell::Number(e.e1), ""),
        ("e2", Cell::Number(e.e2), ""),
        ("e3", finite(e.e3), ""),
        ("e4", motion.top().e4().into(), ""),
        ("one_plus_e1", Cell::Number(e.one_plus_e1), ""),
        ("one_minus_e2", Cell::Number(e.one_minus_e2), ""),
        ("e2_minus_e1", Cell::Number(e.e2_minus_e1), ""),
        ("e3_minus_e2", finite(e.e3_minus_e2), ""),
        ("e3_minus_one", finite(e.e3_minus_one), ""),
        ("regime", Cell::Text(names::regime(motion.regime()).to_owned()), ""),
        ("period", averages.map(|averages| averages.period).into(), "s"),
        ("alpha_turns", turning(|averages| averages.alpha_turns).into(), "turns a period"),
        ("beta_turns", turning(|averages| averages.beta_turns).into(), "turns a period"),
        ("phi_per_period", phi_per_period.into(), "rad a period"),
        ("tip_class", Cell::Text(names::tip_class(motion.tip_class()).to_owned()), ""),
        ("min_normal_force", motion.min_normal_force().into(), "weights"),
    ]
}

/// Whether the axis stays in a vertical plane: it has no momentum about the vertical, and the body none about the axis. The arguments of
/// α and β then are constant, and their mean rates exactly 0, which quadratures reach only up to rounding.
fn is_in_a_plane(motion: &Motion) -> bool {
    let integrals = motion.first_integrals();
    integrals.l == 0.0 && integrals.n == 0.0
}

/// Least and greatest tilt of the axis, degrees.
pub(super) fn tilts(motion: &Motion) -> [f64; 2] {
    let e = motion.branch_points();
    let tilt =
        |one_plus_e: f64, one_minus_e: f64| 2.0 * one_minus_e.sqrt().atan2(one_plus_e.sqrt()).to_degrees();
    match motion.regime() {
        Regime::Hanging => [180.0; 2],
        regime if regime.is_vertical() => [0.0; 2],
        _ => [tilt(2.0 - e.one_minus_e2, e.one_minus_e2), tilt(e.one_plus_e1, 2.0 - e.one_plus_e1)],
    }
}

/// Number as a cell; the cell is empty where the number is infinite, as e₃ is without torque.
fn finite(number: f64) -> Cell {
    Some(number).filter(|number| number.is_finite()).into()
}

/// Constants in degrees and turns. Without units, a second stands for the scenario's unit of time.
fn in_everyday_units(motion: &Motion) -> Vec<(&'static str, Cell, &'static str)> {
    let (top, integrals) = (motion.top(), motion.first_integrals());
    let vertical = motion.regime().is_vertical();
    let [least, greatest] = tilts(motion);
    let advance = motion.period_advance();
    let precession =
        advance.as_ref().filter(|_| !vertical).map(|a| a.phi_per_period() / (2.0 * PI * a.period));
    let precession = precession.map(|turns| if is_in_a_plane(motion) { 0.0 } else { turns });
    let (a, c) = (top.transverse_inertia(), top.axial_inertia());
    let spin = integrals.spin / (2.0 * PI);
    // for the upright axis, e3 > 1 if n² > 4 A p g, where n = C spin + K
    let critical_momentum = 2.0 * (a * top.mass_moment() * top.gravity()).sqrt();
    let critical =
        Some((critical_momentum - top.rotor_momentum()) / c / (2.0 * PI)).filter(|spin| spin.is_finite());
    let rates = |turns: Option<f64>| [360.0, 60.0].map(|unit| Cell::from(turns.map(|turns| turns * unit)));
    let [precession_deg, precession_rpm] = rates(precession);
    let [spin_deg, spin_rpm] = rates(Some(spin));
    let [critical_deg, critical_rpm] = rates(critical);
    vec![
        ("min_tilt_deg", Cell::Number(least), "degrees"),
        ("max_tilt_deg", Cell::Number(greatest), "degrees"),
        ("nutation_hz", advance.as_ref().map(|advance| 1.0 / advance.period).into(), "1/s"),
        ("mean_precession_deg_per_s", precession_deg, "degrees/s"),
        ("mean_precession_rpm", precession_rpm, "turns/min"),
        ("spin_deg_per_s", spin_deg, "degrees/s"),
        ("spin_rpm", spin_rpm, "turns/min"),
        ("critical_spin_deg_per_s", critical_deg, "degrees/s"),
        ("critical_spin_rpm", critical_rpm, "turns/min"),
    ]
}

fn table(constants: &[(&'static str, Cell, &'static str)], units: Units) -> String {
    let row = |(key, cell, unit): &(&'static str, Cell, &'static str)| {
        let unit = match units {
            Units::None
                if unit.contains("kg") || unit.ends_with('s') && *unit != "weights" && *unit != "degrees" =>
            {
                ""
            }
            _ => unit,
        };
        let value = match cell {
            Cell::Number(x) => number(*x),
            Cell::Text(word) => word.clone(),
            _ => "-".to_owned(),
        };
        vec![(*key).to_owned(), value, unit.to_owned()]
    };
    output::columns(constants.iter().map(row).collect(), 3)
}
