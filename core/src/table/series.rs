//! Power series of the phase equations, in integers.

pub(super) mod integers;

mod rate;

mod sincos;

pub(super) mod expansion;

mod recurrence;
