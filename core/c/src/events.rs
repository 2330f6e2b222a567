//! Events: turning points, crossings of a tilt, and tip angles.

use crate::status::{Refusal, toytop_status};
use crate::table::*;
use toytop::{EphemerisScalar, Event, Events, Level, ParameterError, Phase};

/// Event of a motion: its instant in ticks, and the sense of the change.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct toytop_event {
    /// Last tick at or before the event.
    pub tick: i64,
    /// Fraction of the following tick that passes before the event, in [0, 1).
    pub fraction: f64,
    /// 1 or 0: see the function that found the event.
    pub upward: u32,
}

/// First event of an iterator.
fn first_event<R: EphemerisScalar>(mut events: Events<'_, R>) -> Result<toytop_event, Refusal> {
    let Event { tick, fraction, upward } = events.next().ok_or(toytop_status::TOYTOP_NONE)?;
    Ok(toytop_event { tick, fraction, upward: upward.into() })
}

/// Tip angle from rad.
fn tip_angle(angle: f64) -> Result<Phase, Refusal> {
    if !angle.is_finite() {
        return Err(ParameterError::NotFinite { parameter: "angle" }.into());
    }
    Ok(Phase::from_radians(angle))
}

macro_rules! functions {
    ($name:ident, $scalar:ty, $table:ty, $orientation:ty, $rate:ty) => { pastey::paste! {

reader! {
/// First turning point of u at tick `from` or later; `upward` is 1 where u = e2. `TOYTOP_NONE` where there is none. The next one is
/// found from `tick + 1` of this one, here and below.
[<toytop_ $name _first_turning_point>](table: $table; from: i64, event: *mut toytop_event)
    |table, from, event| write_from::<$scalar, _>(table, event, |table| first_event(table.turning_points(from)))
}

reader! {
/// First crossing of a tilt, the angle of the axis to the upward vertical in rad, at tick `from` or later; `upward` is 1 where the axis
/// rises. `TOYTOP_NONE` where the motion does not reach it. The tip is on the circle of a radius r about the origin where the sine of the
/// tilt is r/s.
[<toytop_ $name _first_crossing>](table: $table; tilt: f64, from: i64, event: *mut toytop_event)
    |table, tilt, from, event| {
        write_from::<$scalar, _>(table, event, |table| first_event(table.crossings(Level::of_tilt(tilt)?, from)))
    }
}

reader! {
/// First instant at tick `from` or later at which the angle of the tip is `angle`, rad, up to whole turns; `upward` is 1 where it
/// increases. `TOYTOP_NONE` where the axis is always vertical or the angle is not reached.
[<toytop_ $name _first_tip_angle>](table: $table; angle: f64, from: i64, event: *mut toytop_event)
    |table, angle, from, event| {
        write_from::<$scalar, _>(table, event, |table| first_event(table.tip_angles(tip_angle(angle)?, from)))
    }
}

    } };
}

for_each_scalar!(functions);
