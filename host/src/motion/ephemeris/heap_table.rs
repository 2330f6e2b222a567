//! Table of the core on the heap, as a source of samples.

use super::events::{self, Condition};
use super::{EventQuery, Instant, MotionEphemeris, MotionEvent, Source, unwrapped};
use crate::motion::Scalar;
use crate::motion::column::SampleColumn;
use crate::motion::sample::Sample;
use fixed::types::{I2F14, I2F30};
use toytop::scalar::Float;
use toytop::{Complex, EphemerisMemory, EphemerisScalar, Orientation, Pose, Table};
use toytop_model::equations::Rates;

/// Scalar of the core with its name and the capacity of its own table.
pub trait TableScalar:
    EphemerisScalar<Coefficient: Into<f64>, Segment: Send + Sync, Quantity: Send + Sync> + Send + Sync
{
    /// Scalar on the command line.
    const SCALAR: Scalar;

    /// Segments of the core's own type of table, which fits most motions.
    const SEGMENTS: u32;

    /// Checksum of a table.
    fn crc32(table: &Table<Self>) -> u32;
}

macro_rules! table_scalar {
    ($($scalar:ty: $name:ident, $segments:literal;)*) => { $(
        impl TableScalar for $scalar {
            const SCALAR: Scalar = Scalar::$name;
            const SEGMENTS: u32 = $segments;

            fn crc32(table: &Table<Self>) -> u32 {
                table.crc32()
            }
        }
    )* };
}

table_scalar! {
    f64: F64, 48;
    f32: F32, 25;
    I2F30: Q31, 32;
    I2F14: Q15, 16;
}

/// Table of the core on the heap, after its set-up.
pub struct HeapTable<R: EphemerisScalar>(pub(super) Box<EphemerisMemory<Table<R>>>);

impl<R: TableScalar> HeapTable<R> {
    /// Table itself.
    pub fn table(&self) -> &Table<R> {
        self.0.get().expect("set up")
    }

    /// Ephemeris of this table.
    pub(super) fn ephemeris(self) -> MotionEphemeris {
        let table = self.table();
        let [ticks_per_time, _] = table.clock().ticks_per_time;
        MotionEphemeris {
            size: [table.capacity(), R::TERMS],
            ticks_per_time,
            error_bound: table.error_bound(),
            rate_error_bound: table.rate_error_bound(),
            source: Box::new(self),
        }
    }
}

impl<R: TableScalar> Source for HeapTable<R> {
    fn sample(&self, instant: Instant, only: Option<SampleColumn>) -> Sample {
        let table = self.table();
        let [rate, _] = table.clock().ticks_per_time;
        match instant {
            Instant::Time(t) => sample(table, &table.at(t), [t, t * rate], only),
            Instant::Tick(n) => sample(table, &table.at_tick(n), [n as f64 / rate, n as f64], only),
        }
    }

    fn events(&self, condition: Condition, query: &EventQuery) -> Vec<MotionEvent> {
        let table = self.table();
        let [rate, _] = table.clock().ticks_per_time;
        let sample = |event: &_, t| sample(table, &table.at_event(event), [t, t * rate], None);
        events::table_events(table, condition, query, sample)
    }
}

/// Sample of a table. With a column, NaN stands for numbers that it does not need.
///
/// * `ticks`: the time t in ticks
#[inline]
fn sample<R: TableScalar>(
    table: &Table<R>,
    now: &toytop::Sample<'_, R>,
    [t, ticks]: [f64; 2],
    only: Option<SampleColumn>,
) -> Sample {
    const ABSENT: Complex<f64> = Complex::new(f64::NAN, f64::NAN);
    const NO_POSE: Pose<f64, f64> =
        Pose { orientation: Orientation { alpha: ABSENT, beta: ABSENT }, u: f64::NAN, tip: ABSENT };
    let needs = |column| only.is_none_or(|only| only == column);
    let vector = |x: [R::Quantity; 3]| x.map(Float::to_f64);
    let [omega, omega_body] = [SampleColumn::Omega, SampleColumn::OmegaBody].map(needs);
    Sample {
        t,
        pose: if only.is_none_or(SampleColumn::needs_pose) { widened(now.pose()) } else { NO_POSE },
        rates: Rates {
            omega: if omega { vector(now.omega()) } else { [f64::NAN; 3] },
            omega_body: if omega_body { vector(now.omega_body()) } else { [f64::NAN; 3] },
            udot: if needs(SampleColumn::Udot) { now.udot().to_f64() } else { f64::NAN },
        },
        tip_angle: if needs(SampleColumn::TipAngle) {
            now.tip_angle().map(|angle| unwrapped(angle, table.mean_tip_angle_rate() * t))
        } else {
            None
        },
        error_bound: Some(table.error_bound().after(ticks)),
    }
}

fn widened<R: TableScalar>(Pose { orientation, u, tip }: Pose<R, R::Quantity>) -> Pose<f64, f64> {
    let [alpha, beta] = [orientation.alpha, orientation.beta].map(|z| Complex::new(z.re.into(), z.im.into()));
    let tip = Complex::new(tip.re.to_f64(), tip.im.to_f64());
    Pose { orientation: Orientation { alpha, beta }, u: u.into(), tip }
}
