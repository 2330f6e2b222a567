//! Reading of a table: samples at ticks and at any time.

mod sample;

mod tip_angle;

mod cursor;

pub use cursor::Cursor;
pub use sample::{Pose, Sample};
