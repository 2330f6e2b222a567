//! Events: turning points, crossings of a tilt, and tip angles.

use crate::memory::{Opaque, opaque, store, write};
use crate::status::{Refusal, toytop_status};
use crate::table::*;
use toytop::internal::check_finite;
use toytop::{Event, Events, Level, Phase, TableScalar};

opaque! {
/// Bytes of the events of a table.
TOYTOP_EVENTS_SIZE = 384;

/// Events of one kind of a table, in order. They may be copied.
///
/// They refer to their table, whose memory must still be there. After another set-up in this memory they are refused.
toytop_events[48]
}

impl<R: TableScalar> Opaque for OfTable<Events<'static, R>> {
    const TAG: u32 = 0x746f_6500 | R::CODE;
}

/// Event of a motion: its instant in ticks, and the sense of the change.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct toytop_event {
    /// Last tick at or before the event.
    pub tick: i64,
    /// Fraction of the following tick that passes before the event, in [0, 1).
    pub fraction: f64,
    /// 1 or 0: see the function that found the events.
    pub upward: u32,
}

/// Writes the next event, and keeps the events after it.
///
/// # Safety
/// The pointers are null or valid, and the memory of the table is still there.
unsafe fn next_event<R: TableScalar>(
    place: *mut toytop_events,
    event: *mut toytop_event,
) -> Result<(), Refusal> {
    // SAFETY: the caller guarantees valid pointers and a valid table.
    unsafe {
        let mut kept: OfTable<Events<'static, R>> = load_of::<R, _, _>(place)?;
        let mut events = kept.value;
        let Event { tick, fraction, upward } = events.next().ok_or(toytop_status::TOYTOP_NONE)?;
        write(event, toytop_event { tick, fraction, upward: upward.into() })?;
        kept.value = events;
        store(place, kept)
    }
}

macro_rules! functions {
    ($name:ident, $scalar:ty, $table:ty, $orientation:ty, $rate:ty) => { pastey::paste! {

reader! {
/// Turning points of u at tick `from` or later; `upward` is 1 where u = e2. There are none where the tilt is constant to 2^-49 rad.
[<toytop_ $name _turning_points>](table: $table; from: i64, events: *mut toytop_events)
    |table, from, events| store_from::<$scalar, _, _>(table, events, |table| Ok(table.turning_points(from)))
}

reader! {
/// Crossings of a tilt, the angle of the axis to the upward vertical in rad, at tick `from` or later; `upward` is 1 where the axis
/// rises. The tip is on the circle of a radius r about the origin where the sine of the tilt is r/s.
[<toytop_ $name _crossings>](table: $table; tilt: f64, from: i64, events: *mut toytop_events)
    |table, tilt, from, events| {
        store_from::<$scalar, _, _>(table, events, |table| Ok(table.crossings(Level::from_tilt(tilt)?, from)))
    }
}

reader! {
/// Instants at tick `from` or later at which the angle of the tip is `angle`, rad, up to whole turns; `upward` is 1 where it
/// increases. There are none where the axis is always vertical.
[<toytop_ $name _tip_angles>](table: $table; angle: f64, from: i64, events: *mut toytop_events)
    |table, angle, from, events| {
        store_from::<$scalar, _, _>(table, events, |table| {
            let angle = Phase::from_radians(check_finite("angle", angle)?);
            Ok(table.tip_angles(angle, from))
        })
    }
}

/// Next of the events. `TOYTOP_NONE` where there is none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn [<toytop_ $name _next_event>](
    events: *mut toytop_events,
    event: *mut toytop_event,
) -> toytop_status {
    // SAFETY: the caller guarantees valid pointers and a valid table.
    unsafe { next_event::<$scalar>(events, event) }.into()
}

    } };
}

for_each_scalar!(functions);
