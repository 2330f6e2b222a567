//! Duration that a picture of a motion shows.

use crate::motion_with_period::MotionWithPeriod;
use core::f64::consts::PI;
use toytop::Regime;
use toytop::scalar::Float;

/// Time that a picture of a motion covers, s: a whole number of nutation periods, one turn where the tilt is constant, or the time until
/// the tip of an aperiodic motion stays at the centre.
///
/// * `tip_distance`: distance of the tip from the centre at a time, which only an aperiodic motion needs
pub fn display_duration(motion: &MotionWithPeriod, tip_distance: impl Fn(f64) -> f64) -> f64 {
    if motion.regime() != Regime::Aperiodic {
        return cycle(motion) * f64::from(periods(motion).unwrap_or(1));
    }
    let one_plus_e1 = motion.branch_points().one_plus_e1;
    let greatest = motion.top().tip_scale() * Float::sqrt(one_plus_e1 * (2.0 - one_plus_e1));
    let step = 0.25 * motion.characteristic_time();
    let is_outside = |n: &u32| tip_distance(step * f64::from(*n)) > 4e-3 * greatest;
    step * f64::from((1..4096).rev().find(is_outside).unwrap_or(0) + 1)
}

/// Time after which the axis repeats its motion, s: the nutation period, or a turn about the vertical where the tilt is constant. A motion
/// that has neither gets its characteristic time.
pub fn cycle(motion: &MotionWithPeriod) -> f64 {
    let turn = 2.0 * PI / Float::abs(motion.phi_per_period()) * motion.period();
    match motion.regime() {
        Regime::Nutating => motion.period(),
        regime if regime.is_regular_precession() && turn.is_finite() => turn,
        _ => motion.characteristic_time(),
    }
}

/// Number of nutation periods in which the tip goes round the centre once, within limits; `None` where the motion does not nutate. At least 3
/// and at most 24; a very slow precession gets 3.
pub fn periods(motion: &MotionWithPeriod) -> Option<u32> {
    const MIN_PERIODS: u32 = 3;
    const MAX_PERIODS: u32 = 24;
    let once_round = 2.0 * PI / Float::abs(motion.phi_per_period());
    let is_slow = once_round > f64::from(4 * MAX_PERIODS);
    let mut periods = MIN_PERIODS..MAX_PERIODS;
    let enough = periods.find(|periods| is_slow || f64::from(*periods) >= once_round);
    (motion.regime() == Regime::Nutating).then_some(enough.unwrap_or(MAX_PERIODS))
}
