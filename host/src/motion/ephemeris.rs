//! Ephemeris of the core with as many segments as a motion needs, behind a trait that hides scalar and capacity.

mod aperiodic;
mod events;
mod sizes;
mod table_data;

pub use events::{EventFilter, EventKind, FoundEvent, search};
pub use sizes::{ephemeris_of_size, ephemeris_with_truncation, smallest_ephemeris};
pub use table_data::TableData;

use crate::motion::column::SampleColumn;
use crate::motion::sample::{Quantities, Sample};
use crate::motion::widened;
use events::Condition;
use std::f64::consts::TAU;
use table_data::TableScalar;
use toytop::scalar::Float;
use toytop::{EphemerisMemory, EphemerisScalar, EphemerisView, ErrorBound, Orientation, Phase, Pose};

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

    /// Calls `visit` with the quantities at a time.
    fn visit(&self, t: f64, visit: &mut dyn FnMut(&dyn Quantities)) {
        visit(&self.at(t));
    }

    /// Writes one column at each time, and computes no other.
    fn fill(&self, column: SampleColumn, times: &[f64], rows: &mut [f64]) {
        let (write, (_, names)) = (column.writer(), column.names());
        for (t, row) in times.iter().zip(rows.chunks_exact_mut(names.len())) {
            self.visit(*t, &mut |quantities| write(quantities, row));
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

    /// Quantities at time t, which is this number of ticks.
    fn quantities<'a>(&'a self, t: f64, ticks: f64, now: toytop::Sample<'a, R>) -> TableQuantities<'a, R> {
        TableQuantities { table: self.table(), t, ticks, now }
    }

    fn quantities_at(&self, t: f64) -> TableQuantities<'_, R> {
        self.quantities(t, t * self.table().clock().ticks_per_time[0], self.table().at(t))
    }
}

/// Quantities of a table at one time.
struct TableQuantities<'a, R: EphemerisScalar> {
    table: &'a EphemerisView<R>,
    t: f64,
    ticks: f64,
    now: toytop::Sample<'a, R>,
}

impl<R: EphemerisScalar> Quantities for TableQuantities<'_, R> {
    fn t(&self) -> f64 {
        self.t
    }

    fn pose(&self) -> Pose<f64, f64> {
        let Pose { orientation, u, tip } = self.now.pose();
        Pose { orientation: exact(orientation), u: u.into(), tip: widened(tip, Float::to_f64) }
    }

    fn orientation(&self) -> Orientation<f64> {
        exact(self.now.orientation())
    }

    fn omega(&self) -> [f64; 3] {
        self.now.omega().map(Float::to_f64)
    }

    fn omega_body(&self) -> [f64; 3] {
        self.now.omega_body().map(Float::to_f64)
    }

    fn udot(&self) -> f64 {
        self.now.udot().to_f64()
    }

    fn tip_angle(&self) -> Option<f64> {
        let near = self.table.mean_tip_angle_rate() * self.t;
        self.now.tip_angle().map(|angle| unwrapped(angle, near))
    }

    fn error_bound(&self) -> Option<f64> {
        Some(self.table.error_bound().after(self.ticks))
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
        self.quantities_at(t).sample()
    }

    fn at_tick(&self, n: i64) -> Sample {
        self.quantities(n as f64 / self.ticks_per_time(), n as f64, self.table().at_tick(n)).sample()
    }

    fn pose(&self, t: f64) -> Pose<f64, f64> {
        self.quantities_at(t).pose()
    }

    fn visit(&self, t: f64, visit: &mut dyn FnMut(&dyn Quantities)) {
        visit(&self.quantities_at(t));
    }

    fn events(&self, condition: Condition, filter: &EventFilter) -> Vec<FoundEvent> {
        let table = self.table();
        let sample =
            |event: &_, t| self.quantities(t, t * self.ticks_per_time(), table.at_event(event)).sample();
        events::of_table(table, condition, filter, sample)
    }

    fn data(&self) -> Option<TableData> {
        Some(R::data(self.table()))
    }
}

fn exact<R: Into<f64>>(Orientation { alpha, beta }: Orientation<R>) -> Orientation<f64> {
    let [alpha, beta] = [alpha, beta].map(|z| widened(z, Into::into));
    Orientation { alpha, beta }
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
