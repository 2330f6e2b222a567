//! Table of the core on the heap, as an ephemeris.

use super::events::{self, Condition};
use super::{DynEphemeris, EventQuery, MotionEvent, unwrapped};
use crate::motion::Scalar;
use crate::motion::column::SampleColumn;
use crate::motion::sample::{Quantities, Sample};
use fixed::types::{I2F14, I2F30};
use toytop::scalar::Float;
use toytop::{Complex, EphemerisMemory, EphemerisScalar, EphemerisView, ErrorBound, Orientation, Pose};
use toytop_model::equations::BodyRates;

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

    /// Quantities t units of time after t = 0.
    fn quantities(&self, t: f64) -> TableQuantities<'_, R> {
        let table = self.table();
        TableQuantities { table, t, ticks: t * ticks_per_time(table), now: table.at(t) }
    }
}

/// Quantities of a motion at one time, read from its table.
struct TableQuantities<'a, R: EphemerisScalar> {
    table: &'a EphemerisView<R>,
    t: f64,
    /// The time in ticks.
    ticks: f64,
    now: toytop::Sample<'a, R>,
}

impl<R: EphemerisScalar> Quantities for TableQuantities<'_, R> {
    fn sample(&self) -> Sample {
        Sample {
            t: self.t,
            pose: self.pose(),
            rates: BodyRates { omega: self.omega(), omega_body: self.omega_body(), udot: self.udot() },
            tip_angle: self.tip_angle(),
            error_bound: self.error_bound(),
        }
    }

    fn t(&self) -> f64 {
        self.t
    }

    fn orientation(&self) -> Orientation<f64> {
        widened(self.now.orientation())
    }

    fn pose(&self) -> Pose<f64, f64> {
        let Pose { orientation, u, tip } = self.now.pose();
        let tip = Complex::new(tip.re.to_f64(), tip.im.to_f64());
        Pose { orientation: widened(orientation), u: u.into(), tip }
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

fn ticks_per_time<R: EphemerisScalar>(table: &EphemerisView<R>) -> f64 {
    let [rate, _] = table.clock().ticks_per_time;
    rate
}

impl<R: TableScalar> DynEphemeris for HeapTable<R> {
    fn size(&self) -> [usize; 2] {
        [self.table().capacity(), R::TERMS]
    }

    fn ticks_per_time(&self) -> f64 {
        ticks_per_time(self.table())
    }

    fn error_bound(&self) -> ErrorBound {
        self.table().error_bound()
    }

    fn rate_error_bound(&self) -> ErrorBound {
        self.table().rate_error_bound()
    }

    fn at(&self, t: f64) -> Sample {
        self.quantities(t).sample()
    }

    fn pose(&self, t: f64) -> Pose<f64, f64> {
        self.quantities(t).pose()
    }

    fn at_tick(&self, n: i64) -> Sample {
        let table = self.table();
        let (t, ticks) = (n as f64 / self.ticks_per_time(), n as f64);
        TableQuantities { table, t, ticks, now: table.at_tick(n) }.sample()
    }

    fn fill(&self, column: SampleColumn, times: &[f64], rows: &mut [f64]) {
        super::fill(column, |t| self.quantities(t), times, rows);
    }

    fn events(&self, condition: Condition, query: &EventQuery) -> Vec<MotionEvent> {
        let table = self.table();
        let sample = |event: &_, t| {
            let ticks = t * self.ticks_per_time();
            TableQuantities { table, t, ticks, now: table.at_event(event) }.sample()
        };
        events::table_events(table, condition, query, sample)
    }
}

fn widened<R: Into<f64>>(Orientation { alpha, beta }: Orientation<R>) -> Orientation<f64> {
    let [alpha, beta] = [alpha, beta].map(|z| Complex { re: z.re.into(), im: z.im.into() });
    Orientation { alpha, beta }
}
