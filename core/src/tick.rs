//! The tick: runs for ever, cannot fail.

mod ephemeris;
#[cfg(feature = "fixed")]
mod fixed_stepper;
mod moment;
mod pose;
mod stepper;
mod table;
mod tabular;
mod tip;

pub use ephemeris::{
    Bakeable, Baked, BakedError, Cursor, Ephemeris, EphemerisF32, EphemerisF64, TurningPoint,
};
#[cfg(feature = "fixed")]
pub use fixed_stepper::{FixedStepper, NoTickMap};
pub use moment::Moment;
pub use pose::Pose;
pub use stepper::Stepper;
pub use table::{ErrorBound, NoFit, Tick};
pub use tabular::{Place, Tabular};
pub use tip::{Tip, TipAngle};
