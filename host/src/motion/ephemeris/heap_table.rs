//! Table of the core on the heap.

use super::events::{Condition, EventQuery, MotionEvent};
use super::source::MotionSource;
use crate::Failure;
use crate::motion::column::SampleColumn;
use crate::motion::sample::{Sample, SampleQuantities, unwrapped};
use std::f64::consts::TAU;
use std::ops::RangeInclusive;
use toytop::scalar::Float;
use toytop::{
    Event, Motion, Pose, SetUpError, SizedTable, Table, TableMemory, TableScalar, TableSettings, Workspace,
};

macro_rules! capacities {
    ($($capacity:literal)*) => {
        /// Numbers of segments that a table may have: powers of two, and those of the core's own types.
        const CAPACITIES: &[u32] = &[$($capacity),*];

        /// Memory of a table with one of the [`CAPACITIES`].
        fn memory<R: TableScalar>(capacity: u32) -> Option<Box<TableMemory<Table<R>>>> {
            Some(match capacity {
                $($capacity => Box::new(TableMemory::<SizedTable<R, $capacity>>::new()),)*
                _ => return None,
            })
        }
    };
}

capacities!(8 16 25 32 48 64 128 256 512 1024 2048 4096);

/// Least and greatest number of segments.
pub const SEGMENTS: RangeInclusive<u32> = 8..=4096;

/// Table of the core on the heap, after its set-up.
pub struct HeapTable<R: TableScalar>(Box<TableMemory<Table<R>>>);

impl<R: TableScalar> HeapTable<R> {
    /// Table of a motion, in the least number of segments that is enough.
    ///
    /// * `segments`: least and greatest number; any other is a power of two
    ///
    /// # Errors
    /// [`Failure::Input`]: no table has this many segments. [`Failure::Method`]: they are too few; the message states a sufficient number.
    pub fn new(
        motion: &Motion,
        settings: &TableSettings,
        segments: RangeInclusive<u32>,
    ) -> Result<Self, Failure> {
        let least = segments.start();
        let is_allowed = |n: &&u32| *n == least || segments.contains(*n) && n.is_power_of_two();
        let mut refusal = None;
        for capacity in CAPACITIES.iter().filter(is_allowed) {
            let mut memory = memory(*capacity).expect("one of the capacities");
            match memory.set_up(&mut Workspace::new(), motion, *settings, &mut || {}) {
                Ok(_) => return Ok(Self(memory)),
                Err(error) => refusal = Some(error),
            }
        }
        let Some(error) = refusal else {
            return Err(Failure::Input(format!("{least}: must be one of {CAPACITIES:?}")));
        };
        let hint = if let SetUpError::TableTooSmall { truncation, .. } = error {
            let needed = Table::<R>::segments_needed(motion, truncation).unwrap_or(u32::MAX);
            match CAPACITIES.iter().find(|capacity| **capacity >= needed) {
                Some(enough) => format!("; at least {enough} segments would be enough"),
                None => "; not even 4096 segments of this degree would be enough".to_owned(),
            }
        } else {
            String::new()
        };
        Err(Failure::Method(format!("no ephemeris: {error}{hint}")))
    }

    /// Table itself.
    pub fn table(&self) -> &Table<R> {
        self.0.get().expect("set up")
    }
}

impl<R: TableScalar> MotionSource for HeapTable<R>
where
    Self: Send + Sync,
{
    fn sample(&self, t: f64, tick: Option<i64>) -> Sample {
        let table = self.table();
        let now = tick.map_or_else(|| table.at(t), |n| table.at_tick(n));
        Sample::new(&TableSample { table, now, t })
    }

    fn pose(&self, t: f64) -> Pose<f64, f64> {
        TableSample::new(self.table(), t).pose()
    }

    fn write(&self, column: SampleColumn, times: &[f64], rows: &mut [f64]) {
        let table = self.table();
        column.write_each(times.iter().map(|t| TableSample::new(table, *t)), rows);
    }

    fn events(&self, condition: Condition, query: &EventQuery) -> Vec<MotionEvent> {
        /// Number of consecutive events of the other direction after which a search ends.
        const MAX_UNWANTED: u32 = 10_000;
        let table = self.table();
        let [ticks_per_time, _] = table.clock().ticks_per_time;
        let from = (query.from * ticks_per_time).floor() as i64;
        let events: Box<dyn Iterator<Item = Event>> = match condition {
            Condition::Turning => Box::new(table.turning_points(from)),
            Condition::Crossing(level) => Box::new(table.crossings(level, from)),
            Condition::TipAngle(angle) => Box::new(table.tip_angles(angle, from)),
        };
        let mut unwanted = 0;
        let mut included = Vec::new();
        for event in events {
            let t = table.time_of(&event);
            if query.includes(t, event.upward) {
                unwanted = 0;
                let sample = Sample::new(&TableSample { table, now: table.at_event(&event), t });
                included.push(MotionEvent::new(condition, t, event.upward, sample));
            } else {
                unwanted += 1;
            }
            if included.len() >= query.count || unwanted == MAX_UNWANTED {
                break;
            }
        }
        included
    }
}

/// Sample of a table at the time t.
struct TableSample<'a, R: TableScalar> {
    table: &'a Table<R>,
    now: toytop::Sample<'a, R>,
    t: f64,
}

impl<'a, R: TableScalar> TableSample<'a, R> {
    fn new(table: &'a Table<R>, t: f64) -> Self {
        Self { table, now: table.at(t), t }
    }
}

impl<R: TableScalar> SampleQuantities for TableSample<'_, R> {
    fn t(&self) -> f64 {
        self.t
    }

    fn pose(&self) -> Pose<f64, f64> {
        let Pose { orientation, u, tip } = self.now.pose();
        Pose { orientation: orientation.map(R::into), u: u.into(), tip: tip.map(Float::to_f64) }
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
        self.now.tip_angle().map(|angle| unwrapped(angle, self.table.mean_tip_angle_rate() * self.t / TAU))
    }

    fn error_bound(&self) -> Option<f64> {
        let [rate, _] = self.table.clock().ticks_per_time;
        Some(self.table.error_bound().after(self.t * rate))
    }
}
