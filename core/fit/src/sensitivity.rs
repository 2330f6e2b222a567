//! Partial derivatives of a motion at any time, with respect to its launch, to the ratios of its top, and to losses of rotation.
//!
//! Linear differential equations are integrated over one period at set-up, and over at most half a period for a time. Each whole
//! period changes the derivatives by the same amount (`docs/partials.md`).

// In the order of dependence.
mod coefficients;

mod flow;

mod equations;

mod integrals;

mod integration;

mod partials;

use crate::vector::{UNITS, Vector, cross};
pub(crate) use coefficients::{
    Coefficients, LOSS_COUNT, RATIOS, coefficients, exponents, ratios, with_coefficients,
};
pub(crate) use equations::Equations;
pub(crate) use flow::{COLUMNS, Flow, LAUNCH_COLUMNS, Tangent};
use integrals::projected;
pub(crate) use integration::steps;
pub use partials::Partials;
use toytop::scalar::{Extended, Float, Scalar};
use toytop::{Motion, Orientation, PeriodAdvance, Phase, Stepper};

/// Product of the longest step and the bound on the frequencies for an error of about 1e-12.
pub(crate) const FINE: f64 = 0.02;
/// Product of the longest step and the bound on the frequencies in a fit, where an error of 1e-9 has no effect.
pub(crate) const COARSE: f64 = 0.1;
/// Largest square of a tangent's size; the squares of larger ones would not be finite.
const LARGEST: f64 = 1e300;

/// Partial derivatives of a motion with respect to its launch, as a function of time.
///
/// There are ten derivatives, with respect to:
///
/// * the rotation vector δ in the fixed frame, Φ(0) → exp(δ) Φ(0), in rad, while ω(0) is kept;
/// * ω(0) in the fixed frame, rad per unit time;
/// * A/C, A/(ps), s and g. For a fixed tip A/p takes the place of A/(ps), and the derivative with respect to s is 0.
///
/// Relative to the largest derivative of the same column, the error is about 1e-12, also after 10⁶ periods.
#[derive(Clone, Copy, Debug)]
pub struct Sensitivity {
    equations: Equations<f64>,
    start: Flow<f64, COLUMNS>,
    period: Option<Period>,
    longest_step: f64,
}

/// Effect of one nutation period.
#[derive(Clone, Copy, Debug)]
struct Period {
    /// Period T.
    length: Extended,
    /// Rotations about the vertical and about the axis in one period.
    turns: [Phase; 2],
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

    /// Sensitivity of a motion. It takes one integration over a nutation period; none where there is no period.
    #[must_use]
    pub fn new(motion: &Motion) -> Self {
        Self::with_equations(motion, Equations::new(motion.top()), FINE)
    }

    /// Sensitivity of a motion whose last four columns are the changes of these equations.
    pub(crate) fn with_equations(motion: &Motion, equations: Equations<f64>, longest_step: f64) -> Self {
        let state = Stepper::<f64>::new(motion).attitude_state();
        let mut sensitivity = Self::launched(equations, &state.orientation, state.omega(), longest_step);
        sensitivity.period = motion.period_advance().and_then(
            |PeriodAdvance { exact_period: length, rotations: turns, .. }| {
                let start = &sensitivity.start;
                let [about_vertical, _] = turns;
                let mut end = sensitivity.moved(start, length.to_f64())?;
                end.turn(f64::sine_cosine(-about_vertical));
                let mut growth = end.tangents;
                for (grown, initial) in growth.iter_mut().zip(&start.tangents) {
                    *grown = grown.plus(initial, -1.0);
                }
                let rate = equations.frequency(start);
                Some(Period { length, turns, growth: projected(&equations.gradients(start), rate, &growth) })
            },
        );
        sensitivity
    }

    /// Sensitivity of a launch, without its period.
    pub(crate) fn launched(
        equations: Equations<f64>,
        orientation: &Orientation<f64>,
        omega: Vector<f64>,
        longest_step: f64,
    ) -> Self {
        let start = Flow::launched(orientation, omega).with_tangents(Tangent::along_axes(&UNITS));
        Self { equations, start, period: None, longest_step }
    }

    /// Flow after a time of either sign. `None` where that takes too many steps, or where a tangent has grown beyond 1e150.
    fn moved(&self, flow: &Flow<f64, COLUMNS>, span: f64) -> Option<Flow<f64, COLUMNS>> {
        let steps = steps(span, self.longest_step / self.equations.frequency(flow))?;
        let mut end = *flow;
        self.equations.advance(&mut end, span, steps);
        let is_bounded = |tangent: &Tangent<f64>| tangent.inner(tangent) < LARGEST;
        end.tangents.iter().all(is_bounded).then_some(end)
    }

    /// Derivatives at time t after the launch; t may be negative. `None` where t is not finite or beyond 2^52 periods, where a derivative
    /// is beyond 1e150, and where a motion without a period would take more than 500 000 steps.
    #[must_use]
    pub fn at(&self, t: f64) -> Option<Partials> {
        self.cursor().at(t)
    }

    /// Cursor, which computes the derivatives at a sequence of times, each from the time before.
    #[must_use]
    pub fn cursor(&self) -> SensitivityCursor<'_> {
        SensitivityCursor { sensitivity: self, count: 0, since_period: 0.0, flow: self.start }
    }
}

/// Derivatives at a sequence of times. Each is integrated from the time before.
#[derive(Clone, Copy, Debug)]
pub struct SensitivityCursor<'a> {
    sensitivity: &'a Sensitivity,
    /// Number of whole periods that are added, and the time of the flow after them.
    count: i64,
    since_period: f64,
    flow: Flow<f64, COLUMNS>,
}

impl SensitivityCursor<'_> {
    /// Derivatives at time t after the launch; as [`Sensitivity::at`].
    #[must_use]
    pub fn at(&mut self, t: f64) -> Option<Partials> {
        let mut partials = self.with_turned_omega(t)?;
        // with ω kept, a rotation δ of Φ changes ω by -δ × ω in the frame that turns by δ
        let omega = self.sensitivity.start.omega();
        if let Some((launch, _)) = partials.flow.tangents.split_first_chunk_mut::<LAUNCH_COLUMNS>() {
            let [x, y, z, by_omega @ ..] = launch;
            for (slot, unit) in [x, y, z].into_iter().zip(UNITS) {
                for (column, weight) in by_omega.iter().zip(cross(omega, unit)) {
                    *slot = slot.plus(column, weight);
                }
            }
        }
        Some(partials)
    }

    /// Derivatives at time t, those of the orientation with ω turned along: Φ(0) → exp(δ) Φ(0), ω(0) → exp(δ) ω(0).
    pub(crate) fn with_turned_omega(&mut self, t: f64) -> Option<Partials> {
        let Sensitivity { equations, start, period, .. } = self.sensitivity;
        if !t.is_finite() {
            return None;
        }
        let (count, since_period) = match period {
            Some(period) => period.reduced(t)?,
            None => (0, t),
        };
        if let Some(Period { turns: [_, about_axis], growth, .. }) = period
            && count != self.count
        {
            (self.flow, self.since_period, self.count) = (*start, 0.0, count);
            self.flow.roll(*about_axis * count);
            for (tangent, growth) in self.flow.tangents.iter_mut().zip(growth) {
                *tangent = tangent.plus(growth, count as f64);
            }
        }
        self.flow = self.sensitivity.moved(&self.flow, since_period - self.since_period)?;
        self.since_period = since_period;
        let mut flow = self.flow;
        if let Some(Period { turns: [about_vertical, _], .. }) = period {
            flow.turn(f64::sine_cosine(*about_vertical * count));
        }
        flow.roll(rolled(start.spin, &equations.coefficients, since_period));
        Some(Partials { flow, equations: *equations })
    }
}

impl Period {
    /// Number of whole periods in t, to the nearest, and the remaining time; `None` beyond 2^52 periods.
    fn reduced(&self, t: f64) -> Option<(i64, f64)> {
        let count = libm::round(t / self.length.to_f64());
        let since_period = Extended::from(t) - self.length * Extended::from(count);
        (libm::fabs(count) <= (1_u64 << 52) as f64).then(|| (count as i64, since_period.to_f64()))
    }
}

/// Angle by which the body has turned about its axis at a time, from S at the start.
pub(crate) fn rolled(spin: f64, &[.., axial, _, _]: &Coefficients, t: f64) -> Phase {
    let lost = axial * t;
    // (1 - e⁻ˣ)/x
    let mean = if lost == 0.0 { 1.0 } else { -libm::expm1(-lost) / lost };
    Phase::from_radians(spin * t * mean)
}
