//! Input of a launch: a top, and its state.

mod error;

mod top;

mod parameters;

mod scaled_top;

mod state;

mod impulse;

pub(crate) use error::check_range;
pub use error::{ParameterError, check, check_finite};
pub use parameters::TopParameters;
pub use scaled_top::ScaledTop;
pub(crate) use state::half_tilt_sine_cosine;
pub use state::{Release, State};
pub use top::{Support, Top};

/// Parameters of a toy top, for tests.
#[cfg(test)]
const TOY: TopParameters = TopParameters {
    transverse_inertia: 3e-5,
    axial_inertia: 2e-5,
    com_height: 0.03,
    mass: 0.05,
    mass_moment: 0.0,
    gravity: 9.81,
    rotor_momentum: 0.0,
};
