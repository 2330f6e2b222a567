//! Numbers of a table, for programs that contain it as data.

use crate::motion::Scalar;
use fixed::types::{I2F14, I2F30};
use toytop::scalar::Float;
use toytop::{Clock, EphemerisScalar, EphemerisView, ErrorBound};

/// Numbers of a [`Baked`](toytop::Baked) of any size and scalar.
pub struct TableData {
    /// Version of the format.
    pub format: u32,
    /// CRC-32 of all other numbers.
    pub crc32: u32,
    /// Scalar of the table.
    pub scalar: Scalar,
    /// Number of segments, and of terms of a polynomial.
    pub size: [usize; 2],
    /// Phases and rates.
    pub clock: Clock<f64>,
    /// Upper bound on the orientation error, rad.
    pub error_bound: ErrorBound,
    /// Upper bound on the error of the angular velocity, rad per unit time.
    pub rate_error_bound: ErrorBound,
    /// Cells of half a period: see core/docs/table_format.md.
    pub cells: [u16; 16],
    /// Coefficients of Re α, Im α, Re β and Im β, by segment and power. An integer of n bits is that of x^k in units of 2^-(n-1+k).
    pub coefficients: Vec<[f64; 4]>,
}

impl TableData {
    /// Size of the table in bytes, without the clock.
    pub fn table_bytes(&self) -> usize {
        let bytes = match self.scalar {
            Scalar::F64 => 8,
            Scalar::F32 | Scalar::Q31 => 4,
            Scalar::Q15 => 2,
        };
        4 * bytes * self.coefficients.len()
    }
}

/// Scalar of the core with the numbers of its tables.
pub trait TableScalar:
    EphemerisScalar<Segment: Send + Sync, Quantity: Send + Sync> + Send + Sync + 'static
{
    /// Scalar on the command line.
    const SCALAR: Scalar;

    /// Checksum and coefficients of a table.
    fn crc32_and_coefficients(table: &EphemerisView<Self>) -> (u32, Vec<[f64; 4]>);

    /// Numbers of a table.
    fn data(table: &EphemerisView<Self>) -> TableData {
        let (crc32, coefficients) = Self::crc32_and_coefficients(table);
        let clock = *table.clock();
        TableData {
            format: toytop::Baked::<Self, 16>::FORMAT,
            crc32,
            scalar: Self::SCALAR,
            size: [table.capacity(), Self::TERMS],
            clock: Clock {
                step: clock.step,
                tip_start_quarter_turns: clock.tip_start_quarter_turns,
                tip_sign_changes: clock.tip_sign_changes,
                tip_exists: clock.tip_exists,
                has_turning_points: clock.has_turning_points,
                twice_tip_scale: clock.twice_tip_scale.to_f64(),
                x_rate: clock.x_rate.to_f64(),
                slow_sum_rate: clock.slow_sum_rate.to_f64(),
                axial_rate: clock.axial_rate.to_f64(),
                first_phases: clock.first_phases,
                exact_step: clock.exact_step,
                ticks_per_time: clock.ticks_per_time,
                tip_start: clock.tip_start,
                tip_step: clock.tip_step,
                epoch: clock.epoch,
            },
            error_bound: table.error_bound(),
            rate_error_bound: table.rate_error_bound(),
            cells: table.cells(),
            coefficients,
        }
    }
}

macro_rules! table_scalar {
    ($($scalar:ty: $name:ident),*) => { $(
        impl TableScalar for $scalar {
            const SCALAR: Scalar = Scalar::$name;

            fn crc32_and_coefficients(table: &EphemerisView<Self>) -> (u32, Vec<[f64; 4]>) {
                let rows = table.segments().as_flattened().iter();
                (table.crc32(), rows.map(|row| row.map(f64::from)).collect())
            }
        }
    )* };
}

table_scalar!(f32: F32, f64: F64, I2F30: Q31, I2F14: Q15);
