//! Table of the core on the heap.

use super::events::{Condition, EventQuery, MotionEvent};
use crate::motion::Scalar;
use crate::motion::sample::{Quantities, Sample, unwrapped};
use core::f64::consts::TAU;
use fixed::types::{I2F14, I2F30};
use toytop::scalar::Float;
use toytop::{
    Event, Pose, SizedTable, Table, TableF32, TableF64, TableMemory, TableQ15, TableQ31, TableScalar,
};

/// Scalar of the core with its name and the capacity of its own table.
pub trait HeapScalar:
    TableScalar<Coefficient: Into<f64>, Segment: Send + Sync, Quantity: Send + Sync> + Send + Sync
{
    /// Scalar on the command line.
    const SCALAR: Scalar;

    /// Capacity of the core's own type of table, which fits most motions.
    const OWN_CAPACITY: Capacity<Self>;

    /// Checksum of a table.
    fn crc32(table: &Table<Self>) -> u32;
}

/// Number of segments of a table, and function that makes its memory.
pub type Capacity<R> = (u32, fn() -> Box<TableMemory<Table<R>>>);

/// Capacity of the memory of a type.
pub(super) const fn capacity<R: HeapScalar, const SEGMENTS: usize>(
    _: fn() -> TableMemory<SizedTable<R, SEGMENTS>>,
) -> Capacity<R> {
    (SEGMENTS as u32, || Box::new(TableMemory::<SizedTable<R, SEGMENTS>>::new()))
}

macro_rules! heap_scalar {
    ($($scalar:ty: $name:ident, $table:ty;)*) => { $(
        impl HeapScalar for $scalar {
            const SCALAR: Scalar = Scalar::$name;
            const OWN_CAPACITY: Capacity<Self> = capacity(TableMemory::<$table>::new);

            fn crc32(table: &Table<Self>) -> u32 {
                table.crc32()
            }
        }
    )* };
}

heap_scalar! {
    f64: F64, TableF64;
    f32: F32, TableF32;
    I2F30: Q31, TableQ31;
    I2F14: Q15, TableQ15;
}

/// Table of the core on the heap, after its set-up.
pub struct HeapTable<R: TableScalar>(pub(super) Box<TableMemory<Table<R>>>);

impl<R: HeapScalar> HeapTable<R> {
    /// Table itself.
    pub fn table(&self) -> &Table<R> {
        self.0.get().expect("set up")
    }

    /// Motion at the time t, or at a tick, which is then at this time.
    pub(super) fn at(&self, t: f64, tick: Option<i64>) -> impl Quantities {
        let table = self.table();
        let now = tick.map_or_else(|| table.at(t), |n| table.at_tick(n));
        TableSample { table, now, t }
    }

    /// First events at which a condition holds, of those that the query includes.
    pub(super) fn events(&self, condition: Condition, query: &EventQuery) -> Vec<MotionEvent> {
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
struct TableSample<'a, R: HeapScalar> {
    table: &'a Table<R>,
    now: toytop::Sample<'a, R>,
    t: f64,
}

impl<R: HeapScalar> Quantities for TableSample<'_, R> {
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
