//! Ephemeris of the core with as many segments as a motion needs, behind a trait that hides scalar and capacity.

mod aperiodic;
mod events;
mod sizes;
mod table_data;

pub use events::{EventFilter, EventKind, FoundEvent, search};
pub use sizes::{ephemeris_of_size, ephemeris_with_truncation, smallest_ephemeris};
pub use table_data::TableData;

use crate::motion::column::{Numbers, SampleColumn};
use crate::motion::sample::{Sample, body_rates};
use crate::motion::widened;
use events::Condition;
use std::f64::consts::TAU;
use table_data::TableScalar;
use toytop::scalar::Float;
use toytop::{EphemerisMemory, EphemerisScalar, EphemerisView, ErrorBound, Orientation, Phase, Pose};
use toytop_model::equations::BodyRates;

/// Ephemeris of any scalar.
pub trait DynEphemeris: Send + Sync {
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
    fn at(&self, t: f64) -> Sample;

    /// Sample of the motion at tick n.
    fn at_tick(&self, n: i64) -> Sample;

    /// Part [`Sample::pose`] of a sample.
    fn pose(&self, t: f64) -> Pose<f64, f64> {
        self.at(t).pose
    }

    /// Part [`Sample::rates`] of a sample.
    fn rates(&self, t: f64) -> BodyRates {
        self.at(t).rates
    }

    /// Writes one column at each time; computes only the part of a sample that it needs.
    fn fill(&self, column: SampleColumn, times: &[f64], rows: &mut [f64]) {
        let rows = times.iter().zip(rows.chunks_exact_mut(column.names().1.len()));
        match column.numbers() {
            Numbers::OfPose(write) => rows.for_each(|(t, row)| write(&self.pose(*t), row)),
            Numbers::OfRates(write) => rows.for_each(|(t, row)| write(&self.rates(*t), row)),
            Numbers::OfSample(write) => rows.for_each(|(t, row)| write(&self.at(*t), row)),
        }
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

/// Ephemeris on the heap.
struct HeapEphemeris<R: EphemerisScalar>(Box<EphemerisMemory<EphemerisView<R>>>);

impl<R: EphemerisScalar> HeapEphemeris<R> {
    fn table(&self) -> &EphemerisView<R> {
        self.0.get().expect("set up")
    }

    /// Sample at time t, which is this number of ticks.
    fn sample(&self, t: f64, ticks: f64, now: &toytop::Sample<'_, R>) -> Sample {
        let turns = self.table().mean_tip_angle_rate() * t;
        Sample {
            t,
            pose: pose(now),
            rates: body_rates(&now.attitude_state()),
            tip_angle: now.tip_angle().map(|angle| unwrapped(angle, turns)),
            error_bound: Some(self.table().error_bound().after(ticks)),
        }
    }
}

impl<R: TableScalar> DynEphemeris for HeapEphemeris<R> {
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

    fn at(&self, t: f64) -> Sample {
        self.sample(t, t * self.ticks_per_time(), &self.table().at(t))
    }

    fn at_tick(&self, n: i64) -> Sample {
        self.sample(n as f64 / self.ticks_per_time(), n as f64, &self.table().at_tick(n))
    }

    fn pose(&self, t: f64) -> Pose<f64, f64> {
        pose(&self.table().at(t))
    }

    fn rates(&self, t: f64) -> BodyRates {
        body_rates(&self.table().at(t).attitude_state())
    }

    fn events(&self, condition: Condition, filter: &EventFilter) -> Vec<FoundEvent> {
        let table = self.table();
        let sample = |event: &_, t| self.sample(t, t * self.ticks_per_time(), &table.at_event(event));
        events::of_table(table, condition, filter, sample)
    }

    fn data(&self) -> Option<TableData> {
        Some(R::data(self.table()))
    }
}

fn pose<R: EphemerisScalar>(now: &toytop::Sample<'_, R>) -> Pose<f64, f64> {
    let Pose { orientation: Orientation { alpha, beta }, u, tip } = now.pose();
    let [alpha, beta] = [alpha, beta].map(|z| widened(z, Into::into));
    Pose { orientation: Orientation { alpha, beta }, u: u.into(), tip: widened(tip, Float::to_f64) }
}

/// Angle in radians of a phase known modulo 2^32 turns, nearest to `near`, a number of turns.
fn unwrapped(phase: Phase, near: f64) -> f64 {
    const MODULUS: f64 = (1_u64 << 32) as f64;
    let turns = phase.to_turns();
    TAU * (turns + MODULUS * ((near - turns) / MODULUS).round())
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
            let (rate, period) = (constants.ticks_per_time(), constants.period_or_natural_time());
            assert!(rate * period >= 1000.0 && rate.log2().fract() == 0.0);
            assert!(furthest_time(rate) / period >= 1e10);
        }
    }
}
