//! Events of a motion: turning points, and instants at which it has a tilt or a direction.

use crate::status::{Refusal, toytop_status};
use crate::table::Tabulated;
use toytop::{Event, Events, ParameterError, Phase};

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
pub(crate) fn first<R: Tabulated>(mut events: Events<'_, R>) -> Result<toytop_event, Refusal> {
    let Event { tick, fraction, upward } = events.next().ok_or(toytop_status::TOYTOP_NONE)?;
    Ok(toytop_event { tick, fraction, upward: upward.into() })
}

/// Direction of the tip, from an angle in rad.
pub(crate) fn direction(angle: f64) -> Result<Phase, Refusal> {
    if !angle.is_finite() {
        return Err(ParameterError::NotFinite { parameter: "direction" }.into());
    }
    Ok(Phase::from_radians(angle))
}
