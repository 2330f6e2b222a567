//! Power series of the phase equations, in integers.

mod integers;

mod block;

mod sincos;

mod rate;

pub(super) mod expansion;

mod coefficients;

mod expand;
