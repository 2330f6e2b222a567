//! Table of the core on the heap.

use super::evaluate::Evaluate;
use super::events::{Condition, EventQuery, MotionEvent};
use crate::Failure;
use crate::motion::column::SampleColumn::{self, ErrorBound, Omega, OmegaBody, T, Tip, TipAngle, Udot};
use crate::motion::sample::{MotionSample, unwrapped};
use std::f64::consts::TAU;
use std::ops::RangeInclusive;
use toytop::scalar::Float;
use toytop::{
    Event, Motion, SetUpError, SizedTable, Table, TableMemory, TableScalar, TableSettings, Workspace,
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
pub struct BoxedTable<R: TableScalar> {
    memory: Box<TableMemory<Table<R>>>,
    /// Mean rate of the tip angle, rad/s.
    tip_rate: f64,
}

impl<R: TableScalar> BoxedTable<R> {
    /// Table of a motion, in the least number of segments that is enough.
    ///
    /// * `segments`: least and greatest number; any other is a power of two
    ///
    /// # Errors
    /// [`Failure::input`]: no table has this many segments. [`Failure::method`]: they are too few; the message states a sufficient number.
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
                Ok(table) => return Ok(Self { tip_rate: table.mean_tip_angle_rate(), memory }),
                Err(error) => refusal = Some(error),
            }
        }
        let Some(error) = refusal else {
            return Err(Failure::input(format!("must be one of {CAPACITIES:?}")).at(least.to_string()));
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
        Err(Failure::method(format!("no table: {error}{hint}")))
    }

    /// Table itself.
    pub fn table(&self) -> &Table<R> {
        self.memory.get().expect("set up")
    }

    /// Sample in `f64` at the time t.
    ///
    /// * `column`: column whose numbers are computed; without it, all quantities
    fn sample_at(&self, now: &toytop::Sample<'_, R>, t: f64, column: Option<SampleColumn>) -> MotionSample {
        let table = self.table();
        let needs = |quantity| column.is_none_or(|column| column == quantity);
        let mut sample = MotionSample { t, ..MotionSample::EMPTY };
        if needs(ErrorBound) {
            let [rate, _] = table.clock().ticks_per_time;
            sample.error_bound = Some(table.error_bound().after(t * rate));
        }
        if needs(Tip) {
            sample.tip = now.tip().map(Float::to_f64);
        }
        // all other columns are functions of the orientation and u
        if !matches!(column, Some(T | Udot | Omega | OmegaBody | Tip | TipAngle | ErrorBound)) {
            (sample.orientation, sample.u) = (now.orientation().map(R::into), now.u().into());
        }
        if needs(Omega) {
            sample.rates.omega = now.omega().map(Float::to_f64);
        }
        if needs(OmegaBody) {
            sample.rates.omega_body = now.omega_body().map(Float::to_f64);
        }
        if needs(Udot) {
            sample.rates.udot = now.udot().to_f64();
        }
        if needs(TipAngle) {
            let near = self.tip_rate * t / TAU;
            sample.tip_angle = now.tip_angle().map(|angle| unwrapped(angle, near));
        }
        sample
    }
}

impl<R: TableScalar> Evaluate for BoxedTable<R>
where
    Self: Send + Sync,
{
    fn sample(&self, t: f64, tick: Option<i64>, column: Option<SampleColumn>) -> MotionSample {
        let table = self.table();
        self.sample_at(&tick.map_or_else(|| table.at(t), |n| table.at_tick(n)), t, column)
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
                let sample = self.sample_at(&table.at_event(&event), t, None);
                included.push(MotionEvent::new(condition, event.upward, sample));
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
