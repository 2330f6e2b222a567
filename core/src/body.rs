//! Input of a launch: a top, and its state.

mod error;

mod parameters;

mod top;

mod state;

mod impulse;

pub(crate) use error::check_range;
pub use error::{ParameterError, check, check_finite, check_item};
pub use impulse::PointImpulse;
pub use parameters::TopParameters;
pub(crate) use state::half_tilt_sine_cosine;
pub use state::{Release, State};
pub use top::{Support, Top};
