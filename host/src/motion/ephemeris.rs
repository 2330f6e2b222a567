//! Ephemeris of the core with as many segments as a motion needs, behind a trait that hides scalar and capacity.

mod aperiodic;
mod events;
mod sizes;
mod table_data;

pub use events::{EventFilter, EventKind, FoundEvent, search};
pub use sizes::{CAPACITIES, approximate, ephemeris_of_size, sizes, smallest_ephemeris};
pub use table_data::TableData;

use crate::motion::errors::greater;
use crate::motion::propagate::Sample;
use crate::motion::quantity::Quantity;
use crate::motion::widened;
use events::Condition;
use std::f64::consts::TAU;
use table_data::TableScalar;
use toytop::scalar::Float;
use toytop::su2::OrientationRate;
use toytop::{Complex, EphemerisMemory, EphemerisScalar, EphemerisView, ErrorBound, Phase};
use toytop_model::equations::dot;

/// Sample of an ephemeris with the rates and the phase that only an ephemeris has.
pub struct EphemerisSample {
    /// Sample in `f64`. α, β and u have the precision of the scalar, and rates, tip and tip angle of its quantities (`f32` for fixed point).
    pub sample: Sample,
    /// Rate Φ' of the orientation, per unit time.
    pub rate: OrientationRate<f64>,
    /// Position of the tip in units of s, c/s = 2αβ, in the precision of the scalar.
    pub tip_over_s: Complex<f64>,
    /// Nutation phase: one turn a nutation period, 0 at u = e₁.
    pub nutation_phase: Phase,
}

/// Rates at one time.
pub struct Rates {
    /// Angular velocity ω in the fixed frame, rad per unit time.
    pub omega: [f64; 3],
    /// Angular velocity Ω in the body frame, rad per unit time.
    pub omega_body: [f64; 3],
    /// Rate u' of the cosine of the tilt, per unit time.
    pub udot: f64,
}

impl Rates {
    /// Greatest of the differences |Δω|, |ΔΩ| and |Δu'|, rad per unit time; infinite where one of them is no number.
    pub fn distance(&self, other: &Self) -> f64 {
        let apart = |x: [f64; 3], y: [f64; 3]| length([x[0] - y[0], x[1] - y[1], x[2] - y[2]]);
        let vectors = [apart(self.omega, other.omega), apart(self.omega_body, other.omega_body)];
        vectors.into_iter().fold(greater(0.0, (self.udot - other.udot).abs()), greater)
    }

    /// Angular speed |Ω|, rad per unit time.
    pub fn speed(&self) -> f64 {
        length(self.omega_body)
    }
}

fn length(x: [f64; 3]) -> f64 {
    dot(x, x).sqrt()
}

/// Ephemeris of any scalar.
pub trait AnyEphemeris: Send + Sync {
    /// Number of segments, and of coefficients of each polynomial.
    fn size(&self) -> [usize; 2];

    /// Ticks in a unit of time.
    fn ticks_per_time(&self) -> f64;

    /// Greatest distance of a time from t = 0 at which the ephemeris can be evaluated.
    fn furthest_time(&self) -> f64 {
        furthest_time(self.ticks_per_time())
    }

    /// Upper bound on the orientation error, rad.
    fn error_bound(&self) -> ErrorBound;

    /// Upper bound on the error of ω, of Ω and of u', rad per unit time.
    fn rate_error_bound(&self) -> ErrorBound;

    /// Sample of the motion t units of time after t = 0, t taken as exact.
    fn at(&self, t: f64) -> EphemerisSample;

    /// Sample of the motion at tick n.
    fn at_tick(&self, n: i64) -> EphemerisSample;

    /// Rates at tick n.
    fn rates_at_tick(&self, n: i64) -> Rates;

    /// Writes one column at each time; computes no other.
    fn fill(&self, column: Quantity, times: &[f64], rows: &mut [f64]) {
        fill_from_samples(column, times, rows, |t| self.at(t).sample);
    }

    /// First events at which a condition holds, of those that the filter accepts.
    fn events(&self, condition: Condition, filter: &EventFilter) -> Vec<FoundEvent>;

    /// Numbers of the table; `None` for a motion without one.
    fn data(&self) -> Option<TableData>;
}

/// Greatest distance of a time from t = 0 at which an ephemeris can be evaluated, because ticks are counted in 64 bits.
pub fn furthest_time(ticks_per_time: f64) -> f64 {
    62_f64.exp2() / ticks_per_time
}

/// Table on the heap, which was set up.
struct Table<R: EphemerisScalar>(Box<EphemerisMemory<EphemerisView<R>>>);

impl<R: EphemerisScalar> Table<R> {
    fn table(&self) -> &EphemerisView<R> {
        self.0.get().expect("set up")
    }

    /// Sample at time t, which is this number of ticks.
    fn timed(&self, t: f64, ticks: f64, now: toytop::Sample<'_, R>) -> EphemerisSample {
        let (orientation, state) = (now.orientation(), now.attitude_state());
        let wide = |z: Complex<R::Quantity>| widened(z, Float::to_f64);
        let phi = now.tip_angle().map(|angle| self.unwrapped(angle, t));
        EphemerisSample {
            sample: Sample {
                u: now.u().into(),
                alpha: exact(orientation.alpha),
                beta: exact(orientation.beta),
                error_bound: Some(self.table().error_bound().after(ticks)),
                ..Sample::from_state(t, &state, now.tip(), phi)
            },
            rate: OrientationRate { alpha: wide(state.rate.alpha), beta: wide(state.rate.beta) },
            tip_over_s: exact(orientation.tip_over_s()),
            nutation_phase: now.nutation_phase(),
        }
    }

    fn unwrapped(&self, angle: Phase, t: f64) -> f64 {
        unwrapped(angle, self.table().mean_tip_angle_rate() * t)
    }
}

impl<R: TableScalar> AnyEphemeris for Table<R> {
    fn size(&self) -> [usize; 2] {
        [self.table().capacity(), R::TERMS]
    }

    fn ticks_per_time(&self) -> f64 {
        let [rate, _] = self.table().clock().ticks_per_time;
        rate
    }

    fn error_bound(&self) -> ErrorBound {
        self.table().error_bound()
    }

    fn rate_error_bound(&self) -> ErrorBound {
        self.table().rate_error_bound()
    }

    fn at(&self, t: f64) -> EphemerisSample {
        self.timed(t, t * self.ticks_per_time(), self.table().at(t))
    }

    fn at_tick(&self, n: i64) -> EphemerisSample {
        self.timed(n as f64 / self.ticks_per_time(), n as f64, self.table().at_tick(n))
    }

    fn rates_at_tick(&self, n: i64) -> Rates {
        let now = self.table().at_tick(n);
        let wide = |vector: [R::Quantity; 3]| vector.map(Float::to_f64);
        Rates { omega: wide(now.omega()), omega_body: wide(now.omega_body()), udot: now.udot().to_f64() }
    }

    fn fill(&self, column: Quantity, times: &[f64], rows: &mut [f64]) {
        let (table, wide) = (self.table(), <R::Quantity as Float>::to_f64);
        match column {
            Quantity::Quaternion => fill(times, rows, |t| table.at(t).quaternion().map(Into::into)),
            Quantity::Axis => fill(times, rows, |t| table.at(t).axis().map(Into::into)),
            Quantity::U => fill(times, rows, |t| [table.at(t).u().into()]),
            Quantity::Udot => fill(times, rows, |t| [wide(table.at(t).udot())]),
            Quantity::Omega => fill(times, rows, |t| table.at(t).omega().map(wide)),
            Quantity::OmegaBody => fill(times, rows, |t| table.at(t).omega_body().map(wide)),
            Quantity::Tip => fill(times, rows, |t| {
                let tip = table.at(t).tip();
                [tip.re, tip.im].map(wide)
            }),
            Quantity::Phi => fill(times, rows, |t| {
                [table.at(t).tip_angle().map_or(f64::NAN, |angle| self.unwrapped(angle, t))]
            }),
            Quantity::ErrorBound => {
                fill(times, rows, |t| [self.error_bound().after(t * self.ticks_per_time())])
            }
            _ => fill_from_samples(column, times, rows, |t| self.at(t).sample),
        }
    }

    fn events(&self, condition: Condition, filter: &EventFilter) -> Vec<FoundEvent> {
        let table = self.table();
        let sample = |event: &_, t| self.timed(t, t * self.ticks_per_time(), table.at_event(event));
        events::of_table(table, condition, filter, sample)
    }

    fn data(&self) -> Option<TableData> {
        Some(R::data(self.table()))
    }
}

/// Rows of N numbers, one for each time.
fn fill<const N: usize>(times: &[f64], rows: &mut [f64], numbers: impl Fn(f64) -> [f64; N]) {
    for (t, row) in times.iter().zip(rows.as_chunks_mut().0) {
        *row = numbers(*t);
    }
}

/// Rows of a column's numbers, one for each time, from whole samples.
fn fill_from_samples(column: Quantity, times: &[f64], rows: &mut [f64], at: impl Fn(f64) -> Sample) {
    let (_, names) = column.names();
    for (t, row) in times.iter().zip(rows.chunks_exact_mut(names.len())) {
        row.copy_from_slice(&column.numbers(&at(*t)));
    }
}

/// Angle in radians of a phase known modulo 2^32 turns, nearest to `near`, a number of turns.
fn unwrapped(phase: Phase, near: f64) -> f64 {
    const MODULUS: f64 = (1_u64 << 32) as f64;
    let turns = phase.to_turns();
    TAU * (turns + MODULUS * ((near - turns) / MODULUS).round())
}

fn exact<R: Into<f64>>(z: Complex<R>) -> Complex<f64> {
    widened(z, Into::into)
}

#[cfg(test)]
mod tests {
    use super::*;
    use toytop::{InitialAngles, Motion, Signs, Top, TopParameters};
    use toytop_model::constants::MotionConstants;

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
        Motion::from_branch_points(&top, e, Signs::default(), &InitialAngles::default()).unwrap()
    }

    #[test]
    fn a_tick_is_shorter_than_a_turn_and_a_thousandth_of_a_period() {
        for motion in
            [motion(1.0, [0.2, 0.8, 1.5]), motion(1e-6, [0.2, 0.8, 1e6]), motion(1e9, [0.2, 0.8, 1.5])]
        {
            let constants = MotionConstants::new(motion);
            let (rate, period) = (constants.ticks_per_time(), constants.nutation_period());
            assert!(rate * period >= 1000.0 && rate.log2().fract() == 0.0);
            assert!(furthest_time(rate) / period >= 1e10);
        }
    }
}
