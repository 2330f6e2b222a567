//! Samples of a table at any tick or time, their error bounds and quantities.

use crate::input::toytop_state;
use crate::memory::{Opaque, opaque, write};
use crate::status::{Refusal, toytop_status};
use crate::table::*;
use toytop::internal::{check, check_finite};
use toytop::{Complex, Orientation, Sample, Table, TableScalar};

opaque! {
/// Bytes of a sample.
TOYTOP_SAMPLE_SIZE = 144;

/// Sample of a motion at one instant: its orientation, and phases from which each rate is computed on demand. It may be copied.
///
/// A sample refers to its table, whose memory must still be there. After another set-up in this memory the sample is refused.
toytop_sample[18]
}

impl<R: TableScalar> Opaque for OfTable<Sample<'static, R>> {
    const TAG: u32 = 0x746f_7300 | R::CODE;
}

/// Writes a quantity of a sample to memory of the caller. The sample is refused if its table was set up again. A number in fixed point is
/// written as its integer, which has the same layout.
///
/// # Safety
/// The pointers are null or valid, and the memory of the sample's table is still there.
unsafe fn write_quantity<R: TableScalar, T>(
    from: *const toytop_sample,
    place: *mut T,
    quantity: impl FnOnce(Sample<'static, R>) -> Result<T, Refusal>,
) -> Result<(), Refusal> {
    // SAFETY: the caller guarantees valid pointers and a valid table.
    unsafe { write(place, quantity(load_of::<R, _, _>(from)?.value)?) }
}

/// Sample at a time.
fn at<R: TableScalar>(table: &Table<R>, time: f64) -> Result<Sample<'_, R>, Refusal> {
    let is_reached = check_finite("time", time)?.abs() < table.end_time();
    check(is_reached, "time", "within 2^63 ticks")?;
    Ok(table.at(time))
}

/// Upper bounds on the errors of a table at a tick.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct toytop_error_bounds {
    /// Orientation error 2 sqrt(|d alpha|^2 + |d beta|^2), rad.
    pub orientation: f64,
    /// Error of the angular velocity, in either frame, rad/s.
    pub rate: f64,
}

/// Parts of a complex number, {re, im}.
fn re_im<R>(z: Complex<R>) -> [R; 2] {
    [z.re, z.im]
}

/// Function that writes one quantity of a sample.
macro_rules! quantity {
    ($(#[$doc:meta])* $function:ident<$scalar:ty>($quantity:ident: $number:ty) = |$sample:ident| $value:expr) => {
$(#[$doc])*
#[unsafe(no_mangle)]
pub unsafe extern "C" fn $function(
    sample: *const toytop_sample,
    $quantity: *mut $number,
) -> toytop_status {
    // SAFETY: the caller guarantees valid pointers and a valid table.
    unsafe { write_quantity::<$scalar, _>(sample, $quantity.cast(), |$sample| Ok($value)).into() }
}
    };
}

macro_rules! functions {
    ($name:ident, $scalar:ty, $table:ty, $orientation:ty, $rate:ty) => {
        pastey::paste! {

        reader! {
        /// Sample at any tick, of either sign, always at the same cost.
        [<toytop_ $name _at_tick>](table: $table; tick: i64, sample: *mut toytop_sample)
            |table, tick, place| store_from::<$scalar, _, _>(table, place, |table| Ok(table.at_tick(tick)))
        }

        reader! {
        /// Sample at any time, s from tick 0.
        [<toytop_ $name _at>](table: $table; time: f64, sample: *mut toytop_sample)
            |table, time, place| store_from::<$scalar, _, _>(table, place, |table| at(table, time))
        }

        reader! {
        /// Error bounds of a table at a tick.
        [<toytop_ $name _error_bounds>](table: $table; tick: i64, bounds: *mut toytop_error_bounds)
            |table, tick, bounds| {
                let CheckedTable { table, .. } = table_at::<$scalar>(table)?;
                write(bounds, toytop_error_bounds { orientation: table.error_bound_at(tick), rate: table.rate_error_bound_at(tick) })
            }
        }

        quantity! {
        /// Cayley-Klein parameters: four numbers Re alpha, Im alpha, Re beta, Im beta.
        [<toytop_ $name _cayley_klein>]<$scalar>(parameters: $orientation) = |sample| {
            let Orientation { alpha, beta } = sample.orientation();
            [re_im(alpha), re_im(beta)]
        }
        }

        quantity! {
        /// Unit quaternion, four numbers w, x, y, z, from body to fixed coordinates.
        [<toytop_ $name _quaternion>]<$scalar>(quaternion: $orientation) = |sample| sample.quaternion()
        }

        quantity! {
        /// Unit vector of three components from the tip to the centre of mass, in the fixed frame. The third is u, the cosine of the
        /// tilt, which a rounding can take past 1.
        [<toytop_ $name _axis>]<$scalar>(axis: $orientation) = |sample| sample.axis()
        }

        quantity! {
        /// Angular velocity of three components in the fixed frame, rad/s.
        [<toytop_ $name _omega>]<$scalar>(omega: $rate) = |sample| sample.omega()
        }

        quantity! {
        /// Angular velocity of three components in the body frame, rad/s, as a gyroscope measures it.
        [<toytop_ $name _omega_body>]<$scalar>(omega: $rate) = |sample| sample.omega_body()
        }

        quantity! {
        /// Position x, y of the tip, m from the point of the plane below the centre of mass; for a fixed tip the horizontal part of the
        /// axis with the opposite sign.
        [<toytop_ $name _tip>]<$scalar>(tip: $rate) = |sample| re_im(sample.tip())
        }

        quantity! {
        /// Velocity x, y of the tip, m/s; 1/s for a fixed tip.
        [<toytop_ $name _tip_velocity>]<$scalar>(velocity: $rate) = |sample| re_im(sample.tip_velocity())
        }

        quantity! {
        /// Angle of the tip, rad, continued in time from (-pi, pi] at the launch. `TOYTOP_NONE` if the axis is always vertical.
        [<toytop_ $name _tip_angle>]<$scalar>(angle: f64) =
            |sample| sample.tip_angle().ok_or(toytop_status::TOYTOP_NONE)?.to_radians()
        }

        quantity! {
        /// State of a sample, from which another motion can be launched.
        [<toytop_ $name _state>]<$scalar>(state: toytop_state) =
            |sample| toytop_state::from_state(&sample.state()?)
        }

            }
    };
}

for_each_scalar!(functions);
