//! The tick: runs for ever, cannot fail.

mod ephemeris;
mod moment;
mod pose;
mod stepper;
mod table;
mod tabular;
mod tip;

pub use ephemeris::{Cursor, Ephemeris, EphemerisF32, EphemerisF64, TurningPoint};
pub use moment::Moment;
pub use pose::Pose;
pub use stepper::Stepper;
pub use table::{ErrorBound, NoFit, Tick};
pub use tabular::{Place, Tabular};
pub use tip::{Tip, TipAngle};
