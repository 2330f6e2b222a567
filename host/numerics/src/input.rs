//! Input of a computation.
//!
//! | module | contents |
//! |---|---|
//! | [`scenario`], [`builtin`] | motion from a TOML file; motions that need no file |
//! | [`random`] | random numbers fixed by a seed |

pub mod builtin;
pub mod random;
pub mod scenario;
