//! Table of the core on the heap, as an ephemeris.

use super::events::{self, Condition};
use super::{DynEphemeris, EventFilter, FoundEvent, unwrapped};
use crate::motion::Scalar;
use crate::motion::sample::{Part, Sample};
use fixed::types::{I2F14, I2F30};
use toytop::scalar::Float;
use toytop::{Complex, EphemerisMemory, EphemerisScalar, EphemerisView, ErrorBound, Orientation, Pose};

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

    /// Sets one part of a sample to that of `now`, at time t and at this number of ticks.
    fn update_from(
        &self,
        sample: &mut Sample,
        part: Part,
        [t, ticks]: [f64; 2],
        now: &toytop::Sample<'_, R>,
    ) {
        let wanted = |other: Part| part == Part::All || part == other;
        sample.t = t;
        if part == Part::Orientation {
            sample.pose.orientation = widened(now.orientation());
        }
        if wanted(Part::Pose) {
            let Pose { orientation, u, tip } = now.pose();
            let tip = Complex::new(tip.re.to_f64(), tip.im.to_f64());
            sample.pose = Pose { orientation: widened(orientation), u: u.into(), tip };
        }
        if wanted(Part::Omega) {
            sample.rates.omega = now.omega().map(Float::to_f64);
        }
        if wanted(Part::OmegaBody) {
            sample.rates.omega_body = now.omega_body().map(Float::to_f64);
        }
        if wanted(Part::Udot) {
            sample.rates.udot = now.udot().to_f64();
        }
        if wanted(Part::TipAngle) {
            let near = self.table().mean_tip_angle_rate() * t;
            sample.tip_angle = now.tip_angle().map(|angle| unwrapped(angle, near));
        }
        if wanted(Part::ErrorBound) {
            sample.error_bound = Some(self.table().error_bound().after(ticks));
        }
    }

    /// Sample `now`, at time t and at this number of ticks.
    fn sample(&self, times: [f64; 2], now: &toytop::Sample<'_, R>) -> Sample {
        let mut sample = Sample::UNKNOWN;
        self.update_from(&mut sample, Part::All, times, now);
        sample
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

    fn update(&self, sample: &mut Sample, part: Part, t: f64) {
        self.update_from(sample, part, [t, t * self.ticks_per_time()], &self.table().at(t));
    }

    fn at_tick(&self, n: i64) -> Sample {
        self.sample([n as f64 / self.ticks_per_time(), n as f64], &self.table().at_tick(n))
    }

    fn events(&self, condition: Condition, filter: &EventFilter) -> Vec<FoundEvent> {
        let table = self.table();
        let sample = |event: &_, t| self.sample([t, t * self.ticks_per_time()], &table.at_event(event));
        events::table_events(table, condition, filter, sample)
    }
}

fn widened<R: Into<f64>>(Orientation { alpha, beta }: Orientation<R>) -> Orientation<f64> {
    let [alpha, beta] = [alpha, beta].map(|z| Complex { re: z.re.into(), im: z.im.into() });
    Orientation { alpha, beta }
}
