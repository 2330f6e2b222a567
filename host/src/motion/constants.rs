//! Constants of a motion by name.

use crate::output::names;
use serde_json::Value;
use std::f64::consts::PI;
use toytop::{Motion, PeriodAdvance, Regime};
use toytop_model::constants::MotionConstants;

/// Constant: its name, its unit in a scenario in SI units, and its value; null where the motion does not have it.
pub type Constant = (&'static str, &'static str, fn(&MotionConstants) -> Value);

/// All constants. Without units in the scenario, a second stands for its unit of time.
pub const CONSTANTS: [Constant; 28] = [
    ("l", "kg m^2/s", |motion| motion.first_integrals().l.into()),
    ("n", "kg m^2/s", |motion| motion.first_integrals().n.into()),
    ("h", "kg m^2/s^2", |motion| motion.first_integrals().h.into()),
    ("e1", "", |motion| motion.branch_points().e1.into()),
    ("e2", "", |motion| motion.branch_points().e2.into()),
    // e₃ is infinite without torque, and then null
    ("e3", "", |motion| motion.branch_points().e3.into()),
    ("e4", "", |motion| motion.top().e4().into()),
    ("one_plus_e1", "", |motion| motion.branch_points().one_plus_e1.into()),
    ("one_minus_e2", "", |motion| motion.branch_points().one_minus_e2.into()),
    ("e2_minus_e1", "", |motion| motion.branch_points().e2_minus_e1.into()),
    ("e3_minus_e2", "", |motion| motion.branch_points().e3_minus_e2.into()),
    ("e3_minus_one", "", |motion| motion.branch_points().e3_minus_one.into()),
    ("regime", "", |motion| names::regime(motion.regime()).into()),
    ("period", "s", |motion| motion.period().into()),
    ("alpha_turns", "turns a period", |motion| motion.turning(|advance| advance.alpha_turns).into()),
    ("beta_turns", "turns a period", |motion| motion.turning(|advance| advance.beta_turns).into()),
    ("phi_per_period", "rad a period", |motion| phi_per_period(motion).into()),
    ("tip_class", "", |motion| names::tip_class(motion.tip_class()).into()),
    ("min_normal_force", "weights", |motion| motion.min_normal_force().into()),
    ("min_tilt_deg", "degrees", |motion| tilts(motion)[0].into()),
    ("max_tilt_deg", "degrees", |motion| tilts(motion)[1].into()),
    ("nutation_hz", "1/s", |motion| (1.0 / motion.period()).into()),
    ("mean_precession_deg_per_s", "degrees/s", |motion| (360.0 * mean_precession(motion)).into()),
    ("mean_precession_rpm", "turns/min", |motion| (60.0 * mean_precession(motion)).into()),
    ("spin_deg_per_s", "degrees/s", |motion| (360.0 * spin(motion)).into()),
    ("spin_rpm", "turns/min", |motion| (60.0 * spin(motion)).into()),
    ("critical_spin_deg_per_s", "degrees/s", |motion| (360.0 * critical_spin(motion)).into()),
    ("critical_spin_rpm", "turns/min", |motion| (60.0 * critical_spin(motion)).into()),
];

/// Least and greatest tilt of the axis, degrees.
pub fn tilts(motion: &Motion) -> [f64; 2] {
    let e = motion.branch_points();
    let tilt =
        |one_plus_e: f64, one_minus_e: f64| 2.0 * one_minus_e.sqrt().atan2(one_plus_e.sqrt()).to_degrees();
    match motion.regime() {
        Regime::Hanging => [180.0; 2],
        regime if regime.is_vertical() => [0.0; 2],
        _ => [tilt(2.0 - e.one_minus_e2, e.one_minus_e2), tilt(e.one_plus_e1, 2.0 - e.one_plus_e1)],
    }
}

/// Advance of the tip angle in a period, rad; NaN where the axis is vertical.
fn phi_per_period(motion: &MotionConstants) -> f64 {
    if motion.regime().is_vertical() { f64::NAN } else { motion.turning(PeriodAdvance::phi_per_period) }
}

/// Mean rate of the axis about the vertical, turns/s.
fn mean_precession(motion: &MotionConstants) -> f64 {
    phi_per_period(motion) / (2.0 * PI * motion.period())
}

/// Component of the angular velocity along the axis, turns/s.
fn spin(motion: &Motion) -> f64 {
    motion.first_integrals().spin / (2.0 * PI)
}

/// Spin above which an upright axis is stable, turns/s: there e₃ > 1, because n² > 4 A p g, where n = C spin + K.
fn critical_spin(motion: &Motion) -> f64 {
    let top = motion.top();
    let momentum =
        2.0 * (top.transverse_inertia() * top.mass_moment() * top.gravity()).sqrt() - top.rotor_momentum();
    momentum / top.axial_inertia() / (2.0 * PI)
}
