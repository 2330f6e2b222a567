//! Data of a table.

pub(super) mod tip_clock;

pub(super) mod clock;

pub(super) mod storage;

mod crc32;

pub(super) mod baked;
