//! Reading of a table: any tick, ticks one after the other, and turning points. Nothing here can fail.

mod locate;

mod tip_angle;

pub(super) mod sample;

mod batch;

pub(super) mod cursor;

pub(super) mod sampler;

pub(super) mod turning_point;
