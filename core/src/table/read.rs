//! Reading of a table: samples at ticks and at any time.

mod located_segment;

mod sample;

mod tip_angle;

mod at;

mod cursor;

pub use cursor::Cursor;
pub use sample::Sample;
