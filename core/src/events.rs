//! Events: instants at which a motion turns, or reaches a tilt, a circle or a tip angle.
//!
//! u has a value at one nutation phase while it rises, found by bisection, and at minus that phase while it falls. A tip angle is found by
//! bisection in time.

mod event;

mod level;

mod recurring_instants;

mod tip_angle_search;

mod iterator;

pub use event::Event;
pub use iterator::Events;
pub use level::Level;
