//! Sensitivity: partial derivatives of a motion with respect to its launch and to the ratios of its top, at any time.
//!
//! The derivation is in `docs/partials.md`. The derivatives obey linear differential equations with the frequency of
//! the nutation, which are integrated over one period at set-up, and over at most half a period for a single time. Whole periods
//! are added exactly: each changes the derivatives by the same amount, which follows from the derivatives of the mean rates.

mod coefficients;
mod flow;

mod equations;
mod extrapolation;
mod growth;
mod losses;
mod partials;

pub(crate) use coefficients::{Coefficients, LOSSES};
pub(crate) use equations::{Acceleration, Equations};
pub(crate) use extrapolation::advance;
pub(crate) use flow::{Flow, Tangent, total};
pub use partials::Partials;
pub(crate) use partials::along;

use crate::motion::Motion;
use crate::phase::Phase;
use crate::scalar::{Extended, Float};
use crate::stepper::Stepper;

/// Number of columns of the launch.
pub(crate) const LAUNCH: usize = 6;
/// Number of columns: derivatives with respect to the rotation vector of Φ at t = 0, to ω at t = 0, and to four ratios.
pub(crate) const COLUMNS: usize = 10;

/// Error of one step of the integration relative to its result.
const TOLERANCE: f64 = 3e-13;
/// Largest number of steps for one time. Only a motion without a period, or one with A/(ps) near 0, needs many.
const MOST_STEPS: u32 = 10_000;

/// Partial derivatives of a motion with respect to its launch, as a function of time: the state transition matrix of
/// orbit determination.
///
/// There are ten derivatives, in this order, with respect to:
///
/// * the three components of the rotation vector that turns Φ(0) in the fixed frame, Φ(0) → exp(δ) Φ(0), in rad, while
///   ω(0) in the fixed frame is kept;
/// * the three components of ω(0) in the fixed frame, rad per unit time;
/// * A/C, A/(ps), s and g, while the launch and the other three are kept. For a fixed tip the length A/p takes the
///   place of A/(ps), and the derivative with respect to s is 0.
///
/// Relative to the largest derivative of the same column, the error is about 1e-12, also after 10⁶ periods.
#[derive(Clone, Copy, Debug)]
pub struct Sensitivity {
    equations: Equations<f64>,
    start: Flow<f64, COLUMNS>,
    period: Option<Period>,
    tip_scale: f64,
}

/// Effect of one nutation period.
#[derive(Clone, Copy, Debug)]
struct Period {
    /// Period T.
    length: Extended,
    /// Rotations about the vertical and about the axis in one period.
    turns: [Phase; 2],
    /// Change of the tangents by one period, in a frame that rotates with the mean precession.
    growth: [Tangent<f64>; COLUMNS],
}

impl Sensitivity {
    /// Names of the derivatives, in order.
    pub const NAMES: [&'static str; COLUMNS] = [
        "orientation_x",
        "orientation_y",
        "orientation_z",
        "omega_x",
        "omega_y",
        "omega_z",
        "inertia_ratio",
        "support_ratio",
        "com_height",
        "gravity",
    ];

    /// Sensitivity of a motion. Cost: one integration over a nutation period; none where there is no period.
    #[must_use]
    pub fn of(motion: &Motion) -> Self {
        let state = Stepper::<f64>::new(motion).attitude_state();
        let (orientation, omega) = (state.orientation, state.omega());
        let equations = Equations::of(motion.top());
        let start = Flow::launched(&orientation, omega);
        let tip_scale = motion.top().tip_scale();
        let mut sensitivity = Self { equations, start, period: None, tip_scale };
        sensitivity.period = motion.mean_motion().and_then(|mean| {
            let length = mean.advance.period;
            let turns = mean.turns(motion.half_tau());
            let [about_vertical, _] = turns;
            let mut end = advance(&equations, &start, length.to_f64(), TOLERANCE, MOST_STEPS)?;
            end.turn(-about_vertical);
            let mut growth = end.tangents;
            for (grown, initial) in growth.iter_mut().zip(&start.tangents) {
                *grown = grown.plus(initial, -1.0);
            }
            let growth = growth::projected(&equations, &start, &growth);
            Some(Period { length, turns, growth })
        });
        sensitivity
    }

    /// Sensitivity of a launch whose motion has the losses of rotation of these equations.
    pub(crate) fn losing(equations: &Equations<f64>, start: Flow<f64, COLUMNS>, tip_scale: f64) -> Self {
        Self { equations: *equations, start, period: None, tip_scale }
    }

    /// Derivatives at time t after the launch; t may be negative. `None` where t is not finite or beyond 2^52 periods, and where the
    /// integration would take more than 10 000 steps, as for a motion without a period and a far t.
    #[must_use]
    pub fn at(&self, t: f64) -> Option<Partials> {
        self.cursor().at(t)
    }

    /// Cursor, which computes the derivatives at a sequence of times, each from the time before.
    #[must_use]
    pub fn cursor(&self) -> SensitivityCursor<'_> {
        SensitivityCursor { sensitivity: self, count: 0, rest: 0.0, flow: self.start }
    }

    /// State and tangents after this number of periods, in a frame that turned with the mean precession.
    fn after_periods(&self, period: &Period, count: i64) -> Flow<f64, COLUMNS> {
        let [_, about_axis] = period.turns;
        let mut flow = self.start;
        flow.roll(about_axis.times(count));
        for (tangent, growth) in flow.tangents.iter_mut().zip(&period.growth) {
            *tangent = tangent.plus(growth, count as f64);
        }
        flow
    }
}

/// Derivatives at a sequence of times. Between two times in the same period, only the interval between them is integrated.
#[derive(Clone, Copy, Debug)]
pub struct SensitivityCursor<'a> {
    sensitivity: &'a Sensitivity,
    /// Number of whole periods that are added, and the time of the flow after them.
    count: i64,
    rest: f64,
    flow: Flow<f64, COLUMNS>,
}

impl SensitivityCursor<'_> {
    /// Derivatives at time t after the launch; as [`Sensitivity::at`].
    #[must_use]
    pub fn at(&mut self, t: f64) -> Option<Partials> {
        let Sensitivity { equations, period, tip_scale, .. } = self.sensitivity;
        if !t.is_finite() {
            return None;
        }
        let (count, rest) = match period {
            Some(period) => period.reduced(t)?,
            None => (0, t),
        };
        if let Some(period) = period
            && count != self.count
        {
            self.flow = self.sensitivity.after_periods(period, count);
            self.rest = 0.0;
            self.count = count;
        }
        self.flow = advance(equations, &self.flow, rest - self.rest, TOLERANCE, MOST_STEPS)?;
        self.rest = rest;
        let precessed = period.map_or(Phase::ZERO, |period| {
            let [about_vertical, _] = period.turns;
            about_vertical.times(count)
        });
        let mut partials = Partials::new(equations, self.flow, *tip_scale, COLUMNS);
        partials.flow.turn(precessed);
        partials.flow.roll(equations.coefficients.rolled(self.sensitivity.start.spin, rest));
        Some(partials)
    }
}

impl Period {
    /// Number of whole periods in t, to the nearest, and the remaining time; `None` beyond 2^52 periods.
    fn reduced(&self, t: f64) -> Option<(i64, f64)> {
        let count = libm::round(t / self.length.to_f64());
        if Float::abs(count) > (1_u64 << 52) as f64 {
            return None;
        }
        let rest = Extended::from(t) - self.length * Extended::from(count);
        Some((count as i64, rest.to_f64()))
    }
}
