//! `toytop constants`: first integrals, branch points, period and mean rotations of a motion.

use super::{Report, warnings};
use crate::Failure;
use crate::input::scenario::{Scenario, Units};
use crate::motion::tilts;
use crate::output::{self, Format, Lists, Record, eight, names};
use clap::Args;
use serde_json::Value;
use std::f64::consts::PI;
use std::path::PathBuf;
use toytop::{Motion, PeriodAdvance};
use toytop_model::constants::{CONSTANTS, MotionConstants};

/// `toytop constants`
#[derive(Args)]
pub struct ConstantsArgs {
    /// Scenario file
    scenario: PathBuf,
    /// Form of the output
    #[arg(long, default_value = "table")]
    format: Format,
}

pub fn run(arguments: &ConstantsArgs) -> Result<Report, Failure> {
    let scenario = Scenario::read(&arguments.scenario)?;
    let motion = MotionConstants::new(scenario.motion);
    let record = Record(ALL.map(|(name, _)| (name, value(&motion, name))).into());
    let table = || {
        let line = |(name, unit): Constant| {
            let named = scenario.units == Units::Si
                || !(unit.contains("kg") || ["s", "1/s", "degrees/s"].contains(&unit));
            let unit = if named { unit } else { "" };
            Record::default().with("key", name).with("value", value(&motion, name)).with("unit", unit)
        };
        output::aligned(&ALL.map(line), &[("key", "", eight), ("value", "", eight), ("unit", "", eight)])
    };
    let text = output::render(arguments.format, &Lists(Vec::new(), record), table)?;
    Ok(Report::from(text).with_remarks(warnings(&[scenario]), arguments.format == Format::Table))
}

/// Name of a constant, and its unit in a scenario in SI units.
pub type Constant = (&'static str, &'static str);

/// All constants. Without units in the scenario, a second stands for its unit of time.
pub const ALL: [Constant; 28] = [
    ("l", "kg m^2/s"),
    ("n", "kg m^2/s"),
    ("h", "kg m^2/s^2"),
    ("e1", ""),
    ("e2", ""),
    ("e3", ""),
    ("e4", ""),
    ("one_plus_e1", ""),
    ("one_minus_e2", ""),
    ("e2_minus_e1", ""),
    ("e3_minus_e2", ""),
    ("e3_minus_one", ""),
    ("regime", ""),
    ("period", "s"),
    ("alpha_turns", "turns a period"),
    ("beta_turns", "turns a period"),
    ("phi_per_period", "rad a period"),
    ("tip_class", ""),
    ("min_normal_force", "weights"),
    ("min_tilt_deg", "degrees"),
    ("max_tilt_deg", "degrees"),
    ("nutation_hz", "1/s"),
    ("mean_precession_deg_per_s", "degrees/s"),
    ("mean_precession_rpm", "turns/min"),
    ("spin_deg_per_s", "degrees/s"),
    ("spin_rpm", "turns/min"),
    ("critical_spin_deg_per_s", "degrees/s"),
    ("critical_spin_rpm", "turns/min"),
];

/// Value of a constant; absent where the motion does not have it.
pub fn value(motion: &MotionConstants, name: &str) -> Value {
    let turns_per_second = match name.strip_suffix("_deg_per_s").or(name.strip_suffix("_rpm")) {
        Some("mean_precession") => mean_precession(motion),
        Some("spin") => motion.first_integrals().spin / (2.0 * PI),
        Some("critical_spin") => critical_spin(motion),
        _ => f64::NAN,
    };
    let number = match name {
        "regime" => return names::regime(motion.regime()).into(),
        "tip_class" => return names::tip_class(motion.tip_class()).into(),
        "e3_minus_e2" => motion.branch_points().e3_minus_e2,
        "phi_per_period" if motion.regime().is_vertical() => f64::NAN,
        "min_tilt_deg" => tilts(motion)[0],
        "max_tilt_deg" => tilts(motion)[1],
        "nutation_hz" => 1.0 / motion.period(),
        _ if name.ends_with("_rpm") => 60.0 * turns_per_second,
        _ if name.ends_with("_deg_per_s") => 360.0 * turns_per_second,
        _ => CONSTANTS.iter().find(|(other, _)| *other == name).map_or(f64::NAN, |(_, value)| value(motion)),
    };
    // e₃ is infinite without torque
    Some(number).filter(|number| number.is_finite()).into()
}

/// Mean rate of the axis about the vertical, turns/s.
fn mean_precession(motion: &MotionConstants) -> f64 {
    if motion.regime().is_vertical() {
        return f64::NAN;
    }
    motion.turning(PeriodAdvance::phi_per_period) / (2.0 * PI * motion.period())
}

/// Spin above which an upright axis is stable, turns/s: there e₃ > 1, because n² > 4 A p g, where n = C spin + K.
fn critical_spin(motion: &Motion) -> f64 {
    let top = motion.top();
    let momentum =
        2.0 * (top.transverse_inertia() * top.mass_moment() * top.gravity()).sqrt() - top.rotor_momentum();
    momentum / top.axial_inertia() / (2.0 * PI)
}
