//! Ephemeris of the core with as many segments as a motion needs, behind a trait that hides scalar and capacity.

mod batch;
mod events;
mod rates;
mod sizes;
mod ticks;

pub use batch::Quantity;
pub use events::{FoundEvent, Sought};
pub use rates::RateSample;
pub use sizes::{approximate, default_or_smallest, of_size, smaller, smallest, smallest_with_period};
pub use ticks::tick;
pub use ticks::{furthest_time, ticks_for, ticks_per_time};

use crate::bake::{Bake, Parts};
use crate::motion::cast;
use crate::motion::propagate::Sample;
use std::f64::consts::PI;
use toytop::scalar::Float;
use toytop::su2::OrientationRate;
use toytop::{Complex, EphemerisScalar, EphemerisView, ErrorBound, Micromath, Orientation, Phase};

/// Ephemeris of any scalar.
pub trait AnyScalar: Send + Sync {
    /// Number of segments, and of coefficients of each polynomial.
    fn size(&self) -> [usize; 2];

    /// Upper bound on the orientation error, rad.
    fn error_bound(&self) -> ErrorBound;

    /// Upper bound on the error of ω, of Ω and of u', rad per unit time.
    fn rate_error_bound(&self) -> ErrorBound;

    /// Sample of the motion t units of time after t = 0, t taken as exact.
    fn at(&self, t: f64) -> TimedSample;

    /// Writes the components of a quantity at each of these times to `out`.
    fn fill(&self, quantity: Quantity, times: &[f64], out: &mut [f64]);

    /// Sample of the motion at tick n, whose time is `t`.
    fn sample_at_tick(&self, n: i64, t: f64) -> TimedSample;

    /// Orientation, u and tip at tick n in the arithmetic of the scalar, as an interrupt computes them.
    fn at_tick(&self, n: i64) -> TickSample;

    /// Rates at tick n.
    fn rates_at_tick(&self, n: i64) -> RateSample;

    /// Events at tick `from` or later that `wanted` accepts by their time and sense, at most `count`.
    fn events(
        &self,
        sought: Sought,
        from: i64,
        wanted: &dyn Fn(f64, bool) -> bool,
        most: usize,
    ) -> Vec<FoundEvent>;

    /// Numbers of the table; `None` for a scalar whose tables cannot be written to a file.
    fn parts(&self) -> Option<Parts>;
}

/// Orientation, u and tip at a tick, in `f64` without rounding.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TickSample {
    /// Orientation Φ.
    pub orientation: Orientation<f64>,
    /// Cosine of the tilt.
    pub u: f64,
    /// Position of the tip in units of s, c/s = 2αβ.
    pub tip_over_s: Complex<f64>,
}

/// Sample of an ephemeris at a time, with its phase and the rate of the orientation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimedSample {
    /// α, β and u in the precision of the scalar; rates, tip and tip angle in that of its type for lengths and rates (`f32` for fixed
    /// point).
    pub sample: Sample,
    /// Rate Φ' of the orientation, per unit time.
    pub rate: OrientationRate<f64>,
    /// Nutation phase: one turn a nutation period, 0 at u = e₁.
    pub nutation_phase: Phase,
}

/// Ephemeris on the heap.
struct Boxed<R: EphemerisScalar>(Box<EphemerisView<R>>);

impl<R: BoxedScalar> Boxed<R> {
    /// Sample at time t, with its phase and the rate of the orientation.
    fn timed(&self, t: f64, now: toytop::Sample<'_, R>) -> TimedSample {
        let (orientation, state) = (now.orientation(), now.attitude_state());
        let wide = |z: Complex<R::Wide>| cast::complex(z, |x| x.to_f64());
        let phi = now.tip_angle().map(|angle| unwrapped(angle, self.0.mean_tip_angle_rate() * t));
        let sample = Sample {
            u: orientation.clamped_u().into(),
            alpha: exact(orientation.alpha),
            beta: exact(orientation.beta),
            ..Sample::of(t, &state, now.tip(), phi)
        };
        let rate = OrientationRate { alpha: wide(state.rate.alpha), beta: wide(state.rate.beta) };
        TimedSample { sample, rate, nutation_phase: now.nutation_phase() }
    }
}

impl<R: BoxedScalar> AnyScalar for Boxed<R> {
    fn size(&self) -> [usize; 2] {
        [self.0.capacity(), R::TERMS]
    }

    fn error_bound(&self) -> ErrorBound {
        self.0.error_bound()
    }

    fn rate_error_bound(&self) -> ErrorBound {
        self.0.rate_error_bound()
    }

    fn at_tick(&self, n: i64) -> TickSample {
        let orientation = self.0.at_tick(n).orientation();
        TickSample {
            orientation: Orientation { alpha: exact(orientation.alpha), beta: exact(orientation.beta) },
            u: orientation.clamped_u().into(),
            tip_over_s: exact(orientation.tip_over_s()),
        }
    }

    fn rates_at_tick(&self, n: i64) -> RateSample {
        let now = self.0.at_tick(n);
        let wide = |vector: [R::Wide; 3]| vector.map(Float::to_f64);
        RateSample { omega: wide(now.omega()), omega_body: wide(now.omega_body()), udot: now.udot().to_f64() }
    }

    fn at(&self, t: f64) -> TimedSample {
        self.timed(t, self.0.at(t))
    }

    fn fill(&self, quantity: Quantity, times: &[f64], out: &mut [f64]) {
        self.fill_with(quantity, times, out);
    }

    fn sample_at_tick(&self, n: i64, t: f64) -> TimedSample {
        self.timed(t, self.0.at_tick(n))
    }

    fn events(
        &self,
        sought: Sought,
        from: i64,
        wanted: &dyn Fn(f64, bool) -> bool,
        most: usize,
    ) -> Vec<FoundEvent> {
        events::found(&self.0, sought, from, wanted, most, |event, t| self.timed(t, self.0.at_event(event)))
    }

    fn parts(&self) -> Option<Parts> {
        R::parts(&self.0)
    }
}

/// Angle in radians of a phase known modulo 2^32 turns, nearest to `near`, a number of turns.
fn unwrapped(phase: Phase, near: f64) -> f64 {
    const MODULUS: f64 = (1_u64 << 32) as f64;
    let turns = phase.to_f64();
    2.0 * PI * (turns + MODULUS * ((near - turns) / MODULUS).round())
}

fn exact<R: Into<f64>>(z: Complex<R>) -> Complex<f64> {
    cast::complex(z, Into::into)
}

/// Scalar of an ephemeris on the heap.
trait BoxedScalar:
    EphemerisScalar<Segment: Send + Sync, Wide: Send + Sync> + Into<f64> + Send + Sync + 'static
{
    /// Numbers of a table; `None` for a scalar whose tables cannot be written to a file.
    fn parts(_: &EphemerisView<Self>) -> Option<Parts> {
        None
    }
}

impl BoxedScalar for Micromath {}

macro_rules! baked {
    ($($scalar:ty)*) => { $(
        impl BoxedScalar for $scalar {
            fn parts(table: &EphemerisView<Self>) -> Option<Parts> {
                Some(<Self as Bake>::parts(table))
            }
        }
    )* };
}

baked!(f64 f32 fixed::types::I2F30 fixed::types::I2F14);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::propagate::period;
    use toytop::{Motion, Signs, Start, Top, TopParameters};

    pub(super) fn motion(a: f64, e: [f64; 3]) -> Motion {
        let top = Top::sliding(&TopParameters {
            transverse_inertia: a,
            axial_inertia: 0.8 * a,
            com_height: 1.0,
            mass_moment: 1.0,
            gravity: 1.0,
            ..TopParameters::default()
        })
        .unwrap();
        Motion::from_branch_points(&top, e, Signs::default(), &Start::default()).unwrap()
    }

    #[test]
    fn a_tick_is_shorter_than_a_turn_and_a_thousandth_of_a_period() {
        for motion in
            [motion(1.0, [0.2, 0.8, 1.5]), motion(1e-6, [0.2, 0.8, 1e6]), motion(1e9, [0.2, 0.8, 1.5])]
        {
            let rate = ticks_per_time(&motion);
            assert!(rate * period(&motion) >= 1000.0 && rate.log2().fract() == 0.0);
            assert!(furthest_time(&motion) / period(&motion) >= 1e10);
        }
    }
}
