//! What a computation starts from.
//!
//! | module | contents |
//! |---|---|
//! | [`scenario`], [`builtin`] | motion from a TOML file; motions that need no file |
//! | [`times`] | times asked for |
//! | [`random`] | random numbers fixed by a seed |

pub mod builtin;
pub mod random;
pub mod scenario;
#[cfg(feature = "program")]
pub mod times;
