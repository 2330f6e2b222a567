//! Input of a computation.
//!
//! | module | contents |
//! |---|---|
//! | [`scenario`], [`builtin`] | motion from a TOML file; motions that need no file |
//! | [`times`] | times at which a motion is computed |
//! | [`random`] | random numbers fixed by a seed |

pub mod builtin;
pub mod random;
pub mod scenario;
#[cfg(feature = "program")]
pub mod times;
