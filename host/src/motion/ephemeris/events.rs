//! Samples and events of an ephemeris of any scalar, in `f64`.

use crate::motion::greater;
use crate::motion::propagate::Sample;
use toytop::su2::OrientationRate;
use toytop::{Complex, EphemerisScalar, EphemerisView, Event, Level, Phase};
use toytop_model::equations::dot;

/// Sample of an ephemeris with the rates and the phase that only an ephemeris has.
pub struct TimedSample {
    /// α, β and u in the precision of the scalar; rates, tip and tip angle in that of its type for lengths and rates (`f32` for fixed
    /// point).
    pub sample: Sample,
    /// Rate Φ' of the orientation, per unit time.
    pub rate: OrientationRate<f64>,
    /// Position of the tip in units of s, c/s = 2αβ, in the precision of the scalar.
    pub tip_over_s: Complex<f64>,
    /// Nutation phase: one turn a nutation period, 0 at u = e₁.
    pub nutation_phase: Phase,
}

/// Rates at one time.
pub struct RateSample {
    /// Angular velocity ω in the fixed frame, rad per unit time.
    pub omega: [f64; 3],
    /// Angular velocity Ω in the body frame, rad per unit time.
    pub omega_body: [f64; 3],
    /// Rate u' of the cosine of the tilt, per unit time.
    pub udot: f64,
}

impl RateSample {
    /// Greatest of the differences |Δω|, |ΔΩ| and |Δu'|, rad per unit time; infinite where one of them is no number.
    pub fn distance(&self, other: &Self) -> f64 {
        let apart = |x: [f64; 3], y: [f64; 3]| norm([x[0] - y[0], x[1] - y[1], x[2] - y[2]]);
        let vectors = [apart(self.omega, other.omega), apart(self.omega_body, other.omega_body)];
        vectors.into_iter().fold(greater(0.0, (self.udot - other.udot).abs()), greater)
    }

    /// Angular speed |Ω|, rad per unit time.
    pub fn speed(&self) -> f64 {
        norm(self.omega_body)
    }
}

fn norm(x: [f64; 3]) -> f64 {
    dot(x, x).sqrt()
}

/// Event that is searched for.
#[derive(Clone, Copy, PartialEq)]
pub enum EventQuery {
    /// Turning points of u.
    Turning,
    /// Crossings of a level.
    Crossing(Level),
    /// Times at which the tip angle has this value, modulo whole turns.
    TipAngle(Phase),
}

/// Event with its time and the motion there.
pub struct FoundEvent {
    /// Time in the motion's unit.
    pub t: f64,
    /// Whether u rises there, or the tip angle; at a turning point, whether u = e₂.
    pub upward: bool,
    /// Motion at the event.
    pub state: TimedSample,
}

impl FoundEvent {
    /// Upper bound on the error of the time: that of u or of the tip angle, divided by its rate. `None` for a turning point, and where the
    /// rate is 0.
    pub fn time_error(&self, sought: &EventQuery) -> Option<f64> {
        let TimedSample { sample, rate, .. } = &self.state;
        let bound = sample.error_bound? + f64::EPSILON;
        let error = match sought {
            EventQuery::Turning => return None,
            EventQuery::Crossing(_) => bound / sample.udot.abs(),
            EventQuery::TipAngle(_) => {
                let product = sample.alpha * sample.beta;
                let change = rate.alpha * sample.beta + sample.alpha * rate.beta;
                let turning = (product.re * change.im - product.im * change.re) / product.norm_squared();
                bound / (2.0 * product.modulus() * turning.abs())
            }
        };
        Some(error).filter(|error| error.is_finite())
    }
}

/// Greatest number of consecutive events of another sense.
const MOST_UNWANTED: u32 = 10_000;

/// Events at tick `from` or later, at times that `wanted` accepts.
pub fn find<R: EphemerisScalar>(
    view: &EphemerisView<R>,
    sought: EventQuery,
    from: i64,
    wanted: &dyn Fn(f64, bool) -> bool,
    most: usize,
    state: impl Fn(&Event, f64) -> TimedSample,
) -> Vec<FoundEvent> {
    let events: Box<dyn Iterator<Item = Event>> = match sought {
        EventQuery::Turning => Box::new(view.turning_points(from)),
        EventQuery::Crossing(level) => Box::new(view.crossings(level, from)),
        EventQuery::TipAngle(angle) => Box::new(view.tip_angles(angle, from)),
    };
    let timed = events.map(|event| (view.time_of(&event), event));
    let mut unwanted = 0;
    let expected = |(t, event): &(f64, Event)| {
        unwanted = if wanted(*t, event.upward) { 0 } else { unwanted + 1 };
        unwanted < MOST_UNWANTED
    };
    let timed = timed.take_while(expected).filter(|(t, event)| wanted(*t, event.upward)).take(most);
    timed.map(|(t, event)| FoundEvent { t, upward: event.upward, state: state(&event, t) }).collect()
}
