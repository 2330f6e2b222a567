//! Partial derivatives of a motion at any time, with respect to its launch, to the ratios of its top, and to losses of rotation.
//!
//! Linear differential equations are integrated over one period at set-up, and over at most half a period for a time. Each whole
//! period changes the derivatives by the same amount ([partials](crate::partials)).

// In the order of dependence.
mod coefficients;

mod state;

mod equations;

mod integrals;

mod sixth_order;

mod partials;

mod trajectory;

pub(crate) use coefficients::{Coefficients, LOSS_COUNT, RATIOS, log_derivatives};
pub(crate) use equations::Equations;
use integrals::projected;
pub use partials::Partials;
pub(crate) use state::{BodyState, COLUMNS, LAUNCH_COLUMNS, Tangent};
use toytop::internal::period_and_rotations;
use toytop::scalar::{Extended, Float};
use toytop::{Motion, Phase};
pub(crate) use trajectory::Trajectory;

/// Longest step, in rad of the highest frequency.
const SENSITIVITY_STEP: f64 = 0.02;
/// Longest step for a motion that was fitted, in the same unit. An error of 1e-9 has no effect there.
pub(crate) const FITTED_STEP: f64 = 0.1;
/// Longest step of a pass over measurements, in the same unit. The error of the derivatives is below 2e-3 in `f32`.
pub(crate) const PASS_STEP: f64 = 0.4;

/// Partial derivatives of a motion with respect to its launch, as a function of time.
///
/// There are ten derivatives, with respect to:
///
/// * the rotation vector δ in the fixed frame, in rad, which turns the whole launch: exp(δ) Φ(0) and exp(δ) ω(0);
/// * ω(0) in the fixed frame, rad per unit time;
/// * A/C, A/(ps), s and g. For a fixed tip A/p takes the place of A/(ps), and the derivative with respect to s is 0.
///
/// The error of a change of the motion is below 1e-10 of its size, also after 10⁶ periods.
#[derive(Clone, Copy, Debug)]
pub struct Sensitivity {
    start: Trajectory<f64>,
    period: Option<PeriodEffect>,
    /// Trajectory from which the next time is reached, and the number of whole periods that are added to its time.
    trajectory: Trajectory<f64>,
    count: i64,
}

/// Effect of one nutation period.
#[derive(Clone, Copy, Debug)]
struct PeriodEffect {
    /// Period T.
    length: Extended,
    /// Rotations about the vertical and about the axis in one period.
    rotations: [Phase; 2],
    /// Change of the tangents by one period, in a frame that turns with the mean precession.
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

    /// Sensitivity of a motion. If the motion has a nutation period, one period is integrated.
    #[must_use]
    pub fn new(motion: &Motion) -> Self {
        Self::with_equations(motion, &Equations::new(motion.top()), SENSITIVITY_STEP)
    }

    /// Sensitivity of a motion whose last four columns are the changes of these equations.
    pub(crate) fn with_equations(motion: &Motion, equations: &Equations<f64>, longest_step: f64) -> Self {
        let attitude = motion.attitude_at_launch();
        let launch = BodyState::new(attitude.orientation, attitude.omega());
        let launched = Self::without_period(equations, &launch, longest_step);
        let start = launched.start;
        let period = period_and_rotations(motion).and_then(|(length, rotations)| {
            let [about_vertical, _] = rotations;
            let mut end = start.at(length.to_f64())?.now;
            end.turn(-about_vertical);
            let mut growth = end.tangents;
            for (grown, initial) in growth.iter_mut().zip(&start.now.tangents) {
                *grown = grown.plus(initial, -1.0);
            }
            let growth = projected(&equations.gradients(&launch), equations.frequency(&launch), &growth);
            Some(PeriodEffect { length, rotations, growth })
        });
        Self { period, ..launched }
    }

    /// Sensitivity of a launch, without its period.
    pub(crate) fn without_period(
        equations: &Equations<f64>,
        launch: &BodyState<f64>,
        longest_step: f64,
    ) -> Self {
        let start = Trajectory::new(launch, equations, longest_step);
        Self { start, period: None, trajectory: start, count: 0 }
    }

    /// Derivatives at time t after the launch; t may be negative. `None` where t is not finite or beyond 2^52 periods, where a derivative
    /// is beyond 1e150, and where a motion without a period would take more than 200 000 steps.
    #[must_use]
    pub fn at(&self, t: f64) -> Option<Partials> {
        Self { trajectory: self.start, count: 0, ..*self }.advance_to(t)
    }

    /// Derivatives as by [`Sensitivity::at`], integrated from the time of the last call. This is faster for a sequence of times.
    pub fn advance_to(&mut self, t: f64) -> Option<Partials> {
        let Self { start, period, .. } = self;
        if !t.is_finite() {
            return None;
        }
        let Some(period) = period else {
            self.trajectory = self.trajectory.at(t)?;
            return Some(self.trajectory.now);
        };
        let (count, since_period) = period.reduced(t)?;
        let [about_vertical, about_axis] = period.rotations;
        if count != self.count {
            let mut tangents = start.now.tangents;
            for (tangent, growth) in tangents.iter_mut().zip(&period.growth) {
                *tangent = tangent.plus(growth, count as f64);
            }
            (self.trajectory, self.count) = (start.relaunched(about_axis * count, tangents), count);
        }
        self.trajectory = self.trajectory.at(since_period)?;
        let mut partials = self.trajectory.now;
        partials.turn(about_vertical * count);
        Some(partials)
    }
}

impl PeriodEffect {
    /// Number of whole periods in t, to the nearest, and the remaining time; `None` beyond 2^52 periods.
    fn reduced(&self, t: f64) -> Option<(i64, f64)> {
        let count = libm::round(t / self.length.to_f64());
        let since_period = Extended::from(t) - self.length * Extended::from(count);
        (count.abs() <= (1_u64 << 52) as f64).then(|| (count as i64, since_period.to_f64()))
    }
}
