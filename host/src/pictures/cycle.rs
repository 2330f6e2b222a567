//! Time in which a motion repeats itself, by which the number of points of a picture is chosen.

use crate::motion::propagate::{natural_time, period};
use std::f64::consts::PI;
use toytop::{Motion, Regime};

/// Time in which tilt and azimuth of the axis do the same again, with its name in messages.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Cycle {
    /// Length, s.
    pub(crate) time: f64,
    /// Name in the plural.
    #[cfg_attr(not(feature = "program"), allow(dead_code))]
    pub(crate) name: &'static str,
}

impl Cycle {
    /// Nutation period; a turn about the vertical where the tilt is constant; the natural time of an aperiodic motion. `None` where
    /// the axis is at rest.
    #[must_use]
    pub(crate) fn of(motion: &Motion) -> Option<Self> {
        match motion.regime() {
            Regime::Nutating => Some(Self { time: period(motion), name: "nutation periods" }),
            Regime::Aperiodic => {
                Some(Self { time: natural_time(motion), name: "times 2 pi sqrt((A/p + s)/g)" })
            }
            regime if regime.is_regular_precession() => {
                let time = turn(motion)?;
                Some(Self { time, name: "turns about the vertical" })
            }
            _ => None,
        }
    }
}

/// Mean time in which the axis goes once round the vertical, s; `None` where it does not.
pub(crate) fn turn(motion: &Motion) -> Option<f64> {
    let advance = motion.period_advance()?;
    let rate = advance.phi_per_period().abs() / advance.period;
    (rate > 0.0 && !motion.regime().is_vertical()).then(|| 2.0 * PI / rate)
}
