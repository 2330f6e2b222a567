//! Table of the core on the heap, as an ephemeris.

use super::events::{self, Condition};
use super::{DynEphemeris, EventFilter, FoundEvent, unwrapped};
use crate::motion::column::SampleColumn;
use crate::motion::sample::{Quantities, Sample};
use crate::motion::{Scalar, widened};
use fixed::types::{I2F14, I2F30};
use toytop::scalar::Float;
use toytop::{EphemerisMemory, EphemerisScalar, EphemerisView, ErrorBound, Orientation, Pose};

/// Scalar of the core, with its name and the numbers of its tables.
pub trait TableScalar: EphemerisScalar<Segment: Send + Sync, Quantity: Send + Sync> + Send + Sync {
    /// Scalar on the command line.
    const SCALAR: Scalar;

    /// Checksum of a table.
    fn crc32(table: &EphemerisView<Self>) -> u32;

    /// Coefficient of a table. An integer of n bits is that of x^k in units of 2^-(n-1+k).
    fn number(coefficient: Self::Coefficient) -> f64;
}

macro_rules! table_scalar {
    ($($scalar:ty: $name:ident),*) => { $(
        impl TableScalar for $scalar {
            const SCALAR: Scalar = Scalar::$name;

            fn crc32(table: &EphemerisView<Self>) -> u32 {
                table.crc32()
            }

            fn number(coefficient: Self::Coefficient) -> f64 {
                coefficient.into()
            }
        }
    )* };
}

table_scalar!(f64: F64, f32: F32, I2F30: Q31, I2F14: Q15);

/// Table of the core on the heap, after its set-up.
pub struct HeapTable<R: EphemerisScalar>(pub(super) Box<EphemerisMemory<EphemerisView<R>>>);

impl<R: EphemerisScalar> HeapTable<R> {
    /// Table itself.
    pub fn table(&self) -> &EphemerisView<R> {
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

impl<R: TableScalar> DynEphemeris for HeapTable<R> {
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

    fn fill(&self, column: SampleColumn, times: &[f64], rows: &mut [f64]) {
        column.fill(times.iter().map(|t| self.quantities_at(*t)), rows);
    }

    fn events(&self, condition: Condition, filter: &EventFilter) -> Vec<FoundEvent> {
        let table = self.table();
        let sample =
            |event: &_, t| self.quantities(t, t * self.ticks_per_time(), table.at_event(event)).sample();
        events::of_table(table, condition, filter, sample)
    }
}

fn exact<R: Into<f64>>(Orientation { alpha, beta }: Orientation<R>) -> Orientation<f64> {
    let [alpha, beta] = [alpha, beta].map(|z| widened(z, Into::into));
    Orientation { alpha, beta }
}
